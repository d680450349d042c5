#!/bin/bash
# The table of the log: columns, formats, blocks, variable steps, norm, and what is refused.
. "$top_srcdir/tests/lib_cases.sh" || exit 99

scene='units si
boundary p p p
region box block 0 1 0 1 0 2 units box
create_box 1 box
create_atoms 1 single 0.25 0.5 0.5 units box
create_atoms 1 single 0.75 0.5 0.5 units box
set group all diameter 0.1 mass 2.385
set atom 1 vx 2
velocity all set NULL 1 NULL units box
fix move all nve/sphere
neighbor 0.01 bin
timestep 0.001
variable bits equal count(all)+0.5
compute mv all reduce sum vx vy
'
# table WHAT SCRIPT FILE: the rows and titles, without the loop lines, are those of the file
table() {
	printf '%s\n' "$scene" "$2" >in.script
	"$TSIM" -in in.script -log none >out 2>&1
	report "$1: runs" $? out
	sed -n '/^ *Step\|^  *Dt\|^-----/,/^Loop/p' out | grep -v '^Loop' >got
	same "$1" "$3" got
}
printf '%8s %14s %14s %14s %14s \n%8d %14.8g %14.8g %14.8g %14.8g \n%8d %14.8g %14.8g %14.8g %14.8g \n' \
	Step Time KinEng mv'[1]' bits 0 0 7.155 2 2.5 2 0.002 7.155 2 2.5 >want
table 'custom columns' 'thermo_style custom step time ke c_mv[1] v_bits
run 2' want
printf '%8s %14s %14s \n%8d %14.8g %14.8g \n' Step mv'[1]' mv'[2]' 0 2 2 >want
table 'all elements' 'thermo_style custom step c_mv[*]
run 0' want
printf '%8s %14s %14s %8s \n  0    7.1550 2.000e+00 2\n' Step KinEng Volume Atoms >want
printf '  0    7.1550 2.000e+00 2 \n' >row
{ head -1 want; cat row; } >want2
table 'formats: column, kind, line' 'thermo_style custom step ke vol atoms
thermo_modify format float %9.4f format 3 %.3e format int %d format 1 %3d
run 0' want2
# titles are as long as the names; with legacy they have eight characters, with that of LAMMPS the prefix, too
long='variable goes_on_and_on equal 2.5
variable goes_farther equal 3.5
thermo_style custom step v_goes_on_and_on v_goes_farther
run 0'
printf '%8s %14s %14s \n%8d %14.8g %14.8g \n' Step goes_on_and_on goes_farther 0 2.5 3.5 >want
table 'titles as long as names' "$long" want
printf '%8s %17s %14s \n%8d %17.8g %14.8g \n' Step goes_on_and_on_on goes_farther 0 2.5 3.5 >want
table 'titles beyond the column' "${long//_and_on/_and_on_on}" want
printf '%8s %14s %14s \n%8d %14.8g %14.8g \n' Step goes_on_ goes_far 0 2.5 3.5 >want
table 'titles, legacy' "legacy yes
$long" want
printf '%8s %16s %14s \n%8d %16.8g %14.8g \n' Step v_goes_on_and_on v_goes_farther 0 2.5 3.5 >want
table 'titles as those of LAMMPS' "legacy lammps
${long/run 0/legacy no
run 0}" want
printf '%8s %14s \n%6d %5.3f \n' Step KinEng 0 7.155 >want
table 'formats: line' 'thermo_style custom step ke
thermo_modify format line "%6d %5.3f"
run 0' want
printf '%8s %14s \n%8d %14.8g \n' Step KinEng 0 3.5775 >want
table 'norm' 'thermo_style custom step ke
thermo_modify norm yes format none
run 0' want
printf -- '---------------- Step %8d ----- CPU = %11.4f (sec) ----------------\nStep     = %14d Atoms    = %14d KinEng   = %14.4f \nVolume   = %14.4f \n' \
	0 0 0 2 7.155 2 >want
table 'blocks' 'thermo_style custom step atoms ke vol
thermo_modify line multi
run 0' want
printf '%8s %8s \n' Step Ndanger >want
for k in 0 1 2 4 8 16 17; do printf '%8d %8d \n' $k 0; done >>want
table 'a variable says the steps' 'variable s equal logfreq(1,1,2)+0*step
thermo v_s
thermo_style custom step ndanger
run 17' want
printf '%14s %14s %14s %14s %14s %8s \n%14.8g %14.8g %14.8g %14.8g %14.8g %8d \n' \
	Cella CellAlpha Xy Lx Zhi Part 1 90 0 1 2 0 >want
printf '%s\n' "$scene" 'thermo_style custom cella cellalpha xy lx zhi part
run 0' >in.script
"$TSIM" -in in.script -log none >out 2>&1
grep -A1 Cella out >got
same 'the box' want got
# T = sum m v^2/(3 k), p = sum m v^2/(3 V) without contacts
printf '%s\n' "$scene" 'thermo_style custom temp press pxx pxy bonds
thermo_modify format float %.6e
run 0' >in.script
"$TSIM" -in in.script -log none >out 2>&1
echo '3.454897e+23 2.385000e+00 4.770000e+00 2.385000e+00        0 ' >want
grep -A1 Temp out | tail -1 >got
same 'temperature and pressure' want got

wrong() { # WHAT LINE TEXT
	printf '%s\n' "$scene" "$2" 'run 1' >in.script
	refused "$1" "$3" -in in.script
}
wrong 'unknown keyword' 'thermo_style custom step kee' "kee"
wrong 'format of an integer' 'thermo_modify format int %g' "'%g' is not a format of one integer"
wrong 'two conversions' 'thermo_modify format float %g%g' 'is not a format of one number'
wrong 'no text' 'thermo_modify format float' 'format float lacks its text'
wrong 'no such column' 'thermo_modify format 9 %g' "expected float, int, line, none or the number of a column from 1 to 4"
wrong 'column of another kind' 'thermo_modify format 1 %g' "'%g' is not a format of one integer"
wrong 'short line' 'thermo_modify format line "%d %d"' 'format line has 2 formats, but there are 4 columns'
wrong 'half a step' 'thermo 2.5' 'every is 2.5, expected an integer'
# the number of elements is known before there are contacts
contacts='pair_style gran/hooke 1e4 NULL 3 NULL 0.4 0
pair_coeff * *
set atom 2 x 0.34
compute st all stress/atom NULL
compute rs all reduce sum c_st[1] c_st[2]
compute pl all pair/local dist force
compute rp all reduce sum c_pl[*]
variable t equal count(all)'
printf '%8s %14s %14s %14s %14s %14s \n' Step rs'[1]' rs'[2]' rp'[1]' rp'[2]' thermo_press'[2]' >want
printf '%s\n' "$scene" "$contacts" 'thermo_style custom step c_rs[*] c_rp[*] c_thermo_press[2*2]' 'run 1' >in.script
"$TSIM" -in in.script -log none >out 2>&1
report 'elements of reduced contacts run' $? out
grep '^ *Step' out >got
same 'elements of reduced contacts' want got
awk '$1 == "0" && NF == 6 { ok = $4 == 0.09 } END { exit !ok }' out
report 'their values' $? out
wrong 'no seventh component' 'thermo_style custom step c_thermo_press[*7]' 'c_thermo_press'
wrong 'a variable that stands still' 'variable s equal 0
thermo v_s' 'the step of the next row would be 0, but step 0 is reached'
finish
