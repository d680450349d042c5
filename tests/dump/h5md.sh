#!/bin/bash
# dump h5md: the numbers of dump custom; particles that come and go; groups that share a file; continued, killed, and
# on a full disk.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >model <<'END'
units si
atom_style granular
boundary p f f
newton off
communicate single vel yes
region box block 0 1 -1 1 0 1 units box
END
cat >start <<'END'
create_box 2 box
create_atoms 1 random 30 12345 box
create_atoms 2 random 20 54321 box
set group all diameter 0.01 density 2385
velocity all create 1e19 4928459
END
cat >rest <<'END'
group big type 1
group few type 2
timestep 1e-3
thermo_modify lost ignore
fix move all nve/sphere
variable kin atom mass*vx
compute p all property/atom radius omegax
END
cat >dumps <<'END'
dump d all h5md 10 file.h5 position velocity every 2 force image species radius v_kin c_p[*] author "A. Miller"
dump t all custom 10 table.csv id x y z vx vy vz fx fy fz ix iy iz type radius v_kin c_p[1] c_p[2]
dump_modify t append yes
END
cat model start rest - >in.probe <<<'dump d all h5md 10 file.h5 position'
if "$TSIM" -check -in in.probe 2>&1 | grep -q 'this tsim was built without HDF5'; then
	echo 'skipped: needs HDF5 (apt-get install libhdf5-dev; configure)'
	finish
fi

cat model start rest dumps - >in.whole <<<'run 60'
"$TSIM" -in in.whole -log none >out 2>&1
report 'runs' $? out
# without a reader of Python what follows has only the refused
cat >read.py <<'END'
import csv, sys
import h5py
import numpy as np

def group(name="file.h5", of="all"):
    return h5py.File(name, "r")["particles/" + of]

def same(what, a, b):
    good = np.shape(a) == np.shape(b) and np.array_equal(np.asarray(a, float), np.asarray(b, float), equal_nan=True)
    print(what, "same" if good else "different: %s %s" % (a, b))

def table(name="table.csv"):
    rows = list(csv.DictReader(open(name)))
    return sorted({int(r["step"]) for r in rows}), rows

def compare(name="file.h5", csv_name="table.csv"):
    g, (steps, rows) = group(name), table(csv_name)
    same("steps", g["id/step"][:], steps)
    same("times", g["position/time"][:], [s * 1e-3 for s in steps])
    columns = {"position": "x y z", "force": "fx fy fz", "image": "ix iy iz", "species": "type", "radius": "radius",
               "v_kin": "v_kin", "c_p[1]": "c_p[1]", "c_p[2]": "c_p[2]", "id": "id"}
    for element, names in columns.items():
        value, names = g[element + "/value"], names.split()
        missing = -1 if value.dtype.kind == "i" else float("nan")
        want = np.full((len(steps), value.shape[1], len(names)), missing, float)
        for k, s in enumerate(steps):
            for i, r in enumerate([r for r in rows if int(r["step"]) == s]):
                want[k, i] = [float(r[n]) for n in names]
        same(element, value[:], want if len(names) > 1 else want[:, :, 0])

exec(sys.argv[1])
END
python_with h5py python3-h5py || finish
read_it() { # WHAT CODE N: the code prints N lines, all `same`
	"$python" read.py "$2" >got 2>&1 && [ "$(grep -c ' same$' got)" = "$3" ] && ! grep -q different got
	report "$1" $? got
}
read_it 'the numbers of dump custom' 'compare()' 11
read_it 'what a file has' '
f = h5py.File("file.h5"); g = group()
same("version", f["h5md"].attrs["version"], [1, 1])
print("author", "same" if f["h5md/author"].attrs["name"] == b"A. Miller" else "different")
same("dimension", g["box"].attrs["dimension"], 3)
print("boundary", "same" if list(g["box"].attrs["boundary"]) == [b"periodic", b"none", b"none"] else "different")
same("edges", g["box/edges/value"][:], [[1, 2, 1]] * 7)
same("offset", g["box/offset/value"][:], [[0, -1, 0]] * 7)
same("every", g["velocity/step"][:], [0, 20, 40, 60])
same("velocity", g["velocity/value"][1, 3], [float(next(r for r in table()[1] if r["step"] == "20" and int(r["id"]) == g["id/value"][2, 3])["v" + d]) for d in "xyz"])
print("linked", "same" if g["position/step"] == g["box/edges/step"] else "different")
print("leave", "same" if (g["id/value"][-1] < 0).any() and (g["id/value"][0] > 0).all() else "different")
' 10

# a restart; the first part has gone too far
mkdir whole && mv file.h5 table.csv whole
{ cat model start rest dumps; printf '%s\n' 'run 25' 'write_restart half' 'run 15'; } >in.first
{ sed 's/^region.*//' model; echo 'read_restart half'; cat rest dumps; echo 'run 35'; } >in.second
"$TSIM" -in in.first -log none >out 2>&1 && "$TSIM" -in in.second -log none -threads 2 >>out 2>&1
report 'in two runs' $? out
read_it 'continued' '
a, b = group("whole/file.h5"), group()
names = []
a.visit(lambda n: names.append(n))
for n in names:
    if isinstance(a[n], h5py.Dataset):
        same(n, a[n][:], b[n][:])' 16

# more particles than in the first frames
{ cat model; sed '/random 20/d' start; cat rest dumps
  printf '%s\n' 'run 20' 'create_atoms 2 random 25 777 box' 'set type 2 diameter 0.01 density 2385' 'run 20'; } >in.more
rm -f file.h5 table.csv
"$TSIM" -in in.more -log none >out 2>&1
report 'particles come' $? out
read_it 'the numbers with more particles' 'compare()
print("first", "same" if group()["id/value"].shape[1] > 30 and (group()["id/value"][0, 30:] == -1).all() else "different")' 12

# two groups in one file, and one file per frame
{ cat model start rest; printf '%s\n' 'dump a big h5md 10 both.h5 position' 'dump b few h5md 20 both.h5 species file_from a' \
	'dump c few h5md 20 one.*.h5 id2' 'run 40'; } | sed 's/id2/mass/' >in.both
"$TSIM" -in in.both -log none >out 2>&1
report 'two groups' $? out
read_it 'a file of two groups' '
same("big", group("both.h5", "big")["position/step"][:], [0, 10, 20, 30, 40])
same("few", group("both.h5", "few")["species/step"][:], [0, 20, 40])
same("type", np.unique(group("both.h5", "few")["species/value"][0]), [2])
same("one", group("one.20.h5", "few")["mass/step"][:], [20])' 4

# a sheared box
printf '%s\n' 'units si' 'boundary p p p' 'region b block 0 2 0 1 0 1 units box' 'create_box 1 b' \
	'create_atoms 1 single 0.5 0.5 0.5 units box' 'set group all diameter 0.1 density 1000' 'timestep 1e-3' \
	'fix n all nve/sphere' 'fix s all deform 1 xy erate 1 remap v' 'dump d all h5md 100 sheared.h5 position' 'run 100' >in.sheared
"$TSIM" -in in.sheared -log none >out 2>&1
report 'a sheared box runs' $? out
read_it 'its vectors' 'e = group("sheared.h5")["box/edges/value"][-1]
same("edges", np.round(e, 12), [[2, 0, 0], [0.1, 1, 0], [0, 0, 1]])' 1

# killed: frames up to then, but one if it is killed while it writes it; and the next run goes on
{ cat model start rest; echo 'dump d all h5md 10 killed.h5 position'; echo 'run 100000000'; } >in.killed
"$TSIM" -in in.killed -log none -screen none &
process=$!
wait_for test -s killed.h5
sleep 0.3
kill -9 $process
wait $process 2>/dev/null
read_it 'a killed run leaves a readable file' '
g = group("killed.h5"); n = len(g["position/step"])
same("steps", g["position/step"][:], [10 * k for k in range(n)])
print("frames", "same" if n > 1 and abs(g["position/value"].shape[0] - n) <= 1 else "different %d" % n)' 2

# a full disk
small() { # PROGRAM ARGUMENTS: files may have 1 MB
	(
		ulimit -f 1000
		exec "$@"
	)
}
{ cat model; sed 's/random 30/random 1000/' start; cat rest; echo 'dump d all h5md 1 full.h5 position velocity'; echo 'run 50'; } >in.full
small "$TSIM" -in in.full -log none >out 2>err
[ $? = 1 ] && grep -q "writing 'full.h5' failed: File too large" err && [ "$(grep -c error err)" = 1 ]
report 'a full disk: one message' $? err
read_it 'the frames before it' '
g = group("full.h5"); n = len(g["position/step"])
same("steps", g["position/step"][:], range(n))
print("whole", "same" if n > 1 and (np.isfinite(g["velocity/value"][:, :, 0]) == (g["id/value"][:] > 0)).all() and g["velocity/value"].shape[0] == n else "different")' 2

# refused
wrong() { # WHAT LINES TEXT
	{ cat model start rest; printf '%s\n' "$2" 'run 10'; } >in.wrong
	refused "$1" "$3" -in in.wrong
}
wrong 'nothing to write' 'dump d all h5md 10 a.h5 author me' 'say what to write'
wrong 'an unknown word' 'dump d all h5md 10 a.h5 velocities' 'velocities'
wrong 'twice' 'dump d all h5md 10 a.h5 image image' "'image' is named twice"
wrong 'every alone' 'dump d all h5md 10 a.h5 every 10' '`every` must follow a quantity'
wrong 'two dumps, one file' 'dump d big h5md 10 a.h5 image
dump e few h5md 10 a.h5 image' 'share it by `file_from d`'
wrong 'two dumps, one group' 'dump d all h5md 10 a.h5 image
dump e all h5md 10 a.h5 force file_from d' 'writes the same group'
wrong 'file_from of another dump' 'dump d all custom 10 a id
dump e all h5md 10 a.h5 force file_from d' 'd is not one'
echo 'no HDF5' >text.h5
wrong 'no HDF5 file' 'dump d all h5md 10 text.h5 image
dump_modify d append yes' 'it is not an HDF5 file'
wrong 'other quantities' 'dump d all h5md 10 whole/file.h5 mass
dump_modify d append yes
reset_timestep 1000' "its frames have no 'mass'"
{ cat model start rest; echo 'dump d all h5md 10 a.h5 image'; echo 'run 0'; } >in.wrong
refused 'in the sandbox' 'cannot be written with -sandbox' -sandbox -in in.wrong
finish
