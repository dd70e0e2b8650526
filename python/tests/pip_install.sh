#!/usr/bin/env bash
# Installs the module by pip into a virtual environment, without a network, and uses it from another folder: from a
# copy of what git has, so that the source tree is neither needed nor changed. usage: pip_install.sh PYTHON SOURCE_FOLDER
set -euo pipefail
python=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/source"
git -C "$source" archive HEAD | tar -x -C "$work/source"
"$python" -m venv --system-site-packages "$work/venv"
"$work/venv/bin/pip" install --quiet --no-build-isolation --no-index "$work/source"
mv "$work/source" "$work/gone"
cd "$work"
venv/bin/python - <<'END'
import sluice

simulation = sluice.Simulation("breaking_dam")
simulation.run(steps=3)
assert simulation.field("density").shape == (simulation.particles,)
assert "wcsph_box" in sluice.scenes()
print(sluice.__version__, sluice.__file__)
END
