#!/usr/bin/env bash
# Installs the module by pip into a virtual environment and runs a script there, away from the sources.
#
#   pip.sh PYTHON SOURCE VENV
set -euo pipefail
python=$1 source=$2 venv=$3
rm -rf "$venv"
"$python" -m venv --system-site-packages "$venv"
"$venv/bin/pip" install --quiet --disable-pip-version-check --no-index --no-build-isolation "$source"
cd "$venv"
env -u PYTHONPATH bin/python - <<'EOF'
import pathlib, stickslip, sys
assert pathlib.Path(stickslip.__file__).is_relative_to(sys.prefix), stickslip.__file__
folder = pathlib.Path(stickslip.__file__).parent
assert (folder / "py.typed").exists() and (folder / "_core.pyi").exists()
assert stickslip.orbits("symmetric", example="S").admissible
EOF
