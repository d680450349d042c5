"""tsim from Python: granular particles, bonds and drilling.

    import tsim

    with tsim.Simulation() as sim:
        sim.file("in.drilling")
        print(sim.value("ke"), sim.x[:, 2].max())

Everything goes through the C library libtsim (doc/library.md) by ctypes; nothing is compiled. With
NumPy columns of particles are arrays on the memory of the simulation: writing to `sim.v` changes
velocities. Without NumPy numbers come as array.array, tables as lists of rows, columns as
memoryview.

The library is looked for in the file that TSIM_LIBRARY names, in the build tree around this file,
where `make install` puts it, and where the system looks for libraries.
"""

import array
import collections
import ctypes
import ctypes.util
import enum
import os
import sys
import weakref

try:
    import numpy
except ImportError:
    numpy = None

__all__ = ["Simulation", "TsimError", "Stopped", "StaleView", "Box", "Clock", "Output", "Argument",
           "version", "check", "kinds", "styles", "help", "arguments"]


# ---- the library

class _Structure(ctypes.Structure):
    """One that begins with its size."""

    def __init__(self, **fields):
        super().__init__(size=ctypes.sizeof(self), **fields)


_c_double_p = ctypes.POINTER(ctypes.c_double)
_c_int32_p = ctypes.POINTER(ctypes.c_int32)
_c_size_p = ctypes.POINTER(ctypes.c_size_t)
_Texts = ctypes.POINTER(ctypes.c_char_p)
_LogFunction = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int, ctypes.c_char_p)
_StepFunction = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)


class _Options(_Structure):
    _fields_ = [("size", ctypes.c_size_t), ("threads", ctypes.c_int), ("explain", ctypes.c_int),
                ("screen", ctypes.c_void_p), ("log", ctypes.c_char_p), ("on_log", _LogFunction),
                ("on_log_data", ctypes.c_void_p), ("check", ctypes.c_int)]


class _ErrorPlace(_Structure):
    _fields_ = [("size", ctypes.c_size_t), ("status", ctypes.c_int), ("line", ctypes.c_int),
                ("column", ctypes.c_int), ("length", ctypes.c_int), ("message", ctypes.c_char_p),
                ("file", ctypes.c_char_p), ("text", ctypes.c_char_p)]


class _Table(_Structure):
    _fields_ = [("size", ctypes.c_size_t), ("data", _c_double_p), ("rows", ctypes.c_size_t),
                ("columns", ctypes.c_size_t)]


class _Output(_Structure):
    _fields_ = [("size", ctypes.c_size_t), ("name", ctypes.c_char_p), ("unit", ctypes.c_char_p),
                ("help", ctypes.c_char_p), ("shape", ctypes.c_int), ("columns", ctypes.c_size_t),
                ("column_names", _Texts)]


class _View(_Structure):
    _fields_ = [("size", ctypes.c_size_t), ("data", ctypes.c_void_p), ("type", ctypes.c_int),
                ("writable", ctypes.c_int), ("element", ctypes.c_size_t),
                ("width", ctypes.c_size_t), ("count", ctypes.c_size_t),
                ("generation", ctypes.c_uint64)]


class _Particles(_Structure):
    _fields_ = [("size", ctypes.c_size_t), ("n", ctypes.c_size_t), ("x", _c_double_p),
                ("v", _c_double_p), ("type", _c_int32_p), ("radius", _c_double_p),
                ("density", _c_double_p)]


class _Box(_Structure):
    _fields_ = [("size", ctypes.c_size_t), ("exists", ctypes.c_int), ("dimension", ctypes.c_int),
                ("lo", ctypes.c_double * 3), ("hi", ctypes.c_double * 3),
                ("periodic", ctypes.c_int * 3), ("face", (ctypes.c_char * 2) * 3)]


class _Argument(_Structure):
    _fields_ = [("size", ctypes.c_size_t), ("name", ctypes.c_char_p), ("help", ctypes.c_char_p),
                ("type", ctypes.c_char_p), ("unit", ctypes.c_char_p),
                ("fallback", ctypes.c_char_p), ("mode", ctypes.c_char_p),
                ("positional", ctypes.c_int), ("optional", ctypes.c_int),
                ("nullable", ctypes.c_int), ("least", ctypes.c_double), ("most", ctypes.c_double),
                ("positive", ctypes.c_int), ("choices", _Texts)]


def _declare(lib):
    """Result and argument types of what is used; a simulation is a void pointer."""
    sim, text, size, number = ctypes.c_void_p, ctypes.c_char_p, ctypes.c_size_t, ctypes.c_int
    p = ctypes.POINTER
    for name, result, *arguments in (
            ("open_with", number, p(_Options), p(ctypes.c_void_p)), ("close", None, sim),
            ("error", text, sim), ("error_where", None, sim, p(_ErrorPlace)),
            ("error_clear", None, sim), ("log", number, sim, text),
            ("text", number, sim, text, text), ("file", number, sim, text),
            ("check_report", number, sim, p(ctypes.c_int), text, size, _c_size_p),
            ("has_quit", number, sim, p(ctypes.c_int)), ("stop", None, sim),
            ("step", number, sim, ctypes.c_int64),
            ("on_step", number, sim, number, _StepFunction, ctypes.c_void_p),
            ("off_step", number, sim, number, _StepFunction, ctypes.c_void_p),
            ("value", number, sim, text, _c_double_p),
            ("evaluate", number, sim, text, number, p(_Table)),
            ("output", number, sim, text, size, p(_Output)),
            ("variable", number, sim, text, text),
            ("variable_set", number, sim, text, text, text),
            ("variable_number", number, sim, text, ctypes.c_double),
            ("variable_text", number, sim, text, text, size, _c_size_p),
            ("variable_name", text, sim, size), ("count", size, sim),
            ("column_read", number, sim, text, _c_double_p, size),
            ("column_write", number, sim, text, _c_double_p, size),
            ("gather", number, sim, text, _c_int32_p, _c_double_p, size),
            ("scatter", number, sim, text, _c_int32_p, _c_double_p, size),
            ("quantity_name", text, size), ("column_view", number, sim, text, p(_View)),
            ("generation", ctypes.c_uint64, sim), ("column_name", text, sim, size),
            ("hold", number, sim, ctypes.c_void_p), ("release", None, sim, ctypes.c_void_p),
            ("create", number, sim, p(_Particles), _c_int32_p),
            ("delete", number, sim, _c_int32_p, size),
            ("group_get", number, sim, text, p(ctypes.c_ubyte), size),
            ("group_set", number, sim, text, p(ctypes.c_ubyte), size),
            ("group_name", text, sim, number), ("box", None, sim, p(_Box)),
            ("clock", None, sim, p(ctypes.c_int64), _c_double_p, _c_double_p),
            ("setting", number, sim, text, _c_double_p), ("setting_name", text, size, p(text)),
            ("live", text, sim, text, size, p(text)), ("version", text), ("kind", text, size),
            ("style", text, text, size, p(text)),
            ("help", number, text, text, number, text, size, _c_size_p),
            ("argument", number, text, text, size, p(_Argument))):
        function = getattr(lib, "tsim_" + name)
        function.restype, function.argtypes = result, arguments
    return lib


def _candidates():
    here = os.path.dirname(os.path.abspath(__file__))
    if "TSIM_LIBRARY" in os.environ:
        return [os.environ["TSIM_LIBRARY"]]
    folders = ["..", "../build", "../b",            # the source tree and where one builds
               "../../../lib", "../../../lib64",    # PREFIX/share/tsim/python
               "../..", "../../.."]                 # PREFIX/lib/python3/dist-packages
    files = [os.path.normpath(os.path.join(here, folder, "libtsim.so")) for folder in folders]
    return [f for f in files if os.path.exists(f)] + [
        ctypes.util.find_library("tsim") or "libtsim.so.0"]


def _load():
    paths = _candidates()
    for path in paths:
        try:
            return _declare(ctypes.CDLL(path))
        except OSError as error:
            failure = error
    raise ImportError("libtsim was not found (%s); name it in the environment variable "
                      "TSIM_LIBRARY" % failure)


_lib = _load()


def _bytes(text):
    return os.fsencode(text) if isinstance(text, os.PathLike) else str(text).encode()


def _text(raw):
    return raw.decode(errors="replace") if raw is not None else None


def _names(function):
    """The texts function(0), function(1) ... up to NULL."""
    names, raw = [], function(0)
    while raw is not None:
        names.append(_text(raw))
        raw = function(len(names))
    return names


# ---- results and errors

Box = collections.namedtuple("Box", "lo hi periodic faces dimension")
Box.__doc__ = "Corners, whether each direction is periodic, letters of the faces, 2 or 3."
Clock = collections.namedtuple("Clock", "step time dt")
Clock.__doc__ = "Step counter, time, time step."
Output = collections.namedtuple("Output", "name unit help shape columns")
Output.__doc__ = "An output of a compute or fix: shape as in Simulation.evaluate, names of columns."
Argument = collections.namedtuple(
    "Argument", "name type help unit default mode positional optional least most choices")
Argument.__doc__ = "An argument of a style: what a front end needs to ask for it."


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

    def __init__(self, report, where):
        super().__init__(report.rstrip("\n"))
        self.code = Status(where.status)
        self.message, self.file = _text(where.message), _text(where.file)
        self.text = _text(where.text)
        self.line, self.column, self.length = where.line, where.column, where.length


class Stopped(TsimError):
    """Simulation.stop was called; all results up to here are written."""


class StaleView(RuntimeError):
    """The array showed particles that have since been added, deleted or reordered."""


SHAPES = {"scalar": 1, "vector": 2, "per_particle": 3, "local": 4, "array": 5}
STAGES = {"before_force": 0, "after_force": 1, "end_of_step": 2}
_TYPES = {1: (ctypes.c_double, "d"), 3: (ctypes.c_int32, "i"), 4: (ctypes.c_uint32, "I")}


def _choose(choices, word, what):
    if word not in choices:
        raise ValueError("%s is one of %s, not %r" % (what, ", ".join(choices), word))
    return choices[word]


# ---- numbers in and out, with NumPy or without

def _doubles(values, n=None, what="values"):
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


def _integers(values, n=None, what="values"):
    if numpy is not None:
        made = numpy.asarray(values)
        if made.ndim == 0 and n is not None:
            made = numpy.full(n, made)
        if made.size and not numpy.array_equal(made, numpy.trunc(made)):
            raise ValueError("%s have to be whole numbers" % what)
        made = numpy.ascontiguousarray(made, dtype=numpy.int32).reshape(-1)
        pointer = made.ctypes.data_as(_c_int32_p)
    else:
        if isinstance(values, int) and n is not None:
            values = [values] * n
        made = array.array("i", values)
        pointer = ctypes.cast(made.buffer_info()[0], _c_int32_p)
    if n is not None and len(made) != n:
        raise ValueError("%d %s given, expected %d" % (len(made), what, n))
    return made, pointer


def _flat(values):
    for value in values:
        if hasattr(value, "__iter__"):
            yield from _flat(value)
        else:
            yield value


def _new_doubles(n):
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

        _sim, _generation = None, 0

        def __array_finalize__(self, origin):
            if isinstance(origin, View) and numpy.may_share_memory(self, origin):
                self._sim, self._generation = origin._sim, origin._generation

        def _check(self):
            if self._sim is not None and (
                    self._sim.closed or self._sim.generation != self._generation):
                raise StaleView("particles were added, deleted or reordered since this view was "
                                "taken: take it anew from the simulation, or keep a copy")

        def __getitem__(self, key):
            self._check()
            return super().__getitem__(key)

        def __setitem__(self, key, value):
            self._check()
            super().__setitem__(key, value)

        def __iter__(self):
            self._check()
            return iter(self.view(numpy.ndarray))

        def __repr__(self):
            self._check()
            return repr(self.view(numpy.ndarray)).replace("array(", "View(", 1)

        __str__ = __repr__

        def copy(self, order="C"):
            self._check()
            return numpy.array(self.view(numpy.ndarray), order=order)

        def __array_ufunc__(self, ufunc, method, *inputs, out=None, **rest):
            plain = [_plain(value) for value in inputs]
            if out is not None:
                rest["out"] = tuple(_plain(value) for value in out)
            result = getattr(ufunc, method)(*plain, **rest)
            return result if out is None else out[0] if len(out) == 1 else out

        def __array_function__(self, function, types, args, kwargs):
            return function(*_plain(args), **_plain(kwargs))


def _plain(value):
    """Views inside, checked, as the arrays they are."""
    if isinstance(value, (list, tuple)):
        return type(value)(_plain(item) for item in value)
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, View):
        value._check()
        return value.view(numpy.ndarray)
    return value


# ---- the simulation

class _Owner:
    """The C simulation. It ends when it was closed and nobody holds its memory any more."""

    def __init__(self, pointer):
        self.pointer, self.held, self.closed = pointer, 0, False

    def hold(self, keeper, data):
        if _lib.tsim_hold(self.pointer, data):
            raise MemoryError
        self.held += 1
        weakref.finalize(keeper, self.release, data)

    def release(self, data):
        _lib.tsim_release(self.pointer, data)
        self.held -= 1
        self._end()

    def close(self):
        if self.closed:
            return
        self.closed = True
        if self.held:  # files are closed and all memory but the views' freed
            _lib.tsim_text(self.pointer, b"clear", b"close")
            _lib.tsim_log(self.pointer, None)
        self._end()

    def _end(self):
        if self.closed and not self.held and self.pointer:
            _lib.tsim_close(self.pointer)
            self.pointer = None


class Simulation:
    """A simulation; several can live at once, each used by one thread at a time.

    threads: 0 as OMP_NUM_THREADS says; log: path of a log file; screen: True prints what the
    command line shows; on_log: a function f(level, text) with level "text", "warning" or "progress"
    that is told instead; explain: run nothing, tell the plan of each run.

    As a context manager it is closed at the end. Its columns of particles: x, v, f, omega, torque,
    image, radius, mass, tag, type, mask (see view); its variables: sim.variables["name"].
    """

    def __init__(self, threads=0, log=None, screen=False, on_log=None, explain=False,
                 _check=False):
        self._owner = None
        self._failure = None   # what a Python function raised inside a C call
        self._calls = {}
        if on_log is None and screen:
            on_log = _print
        self._on_log = _LogFunction(self._logger(on_log)) if on_log else _LogFunction()
        options = _Options(threads=threads, explain=bool(explain), check=_check, on_log=self._on_log,
                           log=_bytes(log) if log is not None else None)
        pointer = ctypes.c_void_p()
        status = _lib.tsim_open_with(ctypes.byref(options), ctypes.byref(pointer))
        if not pointer:
            raise MemoryError("no memory for a simulation")
        self._owner = _Owner(pointer)
        self.variables = _Variables(self)
        try:
            self._check(status)
        except TsimError:
            self.close()
            raise

    # -- life and errors

    def close(self):
        """Ends the simulation and closes its files. Views of its columns become stale."""
        if self._owner:
            self._owner.close()

    def __enter__(self):
        return self

    def __exit__(self, *exception):
        self.close()

    def __del__(self):
        self.close()

    @property
    def closed(self):
        return self._owner.closed

    @property
    def _pointer(self):
        if self._owner.closed:
            raise ValueError("the simulation is closed")
        return self._owner.pointer

    def _check(self, status):
        """Raises what a function of the user raised, else the error of the simulation."""
        failure, self._failure = self._failure, None
        if not status and failure is None:
            return
        pointer, where = self._owner.pointer, _ErrorPlace()
        _lib.tsim_error_where(pointer, ctypes.byref(where))
        report = _text(_lib.tsim_error(pointer))
        error = None
        if where.status:
            error = (Stopped if where.status == Status.STOPPED else TsimError)(report, where)
        _lib.tsim_error_clear(pointer)
        if failure is not None:
            raise failure
        if error is not None:
            raise error

    def _logger(self, on_log):
        levels = ("text", "warning", "progress")

        def tell(_, level, raw):
            try:
                on_log(levels[level], _text(raw))
            except BaseException as error:  # a C function cannot pass it on
                self._failure = self._failure or error
        return tell

    # -- scripts

    def commands(self, text, name="python"):
        """Runs script lines; `name` stands for the file name in messages."""
        self._check(_lib.tsim_text(self._pointer, _bytes(text), _bytes(name)))

    def file(self, path):
        """Runs a script file."""
        self._check(_lib.tsim_file(self._pointer, _bytes(path)))

    @property
    def quit_status(self):
        """The status the script said `quit` with; None: it did not."""
        status = ctypes.c_int()
        said = _lib.tsim_has_quit(self._pointer, ctypes.byref(status))
        return status.value if said else None

    def step(self, n=1):
        """Steps n times. Successive calls are one run, bit for bit that of `run` with their sum;
        after a change from outside forces are computed anew. Ctrl-C is heeded every 1000 steps.
        """
        n = int(n)
        while True:
            piece = min(n, 1000)
            before = self.clock.step
            self._check(_lib.tsim_step(self._pointer, piece))
            n -= piece
            if n <= 0 or self.clock.step < before + piece:  # fix halt
                return

    def stop(self):
        """Lets a run stop after its present step, which raises Stopped there. From a function of
        on_step or from another thread.
        """
        _lib.tsim_stop(self._pointer)

    def on_step(self, stage, function=None):
        """Lets function(sim) take part in every step: stage "before_force", "after_force" (where
        sim.f can be added to) or "end_of_step" (where sim.x, sim.v can be changed). Also as a
        decorator: @sim.on_step("after_force"). An exception ends the run and is raised there.
        """
        number = _choose(STAGES, stage, "a stage")
        if function is None:
            return lambda decorated: self.on_step(stage, decorated)
        owner = weakref.ref(self)

        def call(_pointer, _data):
            sim = owner()
            try:
                function(sim)
                return 0
            except BaseException as error:
                sim._failure = sim._failure or error
                return 1
        wrapped = _StepFunction(call)
        self._check(_lib.tsim_on_step(self._pointer, number, wrapped, None))
        self._calls.setdefault((stage, function), []).append(wrapped)
        return function

    def off_step(self, stage, function):
        """Undoes on_step."""
        wrapped = self._calls.get((stage, function))
        if not wrapped:
            raise ValueError("this function does not take part in stage %r" % (stage,))
        self._check(_lib.tsim_off_step(self._pointer, STAGES[stage], wrapped[-1], None))
        wrapped.pop()

    # -- numbers

    def value(self, formula):
        """The number a formula stands for: "ke", "c_ID[2]", "v_name", "count(rock)/2" ..."""
        out = ctypes.c_double()
        self._check(_lib.tsim_value(self._pointer, _bytes(formula), ctypes.byref(out)))
        return out.value

    def evaluate(self, name, shape):
        """A whole output as a new array: name "c_ID", "f_ID", "c_ID[k]", "v_NAME" or a quantity of
        particles; shape "scalar", "vector", "per_particle" (in the order of particles in memory),
        "local" or "array". Of one column: one-dimensional; without NumPy a list of rows.
        """
        table = _Table()
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

    def outputs(self, name):
        """What "c_ID" or "f_ID" gives: a list of Output."""
        found, raw = [], _Output()
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

    def compute(self, id, shape=None):
        """The output of a compute, of its first shape or the one named."""
        return self._of_style("c_" + id, shape)

    def fix(self, id, shape=None):
        """The output of a fix, of its first shape or the one named."""
        return self._of_style("f_" + id, shape)

    def _of_style(self, name, shape):
        return self.evaluate(name, shape or self.outputs(name)[0].shape)

    def setting(self, name):
        """A number of the simulation itself: "nlocal", "ntypes", "nghost", "threads" ..."""
        out = ctypes.c_double()
        self._check(_lib.tsim_setting(self._pointer, _bytes(name), ctypes.byref(out)))
        return out.value

    # -- particles

    def __len__(self):
        return _lib.tsim_count(self._pointer)

    def __bool__(self):
        return True

    @property
    def generation(self):
        """Grows when views become stale."""
        return _lib.tsim_generation(self._pointer)

    def view(self, name):
        """A stored column on the memory of the simulation: an array of one row per particle, or of
        one number. x, v, omega can be written between runs and at "end_of_step", f and torque
        inside a step; others are read-only. A stale one raises StaleView when it is used (without
        NumPy, as a memoryview, it shows old values).
        """
        view = _View()
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

    def read(self, name):
        """A quantity by its script name, one number per particle, as a new array: "x", "vz",
        "diameter", "density" ... in the order of particles in memory.
        """
        made, pointer = _new_doubles(len(self))
        self._check(_lib.tsim_column_read(self._pointer, _bytes(name), pointer, len(made)))
        return made

    def write(self, name, values):
        """Writes a quantity: one number per particle, or one for all. A radius keeps the density, a
        density and a mass the radius.
        """
        made, pointer = _doubles(values, len(self), "numbers")
        self._check(_lib.tsim_column_write(self._pointer, _bytes(name), pointer, len(made)))

    def gather(self, name, ids=None):
        """A quantity of the particles with these identities; None: of all, by identity."""
        made_ids, id_pointer = _integers(ids, what="identities") if ids is not None else (None, None)
        made, pointer = _new_doubles(len(made_ids) if ids is not None else len(self))
        self._check(_lib.tsim_gather(self._pointer, _bytes(name), id_pointer, pointer, len(made)))
        return made

    def scatter(self, name, values, ids=None):
        """Writes a quantity of the particles with these identities; None: of all, by identity."""
        made_ids, id_pointer = _integers(ids, what="identities") if ids is not None else (None, None)
        made, pointer = _doubles(values, len(made_ids) if ids is not None else len(self), "numbers")
        self._check(_lib.tsim_scatter(self._pointer, _bytes(name), id_pointer, pointer, len(made)))

    def quantities(self):
        """Names that read and gather know."""
        return _names(_lib.tsim_quantity_name)

    def columns(self):
        """Names of the columns that view knows."""
        return _names(lambda k: _lib.tsim_column_name(self._pointer, k))

    def create(self, x, v=None, type=None, radius=None, density=None):
        """Makes particles at the rows of x; the others may be one for all. Their identities."""
        kept = [_doubles(x)]
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

    def delete(self, ids):
        """Deletes the particles with these identities."""
        made, pointer = _integers(ids, what="identities")
        self._check(_lib.tsim_delete(self._pointer, pointer, len(made)))

    def group(self, name):
        """Who is in the group: one truth value per particle, in the order of memory."""
        flags = (ctypes.c_ubyte * len(self))()
        self._check(_lib.tsim_group_get(self._pointer, _bytes(name), flags, len(flags)))
        if numpy is not None:
            return numpy.frombuffer(flags, dtype=numpy.uint8).astype(bool)
        return [bool(flag) for flag in flags]

    def set_group(self, name, members):
        """Makes the group of those whose truth value is set, or changes it."""
        flags = (ctypes.c_ubyte * len(self))(*[bool(member) for member in members])
        self._check(_lib.tsim_group_set(self._pointer, _bytes(name), flags, len(flags)))

    @property
    def groups(self):
        """Names of the groups."""
        names = (_text(_lib.tsim_group_name(self._pointer, bit)) for bit in range(32))
        return [name for name in names if name is not None]

    # -- state

    @property
    def box(self):
        """The box, or None before there is one."""
        box = _Box()
        _lib.tsim_box(self._pointer, ctypes.byref(box))
        if not box.exists:
            return None
        faces = tuple("".join(bytes(side).decode() for side in face) for face in box.face)
        return Box(tuple(box.lo), tuple(box.hi), tuple(bool(p) for p in box.periodic), faces,
                   box.dimension)

    @property
    def clock(self):
        """Step counter, time and time step."""
        step, time, dt = ctypes.c_int64(), ctypes.c_double(), ctypes.c_double()
        _lib.tsim_clock(self._pointer, ctypes.byref(step), ctypes.byref(time), ctypes.byref(dt))
        return Clock(step.value, time.value, dt.value)

    def live(self, kind):
        """The live fixes, computes, regions ... in script order: pairs of id and style."""
        style, found = ctypes.c_char_p(), []
        while True:
            raw = _lib.tsim_live(self._pointer, _bytes(kind), len(found), ctypes.byref(style))
            if raw is None:
                return found
            found.append((_text(raw), _text(style.value)))


def _column(name, what):
    def get(self):
        return self.view(name)

    def put(self, value):
        target = self.view(name)
        if value is not target:
            target[...] = value
    return property(get, put, doc=what + ": Simulation.view(%r)" % name)


for _name, _what in (("x", "positions"), ("v", "velocities"), ("f", "forces"),
                     ("omega", "angular velocities"), ("torque", "torques"),
                     ("image", "how often periodic faces were crossed"), ("tag", "identities"),
                     ("type", "types"), ("mask", "bits of the groups"), ("radius", "radii"),
                     ("mass", "masses")):
    setattr(Simulation, _name, _column(_name, _what))


def _print(level, text):
    if level == "text":
        sys.stdout.write(text)
    elif level == "warning":
        sys.stdout.write("warning: " + text + "\n" if not "warning: " in text else text + "\n")


class _Variables:
    """The script's variables: sim.variables["name"] gives a number, or the text where it is none; a
    number assigned makes it an equal-style variable, a text one of style string.
    """

    def __init__(self, sim):
        self._sim = weakref.proxy(sim)

    def __getitem__(self, name):
        if name not in self:
            raise KeyError(name)
        try:
            return self._sim.value("v_" + name)
        except TsimError:
            return self.text(name)

    def text(self, name):
        """What ${name} stands for."""
        length, room = ctypes.c_size_t(), 256
        while True:
            out = ctypes.create_string_buffer(room)
            self._sim._check(_lib.tsim_variable_text(self._sim._pointer, _bytes(name), out, room,
                                                     ctypes.byref(length)))
            if length.value < room:
                return _text(out.value)
            room = length.value + 1

    def __setitem__(self, name, value):
        if isinstance(value, str):
            self.define(name, "string", value)
        else:
            self._sim._check(_lib.tsim_variable_number(self._sim._pointer, _bytes(name),
                                                       float(value)))

    def define(self, name, style, value):
        """As the line `variable NAME STYLE VALUE`, replacing one of that name."""
        self._sim._check(_lib.tsim_variable_set(self._sim._pointer, _bytes(name), _bytes(style),
                                                _bytes(value)))

    def preset(self, name, value):
        """Sets an index variable, which wins over the script's own, as the option -var does."""
        self._sim._check(_lib.tsim_variable(self._sim._pointer, _bytes(name), _bytes(value)))

    def __contains__(self, name):
        return name in list(self)

    def __iter__(self):
        return iter(_names(lambda k: _lib.tsim_variable_name(self._sim._pointer, k)))

    def __len__(self):
        return len(list(iter(self)))


# ---- what there is

def version():
    """Version of the library."""
    return _text(_lib.tsim_version())


def check(script, name=None, variables=()):
    """Reads a script without running it: (number of errors, text of all of them and of what the
    script would do). script: a path; or, with a name for messages, a text. variables: pairs or a
    dictionary, as the option -var.
    """
    sim = Simulation(_check=True)
    try:
        for key, value in dict(variables).items():
            sim.variables.preset(key, value)
        if name is None:
            sim.file(script)
        else:
            sim.commands(script, name)
        errors, length = ctypes.c_int(), ctypes.c_size_t()
        room = 1 << 16
        while True:
            out = ctypes.create_string_buffer(room)
            sim._check(_lib.tsim_check_report(sim._pointer, ctypes.byref(errors), out, room,
                                              ctypes.byref(length)))
            if length.value < room:
                return errors.value, _text(out.value)
            room = length.value + 1
    finally:
        sim.close()


def kinds():
    """Kinds of styles: command, fix, pair ..."""
    return _names(_lib.tsim_kind)


def styles(kind):
    """Names of the styles of a kind with their summaries."""
    summary, found = ctypes.c_char_p(), {}
    while True:
        raw = _lib.tsim_style(_bytes(kind), len(found), ctypes.byref(summary))
        if raw is None:
            return found
        found[_text(raw)] = _text(summary.value)


def help(kind, style, markdown=False):
    """The manual page of a style; LookupError, with a suggestion, if there is none."""
    length = ctypes.c_size_t()
    _lib.tsim_help(_bytes(kind), _bytes(style), markdown, None, 0, ctypes.byref(length))
    page = ctypes.create_string_buffer(length.value + 1)
    status = _lib.tsim_help(_bytes(kind), _bytes(style), markdown, page, len(page), None)
    if status:
        raise LookupError(_text(page.value))
    return _text(page.value)


def arguments(kind, style):
    """The arguments of a style: a list of Argument."""
    found, raw = [], _Argument()
    while not _lib.tsim_argument(_bytes(kind), _bytes(style), len(found), ctypes.byref(raw)):
        choices = []
        while raw.choices and raw.choices[len(choices)] is not None:
            choices.append(_text(raw.choices[len(choices)]))
        found.append(Argument(_text(raw.name), _text(raw.type), _text(raw.help), _text(raw.unit),
                              _text(raw.fallback), _text(raw.mode), bool(raw.positional),
                              bool(raw.optional), raw.least, raw.most, choices or None))
    if not found:
        help(kind, style)  # a style that does not exist
    return found
