#!/usr/bin/python3
"""Compares the outputs of a deck that runs whole with those of its two parts (split_deck.py).

compare_parts.py WHOLE ONE TWO

Prints `FILE: same`, or where it differs first, for each output in the folder WHOLE that has a content. Titles, which each part
writes, are left out.
"""
import gzip
import os
import sys

NO_RESULTS = {"in", "deck", "err", "log"}
OTHER = (".restart", ".pvd", ".series", ".obj")


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


def tell(name, expected, found):
    if expected == found:
        print(f"{name}: same")
        return
    pairs = zip(expected, found)
    first = next((k for k, (a, b) in enumerate(pairs) if a != b), min(len(expected), len(found)))
    print(f"{name}: differs from byte {first} on, lengths {len(expected)}, {len(found)}")


def main():
    whole, one, two = sys.argv[1:]
    for name in sorted(os.listdir(whole)):
        if name in NO_RESULTS or name.endswith(OTHER):
            continue
        expected = content([whole], name)
        if expected:
            tell(name, expected, content([one, two], name))


main()
