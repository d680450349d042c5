"""Pictures, and what notebooks show: a simulation, the progress of a run."""
from __future__ import annotations

import base64
import html
import math
import os
import re
import sys
import tempfile
import time
from typing import TYPE_CHECKING, Any, Optional, Tuple

from ._library import _bytes, _lib
from ._results import TsimError

if TYPE_CHECKING:
    from ._simulation import Simulation


class Picture(bytes):
    """A picture, as the bytes of a PNG file; notebooks show it."""

    def _repr_png_(self) -> bytes:
        return bytes(self)

    def save(self, path: Any) -> None:
        """Writes it to a file, whose name should end in .png."""
        with open(path, "wb") as file:
            file.write(self)

    @property
    def size(self) -> Tuple[int, int]:
        """Width and height in pixels."""
        return int.from_bytes(self[16:20], "big"), int.from_bytes(self[20:24], "big")

    def __repr__(self) -> str:
        return "<tsim.Picture of %d x %d pixels>" % self.size


def _surfaces(sim: Simulation) -> str:
    """Words that draw the meshes and height fields there are, and the planes of walls."""
    styles = [style for _, style in sim.live("fix")]
    words = ""
    if any(style.startswith("mesh/surface") for style in styles):
        words += " mesh all color silver trans 0.5"
    if any(style.startswith("wall/gran") for style in styles):
        words += " wall all"
    return words


def _zoom(sim: Simulation, size: Tuple[int, int], view: Tuple[float, float]) -> float:
    """The zoom at which the box just fits: at 1 the picture is twice as high as the longest edge."""
    box = sim.box
    if box is None:
        return 1.0
    theta, phi = map(math.radians, view)
    across = (-math.sin(phi), math.cos(phi), 0.0)
    upward = (-math.cos(theta) * math.cos(phi), -math.cos(theta) * math.sin(phi), math.sin(theta))
    edges = [hi - lo for lo, hi in zip(box.lo, box.hi)]
    wide, high = (sum(abs(part) * edge for part, edge in zip(axis, edges)) for axis in (across, upward))
    return 2 * max(edges) / (1.06 * max(high, wide * size[1] / size[0]))


def draw(sim: Simulation, color: str, diameter: str, size: Tuple[int, int],
         view: Tuple[float, float], zoom: Optional[float], words: Optional[str], modify: str,
         group: str) -> Picture:
    """The picture that write_dump makes."""
    handle, path = tempfile.mkstemp(suffix=".png", prefix="tsim")
    os.close(handle)
    if modify:
        modify = " modify " + modify
    line = "write_dump %s image %s %s %s size %d %d view %.17g %.17g zoom %.17g fsaa yes%s%s" % (
        group, path, color, diameter, *size, *view, zoom or _zoom(sim, size, view),
        " " + words if words is not None else _surfaces(sim),
        modify or " modify backcolor white boxcolor gray")
    try:
        sim._check(_lib.tsim_text(sim._pointer, _bytes(line), b"picture"))
        with open(path, "rb") as file:
            return Picture(file.read())
    finally:
        os.unlink(path)


def summary(sim: Simulation) -> str:
    """A simulation in a notebook: its picture and what it consists of."""
    if sim.closed or sim.box is None:
        return html.escape(repr(sim))
    rows = [("particles", "%d" % len(sim)), ("step", "%d" % sim.clock.step),
            ("time", "%.6g" % sim.clock.time), ("time step", "%.6g" % sim.clock.dt),
            ("box", " &times; ".join("%.4g" % (hi - lo) for lo, hi in zip(sim.box.lo, sim.box.hi)))]
    for kind in ("pair", "fix", "compute"):
        live = sim.live(kind)
        rows.append((kind, html.escape(", ".join(
            style if kind == "pair" else "%s (%s)" % (name, style) for name, style in live[:12]) +
            (" ..." if len(live) > 12 else ""))))
    picture = ""
    if len(sim) and not sim.setting("running"):
        try:
            data = base64.b64encode(sim.picture(size=(420, 320))).decode()
            picture = '<img src="data:image/png;base64,%s" alt="the particles">' % data
        except TsimError as error:  # what cannot be drawn is told, not raised
            picture = html.escape(error.message)
    table = "".join("<tr><th style='text-align:left'>%s</th><td style='text-align:left'>%s</td></tr>" % row
                    for row in rows if row[1])
    return '<div style="display:flex;gap:1em">%s<table>%s</table></div>' % (picture, table)


# ---- progress

def in_notebook() -> bool:
    """Whether a notebook, and no terminal, runs this."""
    module = sys.modules.get("IPython")
    shell = module.get_ipython() if module is not None and hasattr(module, "get_ipython") else None
    return shell is not None and hasattr(shell, "kernel")


class Progress:
    """A bar that appears after a second: in a notebook as a picture, otherwise as a line on stderr."""

    PATIENCE = 1.0  # s
    RENEW = 0.2

    def __init__(self) -> None:
        self._due = time.monotonic() + self.PATIENCE
        self._handle: Any = None
        self._shown = False
        self._notebook = in_notebook()

    def line(self, text: str) -> None:
        """A line of progress of the library: "12.5 %, step 125 of 1000 ..."."""
        share = re.match(r"([0-9.]+) %", text)
        self.show(float(share.group(1)) / 100 if share else 0.0, text)

    def show(self, share: float, text: str) -> None:
        """Draws the bar anew, five times a second at most."""
        now = time.monotonic()
        if now < self._due:
            return
        self._due = now + self.RENEW
        self._shown = True
        if not self._notebook:
            sys.stderr.write("\r[%-30s] %5.1f %%  %s" % ("=" * int(30 * share), 100 * share, text))
            sys.stderr.flush()
            return
        from IPython import display  # type: ignore[import]
        bar = display.HTML('<progress value="%.4f" max="1"></progress> %s' % (share, html.escape(text)))
        if self._handle is None:
            self._handle = display.display(bar, display_id=True)
        else:
            self._handle.update(bar)

    def close(self) -> None:
        """Removes the bar."""
        if not self._shown:
            return
        if not self._notebook:
            sys.stderr.write("\r%79s\r" % "")
        elif self._handle is not None:
            from IPython import display
            self._handle.update(display.HTML(""))
