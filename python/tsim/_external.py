"""Forces that a function or an array of the program gives, by the names of LAMMPS.

A `fix external` of the script counts calls and additions, keeps what it was given in restart files, and has outputs.
Without one in the script, a function set under any name is called in each step.
"""
from __future__ import annotations

import ctypes
from typing import Any, Callable, Dict, Optional, Sequence

from ._library import _bytes, _lib
from ._numbers import _doubles, numpy


def _zeros(n: int) -> Any:
    return [[0.0] * 3 for _ in range(n)] if numpy is None else numpy.zeros((n, 3))


def _add(force: Any, f: Any) -> None:
    if numpy is not None:
        force += f
        return
    for k, row in enumerate(f):
        for axis in range(3):
            force[k, axis] += row[axis]


class _Field:
    """The array of fix_external_get_force: its rows are those of the particles when it was taken."""

    def __init__(self, sim: Any, force: Any) -> None:
        self.force, self.tag, self.generation = force, [int(k) for k in sim.tag], sim.generation

    def ordered(self, sim: Any) -> Any:
        """The rows in the present order of memory; new particles have none."""
        if sim.generation == self.generation:
            return self.force
        row = dict(zip(self.tag, self.force))
        return [row.get(int(tag), (0.0, 0.0, 0.0)) for tag in sim.tag]


class ExternalNames:
    """set_fix_external_callback, fix_external_get_force and fix_external_set_..."""

    live: Any
    on_step: Any
    off_step: Any
    evaluate: Any
    _check: Any
    _pointer: Any
    _externals: Optional[Dict[str, Any]] = None
    _fields: Optional[Dict[str, _Field]] = None

    def _is_external(self, fix_id: str) -> bool:
        return (fix_id, "external") in [tuple(pair) for pair in self.live("fix")]

    def _give(self, fix_id: str, what: str, values: Any) -> None:
        flat, pointer = _doubles(values)
        self._check(_lib.tsim_external(self._pointer, _bytes(fix_id), _bytes(what), pointer, len(flat)))

    def _is_due(self, fix_id: str) -> bool:
        due = (ctypes.c_double * 1)()
        self._check(_lib.tsim_external(self._pointer, _bytes(fix_id), b"due", due, 1))
        return due[0] != 0.0

    def set_fix_external_callback(self, fix_id: str, callback: Optional[Callable[..., Any]],
                                  caller: Any = None) -> None:
        """Calls callback(caller, ntimestep, nlocal, tag, x, f): what it writes to f, which is zero before, is added
        to the forces, as the `fix external` of this name says; if there is none, in each step. Another function of
        that name is replaced; None removes it.
        """
        self._externals = self._externals if self._externals is not None else {}
        old = self._externals.pop(fix_id, None)
        if old is not None:
            self.off_step(*old)
        if callback is None:
            return
        function, fixed = callback, self._is_external(fix_id)

        def call(sim: Any) -> None:
            if fixed and not sim._is_due(fix_id):
                return
            f = _zeros(len(sim))
            function(caller, sim.clock.step, len(sim), sim.tag, sim.x, f)
            if fixed:
                sim._give(fix_id, "force", f)
            else:
                _add(sim.f, f)
        stage = "before_force" if fixed else "after_force"
        self._externals[fix_id] = (stage, call)
        self.on_step(stage, call)

    def fix_external_get_force(self, fix_id: str) -> Any:
        """The forces of a `fix external ... pf/array`, three for each particle in the order of memory, to be written
        to. Take it anew when particles were added, deleted or reordered.
        """
        self._fields = self._fields if self._fields is not None else {}
        now = self.evaluate("f_" + fix_id, "per_particle")
        if not self._is_external(fix_id):
            raise ValueError("%s is no fix external" % fix_id)
        force = [list(row)[:3] for row in now]
        force = force if numpy is None else numpy.array(force, dtype=float).reshape(-1, 3)
        old = self._fields.get(fix_id)
        self._fields[fix_id] = _Field(self, force)
        if old is None:
            self.on_step("before_force", lambda sim: sim._send_field(fix_id))
        return force

    def _send_field(self, fix_id: str) -> None:
        field = (self._fields or {}).get(fix_id)
        if field is not None and self._is_external(fix_id):
            self._give(fix_id, "force", field.ordered(self))

    def fix_external_set_energy_global(self, fix_id: str, eng: float) -> None:
        """The energy of all particles: f_ID, and part of pe after `fix_modify ID energy yes`."""
        self._give(fix_id, "energy", [eng])

    def fix_external_set_energy_peratom(self, fix_id: str, eatom: Sequence[float]) -> None:
        """The energy of each particle in the order of memory: f_ID[4] of particles."""
        self._give(fix_id, "energies", eatom)

    def fix_external_set_vector_length(self, fix_id: str, length: int) -> None:
        """The number of elements of the vector f_ID[k], which become 0."""
        self._give(fix_id, "vector", [0.0] * length)

    def fix_external_set_vector(self, fix_id: str, idx: int, val: float) -> None:
        """Element idx, from 1, of the vector f_ID[k]."""
        vector = [float(k) for k in self.evaluate("f_" + fix_id, "vector")]
        if not 1 <= idx <= len(vector):
            raise ValueError("element %d of the vector of fix %s, which has %d" % (idx, fix_id, len(vector)))
        vector[idx - 1] = float(val)
        self._give(fix_id, "vector", vector)

    def fix_external_set_virial_global(self, fix_id: str, virial: Sequence[float]) -> None:
        """Refused: pressures are of contacts, bonds and motion."""
        raise NotImplementedError("pressures are of contacts, bonds and motion: a fix external has no part in them")

    def fix_external_set_virial_peratom(self, fix_id: str, vatom: Any) -> None:
        """Refused, as fix_external_set_virial_global."""
        self.fix_external_set_virial_global(fix_id, vatom)
