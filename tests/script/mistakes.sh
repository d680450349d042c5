#!/bin/sh
# What users get wrong, and what they are told: each case is a script, `=>`, and the first line of the
# message without the name of the file; ` ...` at its end stands for lists that grow. $box stands for a scene
# in order.
. "$top_srcdir/tests/lib_cases.sh"

cat >box <<'END'
units si
region b block 0 1 0 1 0 1 units box
create_box 2 b
create_atoms 1 single 0.5 0.5 0.5 units box
set type 1 diameter 0.1 density 2385
pair_style spring/dashpot
pair_coeff * * stiffness 100 restitution 0.5
fix m all nve
END

# Runs the script collected so far and compares the message.
try() {
	"$TSIM" -log none -screen none -in in.m >out 2>err </dev/null
	status=$?
	found=$(head -n 1 err)
	case $1 in
	*' ...') [ "${found#"in.m:${1% ...}"}" != "$found" ] ;;
	*) [ "$found" = "in.m:$1" ] ;;
	esac && [ $status = 1 ]
	right=$? # the next line runs a program
	report "$(tail -n 1 in.m)" $right err
	: >in.m
}

: >in.m
while IFS= read -r row; do
	case $row in
	'$box') cat box >>in.m ;;
	'=> '*) try "${row#=> }" ;;
	*) printf '%s\n' "$row" >>in.m ;;
	esac
done <<'END'
dimension 4
=> 1:11: error: dimension: dimension is 4, expected a number from 2 to 3
boundary p p
=> 1:1: error: boundary: z is missing, expected a word (faces normal to z)
boundary p p x
=> 1:14: error: boundary: z is 'x', expected p, f, s or m, or two of f, s, m
boundary fp p p
=> 1:10: error: boundary: x is 'fp', but both faces must be periodic or none
regoin b block 0 1 0 1 0 1
=> 1:1: error: unknown command 'regoin'; did you mean 'region'?
region b block 0 1 0 1 0
=> 1:10: error: region block: zhi is missing, expected a number, INF or EDGE (upper z, INF or EDGE)
region b block 0 1 1 0 0 1
=> 1:10: error: region block: ylo = 1 is above yhi = 0
region b block 0 1 0 1 0 1 unit box
=> 1:28: error: region block: unknown keyword 'unit'; did you mean 'units'?
create_box 1 b
=> 1:14: error: there is no region 'b'
region b block 0 1 0 1 0 1
create_box b 1
=> 2:12: error: create_box: types is 'b', expected an integer (number of atom types)
$box
fix 1 all nve/sphre
=> 9:11: error: unknown fix style 'nve/sphre'; did you mean 'nve/sphere'?
$box
fix 1 gravity all 9.81 vector 0 0 -1
=> 9:7: error: there is no group 'gravity'; known: all; 'gravity' is a style, the group stands before it
$box
fix g all gravity vector 0 0 -1
=> 9:19: error: fix gravity: magnitude is 'vector', expected a number or v_name (magnitude of the acceleration)
$box
fix g all gravity 9.81 0 0 -1
=> 9:24: error: fix gravity: mode is '0', expected one of vector, chute ...
$box
fix w all wall/gran primitive type 1 zplan 0
=> 9:38: error: fix wall/gran: unknown keyword 'zplan'; did you mean 'zplane'?
$box
fix w all wall/gran
=> 9:11: error: fix wall/gran: expected one of xplane, yplane, zplane, xcylinder, ycylinder, zcylinder, found 0 of them; or `mesh n_meshes 1 meshes ID`, or `voxels ID`
$box
dump d all custom post.dump 100 id x
=> 9:19: error: dump custom: every is 'post.dump', expected an integer (steps between frames)
$box
dump d all custom 100 post.dump id xx
=> 9:36: error: dump custom: unknown quantity 'xx', expected a quantity of particles, c_ID[k], f_ID[k] or v_NAME; did you mean 'x'?
$box
fix p all print 100 "so" file in.m/post.txt
run 100
=> 9:31: error: cannot write 'in.m/post.txt': 'in.m' is no folder that one can be made in
$box
dump d all custom 100 post.dump
=> 9:12: error: dump custom: columns is missing, expected quantities: id, type, x, y, z, vx, radius ..., c_ID[k], f_ID[k], v_NAME
$box
run
=> 9:1: error: run: N is missing, expected an integer (number of steps)
$box
run 1e3
=> 9:5: error: run: N is '1e3', expected an integer, such as 1000 (number of steps)
$box
run 100.5e1
=> 9:5: error: run: N is '100.5e1', expected an integer, such as 1005 (number of steps)
$box
fix l all langevin 300 300 0.1 4711 angmom no omega yes
run 0
=> 9:11: error: fix langevin: rotations are not thermostatted: angmom and omega can only be no
$box
run 10 upto
run 5 upto
=> 10:5: error: run upto 5: the simulation is already at step 10
$box
timestep 1e-3s
=> 9:10: error: timestep: dt is '1e-3s', expected a number (time step)
$box
thermo_style custom step foo
run 1
=> 9:26: error: unknown quantity 'foo', expected a thermo keyword, c_ID, f_ID or v_name
$box
thermo_style custom stepp c_e
run 1
=> 9:21: error: unknown quantity 'stepp', expected a thermo keyword, c_ID, f_ID or v_name; did you mean 'step'?
$box
variable x equal 2*
print $x
=> 9:19: error: expected a number or a name, found the end of the formula (variable 'x', needed by in.m:10)
$box
variable x equal sqr(2)
print $x
=> 9:18: error: unknown function 'sqr'; did you mean 'sqrt'? (variable 'x', needed by in.m:10)
$box
variable x equal step*y
print $x
=> 9:23: error: unknown name 'y' (variable 'x', needed by in.m:10)
print ${radius}
=> 1:7: error: unknown variable 'radius'
print hello world
=> 1:13: error: print: unknown keyword 'world'; known: ...
print "hello
=> 1:7: error: this quote " is never closed
variable x 5
=> 1:12: error: variable: style is '5', expected one of index, loop ...
variable x equal 1 + 2
=> 1:20: error: a variable of style equal takes one word; put quotes around a value with blanks
include missing.in
=> 1:9: error: cannot open script 'missing.in': No such file or directory
jump SELF end
=> 1:11: error: there is no 'label end' in in.m
if ${x} > 5 then "quit"
=> 1:4: error: unknown variable 'x'
if 1 > 2 then "quit"
=> 1:6: error: expected 'then' after the condition, found '>' (a condition with blanks needs quotes)
variable x equal 3
if "${x} > 2" "quit"
=> 2:1: error: expected: if "condition" then "command" ...
$box
compute c all reduce sum c_d
=> 9:26: error: there is no compute 'd'
$box
compute c all kee
=> 9:15: error: unknown compute style 'kee'; did you mean 'ke'?
$box
fix a all ave/time 10 5 20 c_k
=> 9:11: error: fix ave/time: Nfreq (20) must be a multiple of Nevery (10) and not less than Nrepeat (5) times Nevery
$box
group g radius > 2
=> 9:9: error: group: style is 'radius', expected one of type, id, region ...
$box
unfix grav
=> 9:7: error: there is no fix 'grav'; known: m
$box
compute k all ke
fix k all ave/time 1 1 1 c_k
fix k all nve
=> 11:11: error: fix id 'k' is already in use by style ave/time (in.m:10)
units si
region b block 0 1 0 1 0 1 units box
create_box 2 b
create_atoms 1 single 0.5 0.5 0.5 units box
fix m all nve
run 10
=> 6: error: the periodic box is 1 long in dimension x, less than the reach 1.2 of a contact: make it longer or the skin smaller
units si
region b block 0 1 0 1 0 1 units box
create_box 2 b
units lj
=> 4:1: error: units must come before the simulation box is created
$box
set type 1 diamter 0.1
=> 9:12: error: set: unknown keyword 'diamter'; did you mean 'diameter'?
$box
pair_coeff 1 3 stiffness 1 restitution 0.5
=> 9:1: error: pair_coeff: particle type 3 does not exist, create_box made 2
$box
pair_coeff * * 100 0.5
=> 9:16: error: pair_coeff: unknown keyword '100'; known: ...
pair_style gran model hertz tangential history
run 1
=> 2:1: error: 'run' needs a simulation box: use create_box or read_restart first
$box
read_restart nothing.restart
=> 9:1: error: there is a box already: read_restart comes before create_box
$box
velocity all set 0 0
=> 9:1: error: velocity: vz is missing, expected a number, v_name or NULL (component, v_NAME, or NULL: not changed)
$box
neighbor 0.001 bins
=> 9:16: error: neighbor: style is 'bins', expected one of bin, nsq ...
$box
neigh_modify every 1 delay
=> 9:22: error: neigh_modify: keyword delay lacks its value, expected an integer (no effect: displacements are checked in every step)
$box
fix f all addforce 0 0 v_g
=> 9:24: error: fix addforce: fz names an unknown variable 'g'
$box
read_data no.data
=> 9:1: error: there is a simulation box already: use `add append` or `add merge`
$box
dump_modify e sort id
=> 9:13: error: there is no dump 'e'
$box
bond_coeff 1 stiffness 1 ultimate 1
=> 9:1: error: bond_coeff needs a bond_style before it
$box
create_bonds many all all 1 0 1
=> 9:1: error: create_bonds: there is no `bond_coeff 1 ...` yet
$box
label a
jump SLEF a
=> 10:6: error: cannot open script 'SLEF': No such file or directory
$box
next i
=> 9:6: error: unknown variable 'i'
$box
thermo_modify lost ingore
=> 9:20: error: thermo_modify: lost is 'ingore', expected one of ignore, warn ...
$box
print "a" fil a.txt
=> 9:11: error: print: unknown keyword 'fil'; did you mean 'file'?
units  si metal
=> 1:11: error: units: unexpected 'metal', the line should end before it
$box
region b sphere 0 0 0 1
=> 9:8: error: there is a region 'b' already (in.m:2)
END
finish
