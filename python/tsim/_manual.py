"""What there is: version, kinds, styles, their pages and arguments; the check of scripts."""
from __future__ import annotations

import ctypes
import os
from typing import Any, Dict, List, Optional, Tuple, Union

from ._library import _Argument, _bytes, _lib, _names, _text
from ._results import Argument
from ._simulation import Simulation


def version() -> str:
    """Version of the library."""
    return _text(_lib.tsim_version())


def features() -> Dict[str, str]:
    """What the library was built with: "threads", "png", "hdf5" ... and its libraries; "no" where it
    is not there.
    """
    text, found = ctypes.c_char_p(), dict()  # type: Tuple[Any, Dict[str, str]]
    while True:
        raw = _lib.tsim_feature(len(found), ctypes.byref(text))
        if raw is None:
            return found
        found[_text(raw)] = _text(text.value)


def _text_or_none(raw: Optional[bytes]) -> Optional[str]:
    return None if raw is None else _text(raw)


def check(script: Union[str, "os.PathLike[str]"], name: Optional[str] = None,
          variables: Any = ()) -> Tuple[int, str]:
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
            sim.commands(str(script), name)
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


def kinds() -> List[str]:
    """Kinds of styles: command, fix, pair ..."""
    return _names(_lib.tsim_kind)


def styles(kind: str) -> Dict[str, str]:
    """Names of the styles of a kind with their summaries."""
    summary, found = ctypes.c_char_p(), dict()  # type: Tuple[Any, Dict[str, str]]
    while True:
        raw = _lib.tsim_style(_bytes(kind), len(found), ctypes.byref(summary))
        if raw is None:
            return found
        found[_text(raw)] = _text(summary.value)


def help(kind: str, style: str, markdown: bool = False) -> str:
    """The manual page of a style; LookupError, with a suggestion, if there is none."""
    length = ctypes.c_size_t()
    _lib.tsim_help(_bytes(kind), _bytes(style), markdown, None, 0, ctypes.byref(length))
    page = ctypes.create_string_buffer(length.value + 1)
    status = _lib.tsim_help(_bytes(kind), _bytes(style), markdown, page, len(page), None)
    if status:
        raise LookupError(_text(page.value))
    return _text(page.value)


def arguments(kind: str, style: str) -> List[Argument]:
    """The arguments of a style: a list of Argument."""
    found, raw = [], _Argument()  # type: Tuple[List[Argument], Any]
    while not _lib.tsim_argument(_bytes(kind), _bytes(style), len(found), ctypes.byref(raw)):
        choices: List[str] = []
        while raw.choices and raw.choices[len(choices)] is not None:
            choices.append(_text(raw.choices[len(choices)]))
        found.append(Argument(_text(raw.name), _text(raw.type), _text(raw.help), _text(raw.unit),
                              _text_or_none(raw.fallback),
                              _text_or_none(raw.mode), bool(raw.positional),
                              bool(raw.optional), raw.least, raw.most, choices or None))
    if not found:
        help(kind, style)  # a style that does not exist
    return found
