#!/usr/bin/python3
"""Seeds of the fuzzers: make_seeds.py script|check|explain|expression|restart FOLDER FILE ..."""
import os
import re
import struct
import sys
import zlib


def statements(text):
    """Expressions in a script: what stands in $(...), and formulae of variables."""
    found = re.findall(r"\$\(([^()]*(?:\([^()]*\)[^()]*)*)\)", text)
    found += re.findall(r"(?m)^variable\s+\S+\s+(?:equal|atom)\s+(.*)$", text)
    return [line.strip('"') for line in found]


BOX = """units si
boundary p f m
lattice sc 0.11
region box block 0 1 0 1 0 1 units box
region low block 0 0.6 0 0.3 0 0.3 units box
create_box 2 box
create_atoms 1 region low
set type 1 diameter 0.12 density 1000
group rock type 1
pair_style spring/dashpot
pair_coeff * * stiffness 100 restitution 0.5
fix move all nve
timestep 1e-3
"""


def scripts(path, text):
    """A deck, or the examples of a manual page, each in a scene of its own."""
    if not path.endswith(".md"):
        return ["variable out index x\n" + text]
    found = re.search(r"(?s)## Example\w*\n+```\n(.*?)```", text)
    return [BOX + found.group(1) + "run 2\n"] if found else []


def plain_sections(data):
    """A restart file without its checksums and compression, as fuzz_restart.c reads it."""
    at = data.index(b"\n") + 1 + 8
    out = b""
    while struct.unpack_from("<I", data, at)[0]:
        kind, a, b, c, plain, packed, _, _ = struct.unpack_from("<4I2Q2I", data, at)
        at += 40
        names = data[at:at + a + b + c]
        at += a + b + c
        block = zlib.decompress(data[at:at + packed])[:-4]
        at += packed
        out += struct.pack("<I3BI", kind, a, b, c, len(block)) + names + block
    return out


def main():
    what, folder, files = sys.argv[1], sys.argv[2], sys.argv[3:]
    os.makedirs(folder, exist_ok=True)
    for number, path in enumerate(files):
        with open(path, "rb") as file:
            data = file.read()
        pieces = [data]
        if what == "restart":
            pieces.append(plain_sections(data))
        if what in ("script", "check", "explain"):
            pieces = [s.encode() for s in scripts(path, data.decode(errors="ignore"))]
        if what == "expression":
            pieces = [s.encode() for s in statements(data.decode(errors="ignore"))]
        for k, piece in enumerate(pieces):
            if len(piece) > (1 << 16):
                continue
            with open(f"{folder}/{number}.{k}", "wb") as file:
                file.write(piece)


main()
