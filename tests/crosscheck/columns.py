#!/usr/bin/python3
"""Compares two files word by word.

usage: columns.py FILE FILE TOLERANCE

Words that are numbers may deviate by TOLERANCE times the largest number of their column (counted
within lines of as many words), the others are the same. Prints the largest deviation."""
import sys


def number(word):
    try:
        return float(word)
    except ValueError:
        return None


def rows(name):
    with open(name, encoding='ascii') as lines:
        return [line.split() for line in lines]


def main():
    a, b = rows(sys.argv[1]), rows(sys.argv[2])
    tolerance, worst, scale = float(sys.argv[3]), (0.0, ''), {}
    if not a or len(a) != len(b):
        sys.exit(f'{len(a)} and {len(b)} lines')
    for line in a:
        for k, word in enumerate(line):
            key = len(line), k
            scale[key] = max(scale.get(key, 0.0), abs(number(word) or 0))
    for n, (x, y) in enumerate(zip(a, b), 1):
        if len(x) != len(y):
            sys.exit(f'line {n}: {" ".join(x)} and {" ".join(y)}')
        for k, (u, v) in enumerate(zip(x, y)):
            if u == v:
                continue
            if number(u) is None or number(v) is None:
                sys.exit(f'line {n}: {u} and {v}')
            off = abs(number(u) - number(v)) / (scale[len(x), k] or 1)
            worst = max(worst, (off, f'line {n}: {" ".join(x)} and {" ".join(y)}'))
    print(f'{worst[0]:.1e}')
    if not worst[0] <= tolerance:
        sys.exit(worst[1])


main()
