"""What functions return and raise."""
from __future__ import annotations

import enum
from typing import Any, List, NamedTuple, Optional, Tuple

from ._library import _ErrorPlace, _text


class Box(NamedTuple):
    """Corners, whether each direction is periodic, letters of the faces, 2 or 3."""
    lo: Tuple[float, ...]
    hi: Tuple[float, ...]
    periodic: Tuple[bool, ...]
    faces: Tuple[str, ...]
    dimension: int


class Clock(NamedTuple):
    """Step counter, time, time step."""
    step: int
    time: float
    dt: float


class Output(NamedTuple):
    """An output of a compute or fix: shape as in Simulation.evaluate, names of columns."""
    name: str
    unit: str
    help: str
    shape: str
    columns: Optional[List[str]]


class Argument(NamedTuple):
    """An argument of a style: what a front end needs to ask for it."""
    name: str
    type: str
    help: str
    unit: str
    default: Optional[str]
    mode: Optional[str]
    positional: bool
    optional: bool
    least: float
    most: float
    choices: Optional[List[str]]


class Status(enum.IntEnum):
    """Kinds of errors: TsimError.code."""
    SYNTAX = 1
    UNKNOWN = 2
    RANGE = 3
    STATE = 4
    IO = 5
    DAMAGED = 6
    NOMEM = 7
    PHYSICS = 8
    STOPPED = 9


class TsimError(Exception):
    """What was wrong, and where in which script. str() gives it as the command line prints it, with
    the script line and a mark below the culprit.

    code: a Status; message: without the place; file, line, column, length, text: the place and the
    script line, empty or 0 where no place is known (columns are counted from 1).
    """

    def __init__(self, report: str, where: _ErrorPlace) -> None:
        super().__init__(report.rstrip("\n"))
        self.code = Status(where.status)
        self.message, self.file = _text(where.message), _text(where.file)
        self.text = _text(where.text)
        self.line, self.column, self.length = where.line, where.column, where.length


class Stopped(TsimError):
    """Simulation.stop was called; all results up to here are written."""


class StaleView(RuntimeError):
    """The array showed particles that have since been added, deleted or reordered."""
