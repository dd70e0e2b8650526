#!/usr/bin/env bash
# Builds and runs the programs of docs/library.md: on what a build installs, or with the sources as a subdirectory.
# usage: builds_on_installed.sh BUILD_FOLDER|--subdirectory SOURCE_FOLDER CXX
set -euo pipefail
build=$1 source=$2 compiler=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
project=$work/project
mkdir "$project"
awk -v folder="$project/" '
  /^```cpp /  { file = folder $2; next }
  /^```cmake/ { file = folder "CMakeLists.txt"; next }
  /^```/      { file = ""; next }
  file        { print > file }' "$source/docs/library.md"
cd "$project"
if [ "$build" = --subdirectory ]; then
  sed -i "s|^find_package(sluice .*|add_subdirectory($source sluice)|" CMakeLists.txt
  grep -q '^add_subdirectory' CMakeLists.txt
else
  cmake --install "$build" --prefix "$work/installed" >"$work/log" || { cat "$work/log"; exit 1; }
fi
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_PREFIX_PATH="$work/installed" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror"
cmake --build build --target probe kick
build/probe >probe.csv
awk -F, 'END { if (NR < 100 || $1 < 7.9 || $2 <= 0) { print "probe: not a dam that breaks: " $0; exit 1 } }' probe.csv
[ -s probe.ckp ]
build/kick | tee kick.txt
[ "$(grep -c 'at most 0 apart' kick.txt)" = 3 ]
[ "$(head -c 4 kick.png | tail -c 3)" = PNG ]
