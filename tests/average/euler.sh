#!/bin/bash
# Values of the cells of a grid against what they are by hand.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.begin <<'END'
units si
boundary f f f
region b block 0 0.2 0 0.1 0 0.1 units box
create_box 2 b
create_atoms 1 single 0.0101 0.011 0.012
create_atoms 1 single 0.0151 0.011 0.012
create_atoms 1 single 0.0951 0.051 0.052
create_atoms 2 single 0.1951 0.091 0.092
set atom 1 diameter 0.006 density 2385
set atom 2 diameter 0.005 density 2385
set atom 3 diameter 0.005 density 2300
set atom 4 diameter 0.007 density 2500
set atom 1 vx 0.5 vy 0.1
set atom 2 vx -0.3 vz 0.2
set atom 3 vy 0.3
pair_style spring/dashpot
pair_coeff * * stiffness 2385 restitution 0.5
timestep 1e-6
variable V equal 0.2/7*(0.1/3)^2
variable m equal mass[1]+mass[2]
variable mr equal mass[1]*mass[2]/v_m
END
cat >in.cells <<'END'
include in.begin
region half block 0 $(0.1/7) 0 0.1 0 0.1 units box
group one id 1
fix e all ave/euler nevery 10 cell_size_relative 4 parallel no
fix g one ave/euler nevery 10 cell_size_relative 4 parallel no
fix h all ave/euler nevery 10 cell_size_relative 4 parallel yes basevolume_region half
thermo_style custom step f_e[1][10]
run 0
print "is x $(f_e[2][1]) $(0.3/7)"
print "is z $(f_e[63][3]) $(0.25/3)"
print "is count $(f_e[1][10]) 2"
print "is mass $(f_e[1][11]) ${m}"
print "is v $(f_e[1][4]) $((0.5*mass[1]-0.3*mass[2])/v_m)"
print "is fraction $(f_e[1][7]) $(4/3*PI*(0.003^3+0.0025^3)/v_V)"
print "is radius $(f_e[1][8]) 0.00275"
variable kin equal v_mr*(0.8^2+0.1^2+0.2^2)
print "is pressure $(f_e[1][9]) $((v_kin+0.005*abs(fx[1]))/3/v_V)"
print "is sxx $(f_e[1][12]) $(-(v_mr*0.64+0.005*abs(fx[1]))/v_V)"
print "is sxy $(f_e[1][15]) $(-v_mr*0.8*0.1/v_V)"
print "is none $(f_e[2][9]) 0"
print "is last $(f_e[63][8]) 0.0035"
print "is group $(f_g[1][10]) 1"
print "is half $(f_h[1][7]) $(2*f_e[1][7])"
print "is little $(f_h[63][7]) $(50*f_e[63][7])"
END
agree 'cells' "$(cat in.cells)"
# no particles yet: no cells
prints 'units si
boundary f f f
region b block 0 0.2 0 0.1 0 0.1 units box
create_box 1 b
fix e all ave/euler nevery 2 cell_size_relative 3 parallel no
dump d all euler/vtk 2 none*.vtk
timestep 1e-6
run 2
create_atoms 1 single 0.1 0.05 0.05
set group all diameter 0.02 density 2385
run 2
print "count $(f_e[2][10])"' 'count 1'
grep -q '^POINTS 0 ' none2.vtk && grep -q '^POINTS 3 ' none4.vtk
report 'dump euler/vtk writes what there is' $? none4.vtk
rejects 'include in.begin
dump d all euler/vtk 10 e*.vtk' 'dump euler/vtk needs a fix ave/euler'
rejects 'include in.begin
fix e all ave/euler nevery 10 cell_size_relative 4
dump d all euler/vtk 10 e*.vtk f' 'of id f'
finish
