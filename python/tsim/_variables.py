"""Variables of the script."""
from __future__ import annotations

import ctypes
import weakref
from typing import TYPE_CHECKING, Iterator, Union

from ._library import _bytes, _lib, _names, _text
from ._results import TsimError

if TYPE_CHECKING:
    from ._simulation import Simulation


class Variables:
    """The script's variables: sim.variables["name"] gives a number, or the text where it is none; a
    number assigned makes it an equal-style variable, a text one of style string.
    """

    def __init__(self, sim: Simulation) -> None:
        self._sim = weakref.proxy(sim)

    def __getitem__(self, name: str) -> Union[float, str]:
        if name not in self:
            raise KeyError(name)
        try:
            return float(self._sim.value("v_" + name))
        except TsimError:
            return self.text(name)

    def text(self, name: str) -> str:
        """What ${name} stands for."""
        length, room = ctypes.c_size_t(), 256
        while True:
            out = ctypes.create_string_buffer(room)
            self._sim._check(_lib.tsim_variable_text(self._sim._pointer, _bytes(name), out, room,
                                                     ctypes.byref(length)))
            if length.value < room:
                return _text(out.value)
            room = length.value + 1

    def __setitem__(self, name: str, value: Union[float, str]) -> None:
        if isinstance(value, str):
            self.define(name, "string", value)
        else:
            self._sim._check(_lib.tsim_variable_number(self._sim._pointer, _bytes(name),
                                                       float(value)))

    def define(self, name: str, style: str, value: object) -> None:
        """As the line `variable NAME STYLE VALUE`, replacing one of that name."""
        self._sim._check(_lib.tsim_variable_set(self._sim._pointer, _bytes(name), _bytes(style),
                                                _bytes(value)))

    def preset(self, name: str, value: object) -> None:
        """Sets an index variable, which wins over the script's own, as the option -var does."""
        self._sim._check(_lib.tsim_variable(self._sim._pointer, _bytes(name), _bytes(value)))

    def __contains__(self, name: object) -> bool:
        return name in list(self)

    def __iter__(self) -> Iterator[str]:
        return iter(_names(lambda k: _lib.tsim_variable_name(self._sim._pointer, k)))  # type: ignore[no-any-return]

    def __len__(self) -> int:
        return len(list(iter(self)))
