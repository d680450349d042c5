"""Neighbour lists by the names of LAMMPS: the pairs of the contact list, of which there is one, number 0.

Each pair is there once, in the row of one of its particles: what LAMMPS calls a half list. Particles are indices
in the order of memory; of a pair across a periodic face the particle itself is named, not a ghost.
"""
from __future__ import annotations

import ctypes
import re
from typing import Any, Iterator, List

from ._library import _lib
from ._numbers import numpy

# Styles that read the contact list, besides the pair styles.
_READERS = {
    "fix": ("heat/gran",),
    "compute": ("contact/atom", "contacts", "fabric", "group/group", "neighbor/atom", "pair/gran/local",
                "pair/gran/local/bond", "pair/local", "pressure", "property/local", "stress/atom",
                "stress/region"),
}


def _partners(sim: Any) -> List[List[int]]:
    """By particle, the partners of the pairs of its row."""
    n, room = ctypes.c_size_t(), 0
    sim._check(_lib.tsim_pairs(sim._pointer, None, 0, ctypes.byref(n)))
    room = n.value
    pair = (ctypes.c_int32 * max(2 * room, 1))()
    sim._check(_lib.tsim_pairs(sim._pointer, pair, room, ctypes.byref(n)))
    rows: List[List[int]] = [[] for _ in range(len(sim))]
    for i, j in zip(pair[0:2 * room:2], pair[1:2 * room:2]):
        rows[i].append(j)
    return rows


class NeighList:
    """The contact list as it is now: a copy. Has a row for each particle, also for those without neighbours."""

    def __init__(self, sim: Any, idx: int, arrays: bool = False) -> None:
        if idx != 0:
            raise ValueError("there is no neighbour list %r: there is one, number 0" % (idx,))
        self._rows = _partners(sim)
        self._arrays = arrays

    @property
    def size(self) -> int:
        """Number of rows, that is of particles."""
        return len(self._rows)

    def __len__(self) -> int:
        return self.size

    def __str__(self) -> str:
        return "Neighbour list (%d particles, %d pairs)" % (self.size, sum(map(len, self._rows)))

    def __iter__(self) -> Iterator[Any]:
        for k in range(self.size):
            yield self.get(k)

    def __getitem__(self, element: int) -> Any:
        return self.get(element)

    def get(self, element: int) -> Any:
        """(particle, number of neighbours, their indices) of a row; of `numpy` (particle, array)."""
        if not 0 <= element < self.size:
            raise IndexError("there is no row %r, there are 0 to %d" % (element, self.size - 1))
        row = self._rows[element]
        if self._arrays and numpy is not None:
            return element, numpy.array(row, dtype=numpy.int32)
        return element, len(row), list(row)

    def find(self, iatom: int) -> Any:
        """(number of neighbours, their indices) of the row of a particle, (-1, None): there is none; of
        `numpy` the array, or None.
        """
        if not 0 <= iatom < self.size:
            return None if self._arrays and numpy is not None else (-1, None)
        found = self.get(iatom)
        return found[1] if self._arrays and numpy is not None else found[1:]


class NeighbourNames:
    """get_neighlist and its relatives, a part of LammpsNames."""

    live: Any

    def find_pair_neighlist(self, style: str, exact: bool = True, nsub: int = 0, reqid: int = 0) -> int:
        """0, the number of the contact list, if there is a pair style of this name, or with `exact` False one in
        which the regular expression is found; nsub n: the n-th one; -1: there is none.
        """
        found = [name for _, name in self.live("pair")
                 if (name == style if exact else re.search(style, name))]
        return 0 if found and 0 <= nsub <= len(found) and reqid == 0 else -1

    def find_fix_neighlist(self, fixid: str, reqid: int = 0) -> int:
        """0 if the fix reads the contact list, else -1."""
        return self._reader("fix", fixid, reqid)

    def find_compute_neighlist(self, computeid: str, reqid: int = 0) -> int:
        """0 if the compute reads the contact list, else -1."""
        return self._reader("compute", computeid, reqid)

    def _reader(self, kind: str, id: str, reqid: int) -> int:
        style = dict(self.live(kind)).get(id)
        return 0 if style in _READERS[kind] and reqid == 0 else -1

    def get_neighlist(self, idx: int) -> NeighList:
        """A copy of the contact list as it is now: to go through many rows."""
        return NeighList(self, idx)

    def get_neighlist_size(self, idx: int) -> int:
        """Number of rows; -1: there is no such list."""
        return NeighList(self, idx).size if idx == 0 else -1

    def get_neighlist_element_neighbors(self, idx: int, element: int) -> Any:
        """(particle, number of neighbours, their indices) of one row; each call reads the whole list: use
        get_neighlist for many.
        """
        return NeighList(self, idx).get(element)
