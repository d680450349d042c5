"""Prints the lines executed, in percent, of each folder of src, from the files *.gcda below a folder.

usage: coverage.py SOURCES FOLDER

A line of a header counts once, executed if it was so in any of the sources that include it."""
import collections
import json
import os
import subprocess
import sys


def main():
    sources, folder = os.path.realpath(sys.argv[1]), os.path.realpath(sys.argv[2])
    seen = collections.defaultdict(dict)
    for path, _, names in os.walk(os.path.join(folder, "src")):
        notes = [os.path.join(path, name) for name in names if name.endswith(".gcno")]
        if not notes:
            continue
        out = subprocess.run(["gcov", "--json-format", "--stdout"] + notes, cwd=folder, check=True,
                             stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
        for text in out.decode().splitlines():
            for file in json.loads(text)["files"] if text.startswith("{") else []:
                name = os.path.relpath(os.path.realpath(os.path.join(folder, file["file"])), sources)
                if name.startswith("src" + os.sep):
                    for line in file["lines"]:
                        number = line["line_number"]
                        seen[name][number] = seen[name].get(number, False) or line["count"] > 0
    total = collections.defaultdict(lambda: [0, 0])
    for name, lines in seen.items():
        for key in (os.path.dirname(name), "all"):
            total[key][0] += sum(lines.values())
            total[key][1] += len(lines)
    print("  lines  executed")
    for key in sorted(total, key=lambda k: (k == "all", k)):
        print("%7d  %6.1f %%  %s" % (total[key][1], 100 * total[key][0] / total[key][1], key))
    if not seen:
        sys.exit("coverage.py: no files *.gcno below " + folder)


main()
