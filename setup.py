"""Builds the Python module with CMake, in build/release or $STICKSLIP_BUILD: pip install --no-build-isolation ."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

root = Path(__file__).resolve().parent
build = Path(os.environ.get("STICKSLIP_BUILD", root / "build" / "release"))
version = re.search(r"^project\(stickslip VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text(), re.M).group(1)


class CMakeBuild(build_ext):
    """The extension comes out of CMake's target stickslip_python."""

    def build_extension(self, extension):
        python = getattr(sys, "_base_executable", sys.executable)
        settings = [] if os.path.samefile(python, "/usr/bin/python3") else [f"-DPython3_EXECUTABLE={python}"]
        # Each time, which takes a second: what can be built depends on the packages that are there now.
        known = (build / "CMakeCache.txt").exists() and not settings
        configure = ["cmake", build] if known else ["cmake", "--preset", "release", "-B", build, *settings]
        try:
            subprocess.run(configure, cwd=root, check=True)
            subprocess.run(["cmake", "--build", build, "--target", "stickslip_python"], cwd=root, check=True)
        except (OSError, subprocess.CalledProcessError):
            sys.exit("The module cannot be built: 'script/bootstrap build python' installs what it needs.")
        target = Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(build / "python" / "stickslip" / target.name, target)


(root / "build").mkdir(exist_ok=True)
setup(
    version=version,
    packages=["stickslip"],
    package_dir={"": "python"},
    package_data={"stickslip": ["py.typed", "_core.pyi"]},
    ext_modules=[Extension("stickslip._core", [])],
    cmdclass={"build_ext": CMakeBuild},
    options={"build": {"build_base": "build/pip"}, "egg_info": {"egg_base": "build"}},
)
