#!/bin/bash
# VTK dumps into one file .vtkhdf: the layout that the format asks for, with the numbers of dump custom; particles that come and
# go; lines, triangles; continued and cut runs; misuse.
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
set group all diameter 0.2 density 2385
velocity all create 1e23 4928459
END
cat >rest <<'END'
pair_style spring/dashpot
pair_coeff * * stiffness 2385 damping 0
timestep 1e-3
thermo_modify lost ignore
fix move all nve/sphere
variable kin atom mass*vx
compute p all pair/gran/local pos id force
END
cat >dumps <<'END'
dump d all custom/vtk 10 all.vtkhdf id type vx vy vz radius v_kin
dump l all local/gran/vtk 20 chains.vtkhdf p
dump t all custom 10 table.csv id x y z vx vy vz type radius v_kin
dump_modify t append yes
END
cat model start rest - >in.probe <<<'dump d all custom/vtk 10 file.vtkhdf id'
if "$TSIM" -check -in in.probe 2>&1 | grep -q 'built without HDF5'; then
	echo 'skipped: needs HDF5 (apt-get install libhdf5-dev; configure)'
	finish
fi
cat model start rest dumps - >in.whole <<<'run 60'
"$TSIM" -in in.whole -log none >out 2>&1
report 'runs' $? out

misuse() { # MESSAGE LINES...
	{ cat model start rest; printf '%s\n' "${@:2}" 'run 10'; } >in.misuse
	refused "misuse: $2" "$1" -in in.misuse
}
misuse 'leave out the `*`' 'dump d all custom/vtk 10 file*.vtkhdf id'
misuse "dump d writes 'file.vtkhdf', too" 'dump d all custom/vtk 10 file.vtkhdf id' 'dump e all custom/vtk 10 file.vtkhdf id'
misuse 'its frames have other quantities' 'dump d all custom/vtk 10 file.vtkhdf id' 'run 10' 'undump d' \
	'dump d all custom/vtk 10 file.vtkhdf id type' 'dump_modify d append yes'
misuse "frames have no 'radius'" 'dump d all custom/vtk 10 file.vtkhdf id' 'run 10' 'undump d' \
	'dump d all custom/vtk 10 file.vtkhdf radius' 'dump_modify d append yes'
echo text >file.vtkhdf
misuse 'it is not an HDF5 file' 'dump d all custom/vtk 10 file.vtkhdf id' 'dump_modify d append yes'
# a full disk
rm -f file.vtkhdf
{ cat model start rest; printf '%s\n' 'dump d all custom/vtk 1 file.vtkhdf id x y z vx vy vz fx fy fz' 'run 2000'; } >in.full
(ulimit -f 300; trap '' XFSZ; "$TSIM" -in in.full -log none >out 2>err)
[ $? = 1 ] && [ "$(grep -c error: err)" = 1 ] && grep -q 'writing .file.vtkhdf. failed' err
report 'a full disk' $? err
mv file.vtkhdf full.vtkhdf

cat >read.py <<'END'
import csv, sys
import h5py
import numpy as np

def same(what, a, b):
    good = np.shape(a) == np.shape(b) and np.array_equal(np.asarray(a, float), np.asarray(b, float))
    print(what, "same" if good else "different: %s %s" % (a, b))

def layout(name, size):
    """What the format asks for, whatever is in the file."""
    g = h5py.File(name)["VTKHDF"]
    s, n = g["Steps"], g["Steps"].attrs["NSteps"]
    points, cells = g["NumberOfPoints"][:], g["NumberOfCells"][:]
    before = lambda a: np.concatenate([[0], np.cumsum(a)[:-1]])
    print("type", "same" if g.attrs["Type"] == b"UnstructuredGrid" else "different")
    same("version", g.attrs["Version"], [2, 0])
    same("steps", [len(s["Values"]), len(points)], [n, n])
    same("parts", s["PartOffsets"][:], range(n))
    same("one part", s["NumberOfParts"][:], [1] * n)
    same("points", s["PointOffsets"][:], before(points))
    same("cells", s["CellOffsets"][:], before(cells))
    same("ids", s["ConnectivityIdOffsets"][:], before(g["NumberOfConnectivityIds"][:]))
    same("cell size", points, size * cells)
    same("all points", g["Points"].shape, [sum(points), 3])
    same("connectivity", g["Connectivity"][:], np.concatenate([np.arange(p) for p in points]))
    same("offsets", g["Offsets"][:], np.concatenate([size * np.arange(c + 1) for c in cells]))
    same("types", g["Types"][:], [{1: 1, 2: 3, 3: 5}[size]] * sum(cells))
    for kind, first in ("PointData", s["PointOffsets"]), ("CellData", s["CellOffsets"]):
        same(kind, [len(g[kind][a]) for a in g[kind]], [sum(points) if kind == "PointData" else sum(cells)] * len(g[kind]))
        for a in g[kind]:
            same(a, s[kind + "Offsets"][a][:], first[:])

def numbers(name="all.vtkhdf", table="table.csv"):
    f = h5py.File(name)
    g, rows = f["VTKHDF"], list(csv.DictReader(open(table)))
    steps = sorted({int(r["step"]) for r in rows})
    same("steps", f["tsim/step"][:], steps)
    same("times", g["Steps/Values"][:], [s * 1e-3 for s in steps])
    for k, s in enumerate(steps):
        a = g["Steps/PointOffsets"][k]
        b = a + g["NumberOfPoints"][k]
        of = [r for r in rows if int(r["step"]) == s]
        order = np.argsort(g["PointData/id"][a:b])
        of.sort(key=lambda r: int(r["id"]))
        for data, names in ("Points", "x y z"), ("PointData/v", "vx vy vz"), ("PointData/radius", "radius"), \
                ("PointData/type", "type"), ("PointData/kin", "v_kin"), ("PointData/id", "id"):
            want = np.array([[float(r[n]) for n in names.split()] for r in of])
            same(data, g[data][a:b][order], want if want.shape[1] > 1 else want[:, 0])
    print("leave", "same" if g["NumberOfPoints"][-1] < 50 else "different")

exec(sys.argv[1])
END
python_with h5py python3-h5py || finish
read_it() { # WHAT CODE N: the code prints N lines, all `same`
	"$python" read.py "$2" >got 2>&1 && [ "$(grep -c ' same$' got)" = "$3" ] && ! grep -q different got
	report "$1" $? got
}
read_it 'layout of particles' 'layout("all.vtkhdf", 1)' 20
read_it 'layout of lines' 'layout("chains.vtkhdf", 2)' "$("$python" -c '
import h5py; g = h5py.File("chains.vtkhdf")["VTKHDF"]; print(15 + len(g["CellData"]) + len(g["PointData"]))')"
read_it 'the numbers of dump custom' 'numbers()' 45

read_it 'what a full disk leaves' 'layout("full.vtkhdf", 1)
print("frames", "same" if h5py.File("full.vtkhdf")["VTKHDF/Steps"].attrs["NSteps"] > 10 else "different")' 19

# a mesh in motion
{ cat model start rest; printf '%s\n' 'mesh_primitive box.stl box 0.2 0.4 0.2 0.4 0.2 0.4' \
	'fix m all mesh/surface file box.stl type 1' 'fix mv all move/mesh mesh m linear 0.5 0 0' \
	'dump m all mesh/vtk 10 mesh.vtkhdf area id' 'run 20'; } >in.mesh
"$TSIM" -in in.mesh -log none >out 2>&1
report 'a mesh' $? out
read_it 'layout of triangles' 'layout("mesh.vtkhdf", 3)' 17
read_it 'it moves' 'g = h5py.File("mesh.vtkhdf")["VTKHDF"]; x = g["Points"][:, 0].reshape(3, -1)
print("moves", "same" if abs(x[2] - x[0] - 0.01).max() < 1e-9 else x)' 1

# a restart; the first part has gone too far
mkdir whole && mv ./*.vtkhdf table.csv whole
{ cat model start rest dumps; printf '%s\n' 'run 25' 'write_restart half' 'run 15'; } >in.first
{ sed 's/^region.*//' model; echo 'read_restart half'; cat rest dumps; echo 'run 35'; } >in.second
"$TSIM" -in in.first -log none >out 2>&1 && "$TSIM" -in in.second -log none -threads 2 >>out 2>&1
report 'in two runs' $? out
read_it 'continued' '
for file in "all.vtkhdf", "chains.vtkhdf":
    a, b = h5py.File("whole/" + file), h5py.File(file)
    a.visit(lambda n: same(n, a[n][:], b[n][:]) if isinstance(a[n], h5py.Dataset) else None)' \
	"$("$python" -c '
import h5py
n = [0]
def count(name, item): n[0] += isinstance(item, h5py.Dataset)
for file in "all.vtkhdf", "chains.vtkhdf": h5py.File("whole/" + file).visititems(count)
print(n[0])')"

# VTK itself, of a file with one frame: the reader of version 9.1 knows no series, and warns of version 2
{ cat model start rest; printf '%s\n' 'write_dump all custom/vtk one.vtkhdf id vx vy vz' 'write_dump all custom one.txt id x'; } >in.one
"$TSIM" -in in.one -log none >out 2>&1
report 'one frame' $? out
if python_with vtkmodules python3-vtk9; then
	"$python" -c '
from vtkmodules.vtkIOHDF import vtkHDFReader
r = vtkHDFReader()
r.SetFileName("one.vtkhdf")
r.Update()
o = r.GetOutput()
rows = [line.split() for line in open("one.txt")][9:]
x = {int(r[0]): float(r[1]) for r in rows}
ids = o.GetPointData().GetArray("id")
assert o.GetNumberOfPoints() == o.GetNumberOfCells() == 50 and o.GetPointData().GetArray("v").GetNumberOfComponents() == 3
for k in range(50):
    assert abs(o.GetPoint(k)[0] - x[int(ids.GetTuple1(k))]) < 1e-5 and o.GetCell(k).GetPointId(0) == k
' >out 2>&1
	report 'read by VTK' $? out
fi
finish
