#!/usr/bin/python3
"""Compares what a deck writes that runs whole with what it writes in two parts (split_deck.py).

compare_parts.py WHOLE ONE TWO STEP

Prints `WHAT: same` or where it differs first for each file of the folder WHOLE that has a content, for the state at the end and for
the tables of the logs, without the row of STEP, at which the deck was cut. Titles, which each part writes, are left out.
"""
import gzip
import os
import re
import sys

NO_RESULTS = {"in", "deck", "err", "log"}
OTHER = (".restart", ".pvd", ".series", ".obj")
ROW = re.compile(rb"^ +[0-9]+ +[-+0-9.e ]+$")


def content(folders, name):
    """The bytes of the files of this name, one after the other; of a text, the lines without titles."""
    found = b""
    for folder in folders:
        path = os.path.join(folder, name)
        if not os.path.isfile(path):
            continue
        with (gzip.open if name.endswith(".gz") else open)(path, "rb") as file:
            found += file.read()
    if name.endswith((".gz", ".png", ".ppm")):
        return found
    return b"".join(line for line in found.splitlines(keepends=True) if not line.startswith(b"#"))


def table(folders, step):
    """The rows of the tables, each once where a run follows another."""
    rows = []
    for folder in folders:
        with open(os.path.join(folder, "log"), "rb") as file:
            rows += [line for line in file.read().split(b"\n") if ROW.match(line)]
    once = [row for k, row in enumerate(rows) if k == 0 or row != rows[k - 1]]
    return [row for row in once if row.split()[0] != step]


def tell(what, expected, found):
    """Of bytes, or of rows."""
    if expected == found:
        print(f"{what}: same" if expected else f"{what}: there is none")
        return
    pairs = zip(expected, found)
    first = next((k for k, (a, b) in enumerate(pairs) if a != b), min(len(expected), len(found)))
    print(f"{what}: differs from {first} on, lengths {len(expected)}, {len(found)}")


def main():
    whole, one, two, step = sys.argv[1:]
    for name in sorted(os.listdir(whole)):
        if name in NO_RESULTS or name.endswith(OTHER):
            continue
        expected = content([whole], name)
        if expected:
            tell(name, expected, content([one, two], name))
    tell("the state at the end", content([whole], "end.restart"), content([two], "end.restart"))
    tell("tables", table([whole], step.encode()), table([one, two], step.encode()))


main()
