#!/bin/bash
# Meshes and height fields for ParaView: all formats hold the same numbers, collections list the frames with their times,
# also after a restart and with few files kept.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
printf '%s\n' '0 0 0.1 1 0 0.12345678901 1 1 0.1' '0 0 0.1 1 1 0.1 0 1 0.1' | solid >plate.stl

cat >head <<'END'
units si
boundary f f f
timestep 1e-3
END
cat >make <<'END'
region b block -1 3 -1 2 -1 3 units box
create_box 2 b
END
cat >surfaces <<'END'
fix plate all mesh/surface file plate.stl type 1
fix lift all move/mesh mesh plate linear 0 0 1
variable cx internal 0
variable cy internal 0
variable h equal v_cx/3+v_cy-2*(v_cx==1.5)
fix s all surface/voxel formula v_h x cx y cy type 2 cells 3 2 base 0 origin 0 0 size 3 2
END
cat >dumps <<'END'
dump text all mesh/vtk 2 text.*.vtk area id vel
dump bytes all mesh/vtk 2 bytes.*.vtk area id vel
dump_modify bytes binary yes
dump poly all mesh/vtk 2 poly.*.vtp area id vel
dump grid all mesh/vtk 2 grid.*.vtu area id vel
dump points all mesh/vtk 2 points.*.vtp area id vel output interpolate
dump ptext all mesh/vtk 2 ptext.*.vtk area id vel output interpolate
dump vtext all voxel/vtk 2 vtext.*.vtk s
dump vbytes all voxel/vtk 2 vbytes.*.vtk s
dump_modify vbytes binary yes
dump vpoly all voxel/vtk 2 vpoly.*.vtp s
dump vgrid all voxel/vtk 2 vgrid.*.vtu s
dump packed all mesh/vtk 2 packed.*.vtk.gz id
dump few all mesh/vtk 2 few.*.vtp id
dump_modify few maxfiles 2
END
cat head make surfaces dumps - >in.all <<<'run 8'
"$TSIM" -in in.all -log none >out 2>&1
report 'runs' $? out
grep -c DataSet poly.pvd | grep -qx 5 && grep -q '<DataSet timestep="0.0060000000000000001" part="0" file="poly.6.vtp"/>' poly.pvd
report 'a collection of a mesh' $? poly.pvd
grep -q '"name": "vtext.8.vtk", "time": 0.0080000000000000002 }' vtext.vtk.series && grep -q 'vgrid.8.vtu' vgrid.pvd
report 'collections of a height field' $? vtext.vtk.series
[ "$(echo few*)" = 'few.6.vtp few.8.vtp few.pvd' ] && [ "$(grep -c DataSet few.pvd)" = 2 ] && grep -q 'few.6.vtp' few.pvd
report 'maxfiles: the collection has the files that are left' $? few.pvd
zcat packed.4.vtk.gz | grep -q '^meshid 1 2 int$'
report 'other names are text' $? out
grep -q '^0 0 0.108 1 0 0.131457 1 1 0.108' text.8.vtk
report 'text has six digits' $? text.8.vtk
grep -q '^BINARY$' bytes.8.vtk && grep -q '^BINARY$' vbytes.8.vtk
report 'binary' $? out

# a restart in between: the same files
mkdir whole
mv ./*.pvd ./*.series poly.*.vtp vtext.*.vtk whole
{ cat head make surfaces; grep -v few dumps; printf '%s\n' 'run 3' 'write_restart half'; } >in.first
{ cat head; echo 'read_restart half'; cat surfaces; grep -v few dumps; echo 'run 5'; } >in.second
"$TSIM" -in in.first -log none >out 2>&1 && "$TSIM" -in in.second -log none >>out 2>&1
report 'in two runs' $? out
for f in poly.pvd grid.pvd vgrid.pvd text.vtk.series vtext.vtk.series poly.8.vtp vtext.8.vtk; do
	same "$f after a restart" whole/$f $f
done

python_with vtkmodules.vtkIOXML python3-vtk9 || finish
cat >read.py <<'END'
import sys
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

name, digits = sys.argv[1], int(sys.argv[2])
reader = {"vtk": vtkPolyDataReader, "vtp": vtkXMLPolyDataReader, "vtu": vtkXMLUnstructuredGridReader}[name[-3:]]()
reader.SetFileName(name)
if hasattr(reader, "ReadAllFieldsOn"):
    reader.ReadAllFieldsOn()
reader.Update()
data = reader.GetOutput()
show = lambda v: "%.*g" % (digits, v)
for c in range(data.GetNumberOfCells()):
    cell = data.GetCell(c)
    print(cell.GetClassName().replace("Pixel", "Quad").replace("vtkPolygon", "vtkQuad"), *(show(v) for k in range(cell.GetNumberOfPoints()) for v in cell.GetPoints().GetPoint(k)))
for kind in (data.GetPointData(), data.GetCellData()):
    for k in range(kind.GetNumberOfArrays()):
        a = kind.GetArray(k)
        print(a.GetName(), *(show(v) for i in range(a.GetNumberOfTuples()) for v in a.GetTuple(i)))
END
agrees() { # WHAT FILE FILE DIGITS
	"$python" read.py "$2" "$4" >one 2>&1 && "$python" read.py "$3" "$4" >two 2>&1
	same "$1" one two
}
agrees 'a mesh: binary' poly.8.vtp bytes.8.vtk 17
agrees 'a mesh: unstructured' poly.8.vtp grid.8.vtu 17
agrees 'a mesh: text' poly.8.vtp text.8.vtk 5
agrees 'data at points' points.8.vtp ptext.8.vtk 5
agrees 'a height field: binary' vpoly.8.vtp vbytes.8.vtk 17
agrees 'a height field: unstructured' vpoly.8.vtp vgrid.8.vtu 17
agrees 'a height field: text' vpoly.8.vtp vtext.8.vtk 8
"$python" read.py poly.8.vtp 17 >one
[ "$(grep -c '^vtkTriangle' one)" = 2 ] && grep -q '^vtkTriangle 0 0 0.108[0-9]* 1 0 0.1314567890' one
report 'triangles with all digits' $? one
"$python" read.py vpoly.8.vtp 9 >one
[ "$(grep -c '^vtkQuad' one)" = 4 ] && grep -q '^column 0 2 3 5$' one
report 'squares; the empty column is left out' $? one
finish
