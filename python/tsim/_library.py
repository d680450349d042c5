"""The C library libtsim by ctypes: structures, types of its functions, where it is."""
from __future__ import annotations

import ctypes
import ctypes.util
import os
import sys
from typing import Any, Callable, List, Optional


class _Structure(ctypes.Structure):
    """One that begins with its size."""

    def __init__(self, **fields: Any) -> None:
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


class _Row(_Structure):
    _fields_ = [("size", ctypes.c_size_t), ("step", ctypes.c_int64), ("time", ctypes.c_double),
                ("columns", ctypes.c_size_t), ("names", _Texts), ("values", _c_double_p)]


_RowFunction = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.POINTER(_Row))


class _Sheet(_Structure):
    _fields_ = [("size", ctypes.c_size_t), ("title", ctypes.c_char_p), ("rows", ctypes.c_size_t),
                ("columns", ctypes.c_size_t)]


class _Argument(_Structure):
    _fields_ = [("size", ctypes.c_size_t), ("name", ctypes.c_char_p), ("help", ctypes.c_char_p),
                ("type", ctypes.c_char_p), ("unit", ctypes.c_char_p),
                ("fallback", ctypes.c_char_p), ("mode", ctypes.c_char_p),
                ("positional", ctypes.c_int), ("optional", ctypes.c_int),
                ("nullable", ctypes.c_int), ("least", ctypes.c_double), ("most", ctypes.c_double),
                ("positive", ctypes.c_int), ("choices", _Texts)]


def _declare(lib: ctypes.CDLL) -> ctypes.CDLL:
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
            ("pairs", number, sim, _c_int32_p, size, _c_size_p),
            ("external", number, sim, text, text, _c_double_p, size),
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
            ("on_log", None, sim, _LogFunction, ctypes.c_void_p),
            ("on_row", None, sim, _RowFunction, ctypes.c_void_p),
            ("tables", number, sim, text, _c_size_p),
            ("table", number, sim, size, p(_Sheet)),
            ("table_column", number, sim, size, size, p(text), p(_c_double_p)),
            ("feature", text, size, p(text)),
            ("style", text, text, size, p(text)),
            ("help", number, text, text, number, text, size, _c_size_p),
            ("argument", number, text, text, size, p(_Argument))):
        function = getattr(lib, "tsim_%s" % name)
        function.restype, function.argtypes = result, arguments
    if hasattr(lib, "tsim_mpi_join"):
        lib.tsim_mpi_join.restype, lib.tsim_mpi_join.argtypes = number, [sim, ctypes.c_void_p]
    return lib


def _candidates() -> List[str]:
    here = os.path.dirname(os.path.abspath(__file__))
    if "TSIM_LIBRARY" in os.environ:
        return [os.environ["TSIM_LIBRARY"]]
    folders = [".",                                 # a wheel
               "../..", "../../build", "../../b",   # the source tree and where one builds
               "../../../../lib", "../../../../lib64",  # PREFIX/share/tsim/python
               "../../..", "../../../.."]           # PREFIX/lib/python3/dist-packages
    # With mpi4py the library that can join its communicators, where there is one.
    names = ["tsim_mpi", "tsim"] if "mpi4py.MPI" in sys.modules else ["tsim"]
    files = [os.path.normpath(os.path.join(here, folder, "lib%s.so" % name))
             for name in names for folder in folders]
    return [f for f in files if os.path.exists(f)] + [
        ctypes.util.find_library(name) or "lib%s.so.0" % name for name in names]


def _load() -> ctypes.CDLL:
    failure: object = "no file"
    for path in _candidates():
        try:
            return _declare(ctypes.CDLL(path))
        except OSError as error:
            failure = error
    raise ImportError("libtsim was not found (%s); name it in the environment variable "
                      "TSIM_LIBRARY" % failure)


_lib: Any = _load()

# A wheel has the files of materials, too; the library looks for them where this variable says.
_potentials = os.path.join(os.path.dirname(os.path.abspath(__file__)), "potentials")
if os.path.isdir(_potentials):
    os.environ.setdefault("TSIM_POTENTIALS", _potentials)


def _bytes(text: object) -> bytes:
    made = os.fsencode(text) if isinstance(text, os.PathLike) else str(text).encode()
    if b"\0" in made:  # C would take it as the end
        raise ValueError("%r has a null character" % (text,))
    return made


def _text(raw: Optional[bytes]) -> str:
    return raw.decode(errors="replace") if raw is not None else ""


def _names(function: Callable[[int], Optional[bytes]]) -> List[str]:
    """The texts function(0), function(1) ... up to NULL."""
    names, raw = [], function(0)
    while raw is not None:
        names.append(_text(raw))
        raw = function(len(names))
    return names
