"""tsim from Python: granular particles, bonds, fluids and drilling.

    import tsim

    with tsim.Simulation() as sim:
        sim.file("in.drilling")
        print(sim.value("ke"), sim.x[:, 2].max())
        sim.picture().save("now.png")

Everything goes through the C library libtsim (doc/library.md) by ctypes; nothing is compiled. With
NumPy columns of particles are arrays on the memory of the simulation: writing to `sim.v` changes
velocities. Without NumPy numbers come as array.array, tables as lists of rows, columns as
memoryview.

The names of LAMMPS' and LIGGGHTS' Python modules are there, too (`from tsim import lammps`):
doc/python.md has the table.

The library is looked for in the file that TSIM_LIBRARY names, in this package (a wheel), in the build
tree around it, where `make install` puts it, and where the system looks for libraries.
"""
from __future__ import annotations

from typing import Any, List

from . import _tables
from ._lammps import *  # noqa: F401,F403 (the constants)
from ._lammps import make_class
from ._library import _lib
from ._manual import arguments, check, features, help, kinds, styles, version
from ._numbers import SHAPES, STAGES
from ._pictures import Picture
from ._results import (Argument, Box, Clock, Output, StaleView, Status, Stopped, TsimError)
from ._simulation import Simulation
from ._tables import Table

__all__ = ["Simulation", "TsimError", "Stopped", "StaleView", "Status", "Box", "Clock", "Output",
           "Argument", "Table", "Picture", "lammps", "liggghts", "version", "features", "check",
           "kinds", "styles", "help", "arguments", "read_table", "read_tables"]

lammps = liggghts = make_class(Simulation)

for _public in (Simulation, TsimError, Stopped, StaleView, Status, Box, Clock, Output, Argument, Table,
                Picture, lammps):
    _public.__module__ = __name__  # where they are imported from, in messages
del _public


def read_tables(path: Any) -> List[Table]:
    """The tables of a file of numbers: a log of tsim, LIGGGHTS or LAMMPS (one for each run), a file of
    fix ave/time, ave/chunk, ave/histo, ave/correlate or print (one for each block), comma-separated
    values. It may be compressed (.gz).
    """
    with Simulation() as sim:
        return _tables.read_tables(sim, path)


def read_table(path: Any) -> Table:
    """The same as one Table: the runs of a log joined, of several blocks the last one."""
    return _tables.joined(read_tables(path))
