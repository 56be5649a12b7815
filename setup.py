"""Builds the compiled module by CMake: pip install --no-build-isolation ."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = pathlib.Path(__file__).parent.resolve()


class BuildByCMake(build_ext):
    """Its folder is kept, so that the next time only what has changed is built."""

    def build_extension(self, extension):
        build = pathlib.Path(self.build_temp).resolve()
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        subprocess.run(
            ["cmake", "-S", SOURCE, "-B", build, *generator, "-DCMAKE_BUILD_TYPE=Release",
             "-DCMAKE_UNITY_BUILD=ON", "-DSPOKE_PYTHON=ON",
             f"-DPython_EXECUTABLE={sys.executable}", "-DSPOKE_TESTS=OFF",
             "-DSPOKE_EXAMPLES=OFF"], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "spoke_python", "--parallel",
                        str(os.cpu_count())], check=True)
        module, = (build / "python/spoke").glob("_spoke.*")
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(module, target)


version = re.search(r"project\(spoke VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text())
setup(version=version.group(1), ext_modules=[Extension("spoke._spoke", sources=[])],
      cmdclass={"build_ext": BuildByCMake})
