#!/usr/bin/env bash
# Installs a build, and builds and runs the programs of docs/library.md on what was installed.
# usage: builds_on_installed.sh BUILD_FOLDER SOURCE_FOLDER CXX
set -euo pipefail
build=$1 source=$2 compiler=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$build" --prefix "$work/installed" >"$work/log" || { cat "$work/log"; exit 1; }
mkdir "$work/project"
awk -v folder="$work/project/" '
  /^```cpp /  { file = folder $2; next }
  /^```cmake/ { file = folder "CMakeLists.txt"; next }
  /^```/      { file = ""; next }
  file        { print > file }' "$source/docs/library.md"
cd "$work/project"
ls probe.cpp kick.cpp CMakeLists.txt
cmake -S . -B build -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_PREFIX_PATH="$work/installed" \
  -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror ${SANITIZE:-}"
cmake --build build
build/probe >probe.csv
tail -n 1 probe.csv
awk -F, 'END { if (NR < 100 || $1 < 7.9 || $2 <= 0) { print "probe: not a dam that breaks"; exit 1 } }' probe.csv
ls -s probe.ckp
build/kick
file=kick.png
[ "$(head -c 4 "$file" | tail -c 3)" = PNG ]
