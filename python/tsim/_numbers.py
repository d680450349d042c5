"""Numbers in and out, with NumPy or without."""
from __future__ import annotations

import array
import ctypes
from typing import Any, Dict, Iterable, Iterator, Optional, Tuple

from ._library import _c_double_p, _c_int32_p
from ._results import StaleView

numpy: Any = None
try:
    import numpy as _numpy
    numpy = _numpy
except ImportError:
    pass

SHAPES = {"scalar": 1, "vector": 2, "per_particle": 3, "local": 4, "array": 5}
STAGES = {"before_force": 0, "after_force": 1, "end_of_step": 2}
_TYPES = {1: (ctypes.c_double, "d"), 3: (ctypes.c_int32, "i"), 4: (ctypes.c_uint32, "I")}


def _choose(choices: Dict[str, int], word: str, what: str) -> int:
    if word not in choices:
        raise ValueError("%s is one of %s, not %r" % (what, ", ".join(choices), word))
    return choices[word]


def _doubles(values: Any, n: Optional[int] = None, what: str = "values") -> Tuple[Any, Any]:
    """A C array of doubles, copied only if need be; a single number is repeated n times."""
    if numpy is not None:
        made = numpy.asarray(values, dtype=numpy.float64)
        if made.ndim == 0 and n is not None:
            made = numpy.full(n, made)
        made = numpy.ascontiguousarray(made).reshape(-1)
        pointer = made.ctypes.data_as(_c_double_p)
    else:
        if isinstance(values, (int, float)) and n is not None:
            values = [values] * n
        made = array.array("d", _flat(values))
        pointer = ctypes.cast(made.buffer_info()[0], _c_double_p)
    if n is not None and len(made) != n:
        raise ValueError("%d %s given, expected %d" % (len(made), what, n))
    return made, pointer


def _check_range(least: Any, most: Any, what: str) -> None:
    """A C int32 would wrap round without a word."""
    for value in (least, most):
        if not -2**31 <= value < 2**31:
            raise ValueError("%s have to be from -2147483648 to 2147483647, not %d" % (what, value))


def _integers(values: Any, n: Optional[int] = None, what: str = "values") -> Tuple[Any, Any]:
    if numpy is not None:
        made = numpy.asarray(values)
        if made.ndim == 0 and n is not None:
            made = numpy.full(n, made)
        if made.size and not numpy.array_equal(made, numpy.trunc(made)):
            raise ValueError("%s have to be whole numbers" % what)
        if made.size:
            _check_range(made.min(), made.max(), what)
        made = numpy.ascontiguousarray(made, dtype=numpy.int32).reshape(-1)
        pointer = made.ctypes.data_as(_c_int32_p)
    else:
        if isinstance(values, int) and n is not None:
            values = [values] * n
        values = list(values)
        if values:
            _check_range(min(values), max(values), what)
        made = array.array("i", values)
        pointer = ctypes.cast(made.buffer_info()[0], _c_int32_p)
    if n is not None and len(made) != n:
        raise ValueError("%d %s given, expected %d" % (len(made), what, n))
    return made, pointer


def _flat(values: Iterable[Any]) -> Iterator[Any]:
    for value in values:
        if hasattr(value, "__iter__"):
            yield from _flat(value)
        else:
            yield value


def _new_doubles(n: int) -> Tuple[Any, Any]:
    if numpy is not None:
        return _doubles(numpy.empty(n))
    return _doubles(array.array("d", bytes(8 * n)))


if numpy is not None:
    class View(numpy.ndarray):
        """A column of particles on the memory of the simulation. Reading and writing it after
        particles were added, deleted or reordered (which stepping may do) raises StaleView; copies
        and results of calculations are plain arrays. What escapes the guard (numpy.asarray) reads
        old values then, never freed memory.
        """

        _sim: Any = None
        _generation = 0

        def __array_finalize__(self, origin: Any) -> None:
            if isinstance(origin, View) and numpy.may_share_memory(self, origin):
                self._sim, self._generation = origin._sim, origin._generation

        def _check(self) -> None:
            if self._sim is not None and (
                    self._sim.closed or self._sim.generation != self._generation):
                raise StaleView("particles were added, deleted or reordered since this view was "
                                "taken: take it anew from the simulation, or keep a copy")

        def __getitem__(self, key: Any) -> Any:
            self._check()
            return super().__getitem__(key)

        def __setitem__(self, key: Any, value: Any) -> None:
            self._check()
            super().__setitem__(key, value)

        def __iter__(self) -> Any:
            self._check()
            return iter(self.view(numpy.ndarray))

        def __repr__(self) -> str:
            self._check()
            return repr(self.view(numpy.ndarray)).replace("array(", "View(", 1)

        __str__ = __repr__

        def copy(self, order: Any = "C") -> Any:
            self._check()
            return numpy.array(self.view(numpy.ndarray), order=order)

        def __array_ufunc__(self, ufunc: Any, method: Any, *inputs: Any, out: Any = None,
                            **rest: Any) -> Any:
            plain = [_plain(value) for value in inputs]
            if out is not None:
                rest["out"] = tuple(_plain(value) for value in out)
            result = getattr(ufunc, method)(*plain, **rest)
            return result if out is None else out[0] if len(out) == 1 else out

        def __array_function__(self, function: Any, types: Any, args: Any, kwargs: Any) -> Any:
            return function(*_plain(args), **_plain(kwargs))


def _plain(value: Any) -> Any:
    """Views inside, checked, as the arrays they are."""
    if isinstance(value, (list, tuple)):
        return type(value)(_plain(item) for item in value)
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, View):
        value._check()
        return value.view(numpy.ndarray)
    return value
