#!/bin/bash
# Files for ParaView, read back with VTK's own reader and compared with the text dumps of the same
# run; compressed dumps. Without Debian's python3-vtk9 only the latter.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.files <<END
variable out index small
include $top_srcdir/tests/decks/in.everything
thermo_modify format float %14.8g
dump v all custom/vtk 45 p*.vtp id type type x y z vx vy vz radius
dump l all local/vtk 45 b*.vtp c_nb[1] c_nb[2] c_nb[4] c_nb[5]
dump k all local/vtk 45 c*.vtp c_nc[1] c_nc[2] c_nc[3]
dump x all custom 45 x.dump id x y z vx vy vz radius
dump xb all local 45 xb.dump c_nb[1] c_nb[2] c_nb[4] c_nb[5]
dump xc all local 45 xc.dump c_nc[1] c_nc[2] c_nc[3]
dump z all custom 45 z.dump.gz id x y z vx vy vz radius
dump zs all custom 45 z*.dump.gz id x y z vx vy vz radius
dump_modify x format float %.17g
dump_modify z format float %.17g
dump_modify zs pad 6 format float %.17g
dump_modify xb format float %.17g
dump_modify xc format float %.17g
run 225
END
"$TSIM" -in in.files -log none -screen none 2>err
report 'runs' $? err

gzip -t z.dump.gz && gzip -dc z.dump.gz >z.dump
same 'compressed dump' x.dump z.dump
for step in 000000 000045 000090 000135 000180 000225; do
	gzip -t "z$step.dump.gz" && gzip -dc "z$step.dump.gz"
done >zs.dump
same 'one compressed file per frame' x.dump zs.dump

python_with vtkmodules.vtkIOXML python3-vtk9 || finish
for set in p b c; do
	"$python" "$top_srcdir/tests/vtk_readback.py" $set.pvd >$set.read 2>err
	report "VTK reads $set.pvd" $? err
	grep -q "$set.pvd: 6 frames" $set.read
	report "six frames of $set" $? $set.read
done

# compare.py DUMP READ point|cell COUNT NAME=COLUMN...: number and ranges, frame by frame; COLUMN is
# the first column of the dump that NAME holds
cat >compare.py <<'END'
import re, sys

def dump_frames(path):
    frames, lines, at = [], open(path).read().split("\n"), 0
    while at < len(lines) and lines[at].startswith("ITEM: TIMESTEP"):
        n = int(lines[at + 3])
        while not re.match("ITEM: (ATOMS|ENTRIES)", lines[at]):
            at += 1
        frames.append([[float(w) for w in l.split()] for l in lines[at + 1:at + 1 + n]])
        assert all(len(row) == len(lines[at].split()) - 2 for row in frames[-1])
        at += 1 + n
    return frames

def vtk_frames(path, kind):
    frames = []
    for line in open(path):
        if ".vtp: " in line:
            frames.append({k: int(v) for v, k in re.findall(r"(\d+) (\w+)", line.split(": ")[1])})
        elif line.startswith("  "):
            what, *rest = line.split()
            name = "bounds" if what == "bounds" else rest[0]
            if what in (kind, "bounds"):
                ranges = [tuple(map(float, r.split(".."))) for r in rest if ".." in r]
                frames[-1][name] = ranges
    return frames

dump, read, kind, count = dump_frames(sys.argv[1]), vtk_frames(*sys.argv[2:4]), *sys.argv[3:5]
assert len(dump) == len(read) == 6, (len(dump), len(read))
for rows, frame in zip(dump, read):
    assert frame[count] == len(rows), (frame[count], len(rows))
    for pair in sys.argv[5:]:
        name, first = pair.split("=")
        for c, (low, high) in enumerate(frame[name]):
            column = [row[int(first) + c] for row in rows]
            for mine, theirs in ((min(column), low), (max(column), high)):
                assert abs(mine - theirs) <= 2e-7 * max(abs(mine), 1e-6), (name, mine, theirs)
END
"$python" compare.py x.dump p.read point points id=0 bounds=1 v=4 radius=7 2>err
report 'particles are those of the dump' $? err
"$python" compare.py x.dump p.read point vertices id=0 2>err
report 'one vertex each' $? err
"$python" compare.py xb.dump b.read cell lines 'c_nb[1]=0' 'c_nb[4]=2' 'c_nb[5]=3' 2>err
report 'bonds are those of the dump' $? err
"$python" compare.py xc.dump c.read cell lines 'c_nc[3]=2' 2>err
report 'contacts are those of the dump' $? err
finish
