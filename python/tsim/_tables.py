"""Tables: rows of the log, averages and other files of numbers, outputs of computes."""
from __future__ import annotations

import array
import ctypes
import html
import weakref
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Optional, Sequence, Tuple

from ._library import _bytes, _c_double_p, _lib, _RowFunction, _Sheet, _text
from ._numbers import numpy

if TYPE_CHECKING:
    from ._simulation import Simulation


def _column(values: Any) -> Any:
    if numpy is not None:
        return numpy.array(values, dtype=numpy.float64)
    return array.array("d", values)


class Table:
    """Named columns of numbers: table["Step"] is an array, list(table) the names, len(table) the number
    of rows, table.array all numbers as rows, table.frame() a DataFrame of pandas. Other spellings of a
    name are suggested. A missing number is NaN.
    """

    def __init__(self, title: str, columns: Dict[str, Any]) -> None:
        self.title = title
        self._columns = columns

    @property
    def names(self) -> List[str]:
        """Names of the columns."""
        return list(self._columns)

    def __getitem__(self, name: str) -> Any:
        if name in self._columns:
            return _column(self._columns[name])
        for known in self._columns:
            if known.lower() == str(name).lower():
                raise KeyError("%s; did you mean %r?" % (name, known))
        raise KeyError("%s; the columns are %s" % (name, ", ".join(self._columns)))

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __contains__(self, name: object) -> bool:
        return name in self._columns

    def keys(self) -> List[str]:
        """Names of the columns: dict(table) is a dictionary of arrays."""
        return self.names

    def __len__(self) -> int:
        return len(next(iter(self._columns.values()))) if self._columns else 0

    def row(self, k: int = -1) -> Dict[str, float]:
        """A row, by default the last one."""
        return {name: float(values[k]) for name, values in self._columns.items()}

    @property
    def array(self) -> Any:
        """All numbers: one row for each row of the table; without NumPy a list of lists."""
        if numpy is not None:
            if not self._columns:
                return numpy.empty((0, 0))
            return numpy.stack([_column(values) for values in self._columns.values()], axis=1)
        return [list(row) for row in zip(*self._columns.values())]

    def frame(self, index: Optional[str] = None) -> Any:
        """A DataFrame of pandas; index: the column that numbers its rows."""
        import pandas  # type: ignore[import]
        made = pandas.DataFrame({name: _column(values) for name, values in self._columns.items()})
        return made.set_index(index) if index is not None else made

    def __repr__(self) -> str:
        return "<tsim.Table%s: %d rows of %s>" % (
            " " + self.title if self.title else "", len(self), ", ".join(self._columns))

    def _repr_html_(self) -> str:
        most, n = 10, len(self)
        shown = list(range(n)) if n <= most else [*range(most // 2), *range(n - most // 2, n)]
        cells = ["<tr>%s</tr>" % "".join("<th>%s</th>" % html.escape(name) for name in self)]
        for at, k in enumerate(shown):
            if at and k > shown[at - 1] + 1:
                cells.append("<tr><td colspan=%d>... %d rows</td></tr>" % (len(self.names), n - most))
            cells.append("<tr>%s</tr>" % "".join("<td>%.6g</td>" % values[k]
                                                 for values in self._columns.values()))
        return "<table>%s</table>" % "".join(cells)


class Rows:
    """Keeps the rows of the log of a simulation."""

    def __init__(self, sim: Simulation) -> None:
        self.tables: List[Table] = []
        self._last_step = -1
        keeper, owner = weakref.ref(self), weakref.ref(sim)

        def told(_data: Any, row: Any) -> int:
            rows, simulation = keeper(), owner()
            try:
                if rows is not None:
                    rows._add(row.contents)
                return 0
            except BaseException as error:  # a C function cannot pass it on
                if simulation is not None:
                    simulation._failure = simulation._failure or error
                return 1
        self._call = _RowFunction(told)
        _lib.tsim_on_row(sim._pointer, self._call, None)

    @property
    def last(self) -> Table:
        return self.tables[-1] if self.tables else Table("", {})

    def _add(self, row: Any) -> None:
        names, values, step = _unique(row.names[:row.columns]), row.values[:row.columns], row.step
        if not self.tables or self.last.names != names or step < self._last_step:
            self.tables.append(Table("log", {name: array.array("d") for name in names}))
        elif step == self._last_step:
            return  # the first row of a run is the last one of the run before
        self._last_step = step
        for column, value in zip(self.last._columns.values(), values):
            column.append(value)


def _unique(raw: Sequence[bytes]) -> List[str]:
    """Names; one that another column has already becomes NAME(2)."""
    names: List[str] = []
    for text in map(_text, raw):
        name, k = text, 2
        while name in names:
            name, k = "%s(%d)" % (text, k), k + 1
        names.append(name)
    return names


def read_tables(sim: Simulation, path: Any) -> List[Table]:
    """The tables of a file."""
    number, found = ctypes.c_size_t(), []
    sim._check(_lib.tsim_tables(sim._pointer, _bytes(path), ctypes.byref(number)))
    for k in range(number.value):
        sheet: Any = _Sheet()
        sim._check(_lib.tsim_table(sim._pointer, k, ctypes.byref(sheet)))
        columns = {}
        for c in range(sheet.columns):
            name, values = ctypes.c_char_p(), _c_double_p()
            sim._check(_lib.tsim_table_column(sim._pointer, k, c, ctypes.byref(name),
                                              ctypes.byref(values)))
            columns[_text(name.value)] = _column(values[:sheet.rows])
        found.append(Table(_text(sheet.title), columns))
    return found


def joined(tables: List[Table]) -> Table:
    """The runs of a log with the columns of the last one, as one table; of blocks the last one."""
    last = tables[-1]
    if not all(table.title.startswith("run ") for table in tables):
        return last
    alike = [table for table in tables if table.names == last.names and len(table)]
    columns: Dict[str, Any] = {name: array.array("d") for name in last}
    first = last.names[0] if last.names else ""
    for table in alike:
        # the first row of a run repeats the last one of the run before
        skip = int(len(columns[first]) > 0 and table[first][0] == columns[first][-1])
        for name in last:
            columns[name].extend(table[name][skip:])
    return Table("", columns)


# Which output a table has, if no shape is named.
_ORDER = ("local", "array", "per_particle", "vector", "scalar")


def table_of(sim: Simulation, names: Tuple[str, ...], shape: Optional[str]) -> Table:
    """A table of an output or of quantities of the particles."""
    if not names:
        raise ValueError("expected c_ID, f_ID or names of quantities of the particles")
    if len(names) > 1 or not names[0].startswith(("c_", "f_")):
        return Table("particles", {name: values for key in names
                                   for name, values in _quantity(sim, key)})
    name = names[0]
    there = {output.shape: output for output in reversed(sim.outputs(name))}
    order = _ORDER if shape is None else (shape,)
    output = next((there[key] for key in order if key in there), None)
    if output is None:
        raise ValueError("%s has no output of the shape %r; there are %s" % (
            name, shape, ", ".join(there)))
    values = sim.evaluate(name, output.shape)
    if output.shape == "scalar":
        return Table(name, {output.name: [values]})
    rows = values if _is_wide(values) else [[value] for value in values]
    width = len(rows[0]) if len(rows) else len(output.columns or [output.name])
    titles = output.columns if output.columns and len(output.columns) == width else \
        [output.name] if width == 1 else [str(k + 1) for k in range(width)]
    if output.shape == "vector" and output.columns and len(output.columns) == len(rows):
        return Table(name, {title: [row[0]] for title, row in zip(output.columns, rows)})
    return Table(name, {title: [row[k] for row in rows] for k, title in enumerate(titles)})


def _is_wide(values: Any) -> bool:
    return len(values) > 0 and hasattr(values[0], "__len__")


def _quantity(sim: Simulation, key: str) -> Iterator[Tuple[str, Any]]:
    """A quantity by identity; c_ID and f_ID columns go with them."""
    from ._simulation import VECTORS
    if key.startswith(("c_", "f_", "v_")):
        order = sorted(range(len(sim)), key=sim.read("id").__getitem__)
        values = sim.evaluate(key, "per_particle")
        yield key, [values[k] for k in order]
    elif key in VECTORS:
        for part in VECTORS[key]:
            yield part, sim._gather(part, None)
    else:
        yield key, sim._gather(key, None)
