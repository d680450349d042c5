"""The names of the Python modules of LAMMPS and LIGGGHTS, with the meaning that their manuals give.

LammpsNames is a part of Simulation; the class `lammps` (also called `liggghts`) is a Simulation that is
made with the arguments of theirs and in which all names, also gather and scatter, mean what they mean
there. doc/python.md has the table which is which, and what differs.
"""
from __future__ import annotations

import platform
import sys
from typing import Any, Callable, Dict, Iterable, List, Optional, Sequence, Tuple

from ._external import ExternalNames
from ._library import _lib, _text
from ._neighbours import NeighbourNames, NeighList
from ._numbers import _integers, numpy
from ._results import TsimError

LAMMPS_AUTODETECT = None
LAMMPS_INT, LAMMPS_INT_2D, LAMMPS_DOUBLE, LAMMPS_DOUBLE_2D = 0, 1, 2, 3
LAMMPS_INT64, LAMMPS_INT64_2D, LAMMPS_STRING = 4, 5, 6
LMP_STYLE_GLOBAL, LMP_STYLE_ATOM, LMP_STYLE_LOCAL = 0, 1, 2
LMP_TYPE_SCALAR, LMP_TYPE_VECTOR, LMP_TYPE_ARRAY = 0, 1, 2
LMP_SIZE_VECTOR, LMP_SIZE_ROWS, LMP_SIZE_COLS = 3, 4, 5
LMP_VAR_EQUAL, LMP_VAR_ATOM, LMP_VAR_VECTOR, LMP_VAR_STRING = 0, 1, 2, 3

# Per-atom columns: their name here, whether they are whole numbers, numbers of an atom.
_ATOM = {"id": ("tag", True, 1), "type": ("type", True, 1), "mask": ("mask", True, 1),
         "image": ("image", True, 3), "x": ("x", False, 3), "v": ("v", False, 3),
         "f": ("f", False, 3), "omega": ("omega", False, 3), "torque": ("torque", False, 3),
         "radius": ("radius", False, 1), "rmass": ("mass", False, 1)}
# Shapes that a style of data and a type may have; the first one there is counts.
_SHAPES = {(0, 0): ("scalar",), (0, 1): ("vector",), (0, 2): ("array",), (1, 1): ("per_particle",),
           (1, 2): ("per_particle",), (2, 1): ("local",), (2, 2): ("local",)}


def _edge(side: str, axis: int) -> Callable[[Any], float]:
    return lambda sim: float(getattr(_box(sim), side)[axis])


def _box(sim: Any) -> Any:
    if sim.box is None:
        raise ValueError("there is no box yet: create_box or read_restart makes one")
    return sim.box


_GLOBAL: Dict[str, Tuple[int, Callable[[Any], Any]]] = {
    "dt": (LAMMPS_DOUBLE, lambda sim: sim.clock.dt),
    "ntimestep": (LAMMPS_INT64, lambda sim: sim.clock.step),
    "atime": (LAMMPS_DOUBLE, lambda sim: sim.clock.time),
    "boxlo": (LAMMPS_DOUBLE, lambda sim: list(_box(sim).lo)),
    "boxhi": (LAMMPS_DOUBLE, lambda sim: list(_box(sim).hi)),
    "sublo": (LAMMPS_DOUBLE, lambda sim: list(_box(sim).lo)),
    "subhi": (LAMMPS_DOUBLE, lambda sim: list(_box(sim).hi)),
    "periodicity": (LAMMPS_INT, lambda sim: [int(p) for p in _box(sim).periodic]),
    "dimension": (LAMMPS_INT, lambda sim: _box(sim).dimension),
    "triclinic": (LAMMPS_INT, lambda sim: 0),
    "box_exist": (LAMMPS_INT, lambda sim: int(sim.setting("box_exist"))),
    "natoms": (LAMMPS_INT64, len),
    "nlocal": (LAMMPS_INT, len),
    "nghost": (LAMMPS_INT, lambda sim: int(sim.setting("nghost"))),
    "nmax": (LAMMPS_INT, lambda sim: len(sim) + int(sim.setting("nghost"))),
    "ntypes": (LAMMPS_INT, lambda sim: int(sim.setting("ntypes"))),
    "nbonds": (LAMMPS_INT64, lambda sim: int(sim.value("bonds"))),
    "xy": (LAMMPS_DOUBLE, lambda sim: 0.0), "xz": (LAMMPS_DOUBLE, lambda sim: 0.0),
    "yz": (LAMMPS_DOUBLE, lambda sim: 0.0),
}
for _axis, _letter in enumerate("xyz"):
    _GLOBAL["box%slo" % _letter] = (LAMMPS_DOUBLE, _edge("lo", _axis))
    _GLOBAL["box%shi" % _letter] = (LAMMPS_DOUBLE, _edge("hi", _axis))
_SETTINGS: Dict[str, Callable[[Any], int]] = {
    "bigint": lambda sim: 8, "tagint": lambda sim: 4, "imageint": lambda sim: 4,
    "triclinic": lambda sim: 0, "world_rank": lambda sim: int(sim.setting("rank")),
    "world_size": lambda sim: int(sim.setting("ranks")),
    "universe_rank": lambda sim: int(sim.setting("rank")), "universe_size": lambda sim: int(sim.setting("ranks")),
    "nthreads": lambda sim: int(sim.setting("threads")),
    "nall": lambda sim: len(sim) + int(sim.setting("nghost")),
    "nmax": lambda sim: len(sim) + int(sim.setting("nghost")),
}


def _known(name: str, choices: Iterable[str], what: str) -> None:
    names = sorted(choices)
    if name not in names:
        raise ValueError("%s %r is not known; there are %s" % (what, name, ", ".join(names)))


class Commands:
    """sim.cmd.NAME(words ...) runs the command: sim.cmd.run(100), sim.cmd.fix("1 all nve")."""

    def __init__(self, sim: Any) -> None:
        self._sim = sim

    def __getattr__(self, name: str) -> Callable[..., None]:
        if name.startswith("_"):
            raise AttributeError(name)
        return lambda *words: self._sim.command(" ".join([name, *map(str, words)]))


class NumpyNames:
    """sim.numpy: extract_atom and its relatives. All of them return arrays anyway."""

    def __init__(self, sim: Any) -> None:
        self._sim = sim

    def extract_atom(self, name: str, dtype: Any = None, nelem: Optional[int] = None,
                     dim: Optional[int] = None) -> Any:
        """A column of the particles."""
        return self._sim.extract_atom(name)

    def extract_compute(self, cid: str, cstyle: int, ctype: int) -> Any:
        """An output of a compute."""
        return self._sim.extract_compute(cid, cstyle, ctype)

    def extract_fix(self, fid: str, fstyle: int, ftype: int, nrow: int = 0, ncol: int = 0) -> Any:
        """An output of a fix."""
        return self._sim.extract_fix(fid, fstyle, ftype, nrow, ncol)

    def extract_variable(self, name: str, group: Optional[str] = None,
                         vartype: Optional[int] = None) -> Any:
        """A variable."""
        return self._sim.extract_variable(name, group, vartype)

    def gather_bonds(self) -> Any:
        """Bonds: rows of type and the identities of the partners."""
        return self._sim.gather_bonds()[1]

    def get_neighlist(self, idx: int) -> NeighList:
        """The contact list, with rows (particle, array of neighbours)."""
        return NeighList(self._sim, idx, True)

    def get_neighlist_element_neighbors(self, idx: int, element: int) -> Any:
        """(particle, array of its neighbours) of one row of the contact list."""
        return NeighList(self._sim, idx, True).get(element)

    def fix_external_get_force(self, fix_id: str) -> Any:
        """The forces of a `fix external`, to be written to."""
        return self._sim.fix_external_get_force(fix_id)

    def fix_external_set_energy_peratom(self, fix_id: str, eatom: Any) -> None:
        """The energy of each particle."""
        self._sim.fix_external_set_energy_peratom(fix_id, eatom)

    def fix_external_set_virial_peratom(self, fix_id: str, vatom: Any) -> None:
        """Refused."""
        self._sim.fix_external_set_virial_peratom(fix_id, vatom)


class LammpsNames(NeighbourNames, ExternalNames):
    """Names of LAMMPS and LIGGGHTS, a part of Simulation."""

    # what Simulation has
    variables: Any
    commands: Any
    _comm: Any
    value: Any
    evaluate: Any
    outputs: Any
    view: Any
    setting: Any
    live: Any
    group: Any
    create: Any
    on_step: Any
    off_step: Any
    stop: Any
    close: Any
    thermo: Any
    _check: Any
    _pointer: Any
    _gather: Any
    _read: Any
    _scatter: Any

    # -- scripts and life

    def command(self, line: str) -> None:
        """Runs a line of a script."""
        self.commands(line, "command")

    def commands_string(self, text: str) -> None:
        """Runs lines of a script."""
        self.commands(text, "commands_string")

    def commands_list(self, lines: Iterable[str]) -> None:
        """Runs lines of a script."""
        self.commands("\n".join(lines), "commands_list")

    @property
    def cmd(self) -> Commands:
        """sim.cmd.run(100) is sim.command("run 100")."""
        return Commands(self)

    @property
    def numpy(self) -> NumpyNames:
        """Functions that return arrays of NumPy."""
        return NumpyNames(self)

    def version(self) -> int:
        """The version as a number, 10203 for 1.2.3 (of LAMMPS: a date)."""
        parts = _text(_lib.tsim_version()).split(".")
        return int(parts[0]) * 10000 + int(parts[1]) * 100 + int(parts[2])

    def finalize(self) -> None:
        """Closes the simulation; there is no MPI to be shut down."""
        self.close()

    def error(self, error_type: int, message: str) -> None:
        """Raises an error with this message."""
        raise RuntimeError(message)

    def flush_buffers(self) -> None:
        """Nothing is held back."""
        sys.stdout.flush()

    def get_os_info(self) -> str:
        """The operating system."""
        return platform.platform()

    def get_mpi_comm(self) -> Any:
        """The communicator of mpi4py with which it was made, or None."""
        return self._comm

    def is_running(self) -> bool:
        """Whether a step is being done."""
        return bool(self.setting("running"))

    def force_timeout(self) -> None:
        """Ends a run after its present step."""
        self.stop()

    # -- numbers

    def get_natoms(self) -> int:
        """Number of particles."""
        return len(self)  # type: ignore[arg-type]

    def get_thermo(self, name: str) -> float:
        """A keyword of thermo_style."""
        return float(self.value(name))

    def last_thermo(self) -> Optional[Dict[str, float]]:
        """The last row of the log by the names of its columns; None: there is none."""
        row: Optional[Dict[str, float]] = self.thermo.row() if len(self.thermo) else None
        return row

    def eval(self, formula: str) -> float:
        """The value of a formula."""
        return float(self.value(formula))

    def extract_setting(self, name: str) -> int:
        """A setting; what there is not raises an error (LAMMPS: -1)."""
        if name in _SETTINGS:
            return _SETTINGS[name](self)
        return int(self.setting(name))

    def extract_global(self, name: str, dtype: Any = None) -> Any:
        """A number, or a list of three, of the simulation."""
        _known(name, _GLOBAL, "the global quantity")
        return _GLOBAL[name][1](self)

    def extract_global_datatype(self, name: str) -> int:
        """LAMMPS_INT ... of a global quantity; -1: there is none."""
        return _GLOBAL[name][0] if name in _GLOBAL else -1

    def extract_box(self) -> List[Any]:
        """[boxlo, boxhi, xy, yz, xz, periodicity, box_change]."""
        box = _box(self)
        return [list(box.lo), list(box.hi), 0.0, 0.0, 0.0, [int(p) for p in box.periodic],
                int(any(style == "deform" for _, style in self.live("fix")))]

    def reset_box(self, boxlo: Sequence[float], boxhi: Sequence[float], xy: float = 0.0,
                  yz: float = 0.0, xz: float = 0.0) -> None:
        """Moves the faces of the box; particles stay where they are."""
        if xy or yz or xz:
            raise ValueError("the box has no tilt factors; shear is `fix deform`")
        self.commands("change_box all %s units box" % " ".join(
            "%s final %.17g %.17g" % (axis, lo, hi) for axis, lo, hi in zip("xyz", boxlo, boxhi)),
            "reset_box")

    def extract_compute(self, cid: str, cstyle: int, ctype: int) -> Any:
        """An output of a compute: style LMP_STYLE_GLOBAL, _ATOM or _LOCAL; type LMP_TYPE_SCALAR,
        _VECTOR or _ARRAY, or LMP_SIZE_VECTOR, _ROWS or _COLS. Per-atom data are in the order of memory.
        """
        return self._extract("c_" + cid, cstyle, ctype)

    def extract_fix(self, fid: str, fstyle: int, ftype: int, nrow: int = 0, ncol: int = 0) -> Any:
        """An output of a fix; of a global vector the number nrow, of an array that of row nrow, column
        ncol, from 0.
        """
        made = self._extract("f_" + fid, fstyle, ftype)
        if fstyle != LMP_STYLE_GLOBAL or ftype not in (LMP_TYPE_VECTOR, LMP_TYPE_ARRAY):
            return made
        element = made[nrow] if ftype == LMP_TYPE_VECTOR else made[nrow][ncol]
        return float(element)

    def _extract(self, name: str, style: int, type: int) -> Any:
        sized = {LMP_SIZE_VECTOR: LMP_TYPE_VECTOR, LMP_SIZE_ROWS: LMP_TYPE_ARRAY,
                 LMP_SIZE_COLS: LMP_TYPE_ARRAY}
        key = (style, sized.get(type, type))
        if style == LMP_STYLE_LOCAL and type == LMP_TYPE_SCALAR:
            key = (LMP_STYLE_LOCAL, LMP_TYPE_VECTOR)
        if key not in _SHAPES:
            raise ValueError("%s: there is no style %r with the type %r" % (name, style, type))
        made = self.evaluate(name, _SHAPES[key][0])
        wide = len(made) > 0 and hasattr(made[0], "__len__") if key != (0, 0) else False
        if type in sized:
            return len(made[0]) if type == LMP_SIZE_COLS and wide else \
                1 if type == LMP_SIZE_COLS else len(made)
        if type == LMP_TYPE_VECTOR and wide or type == LMP_TYPE_ARRAY and not wide and len(made):
            raise ValueError("%s gives %s, not %s" % (
                (name, "an array", "a vector") if wide else (name, "a vector", "an array")))
        return made

    # -- variables

    def extract_variable(self, name: str, group: Optional[str] = None,
                         vartype: Optional[int] = None) -> Any:
        """A variable: a number, of style atom one per particle (0 for those that are not in the group),
        of style vector an array, otherwise its text. vartype LMP_VAR_EQUAL ... asks for one of these.
        """
        if vartype == LMP_VAR_STRING:
            return self.variables.text(name)
        shapes = {LMP_VAR_EQUAL: "scalar", LMP_VAR_ATOM: "per_particle", LMP_VAR_VECTOR: "vector"}
        first: Optional[TsimError] = None
        for kind, shape in shapes.items():
            if vartype is not None and kind != vartype:
                continue
            try:
                made = self.evaluate("v_" + name, shape)
            except TsimError as error:
                first = first or error
                continue
            if shape == "per_particle" and group is not None:
                for k, member in enumerate(self.group(group)):
                    made[k] = made[k] if member else 0.0
            return float(made) if shape == "scalar" else made
        if vartype is None and name in self.variables:
            return self.variables.text(name)
        raise first or ValueError("there is no kind %r of variables" % (vartype,))

    def set_variable(self, name: str, value: object) -> int:
        """Sets a variable of style string, or makes it; 0."""
        self.variables.define(name, "string", str(value))
        return 0

    set_string_variable = set_variable

    def set_internal_variable(self, name: str, value: float) -> int:
        """Sets a variable to a number, exactly; 0."""
        self.variables[name] = float(value)
        return 0

    # -- particles

    def extract_atom(self, name: str, dtype: Any = None) -> Any:
        """A column on the memory of the simulation, in the order of memory: see Simulation.view."""
        _known(name, _ATOM, "the per-atom quantity")
        return self.view(_ATOM[name][0])

    def extract_atom_datatype(self, name: str) -> int:
        """LAMMPS_INT ... of a per-atom quantity; -1: there is none."""
        if name not in _ATOM:
            return -1
        _, whole, width = _ATOM[name]
        return (LAMMPS_INT if whole else LAMMPS_DOUBLE) + (1 if width == 3 else 0)

    def extract_atom_size(self, name: str, dtype: int) -> int:
        """LMP_SIZE_ROWS or LMP_SIZE_COLS of a per-atom quantity; -1: there is none."""
        if name not in _ATOM:
            return -1
        return len(self) if dtype == LMP_SIZE_ROWS else _ATOM[name][2]  # type: ignore[arg-type]

    def map_atom(self, id: int) -> Optional[int]:
        """Index in memory of the particle with this identity; None: there is none."""
        tags = list(self.view("tag"))
        return tags.index(id) if id in tags else None

    def _parts_of(self, name: str, count: int) -> List[str]:
        from ._simulation import VECTORS
        if name in _ATOM:
            column, _, width = _ATOM[name]
            if count != width:
                raise ValueError("%r has %d numbers per atom, not %d" % (name, width, count))
            script = {"tag": "id"}.get(column, column)
            return list(VECTORS.get(script, (script,)))
        return [name]

    def _columns(self, name: str, dtype: int, count: int, ids: Any, order: bool) -> Any:
        """count numbers per atom, atom after atom."""
        if name in _ATOM and _ATOM[name][1] != (dtype == 0):
            raise ValueError("%r has %s numbers: dtype %d" % (
                name, "whole" if _ATOM[name][1] else "real", int(not _ATOM[name][1])))
        if name.startswith(("c_", "f_", "v_")):
            made = self.evaluate(name, "per_particle")
            wide = len(made) > 0 and hasattr(made[0], "__len__")
            width = len(made[0]) if wide else 1
            if len(made) and width != count:
                raise ValueError("%s has %d numbers per atom, not %d" % (name, width, count))
            index = self._order(ids) if order else range(len(made))
            rows = [made[k] for k in index]
            flat = [value for row in rows for value in row] if wide else rows
        elif name == "mask":
            bits = [int(value) - (int(value) >> 31 << 32) for value in self.view("mask")]  # as C int
            flat = [bits[k] for k in (self._order(ids) if order else range(len(bits)))]
        elif name == "image" and count == 1:
            counts = self._columns(name, dtype, 3, ids, order)
            flat = [self.encode_image_flags(*counts[k:k + 3]) for k in range(0, len(counts), 3)]
        else:
            parts = [self._gather(part, ids) if order else self._read(part, None)
                     for part in self._parts_of(name, count)]
            flat = [value for row in zip(*parts) for value in row]
        whole = dtype == 0
        if numpy is not None:
            return numpy.array(flat, dtype=numpy.int32 if whole else numpy.float64)
        return [int(value) for value in flat] if whole else [float(value) for value in flat]

    def _order(self, ids: Any) -> List[int]:
        tags = [int(tag) for tag in self.view("tag")]
        place = {tag: k for k, tag in enumerate(tags)}
        wanted = sorted(tags) if ids is None else [int(k) for k in ids]
        for k in wanted:
            if k not in place:
                raise ValueError("there is no particle with the identity %d" % k)
        return [place[k] for k in wanted]

    def gather_atoms(self, name: str, dtype: int, count: int) -> Any:
        """A quantity of all particles by identity: count numbers of each, one after another (dtype 0
        whole, 1 double).
        """
        return self._columns(name, dtype, count, None, True)

    def gather_atoms_concat(self, name: str, dtype: int, count: int) -> Any:
        """The same in the order of memory."""
        return self._columns(name, dtype, count, None, False)

    def gather_atoms_subset(self, name: str, dtype: int, count: int, ndata: int, ids: Any) -> Any:
        """The same of the particles with these ndata identities, in their order."""
        return self._columns(name, dtype, count, _integers(ids, ndata, "identities")[0], True)

    def scatter_atoms(self, name: str, dtype: int, count: int, data: Any) -> None:
        """Writes a quantity of all particles by identity, as gather_atoms gives it."""
        self._put(name, count, data, None)

    def scatter_atoms_subset(self, name: str, dtype: int, count: int, ndata: int, ids: Any,
                             data: Any) -> None:
        """Writes a quantity of the particles with these identities."""
        self._put(name, count, data, _integers(ids, ndata, "identities")[0])

    def _put(self, name: str, count: int, data: Any, ids: Any) -> None:
        values = [float(value) for value in data]
        n = len(self) if ids is None else len(ids)  # type: ignore[arg-type]
        if len(values) != count * n:
            raise ValueError("%d numbers given, expected %d for each of %d particles" %
                             (len(values), count, n))
        for k, part in enumerate(self._parts_of(name, count)):
            self._scatter(part, values[k::count], ids)

    def create_atoms(self, n: int, atomid: Any, atype: Any, x: Any, v: Any = None, image: Any = None,
                     shrinkexceed: bool = False) -> int:
        """Makes n particles; their number. Identities are assigned; others than these are refused."""
        made = self.create([x[3 * k:3 * k + 3] for k in range(n)] if n and not hasattr(
            x[0], "__len__") else x, None if v is None else v, atype)
        if atomid is not None and [int(k) for k in atomid] != [int(k) for k in made]:
            self.delete(made)  # type: ignore[attr-defined]
            raise ValueError("the identities of new particles are assigned: %s" %
                             ", ".join(str(int(k)) for k in made))
        if image is not None:
            decoded = [self.decode_image_flags(int(k)) for k in image]
            for axis, part in enumerate(("ix", "iy", "iz")):
                self._scatter(part, [flags[axis] for flags in decoded], made)
        return len(made)

    def encode_image_flags(self, ix: int, iy: int, iz: int) -> int:
        """Image counts as one number, as LAMMPS stores them: three times ten bits."""
        for k in (ix, iy, iz):
            if not -512 <= k <= 511:
                raise ValueError("an image count is from -512 to 511, not %d" % k)
        return (ix + 512) & 1023 | ((iy + 512) & 1023) << 10 | ((iz + 512) & 1023) << 20

    def decode_image_flags(self, image: int) -> List[int]:
        """The three image counts of such a number."""
        return [(image >> shift & 1023) - 512 for shift in (0, 10, 20)]

    def gather_bonds(self) -> Tuple[int, Any]:
        """(number of bonds, rows of type and the identities of both partners)."""
        name = "tsim_gather_bonds"
        self.commands("compute %s all property/local btype batom1 batom2" % name, "gather_bonds")
        try:
            made = self.evaluate("c_" + name, "local")
        finally:
            self.commands("uncompute " + name, "gather_bonds")
        if numpy is not None:
            made = numpy.asarray(made, dtype=numpy.int32).reshape(-1, 3)
        return len(made), made

    # -- what there is

    def has_style(self, category: str, name: str) -> bool:
        """Whether there is a style: "fix", "compute", "pair", "command" ..."""
        return name in self.available_styles(category)

    def available_styles(self, category: str) -> List[str]:
        """Names of the styles of a category."""
        from ._manual import kinds, styles
        kind = {"atom": "command", "integrate": "command"}.get(category, category)
        _known(kind, kinds(), "the category")
        return list(styles(kind))

    def has_id(self, category: str, name: str) -> bool:
        """Whether there is a compute, dump, fix, group, region or variable of this name."""
        return name in self.available_ids(category)

    def available_ids(self, category: str) -> List[str]:
        """Names of the computes, dumps, fixes, groups, regions or variables."""
        if category == "group":
            return list(self.groups)  # type: ignore[attr-defined]
        if category == "variable":
            return list(self.variables)
        _known(category, ("compute", "dump", "fix", "region", "group", "variable"), "the category")
        return [name for name, _ in self.live(category)]

    def available_plugins(self) -> List[str]:
        """There are none."""
        return []

    @property
    def installed_packages(self) -> List[str]:
        """What the library was built with."""
        from ._manual import features
        return [name for name, text in features().items() if text != "no"]

    @property
    def accelerator_config(self) -> Dict[str, Dict[str, List[str]]]:
        """How loops are divided."""
        return {"OPENMP": {"api": ["openmp"], "precision": ["double"]}} \
            if "threads" in self.installed_packages else {}

    @property
    def has_mpi_support(self) -> bool:
        """Whether it can join the communicators of mpi4py."""
        return hasattr(_lib, "tsim_mpi_join")

    has_mpi4py = has_mpi_support

    @property
    def has_gpu_device(self) -> bool:
        """There is no GPU."""
        return False

    has_jpeg_support = has_curl_support = has_gpu_device

    def get_gpu_device_info(self) -> str:
        """There is no GPU."""
        return ""

    @property
    def has_exceptions(self) -> bool:
        """Errors are exceptions."""
        return True

    has_gzip_support = has_exceptions

    @property
    def has_png_support(self) -> bool:
        """Pictures are written without a library."""
        return True

    @property
    def has_ffmpeg_support(self) -> bool:
        """Whether movies can be made."""
        return "movies" in self.installed_packages


def _open(cmdargs: Sequence[str]) -> Tuple[Dict[str, Any], Dict[str, List[str]], Optional[str]]:
    """Options of Simulation, variables and the script from the words of a command line."""
    options: Dict[str, Any] = {"screen": True}
    variables: Dict[str, List[str]] = {}
    script = None
    words = [str(word) for word in cmdargs]
    ignored = {"-nocite": 0, "-nc": 0, "-nonbuf": 0, "-nb": 0, "-echo": 1, "-e": 1, "-suffix": 1,
               "-sf": 1, "-skiprun": 0, "-sr": 0}
    while words:
        word = words.pop(0)
        if word in ("-log", "-l", "-screen", "-sc", "-in", "-i") and words:
            value = words.pop(0)
            if word in ("-log", "-l"):
                options["log"] = None if value == "none" else value
            elif word in ("-in", "-i"):
                script = value
            else:
                options["screen"] = value != "none"
        elif word in ("-var", "-v") and len(words) > 1:
            name = words.pop(0)
            variables[name] = []
            while words and not (words[0].startswith("-") and words[0][1:2].isalpha()):
                variables[name].append(words.pop(0))
        elif word in ignored and len(words) >= ignored[word]:
            del words[:ignored[word]]
        else:
            raise ValueError("the option %r is not known, or has no value" % word)
    return options, variables, script


def make_class(base: Any) -> Any:
    """The class `lammps` above Simulation."""

    class lammps(base):
        """A Simulation made and used as the class of that name of LAMMPS' or LIGGGHTS' Python module:
        lammps(cmdargs=["-log", "none", "-screen", "none", "-var", "n", "3"]). gather, scatter and their
        relatives have LAMMPS' arguments (name, type, count).
        """

        def __init__(self, name: str = "", cmdargs: Optional[Sequence[str]] = None, ptr: Any = None,
                     comm: Any = None) -> None:
            if ptr is not None:
                raise ValueError("there are no pointers to a simulation here")
            options, variables, script = _open(cmdargs or [])
            super().__init__(comm=comm, **options)
            for key, values in variables.items():
                self.variables.define(key, "index", " ".join(values)) if len(values) > 1 else \
                    self.variables.preset(key, values[0] if values else "")
            if script is not None:
                self.file(script)

        def gather(self, name: str, dtype: int, count: int) -> Any:
            """As gather_atoms, also of computes, fixes and variables: "c_ID", "f_ID", "v_NAME"."""
            return self.gather_atoms(name, dtype, count)

        def gather_concat(self, name: str, dtype: int, count: int) -> Any:
            """The same in the order of memory."""
            return self.gather_atoms_concat(name, dtype, count)

        def gather_subset(self, name: str, dtype: int, count: int, ndata: int, ids: Any) -> Any:
            """The same of these particles."""
            return self.gather_atoms_subset(name, dtype, count, ndata, ids)

        def scatter(self, name: str, dtype: int, count: int, data: Any) -> None:
            """As scatter_atoms."""
            self.scatter_atoms(name, dtype, count, data)

        def scatter_subset(self, name: str, dtype: int, count: int, ndata: int, ids: Any,
                           data: Any) -> None:
            """As scatter_atoms_subset."""
            self.scatter_atoms_subset(name, dtype, count, ndata, ids, data)

    return lammps
