#!/bin/bash
# What a solved fluid puts out: points, lines, planes, fluxes, forces on faces, keywords of the log, and files for
# ParaView, read back with VTK's own reader (skipped without Debian's python3-vtk9).
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# a duct along x, its fluid driven by a body force
cat >duct <<'END'
units si
boundary p f f
region box block 0 1 0 0.5 0 0.25 units box
create_box 1 box
flow_style projection cells 4 6 5 viscosity 0.1 density 2.385 body_force 1 0 0
END
cat >steady <<'END'
include duct
thermo 10000
timestep 5e-3
run 900
END

agree 'forces balance, fluxes are equal, places agree' 'include steady
compute ylo all flow/force ylo
compute yhi all flow/force yhi
compute zlo all flow/force zlo
compute zhi all flow/force zhi
compute x0 all flow/flux xlo
compute x1 all flow/flux xhi
compute x2 all flow/flux x 0.385
compute line all flow/line cells y 0.1 0.125 values y vx p
compute wall all flow/line between 0.385 0.25 0 0.385 0.25 0.25 3 values s vx vy z
compute spot all flow/probe 0.1 0.125 0.125 0.385 0.1 0.2 values vx speed void wz
compute plane all flow/plane x 0.3 values vx y z
variable u vector c_plane[1]
variable force equal c_ylo[7]+c_yhi[7]+c_zlo[7]+c_zhi[7]
print "is balance ${force} $(2.385*0.125*1.0)"
print "is shear $(c_ylo[7]) $(c_yhi[1])"
print "is pressure $(c_ylo[4]) 0"
print "is area $(c_ylo[10]) 0.25"
print "is flux $(c_x0) $(c_x1)"
print "is flux $(c_x2) $(c_x1)"
print "is sum $(c_x2) $(sum(v_u)*0.125/30)"
print "is area $(c_x2[2]) 0.125"
print "is mean $(c_x2[3]) $(c_x2/0.125)"
print "is spot $(c_spot[1]) $(c_line[2][2])"
print "is speed $(c_spot[2][2]) $(abs(c_spot[2][1]))"
print "is void $(c_spot[1][3]) 1"
print "is place $(c_line[6][1]) $(5.5/12)"
print "is walls $(c_wall[1][2]) 0 $(c_x2[3])"
print "is walls $(c_wall[3][2]) 0 $(c_x2[3])"
print "is end $(c_wall[3][1]) 0.25"
print "is middle $(c_wall[2][2]) $(max(v_u))"
print "is second $(c_plane[2][2]) 0.125"
print "is third $(c_plane[7][3]) 0.075"'

agree 'regions cut fluxes and forces' 'include steady
region half block INF INF 0 0.25 INF INF units box
compute all all flow/flux x 0.3
compute half all flow/flux x 0.3 region half
compute zlo all flow/force zlo
compute part all flow/force zlo region half
print "is flux $(2*c_half) $(c_all)"
print "is area $(2*c_half[2]) $(c_all[2])"
print "is force $(2*c_part[7]) $(c_zlo[7])"'
# a velocity point between a cell in the region and one beside it counts by half; regions that share all cells share the force
agree 'regions share the shear force' 'units si
boundary p f p
region box block 0 1 0 1 0 1 units box
create_box 1 box
flow_style projection cells 8 6 4 viscosity 1.385 density 10
flow_boundary yhi wall velocity 1 0 0.5
region a block INF 0.5 INF INF INF INF units box
region b block 0.5 INF INF INF INF INF units box
compute all all flow/force yhi
compute a all flow/force yhi region a
compute b all flow/force yhi region b
timestep 1e-3
run 5
print "is half $(2*c_a[7]) $(c_all[7])"
print "is other $(2*c_b[7]) $(c_all[7])"
print "is beside $(2*c_b[9]) $(c_all[9])"'

agree 'keywords' 'include duct
flow_set velocity 0.7 0 0
compute all all flow/plane x 0.5 values vx
variable ke equal flow_ke
run 0
print "is energy ${ke} $(0.5*2.385*0.125*0.7^2)"
timestep 5e-3
run 3
print "is time $(flow_time) 0.015"
print "is steps $(flow_steps) 3"
print "is step $(flow_dt) 0.005"
print "is divergence $(flow_div) 0"'

# T = 300 + 40 y + 12 z between walls that are held so, which conduction leaves as it is; a fluid at rest
cat >warm <<'END'
units si
boundary p f f
region box block 0 1 0 0.5 0 0.25 units box
create_box 1 box
flow_style projection cells 4 6 5 viscosity 0.1 density 2.385
variable yy internal 0
variable zz internal 0
variable T equal 300+40*v_yy+12*v_zz
fix T all flow/scalar conductivity 0.01 initial v_T set y yy set z zz
END
agree 'scalars of fixes' 'include warm
compute spot all flow/probe 0.1 0.15 0.15 0.6 0.31 0.125 values f_T vx
compute line all flow/line cells y 0.1 0.125 values y f_T interpolation cubic
print "is spot $(c_spot[1][1]) $(300+40*0.15+12*0.15)"
print "is spot $(c_spot[2][1]) $(300+40*0.31+12*0.125)"
print "is line $(c_line[6][2]) $(300+40*5.5/12+12*0.125)"'
rejects 'include warm
compute p all flow/probe 0.1 0.2 0.2 values f_t' "there is no fix 't'; known: T"
rejects 'include warm
fix m all ave/time 1 1 1 c_thermo_temp
compute p all flow/probe 0.1 0.2 0.2 values f_m' 'fix m (style ave/time) transports no scalar'

cat >in.table <<'END'
include steady
compute line all flow/line cells z 0.1 0.25 values z vx
fix out all ave/time 1 1 1 c_line[*] mode vector file line.txt
thermo_style custom step flow_ke flow_cfl flow_iter flow_res
run 1
END
"$TSIM" -in in.table -log none >out 2>&1 && [ "$(grep -vc '^#' line.txt)" = 12 ]
report 'a line in a file, keywords in the log' $? out

# two threads that share even short loops: the same bytes
cat >in.threads <<'END'
if "${threads} > 1" then "package omp ${threads} grain 1"
include duct
flow_boundary yhi wall velocity 1 0 0.3
compute yhi all flow/force yhi
compute flux all flow/flux x 0.385
thermo 5
thermo_style custom step flow_ke flow_div flow_cfl flow_res c_yhi[2] c_yhi[7] c_flux
thermo_modify format float %.17g
timestep 5e-3
dump d all flow/vtk 20 ${threads}.*.vti
run 20
END
for threads in 1 2; do
	OMP_WAIT_POLICY=passive "$TSIM" -in in.threads -var threads $threads -log none >out.$threads 2>&1
	rows out.$threads >rows.$threads
done
same 'two threads: the log' rows.1 rows.2
same 'two threads: the fields' 1.20.vti 2.20.vti

rejects 'include duct
compute p all flow/probe 0.1 0.2' "flow/probe: 2 numbers, expected three for each point"
rejects 'include duct
compute p all flow/probe 0.1 0.2 z1' "'z1', expected a coordinate"
rejects 'include duct
compute p all flow/probe 0.1 0.2 0.3' 'z = 0.3 is outside of the fluid'
rejects 'include duct
compute p all flow/probe 0.1 0.2 0.1 values vx temp' "unknown quantity 'temp'"
rejects 'include duct
compute p all flow/line cells w 0 0' "'w', expected"
rejects 'include duct
compute p all flow/line between 0 0 0 1 1 0.2 5' 'y = 1 is outside'
rejects 'include duct
compute p all flow/plane y 0.6' 'y = 0.6 is outside'
rejects 'include duct
compute p all flow/flux y 0.6' 'y = 0.6 is outside'
rejects 'include duct
compute p all flow/force xlo' 'nothing bounds the fluid at xlo, which is periodic'
rejects 'include duct
dump d all flow/vtk 10 flow*.vtk' 'must end in .vti or .vtr'
rejects 'include duct
dump d all flow/vtk 10 flow*.vti velocity speed' "unknown quantity 'speed'"
rejects 'region b block 0 1 0 1 0 1 units box
create_box 1 b
compute p all flow/probe 0.1 0.2 0.3' 'needs a fluid: use flow_style projection before it'
rejects 'region b block 0 1 0 1 0 1 units box
create_box 1 b
flow_style uniform velocity 1 0 0 viscosity 1
dump d all flow/vtk 10 flow*.vti' 'needs a fluid that is solved for'
rejects 'print $(flow_ke)' 'keyword flow_ke needs a fluid'

python_with vtkmodules.vtkIOXML python3-vtk9 || finish
cat >in.files <<'END'
include duct
flow_boundary yhi wall velocity 1 0 0.3
dump i all flow/vtk 20 image*.vti
dump r all flow/vtk 20 speed*.vtr vorticity velocity
variable yy internal 0
variable zz internal 0
variable T equal 300+40*v_yy+12*v_zz
fix T all flow/scalar conductivity 0.01 initial v_T set y yy set z zz
compute all all flow/plane x 0.375 values y z vx vy vz p wx wy wz f_T
fix out all ave/time 20 1 20 c_all[*] mode vector file plane.txt format " %.17g"
timestep 5e-3
run 40
END
cat >compare.py <<'END'
import sys, xml.etree.ElementTree as tree
from vtkmodules.vtkCommonCore import vtkStringOutputWindow, vtkOutputWindow
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLRectilinearGridReader
messages = vtkStringOutputWindow()
vtkOutputWindow.SetInstance(messages)

def read(path, reader):
    reader.SetFileName(path)
    reader.Update()
    assert not messages.GetOutput() and not reader.GetErrorCode(), messages.GetOutput()
    return reader.GetOutput()

def near(a, b, what, size=None):
    assert abs(a - b) <= 1e-14 * (abs(b) if size is None else size), (what, a, b)

frames, rows = [], [l.split() for l in open("plane.txt") if not l.startswith("#")]
while rows:
    n = int(rows[0][1])
    frames.append([[float(x) for x in r[1:]] for r in rows[1:n + 1]])
    rows = rows[n + 1:]
for name, reader, arrays in (("image", vtkXMLImageDataReader, ["velocity", "pressure", "vorticity", "f_T"]),
                             ("speed", vtkXMLRectilinearGridReader, ["vorticity", "velocity"])):
    sets = tree.parse(name + ".pvd").getroot().findall("./Collection/DataSet")
    assert [float(s.get("timestep")) for s in sets] == [0, 0.1, 0.2]
    for s, plane in zip(sets, frames):
        grid = read(s.get("file"), reader())
        assert grid.GetDimensions() == (5, 7, 6), grid.GetDimensions()
        for a, b in zip(grid.GetBounds(), (0, 1, 0, 0.5, 0, 0.25)):
            near(a, b, "bounds")
        near(grid.GetFieldData().GetArray("TimeValue").GetValue(0), float(s.get("timestep")), "time")
        size = [max(map(abs, column)) for column in zip(*plane)]
        data = grid.GetCellData()
        assert [data.GetArrayName(k) for k in range(data.GetNumberOfArrays())] == arrays
        for k in range(5):
            for j in range(6):
                row, cell = plane[6 * k + j], 1 + 4 * (j + 6 * k)
                for c in range(3):
                    near(data.GetArray("velocity").GetComponent(cell, c), row[2 + c], "velocity", max(size[2:5]))
                    near(data.GetArray("vorticity").GetComponent(cell, c), row[6 + c], "vorticity", max(size[6:9]))
                if name == "image":
                    near(data.GetArray("pressure").GetValue(cell), row[5], "pressure", size[5])
                    near(data.GetArray("f_T").GetValue(cell), row[9], "f_T")
END
"$TSIM" -in in.files -log none >out 2>&1
report 'writes files' $? out
"$python" compare.py >out 2>&1
report 'VTK reads them, and finds what computes give' $? out

# Forces on a wall beside an inlet whose velocity is not that of the wall: no axis is special, at both ends.
cat >in.edge <<'END'
units si
boundary f f f
region box block 0 $(1+v_xx) 0 $(1+v_yy) 0 $(1+v_zz) units box
create_box 1 box
flow_style projection cells $(8+8*v_xx) $(8+8*v_yy) $(8+8*v_zz) viscosity 0.5 density 1.385 time rk2
variable all index xlo xhi ylo yhi zlo zhi
label all
flow_boundary ${all} slip
next all
jump SELF all
flow_boundary ${inlet} inlet velocity $(v_s*v_xx/2) $(v_s*v_yy/2) $(v_s*v_zz/2)
flow_boundary ${outlet} outlet
flow_boundary ${wall} wall velocity $(v_s*v_xx/10) $(v_s*v_yy/10) $(v_s*v_zz/10)
compute f all flow/force ${wall}
timestep 5e-3
run 20
print "force $(v_s*(v_xx*c_f[1]+v_yy*c_f[2]+v_zz*c_f[3]):%.9g)"
END
rm -f forces
while read -r s xx yy zz inlet outlet wall; do
	"$TSIM" -in in.edge -log none -var s "$s" -var xx "$xx" -var yy "$yy" -var zz "$zz" -var inlet "$inlet" \
		-var outlet "$outlet" -var wall "$wall" 2>&1 </dev/null | grep '^force' >>forces
done <<'END'
1 1 0 0 xlo xhi zlo
-1 1 0 0 xhi xlo yhi
1 0 1 0 ylo yhi xlo
1 0 1 0 ylo yhi zhi
1 0 0 1 zlo zhi xlo
-1 0 0 1 zhi zlo ylo
END
[ "$(wc -l <forces)" = 6 ] && [ "$(sort -u forces | wc -l)" = 1 ]
report 'a wall beside an inlet, along each axis' $? forces
# Out of an open face beside an inlet, in the order of the axes and against it.
beside() {
	echo "clear
units si
boundary f f f
region box block $1 0 0.25 units box
create_box 1 box
flow_style projection cells $2 4 viscosity 0.02 density 2.385
flow_boundary $3 inlet pressure 5
flow_boundary $4 inlet velocity $5 0.05
timestep 5e-3
run 7
variable ke_$3 equal \$(flow_ke)"
}
agree 'an inlet beside an open face' "$(beside '0 1 0 0.5' '6 5' xlo yhi '0.03 -0.1')
$(beside '0 0.5 0 1' '5 6' ylo xhi '-0.1 0.03')
print \"is ke \$(v_ke_xlo) \$(v_ke_ylo)\""
# A flow that turns in an outlet, symmetric: the velocity there is round-off, which another unit of length changes.
turns() {
	echo "clear
units si
boundary f f p
region box block 0 $1*1.2 0 $1 0 $1*0.9 units box
create_box 1 box
flow_style projection cells 6 5 5 viscosity $1*$1*0.1 density 1.3 time rk2 convection donor
flow_grid y geometric 2
flow_boundary ylo outlet pressure -$1*$1*0.98780728
flow_boundary yhi slip
flow_set velocity -$1*0.17684178 $1*0.10880536 -$1*0.21216978
compute p all flow/probe $1*0.3 $1*0.33 $1*0.3 values vy
timestep 0.01
run 1
variable v_$2 equal \$(c_p[1]/($1))" | sed -E ':more; s/ (-?[0-9.e-]+\*[0-9.*e-]+)/ $(\1)/; t more'
}
agree 'a flow that turns in an outlet' "$(turns 1.0 metre)
$(turns 1e-6 micrometre)
print \"is vy \$(v_v_metre) \$(v_v_micrometre)\""
# In two dimensions sums over the grid are those of the depth of the box, masses and heat of particles per unit depth.
agree 'depth of the box' 'units si
dimension 2
atom_style sphere
boundary p f p
region box block 0 2 0 1 -0.2 0.2 units box
create_box 1 box
create_atoms 1 single 0.5 0.5 0 units box
set group all diameter 0.1 density 2
fix k all property/global thermalConductivity peratomtype 1
fix c all property/global thermalCapacity peratomtype 3
flow_style projection cells 8 4 1 viscosity 0.1 density 3
flow_boundary all slip
flow_set velocity 0.5 0 0
fix h all heat/gran initial_temperature 9
fix T all flow/scalar conductivity 0.7 capacity 2 initial 1 exchange ranz_marshall
compute q all flow/flux x 1
compute f all flow/force yhi
fix n all nve/sphere
timestep 0.001
run 10
print "is ke $(flow_ke) $(0.5*3*0.5^2*0.8)"
print "is px $(flow_px) $(3*0.5*0.8)"
print "is flux $(c_q) 0.2"
print "is area $(c_f[10]) 0.8"
print "is heat $(f_T[1]-3*2*0.8) $(0.4*mass[1]*3*(9-f_h[1]))"'
finish
