#!/bin/bash
# The formats of files for ParaView hold the same numbers: legacy as text and as bytes, XML PolyData and
# UnstructuredGrid, lists of pieces. Text is read here; the rest by VTK's own readers, where python3-vtk9 is.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.formats <<'END'
units si
boundary p f f
region b block 0 1 0 1 0 1 units box
create_box 2 b
create_atoms 1 single 0.02 0.3 0.4 units box
create_atoms 2 single 0.95 0.31 0.4 units box
create_atoms 1 single 0.5 0.5 0.2385 units box
set group all diameter 0.1 density 2385
set atom 1 vx 0.2385 vz -3
pair_style spring/dashpot
pair_coeff * * stiffness 2385 restitution 0.5
fix move all nve
timestep 1e-6
compute c all pair/gran/local pos id force delta
dump text all custom/vtk 2 text*.vtk id type vx vy vz radius
dump bytes all custom/vtk 2 bytes*.vtk id type vx vy vz radius
dump_modify bytes binary yes
dump poly all custom/vtk 2 poly*.vtp id type vx vy vz radius
dump grid all custom/vtk 2 grid*.vtu id type vx vy vz radius
dump pieces all custom/vtk 2 pieces*.pvtp id type vx vy vz radius
dump parts all custom/vtk 2 parts*.pvtu id type vx vy vz radius
dump chain all local/gran/vtk 2 chain*.vtk c
dump chains all local/gran/vtk 2 chains*.vtu c
run 2
END
"$TSIM" -in in.formats -log none -screen none 2>err
report 'runs' $? err
cat >expected <<'END'
DATASET POLYDATA
POINTS 3 double
0.020000477 0.3 0.399994
0.95 0.31 0.4
0.5 0.5 0.2385
VERTICES 3 6
1 0
1 1
1 2
POINT_DATA 3
FIELD FieldData 4
id 1 3 int
1
2
3
END
sed -n '4,18p' text2.vtk | sed 's/\(0\.0200004[0-9]*\) [0-9.]* \(0\.39999[0-9]*\)$/0.020000477 0.3 0.399994/; s/^0.9499[0-9.]* 0.31[0-9.]* 0.4[0-9.]*$/0.95 0.31 0.4/' >found
same 'legacy text' expected found
# the contact across the periodic face is a short line
awk '/^LINES/ { exit } NF == 3 && /^[-0-9.e ]+$/ { x[++n] = $1 } END { exit !(n == 2 && x[1] - x[2] < 0.0701 && x[1] - x[2] > 0.0699) }' chain2.vtk
report 'a line goes to the nearest image' $? chain2.vtk
grep -q '^force 3 1 double$' chain2.vtk && grep -q '^id3 1 1 double$' chain2.vtk
report 'the line has data' $? chain2.vtk
grep -q '"name": "text2.vtk", "time": 1.9999999999999999e-06 }' text.vtk.series
report 'the series tells times' $? text.vtk.series
grep -q '^Y_COORDINATES 2 double$' textboundingBox_2.vtk
report 'the box has a file' $? textboundingBox_2.vtk
rejects "$(sed 's/text\*.vtk/text*.vtx/' in.formats)" "must end in .vtk, .vtp, .vtu, .pvtp or .pvtu, found 'text*.vtx'"
rejects "$(sed 's/^compute c .*/compute c all pair\/gran\/local id/' in.formats)" 'add the word pos'
rejects "$(sed 's/^compute c .*/compute c all ke/' in.formats)" "needs a compute pair/gran/local or wall/gran/local; 'c' is ke"

if ! /usr/bin/python3 -c 'from vtkmodules.vtkIOXML import vtkXMLPolyDataReader' 2>/dev/null; then
	echo 'VTK is not installed: its files are not read back (apt-get install python3-vtk9)'
	finish
fi
cat >read.py <<'END'
import sys
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOXML import (vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader,
                                 vtkXMLPPolyDataReader, vtkXMLPUnstructuredGridReader)

readers = {"vtk": vtkPolyDataReader, "vtp": vtkXMLPolyDataReader, "vtu": vtkXMLUnstructuredGridReader,
           "pvtp": vtkXMLPPolyDataReader, "pvtu": vtkXMLPUnstructuredGridReader}
reader = readers[sys.argv[1].split(".")[-1]]()
reader.SetFileName(sys.argv[1])
if hasattr(reader, "ReadAllFieldsOn"):
    reader.ReadAllFieldsOn()
reader.Update()
data = reader.GetOutput()
print(data.GetNumberOfCells(), "cells")
for k in range(data.GetNumberOfPoints()):
    print("%.9g %.9g %.9g" % data.GetPoint(k))
for kind in (data.GetPointData(), data.GetCellData()):
    for k in range(kind.GetNumberOfArrays()):
        a = kind.GetArray(k)
        print(a.GetName(), *("%.9g" % v for i in range(a.GetNumberOfTuples()) for v in a.GetTuple(i)))
END
/usr/bin/python3 read.py poly2.vtp >expected 2>&1
[ "$(wc -l <expected)" = 8 ]
report 'VTK reads .vtp' $? expected
for file in text2.vtk bytes2.vtk grid2.vtu pieces2.pvtp parts2.pvtu; do
	/usr/bin/python3 read.py $file >found 2>&1
	same "VTK reads $file" expected found
done
/usr/bin/python3 read.py chain2.vtk >expected 2>&1
/usr/bin/python3 read.py chains2.vtu >found 2>&1
same 'VTK reads lines' expected found
finish
