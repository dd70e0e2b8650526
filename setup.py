"""Builds the module `sluice` with CMake, for pip: pip install --no-build-isolation . (docs/python.md)."""

import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = Path(__file__).resolve().parent
VERSION = re.search(r"^project\(sluice VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text(), re.M)[1]


class CMakeBuild(build_ext):
    """Builds in build/pip, so that a second time only what changed is built."""

    def build_extension(self, extension):
        build = SOURCE / "build/pip"
        options = ["-DSLUICE_PYTHON=ON", "-DSLUICE_TESTS=OFF", "-DSLUICE_BENCH=OFF", "-DSLUICE_WINDOW=OFF"]
        subprocess.run(
            ["cmake", "-S", SOURCE, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON",
             f"-DPython_EXECUTABLE={sys.executable}", *options],
            check=True,
        )  # fmt: skip
        subprocess.run(["cmake", "--build", build, "--target", "sluice_python"], check=True)
        built = next((build / "python/sluice").glob("_sluice.*.so"))
        package = Path(self.get_ext_fullpath(extension.name)).parent
        package.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(built), str(package / built.name))
        for scene in (SOURCE / "scenes").rglob("*.[tc][os][mv]*"):
            target = package / "scenes" / scene.relative_to(SOURCE / "scenes")
            target.parent.mkdir(parents=True, exist_ok=True)
            self.copy_file(str(scene), str(target))


setup(
    version=VERSION,
    packages=["sluice"],
    package_dir={"sluice": "python/sluice"},
    package_data={"sluice": ["*.pyi", "py.typed"]},
    ext_modules=[Extension("sluice._sluice", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
