"""Builds the Python package with the library inside: configure and make in a folder of their own, once.

pip install .                           builds, with the options of CONFIGURE_FLAGS
TSIM_LIBRARY=/path/libtsim.so pip ...   takes a library that is built already
Needed are what `./setup build` installs; from the release archive no autotools.
"""
import os
import re
import shutil
import subprocess

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

here = os.path.dirname(os.path.abspath(__file__))


def version():
    with open(os.path.join(here, "configure.ac")) as file:
        return re.search(r"AC_INIT\(\[tsim\], \[([^\]]*)\]", file.read()).group(1)


def library(folder):
    """The path of libtsim.so, built in this folder."""
    given = os.environ.get("TSIM_LIBRARY")
    if given:
        return given
    if not os.path.exists(os.path.join(here, "configure")):
        subprocess.check_call(["./bootstrap"], cwd=here)
    os.makedirs(folder, exist_ok=True)
    if not os.path.exists(os.path.join(folder, "Makefile")):
        subprocess.check_call([os.path.join(here, "configure"),
                               *os.environ.get("CONFIGURE_FLAGS", "").split()], cwd=folder)
    subprocess.check_call(["make", "-j%d" % (os.cpu_count() or 1), "libtsim.so"], cwd=folder)
    return os.path.join(folder, "libtsim.so")


class Build(build_py):
    """Puts the library and the files of materials into the package."""

    def run(self):
        super().run()
        target = os.path.join(self.build_lib, "tsim")
        made = os.path.join(target, "libtsim.so")
        shutil.copyfile(library(os.path.join(here, "build", "python")), made)
        strip = shutil.which("strip")
        if strip:  # what debuggers read is nine tenths of it
            subprocess.check_call([strip, "--strip-debug", made])
        potentials = os.path.join(here, "potentials")
        shutil.copytree(potentials, os.path.join(target, "potentials"), dirs_exist_ok=True)


class Binary(Distribution):
    """The wheel is one of this system: it has a compiled library, of any version of Python."""

    def has_ext_modules(self):
        return True


try:
    from wheel.bdist_wheel import bdist_wheel

    class Wheel(bdist_wheel):
        def get_tag(self):
            return "py3", "none", super().get_tag()[2]
    commands = {"build_py": Build, "bdist_wheel": Wheel}
except ImportError:
    commands = {"build_py": Build}

setup(version=version(), distclass=Binary, cmdclass=commands)
