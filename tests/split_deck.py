#!/usr/bin/python3
"""Cuts a deck in two, after the fashion of a user who goes on from a restart file.

split_deck.py DECK RUN STEPS FIRST SECOND

FIRST is the deck up to STEPS steps of its RUN-th run command (from 1), and saves cut.restart. SECOND reads
that instead of making box and particles, defines again what was live at the cut, and does the rest. RUN 0:
FIRST is the whole deck, without a cut. Both end by writing end.restart. Decks are straight: no jumps, no
`run every`; one without a run gets two.
"""
import re
import sys

MAKES = {"create_box", "create_atoms", "read_data", "read_restart", "set", "velocity", "group",
         "delete_atoms", "create_bonds", "delete_bonds", "displace_atoms", "reset_timestep",
         "replicate", "change_box", "timestep", "mass", "flow_set"}
STARTS = {"create_box", "read_data", "read_restart"}
UNDO = {"unfix": "fix", "uncompute": "compute", "undump": "dump"}


def commands(path):
    """The command lines, those that go on joined."""
    with open(path) as file:
        text = re.sub(r"[ \t]*&[ \t]*\n", " ", file.read())
    return [line for line in text.split("\n") if line.strip() and not line.startswith("#")]


def names(line):
    """The commands of a line: one, or those of an `if`."""
    words = re.findall(r"[\w/]+", line.split("#")[0])
    return set(words) if words[0] == "if" else set(words[:1])


def live(lines):
    """Without what was undone again later."""
    kept = []
    for line in lines:
        words = line.split()
        if words[0] in UNDO:
            target = [UNDO[words[0]], words[1]]
            kept = [k for k in kept if k.split()[:2] != target
                    and not (k.split()[0] == "dump_modify" and words[0] == "undump"
                             and k.split()[1] == words[1])]
        else:
            kept.append(line)
    return kept


def second_part(before):
    """The lines before the cut, as they are said once more."""
    found = False
    for line in before:
        what = names(line)
        if what & STARTS and not found:
            found = True
            yield "read_restart cut.restart"
        elif not what & MAKES and "run" not in what and not line.startswith("write_"):
            yield line


def rest_of_run(line, steps):
    words = line.split()
    if "upto" in words:
        return line
    number = re.sub(r"\$\{(\w+)\}", r"v_\1", words[1])
    return " ".join(["run", f"$({number}-{steps})"] + words[2:])


def main():
    deck, number, steps, first, second = sys.argv[1:]
    number, steps = int(number), int(steps)
    lines = commands(deck)
    if not any(line.split()[0] == "run" for line in lines):
        lines += ["run 211", "run 389"]
    end = ["write_restart end.restart"]
    with open(first, "w") as file:
        runs = [k for k, line in enumerate(lines) if line.split()[0] == "run"]
        at = runs[number - 1] if number else len(lines)
        cut = [f"run {steps}", "write_restart cut.restart"] if number else end
        file.write("\n".join(lines[:at] + cut) + "\n")
    if number:
        with open(second, "w") as file:
            before = list(second_part(live(lines[:at])))
            file.write("\n".join(before + [rest_of_run(lines[at], steps)] + lines[at + 1:] + end) + "\n")


main()
