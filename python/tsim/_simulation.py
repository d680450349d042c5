"""A simulation: scripts, steps, numbers, particles."""
from __future__ import annotations

import array
import contextlib
import ctypes
import os
import sys
import weakref
from typing import Any, Callable, Dict, Iterable, Iterator, List, Optional, Tuple, TypeVar, Union

from ._lammps import LammpsNames
from ._library import (_Box, _bytes, _ErrorPlace, _lib, _LogFunction, _names, _Options, _Output, _Particles,
                       _StepFunction, _Table, _text, _View)
from ._numbers import (SHAPES, STAGES, _TYPES, _choose, _doubles, _integers, _new_doubles, numpy)
from ._pictures import Picture, Progress, draw, in_notebook, summary
from ._results import Box, Clock, Output, Status, Stopped, TsimError
from ._tables import Rows, Table, read_tables, table_of
from ._variables import Variables

if numpy is not None:
    from ._numbers import View

Path = Union[str, "os.PathLike[str]"]
LogCall = Callable[[str, str], Any]
StepCall = Callable[[Any], Any]
Own = TypeVar("Own", bound="Simulation")

# Quantities of three numbers, by the names of the columns, and the script's names of the three.
VECTORS = {"x": ("x", "y", "z"), "v": ("vx", "vy", "vz"), "f": ("fx", "fy", "fz"),
           "omega": ("omegax", "omegay", "omegaz"), "torque": ("tqx", "tqy", "tqz"),
           "image": ("ix", "iy", "iz")}


class _Owner:
    """The C simulation. It ends when it was closed and nobody holds its memory any more."""

    def __init__(self, pointer: Any) -> None:
        self.pointer, self.held, self.closed = pointer, 0, False

    def hold(self, keeper: Any, data: int) -> None:
        if _lib.tsim_hold(self.pointer, data):
            raise MemoryError
        self.held += 1
        weakref.finalize(keeper, self.release, data)

    def release(self, data: int) -> None:
        _lib.tsim_release(self.pointer, data)
        self.held -= 1
        self._end()

    def close(self) -> None:
        if self.closed:
            return
        self.closed = True
        if self.held:  # files are closed and all memory but the views' freed
            _lib.tsim_text(self.pointer, b"clear", b"close")
            _lib.tsim_log(self.pointer, None)
        self._end()

    def _end(self) -> None:
        if self.closed and not self.held and self.pointer:
            _lib.tsim_close(self.pointer)
            self.pointer = None


def _print(level: str, text: str) -> None:
    if level == "text":
        sys.stdout.write(text)
    elif level == "warning":
        sys.stdout.write(text + "\n" if "warning: " in text else "warning: " + text + "\n")


def _column(name: str, what: str) -> Any:
    def get(self: Simulation) -> Any:
        return self.view(name)

    def put(self: Simulation, value: Any) -> None:
        target = self.view(name)
        if value is not target:
            target[...] = value
    return property(get, put, doc=what + ": Simulation.view(%r)" % name)


class Simulation(LammpsNames):
    """A simulation; several can live at once, each used by one thread at a time.

    threads: 0 as OMP_NUM_THREADS says; log: path of a log file; screen: True prints what the
    command line shows; on_log: a function f(level, text) with level "text", "warning" or "progress"
    that is told instead; explain: run nothing, tell the plan of each run; comm: a communicator of
    mpi4py, which was imported before tsim: its processes compute the simulation together, and all call
    the same methods.

    As a context manager it is closed at the end. Its columns of particles: x, v, f, omega, torque,
    image, radius, mass, tag, type, mask (see view); its variables: sim.variables["name"]; the rows of
    its log: sim.thermo; what it looks like: sim.picture(), which a notebook shows.

    The names of the Python modules of LAMMPS and LIGGGHTS (command, extract_atom, gather_atoms ...) are
    there, too: doc/python.md has a table.
    """

    _owner: Any = None

    x = _column("x", "positions")
    v = _column("v", "velocities")
    f = _column("f", "forces")
    omega = _column("omega", "angular velocities")
    torque = _column("torque", "torques")
    image = _column("image", "how often periodic faces were crossed")
    tag = _column("tag", "identities")
    type = _column("type", "types")
    mask = _column("mask", "bits of the groups")
    radius = _column("radius", "radii")
    mass = _column("mass", "masses")

    def __init__(self, threads: int = 0, log: Optional[Path] = None, screen: bool = False,
                 on_log: Optional[LogCall] = None, explain: bool = False, comm: Any = None,
                 _check: bool = False) -> None:
        self._comm = comm
        self._failure: Optional[BaseException] = None   # what Python raised inside a C call
        self._calls: Dict[Any, List[Any]] = {}
        self._bar: Optional[Progress] = None
        if on_log is None and screen:
            on_log = _print
        self._on_log: Any = _LogFunction()  # type: ignore[call-overload]
        if on_log or in_notebook():
            self._on_log = _LogFunction(self._logger(on_log))
        options = _Options(threads=threads, explain=bool(explain), check=_check, on_log=self._on_log,
                           log=_bytes(log) if log is not None and comm is None else None)
        pointer = ctypes.c_void_p()
        status = _lib.tsim_open_with(ctypes.byref(options), ctypes.byref(pointer))
        if not pointer:
            raise MemoryError("no memory for a simulation")
        self._owner = _Owner(pointer)
        self.variables = Variables(self)
        self._rows = Rows(self)
        try:
            self._check(status)
            if comm is not None:
                self._join(comm)
                self._check(_lib.tsim_log(pointer, _bytes(log) if log is not None else None))
        except (TsimError, ValueError):
            self.close()
            raise

    def _join(self, comm: Any) -> None:
        if not hasattr(_lib, "tsim_mpi_join"):
            raise ValueError("comm: libtsim_mpi is not there, or mpi4py.MPI was not imported before tsim")
        from mpi4py import MPI
        self._check(_lib.tsim_mpi_join(self._owner.pointer, MPI._addressof(comm)))

    # -- life and errors

    def close(self) -> None:
        """Ends the simulation and closes its files. Views of its columns become stale."""
        if self._owner:
            self._owner.close()

    def __enter__(self: Own) -> Own:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    def __del__(self) -> None:
        self.close()

    @property
    def closed(self) -> bool:
        return bool(self._owner.closed)

    @property
    def _pointer(self) -> Any:
        if self._owner.closed:
            raise ValueError("the simulation is closed")
        return self._owner.pointer

    def _check(self, status: int) -> None:
        """Raises what a function of the user raised, else the error of the simulation."""
        failure, self._failure = self._failure, None
        if not status and failure is None:
            return
        pointer = self._owner.pointer
        where: Any = _ErrorPlace()
        _lib.tsim_error_where(pointer, ctypes.byref(where))
        report = _text(_lib.tsim_error(pointer))
        error: Optional[TsimError] = None
        if where.status:
            error = (Stopped if where.status == Status.STOPPED else TsimError)(report, where)
        _lib.tsim_error_clear(pointer)
        if failure is not None:
            raise failure
        if error is not None:
            raise error

    def _logger(self, on_log: Optional[LogCall]) -> Any:
        levels = ("text", "warning", "progress")
        owner = weakref.ref(self)

        def tell(_: Any, level: int, raw: bytes) -> None:
            sim = owner()
            try:
                if on_log:
                    on_log(levels[level], _text(raw))
                if sim is not None and sim._bar and levels[level] == "progress":
                    sim._bar.line(_text(raw))
            except BaseException as error:  # a C function cannot pass it on
                if sim is not None:
                    sim._failure = sim._failure or error
        return tell

    # -- scripts

    def commands(self, text: str, name: str = "python") -> None:
        """Runs script lines; `name` stands for the file name in messages."""
        with self._progress():
            self._check(_lib.tsim_text(self._pointer, _bytes(text), _bytes(name)))

    def file(self, path: Path) -> None:
        """Runs a script file."""
        with self._progress():
            self._check(_lib.tsim_file(self._pointer, _bytes(path)))

    def run(self, n: int, words: str = "") -> None:
        """The command `run n`, with the log it prints; `words` follow it."""
        self.commands("run %d %s" % (int(n), words), "run")

    @contextlib.contextmanager
    def _progress(self) -> Iterator[None]:
        """In a notebook runs of more than a second show a bar."""
        if self._bar or not in_notebook():
            yield
            return
        self._bar = Progress()
        try:
            yield
        finally:
            bar, self._bar = self._bar, None
            bar.close()

    @property
    def quit_status(self) -> Optional[int]:
        """The status the script said `quit` with; None: it did not."""
        status = ctypes.c_int()
        said = _lib.tsim_has_quit(self._pointer, ctypes.byref(status))
        return status.value if said else None

    def step(self, n: int = 1, progress: Optional[bool] = None) -> None:
        """Steps n times. Successive calls are one run, bit for bit that of `run` with their sum;
        after a change from outside forces are computed anew. Ctrl-C is heeded every 1000 steps.
        progress: a bar; None: in a notebook, where the steps take more than a second.
        """
        if n != int(n):
            raise ValueError("%r is not a number of steps" % (n,))
        n = whole = int(n)
        bar = Progress() if progress or (progress is None and in_notebook()) else None
        try:
            while True:
                piece = min(n, 1000)
                before = self.clock.step
                self._check(_lib.tsim_step(self._pointer, piece))
                n -= piece
                if n <= 0 or self.clock.step < before + piece:  # fix halt
                    return
                if bar:
                    bar.show((whole - n) / whole, "step %d" % self.clock.step)
        finally:
            if bar:
                bar.close()

    def stop(self) -> None:
        """Lets a run stop after its present step, which raises Stopped there. From a function of
        on_step or from another thread.
        """
        _lib.tsim_stop(self._pointer)

    def on_step(self, stage: str, function: Optional[StepCall] = None) -> Any:
        """Lets function(sim) take part in every step: stage "before_force", "after_force" (where
        sim.f can be added to) or "end_of_step" (where sim.x, sim.v can be changed). Also as a
        decorator: @sim.on_step("after_force"). An exception ends the run and is raised there.
        """
        number = _choose(STAGES, stage, "a stage")
        if function is None:
            return lambda decorated: self.on_step(stage, decorated)
        owner = weakref.ref(self)

        def call(_pointer: Any, _data: Any) -> int:
            sim = owner()
            try:
                function(sim)  # type: ignore[misc]
                return 0
            except BaseException as error:
                if sim is not None:
                    sim._failure = sim._failure or error
                return 1
        wrapped = _StepFunction(call)
        self._check(_lib.tsim_on_step(self._pointer, number, wrapped, None))
        self._calls.setdefault((stage, function), []).append(wrapped)
        return function

    def off_step(self, stage: str, function: StepCall) -> None:
        """Undoes on_step."""
        wrapped = self._calls.get((stage, function))
        if not wrapped:
            raise ValueError("this function does not take part in stage %r" % (stage,))
        self._check(_lib.tsim_off_step(self._pointer, STAGES[stage], wrapped[-1], None))
        wrapped.pop()

    # -- numbers

    def value(self, formula: str) -> float:
        """The number a formula stands for: "ke", "c_ID[2]", "v_name", "count(rock)/2" ..."""
        out = ctypes.c_double()
        self._check(_lib.tsim_value(self._pointer, _bytes(formula), ctypes.byref(out)))
        return out.value

    def evaluate(self, name: str, shape: str) -> Any:
        """A whole output as a new array: name "c_ID", "f_ID", "c_ID[k]", "v_NAME" or a quantity of
        particles; shape "scalar", "vector", "per_particle" (in the order of particles in memory),
        "local" or "array". Of one column: one-dimensional; without NumPy a list of rows.
        """
        table: Any = _Table()
        number = _choose(SHAPES, shape, "a shape")
        self._check(_lib.tsim_evaluate(self._pointer, _bytes(name), number, ctypes.byref(table)))
        rows, columns = table.rows, table.columns
        if numpy is not None:
            made = numpy.empty((rows, columns))
            if made.size:
                ctypes.memmove(made.ctypes.data, table.data, made.nbytes)
            if shape == "scalar":
                return made[0, 0]
            return made[:, 0] if columns == 1 else made
        if shape == "scalar":
            return table.data[0]
        flat = array.array("d", table.data[:rows * columns])
        if columns == 1:
            return flat
        return [flat[k * columns:(k + 1) * columns] for k in range(rows)]

    def outputs(self, name: str) -> List[Output]:
        """What "c_ID" or "f_ID" gives: a list of Output."""
        found: List[Output] = []
        raw: Any = _Output()
        shapes = {number: shape for shape, number in SHAPES.items()}
        while True:
            status = _lib.tsim_output(self._pointer, _bytes(name), len(found), ctypes.byref(raw))
            if status and found:
                _lib.tsim_error_clear(self._pointer)
                return found
            self._check(status)
            names = [_text(raw.column_names[k]) for k in range(raw.columns)] \
                if raw.column_names else None
            found.append(Output(_text(raw.name), _text(raw.unit), _text(raw.help),
                                shapes[raw.shape], names))

    def compute(self, id: str, shape: Optional[str] = None) -> Any:
        """The output of a compute, of its first shape or the one named."""
        return self._of_style("c_" + id, shape)

    def fix(self, id: str, shape: Optional[str] = None) -> Any:
        """The output of a fix, of its first shape or the one named."""
        return self._of_style("f_" + id, shape)

    def _of_style(self, name: str, shape: Optional[str]) -> Any:
        return self.evaluate(name, shape or self.outputs(name)[0].shape)

    def setting(self, name: str) -> float:
        """A number of the simulation itself: "nlocal", "ntypes", "nghost", "threads" ..."""
        out = ctypes.c_double()
        self._check(_lib.tsim_setting(self._pointer, _bytes(name), ctypes.byref(out)))
        return out.value

    # -- particles

    def __len__(self) -> int:
        return int(_lib.tsim_count(self._pointer))

    def __bool__(self) -> bool:
        return True

    @property
    def generation(self) -> int:
        """Grows when views become stale."""
        return int(_lib.tsim_generation(self._pointer))

    def view(self, name: str) -> Any:
        """A stored column on the memory of the simulation: an array of one row per particle, or of
        one number. x, v, omega can be written between runs and at "end_of_step", f and torque
        inside a step; others are read-only. A stale one raises StaleView when it is used (without
        NumPy, as a memoryview, it shows old values).
        """
        view: Any = _View()
        self._check(_lib.tsim_column_view(self._pointer, _bytes(name), ctypes.byref(view)))
        ctype, letter = _TYPES[view.type]
        size = view.count * view.width
        buffer = (ctype * size)()
        if view.data and size:
            buffer = (ctype * size).from_address(view.data)
            self._owner.hold(buffer, view.data)
        shape = (view.count, view.width) if view.width > 1 else (view.count,)
        if numpy is None:
            flat = memoryview(buffer).cast("B")
            flat = flat.cast(letter, shape) if size else flat.cast(letter)
            return flat if view.writable else flat.toreadonly()
        made = numpy.frombuffer(buffer, dtype=ctype).reshape(shape).view(View)
        made._sim, made._generation = self, view.generation
        made.flags.writeable = bool(view.writable)
        return made

    def read(self, name: str) -> Any:
        """A quantity by its name, as a new array with one number per particle: "vz", "diameter",
        "density" ... in the order of particles in memory; of "x", "v", "f", "omega", "torque" and
        "image" three per particle (the coordinate x alone is sim.x[:, 0]).
        """
        return self._parts(name, None, self._read)

    def _read(self, name: str, _: Any) -> Any:
        made, pointer = _new_doubles(len(self))
        self._check(_lib.tsim_column_read(self._pointer, _bytes(name), pointer, len(made)))
        return made

    def write(self, name: str, values: Any) -> None:
        """Writes a quantity: one number per particle, or one for all; of "x", "v" ... three. A radius
        keeps the density, a density and a mass the radius.
        """
        self._set_parts(name, values, None, self._write)

    def _write(self, name: str, values: Any, _: Any) -> None:
        made, pointer = _doubles(values, len(self), "numbers")
        self._check(_lib.tsim_column_write(self._pointer, _bytes(name), pointer, len(made)))

    def gather(self, name: str, ids: Any = None) -> Any:
        """A quantity, as `read` gives it, of the particles with these identities; None: of all, by
        identity.
        """
        return self._parts(name, ids, self._gather)

    def _gather(self, name: str, ids: Any) -> Any:
        ids, id_pointer = _integers(ids, what="identities") if ids is not None else (None, None)
        made, pointer = _new_doubles(len(ids) if ids is not None else len(self))
        self._check(_lib.tsim_gather(self._pointer, _bytes(name), id_pointer, pointer, len(made)))
        return made

    def scatter(self, name: str, values: Any, ids: Any = None) -> None:
        """Writes a quantity, as `write` does, of the particles with these identities; None: of all, by
        identity.
        """
        self._set_parts(name, values, ids, self._scatter)

    def _scatter(self, name: str, values: Any, ids: Any) -> None:
        ids, id_pointer = _integers(ids, what="identities") if ids is not None else (None, None)
        made, pointer = _doubles(values, len(ids) if ids is not None else len(self), "numbers")
        self._check(_lib.tsim_scatter(self._pointer, _bytes(name), id_pointer, pointer, len(made)))

    def _parts(self, name: str, ids: Any, get: Any) -> Any:
        if name not in VECTORS:
            return get(name, ids)
        parts = [get(part, ids) for part in VECTORS[name]]
        if numpy is not None:
            return numpy.stack(parts, axis=1)
        return [list(row) for row in zip(*parts)]

    def _set_parts(self, name: str, values: Any, ids: Any, put: Any) -> None:
        if name not in VECTORS:
            put(name, values, ids)
            return
        n = len(self) if ids is None else len(_integers(ids)[0])
        flat = list(values) if hasattr(values, "__iter__") else values
        if isinstance(flat, list) and len(flat) == 3 and not hasattr(flat[0], "__iter__"):
            flat = flat * n  # one vector for all
        made, _ = _doubles(flat, 3 * n, "numbers")
        before = self._parts(name, ids, self._read if ids is None and put == self._write
                             else self._gather)
        try:
            for k, part in enumerate(VECTORS[name]):
                put(part, made[k::3], ids)
        except TsimError:  # all or none
            for k, part in enumerate(VECTORS[name]):
                with contextlib.suppress(TsimError):
                    put(part, [row[k] for row in before], ids)
            raise

    def quantities(self) -> List[str]:
        """Names that read and gather know."""
        return _names(_lib.tsim_quantity_name)

    def columns(self) -> List[str]:
        """Names of the columns that view knows."""
        return _names(lambda k: _lib.tsim_column_name(self._pointer, k))  # type: ignore[no-any-return]

    def create(self, x: Any, v: Any = None, type: Any = None, radius: Any = None,
               density: Any = None) -> Any:
        """Makes particles at the rows of x; the others may be one for all. Their identities."""
        kept: List[Any] = [_doubles(x)]
        n, rest = divmod(len(kept[0][0]), 3)
        if rest:
            raise ValueError("positions are rows of three numbers")
        made = _Particles(n=n, x=kept[0][1])
        for name, value, convert, count in (("v", v, _doubles, 3 * n), ("type", type, _integers, n),
                                            ("radius", radius, _doubles, n),
                                            ("density", density, _doubles, n)):
            if value is not None:
                kept.append(convert(value, count, name))
                setattr(made, name, kept[-1][1])
        ids, pointer = _integers([0] * n)
        self._check(_lib.tsim_create(self._pointer, ctypes.byref(made), pointer))
        return ids

    def delete(self, ids: Any) -> None:
        """Deletes the particles with these identities."""
        made, pointer = _integers(ids, what="identities")
        self._check(_lib.tsim_delete(self._pointer, pointer, len(made)))

    def group(self, name: str) -> Any:
        """Who is in the group: one truth value per particle, in the order of memory."""
        flags: Any = (ctypes.c_ubyte * len(self))()
        self._check(_lib.tsim_group_get(self._pointer, _bytes(name), flags, len(flags)))
        if numpy is not None:
            return numpy.frombuffer(flags, dtype=numpy.uint8).astype(bool)
        return [bool(flag) for flag in flags]

    def set_group(self, name: str, members: Iterable[Any]) -> None:
        """Makes the group of those whose truth value is set, or changes it."""
        flags = (ctypes.c_ubyte * len(self))(*[bool(member) for member in members])
        self._check(_lib.tsim_group_set(self._pointer, _bytes(name), flags, len(flags)))

    @property
    def groups(self) -> List[str]:
        """Names of the groups."""
        names = (_lib.tsim_group_name(self._pointer, bit) for bit in range(32))
        return [_text(name) for name in names if name is not None]

    # -- state

    @property
    def box(self) -> Optional[Box]:
        """The box, or None before there is one."""
        box: Any = _Box()
        _lib.tsim_box(self._pointer, ctypes.byref(box))
        if not box.exists:
            return None
        faces = tuple("".join(bytes(side).decode() for side in face) for face in box.face)
        return Box(tuple(box.lo), tuple(box.hi), tuple(bool(p) for p in box.periodic), faces,
                   box.dimension)

    @property
    def clock(self) -> Clock:
        """Step counter, time and time step."""
        step, time, dt = ctypes.c_int64(), ctypes.c_double(), ctypes.c_double()
        _lib.tsim_clock(self._pointer, ctypes.byref(step), ctypes.byref(time), ctypes.byref(dt))
        return Clock(step.value, time.value, dt.value)

    def live(self, kind: str) -> List[Tuple[str, str]]:
        """The live fixes, computes, regions ... in script order: pairs of id and style."""
        found: List[Tuple[str, str]] = []
        style: Any = ctypes.c_char_p()
        while True:
            raw = _lib.tsim_live(self._pointer, _bytes(kind), len(found), ctypes.byref(style))
            if raw is None:
                return found
            found.append((_text(raw), _text(style.value)))

    # -- tables and pictures

    @property
    def thermo(self) -> Table:
        """The rows of the log so far, with all digits: a Table. A new one begins where the columns
        change (thermo_style) or the step counter goes back; thermo_tables has all of them.
        """
        return self._rows.last

    @property
    def thermo_tables(self) -> List[Table]:
        """All tables of the log."""
        return list(self._rows.tables)

    def table(self, *names: str, shape: Optional[str] = None) -> Table:
        """A Table of an output with its names of columns, table("c_ID"), table("f_ID"), of the shape
        "local", "array", "per_particle", "vector" or "scalar", by default the first of these there is;
        or of quantities of the particles by identity, table("id", "type", "radius", "vz").
        """
        return table_of(self, names, shape)

    def read_tables(self, path: Path) -> List[Table]:
        """The tables of a file: see tsim.read_tables."""
        return read_tables(self, path)

    def picture(self, color: str = "type", diameter: str = "diameter",
                size: Tuple[int, int] = (640, 480), view: Tuple[float, float] = (70, 30),
                zoom: Optional[float] = None, words: Optional[str] = None, modify: str = "",
                group: str = "all") -> Picture:
        """What the simulation looks like now, drawn by `write_dump GROUP image`. color: type or any
        quantity of the particles; zoom: by default the box just fits; words: further ones of dump
        image, by default all meshes and walls; modify: those of dump_modify. A notebook shows it;
        picture().save("now.png") writes it.
        """
        return draw(self, color, diameter, size, view, zoom, words, modify, group)

    def __repr__(self) -> str:
        if self.closed:
            return "<tsim.Simulation, closed>"
        box, clock = self.box, self.clock
        if box is None:
            return "<tsim.Simulation without a box>"
        return "<tsim.Simulation: %d particles, step %d, time %.6g>" % (len(self), clock.step,
                                                                        clock.time)

    def _repr_html_(self) -> str:
        return summary(self)
