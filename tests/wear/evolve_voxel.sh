#!/bin/bash
# Height fields that recede as they wear: depths by closed forms, the account of volumes, layers, columns worn through,
# holes, threads and restart files, a scar that changes the angles of later impacts, what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# A uniform jet at normal incidence: ${rows} x ${rows} grains over each of the 10 x 10 columns, in ${n} sheets; each
# impact removes ${V}. All lengths are times ${L}.
cat >in.jet <<'END'
units si
atom_style granular
boundary p p f
variable L index 1
variable n index 8
variable rows index 2
variable V index 1e-4
variable E index 1e9
variable field index 'base -0.5'
variable evolve index 'evolve yes evolve_every 3'
variable move index ''
variable impact index exact
variable h index 1e-3
variable steps index 100
lattice sc ${L}
region b block 0 1 0 1 -1 3 units lattice
create_box 1 b
hard_particles yes
neighbor $(0.01*v_L) bin
fix E all property/global youngsModulus peratomtype ${E}
fix nu all property/global poissonsRatio peratomtype 0.3
fix e all property/global coefficientRestitution peratomtypepair 1 0.9
fix mu all property/global coefficientFriction peratomtypepair 1 0
fix s all surface/voxel constant $(0.3*v_L:%.17g) type 1 cells 10 10 ${field} ${move}
fix w all wall/gran model hertz tangential history voxels s impact ${impact}
variable removed equal ${V}*v_L^3
fix worn all wear/formula surface s volume v_removed ${evolve}
lattice sc $(0.1/v_rows*v_L) origin 0.5 0.5 0.5
region seeds block 0 $(10*v_rows-0.25) 0 $(10*v_rows-0.25) $(4.2*v_rows) $(4.2*v_rows+v_n) units lattice
create_atoms 1 region seeds
set group all diameter $(0.02*v_L) density 2500
velocity all set 0 0 $(-10*v_L) units box
fix move all nve/sphere
timestep ${h}
compute sum all reduce sum f_worn[8] f_worn[12] f_worn[13]
compute low all reduce min f_worn[12]
compute high all reduce max f_worn[12]
thermo_modify lost ignore
thermo 1000000
END
# jet WHAT OPTIONS... <lines after the run: `is NAME VALUE EXPECTED [SIZE]`, equal to 1e-12 of the size
jet() {
	local what=$1
	shift
	{
		cat in.jet
		# shellcheck disable=SC2016
		echo 'run ${steps}'
		cat
	} >in.one
	"$TSIM" -in in.one -log none "$@" >out 2>&1 && awk '
		$1 == "is" {
			n++
			d = $3 - $4
			size = NF > 4 ? $5 : $4
			if (size < 0) size = -size
			if (NF < 4 || NF > 5 || !(d <= 1e-12 * size && -d <= 1e-12 * size)) { print "differs: " $0; bad = 1 }
		}
		END { exit bad || !n }' out >>out 2>&1
	report "$what" $? out
}
# Each column has got N = rows^2 n impacts, so that it is N V/A lower.
cat >depths <<'END'
variable N equal v_rows^2*v_n
variable A equal 0.01*v_L^2
print "is hits $(f_worn[3]) $(100*v_N)"
print "is volume $(f_worn:%.17g) $(100*v_N*v_removed:%.17g)"
print "is taken $(f_worn[9]:%.17g) $(f_worn:%.17g)"
print "is column $(c_sum[3]:%.17g) $(f_worn:%.17g)"
print "is pending $(f_worn[10]:%.17g) 0 $(f_worn:%.17g)"
print "is below_0 $(f_worn[10]<0) 0"
print "is surplus $(f_worn[11]) 0"
print "is geometry $((30*v_L-c_sum[2])*v_A:%.17g) $(f_worn:%.17g)"
print "is lowest $(c_low:%.17g) $(0.3*v_L-v_N*v_removed/v_A:%.17g) $(0.3*v_L)"
print "is highest $(c_high:%.17g) $(c_low:%.17g) $(0.3*v_L)"
END
jet 'depth is volume over area' <depths
jet 'three threads' -threads 3 <depths
jet 'micrometres' -var L 1e-6 <depths
jet 'kilometres' -var L 1e3 -var E 1e15 -var field 'base -500' <depths
jet 'in each step' -var evolve 'evolve yes evolve_every 1' <depths
jet 'a moving field' -var move 'move linear 0.5 0.5 0' <depths
jet 'without a base' -var field '' -var evolve 'evolve yes thickness 2 evolve_every 5' <depths
jet 'resolved contacts' -var impact resolved -var h 2e-5 -var steps 5000 -var n 2 <depths
jet 'off by default' -var evolve '' <<'END'
print "is taken $(f_worn[9]) 0"
print "is pending $(f_worn[10]) 0"
print "is lowest $(c_low:%.17g) 0.3"
print "is volume $(f_worn:%.17g) 0.32"
END
jet 'pending until the update' -var evolve 'evolve yes evolve_every 100000' <<'END'
print "is taken $(f_worn[9]) 0"
print "is pending $(f_worn[10]:%.17g) $(f_worn:%.17g)"
print "is volume $(f_worn:%.17g) 0.32"
END
# 32 impacts lower a column by 0.32: 10 layers of 0.03, and 0.02 pending
jet 'layers' -var evolve 'evolve yes evolve_every 3 layer 0.03' <<'END'
print "is taken $(f_worn[9]:%.17g) 0.3"
print "is pending $(f_worn[10]:%.17g) 0.02 0.3"
print "is lowest $(c_low:%.17g) 0 0.3"
print "is highest $(c_high:%.17g) 0 0.3"
END
jet 'a layer that each impact removes' -var evolve 'evolve yes evolve_every 3 layer 0.01' <depths

# Worn through: 0.25 of 0.32
jet 'stop at the thickness' -var evolve 'evolve yes evolve_every 3 thickness 0.25' <<'END'
print "is taken $(f_worn[9]:%.17g) 0.25"
print "is pending $(f_worn[10]:%.17g) 0 0.3"
print "is below_0 $(f_worn[10]<0) 0"
print "is surplus $(f_worn[11]:%.17g) 0.07 0.3"
print "is through $(f_worn[12]) 100"
print "is hits $(f_worn[3]) 3200"
print "is lowest $(c_low:%.17g) 0.05 0.3"
END
grep -q 'warning: fix wear/formula: element 1 .*the first that is worn through' out
report 'the first column worn through is named' $? out
jet 'stop at the base' -var field 'base 0.1' <<'END'
print "is taken $(f_worn[9]:%.17g) 0.2"
print "is account $(f_worn:%.17g) $(f_worn[9]+f_worn[10]+f_worn[11]:%.17g)"
print "is lowest $(c_low:%.17g) 0.1 0.3"
print "is hits $(f_worn[3]) 3200"
END
# An empty column lets grains pass: 0.2 takes 20 impacts of each column, and 12 more arrive below.
jet 'open' -var field 'base 0.1' -var evolve 'evolve yes evolve_every 1 through open' <<'END'
variable up atom vz>0
compute up all reduce sum v_up
print "is taken $(f_worn[9]:%.17g) 0.2"
print "is surplus $(f_worn[11]:%.17g) 0 0.2"
print "is hits $(f_worn[3]) 2000"
print "is through $(f_worn[12]) 100"
print "is reflected $(c_up) 2000"
END
jet 'open, in one layer' -var field 'base 0.1' -var evolve 'evolve yes evolve_every 1 through open layer 0.2' <<'END'
print "is taken $(f_worn[9]:%.17g) 0.2"
print "is hits $(f_worn[3]) 2000"
END
{
	cat in.jet
	echo 'run 200'
} >in.error
"$TSIM" -in in.error -log none -var evolve 'evolve yes evolve_every 3 thickness 0.25 through error' >out 2>&1
[ $? = 1 ] && grep -q 'in.error:.*element [0-9]* of surface s, at (0.[0-9]* 0.[0-9]* 0.05), is worn through at step' out
report 'error' $? out

# What a second fix finds is the field as it is; the thickness counts from the original surface.
jet 'one fix after the other' -var n 4 -var evolve 'evolve yes evolve_every 1 thickness 0.25' <<'END'
unfix worn
fix worn all wear/formula surface s volume v_removed evolve yes evolve_every 1 thickness 0.25
create_atoms 1 region seeds
set group all diameter 0.02 density 2500
velocity all set 0 0 -10 units box
group fresh region seeds
run 100
print "is taken $(f_worn[9]:%.17g) 0.09 0.25"
print "is lowest $(c_low:%.17g) 0.05 0.3"
END

# Spheres rest on the column that they hit again and again: they follow the surface.
cat >in.rest <<'END'
units si
boundary f f f
atom_style granular
newton off
communicate single vel yes
region b block -1 1 -1 1 -1 1 units box
create_box 1 b
fix E all property/global youngsModulus peratomtype 5e6
fix nu all property/global poissonsRatio peratomtype 0.3
fix e all property/global coefficientRestitution peratomtypepair 1 0.3
fix mu all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
fix s all surface/voxel constant 0 type 1 cells 1 1
fix w all wall/gran model hertz tangential history voxels s
fix worn all wear/formula surface s volume 0.2 evolve yes evolve_every 1 thickness 0.5
fix g all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
create_atoms 1 single 0.3 0 0.0999 units box
create_atoms 1 single -0.4 0 0.3 units box
set group all diameter 0.2 density 2500
timestep 2e-4
thermo 1000000
compute z all property/atom z
compute least all reduce min c_z
compute most all reduce max c_z
run 8000
print "rests $(c_most-c_least<1e-3) $(abs(c_least-0.1+f_worn[9]/4)<2e-3) $(f_worn[9]>0.1) $(f_worn[9]) $(c_least) $(c_most)"
END
"$TSIM" -in in.rest -log none >out 2>&1 && grep -q '^rests 1 1 1' out
report 'spheres that rest follow the surface' $? out

# A jet at 30 degrees makes a scar, whose surface downstream of the deepest point faces the jet, and upstream turns away
# from it: the angles of later impacts are larger there, and smaller here.
cat >in.scar <<'END'
units si
atom_style granular
boundary p p f
variable evolve index 'evolve yes evolve_every 20 thickness 1'
region b block -1 1 -0.5 0.5 -1 2 units box
create_box 1 b
hard_particles yes
fix E all property/global youngsModulus peratomtype 1e9
fix nu all property/global poissonsRatio peratomtype 0.3
fix e all property/global coefficientRestitution peratomtypepair 1 0.9
fix mu all property/global coefficientFriction peratomtypepair 1 0
fix s all surface/voxel constant 0 type 1 cells 80 40
fix w all wall/gran model hertz tangential history voxels s impact exact
fix worn all wear/finnie surface s flow_stress 2.5e6 ${evolve}
region nozzle block -0.25 0.25 -0.25 0.25 0.1 1.9 units box
create_atoms 1 random 6000 4711 nozzle
set group all diameter 0.1 density 1000
velocity all set $(10*cos(PI/6):%.17g) 0 -5 units box
variable back atom x+(z-0.05)*vx/vz
set group all x v_back
fix move all nve/sphere
timestep 1e-3
thermo 1000000
thermo_modify lost ignore
run 200
fix later all wear/finnie surface s flow_stress 2.5e6
run 250
dump map all local 1 ${out} f_later[1] f_later[3] f_later[10] f_later[12]
run 0
END
# angles FILE: mean angle of the later impacts upstream, x < -0.1, and downstream, x > 0.1, and the depth
angles() {
	awk 'NF == 4 && /^[-0-9]/ {
			if ($1 > 0) { k = $3 > 0.1 ? 2 : $3 < -0.1 ? 1 : 0; n[k] += $1; s[k] += $1 * $2; if ($2 < 1e9 && ($2 - 30) ^ 2 > 1e-12) off++ }
			if (-$4 > deepest) deepest = -$4
		}
		END { printf "%.4g %.4g %.4g %d\n", s[1] / n[1], s[2] / n[2], deepest, off + 0 }' "$1"
}
for evolve in 'evolve yes evolve_every 20 thickness 1' 'evolve no'; do
	"$TSIM" -in in.scar -log none -var out "scar.${evolve:7:1}" -var evolve "$evolve" >out 2>&1
	report "scar, $evolve" $? out
done
angles scar.y >scar
read -r up down deepest off <scar
echo "angles of later impacts: upstream $up, downstream $down; deepest column $deepest"
awk -v u="$up" -v d="$down" -v h="$deepest" 'BEGIN { exit !(h > 0.03 && u < 28 && d > 32) }'
report 'a scar turns the surface' $? scar
[ "$(angles scar.n)" = '30 30 0 0' ]
report 'without recession all angles are those of the jet' $?

# Threads, and a cut by a restart file, give the same bytes.
deck=$top_srcdir/tests/decks/in.evolving
mkdir one two whole
python3 "$top_srcdir/tests/split_deck.py" "$deck" 0 0 whole/deck none
python3 "$top_srcdir/tests/split_deck.py" "$deck" 2 403 one/deck two/deck
for part in whole one two; do
	[ $part = two ] && cp one/cut.restart two
	(cd $part && "$TSIM" -in deck -log none >out 2>&1)
	report "restart: $part" $? $part/out
done
same 'restart' whole/end.restart two/end.restart
printf 'package omp 3 grain 1\ninclude %s\nwrite_restart three\n' "$deck" >in.three
"$TSIM" -in in.three -log none >out 2>&1
report 'three threads: runs' $? out
same 'three threads' whole/end.restart three
awk '$1 == 2300 { seen = 1; for (k = 4; k <= 11; k++) bad += k != 9 && !($k > 0) } END { exit bad || !seen }' whole/out
report 'the deck wears, with pending and surplus volume and holes' $? whole/out

# The dump has the worn heights.
jet 'dump' <<'END'
dump top all voxel/vtk 1 top.*.vtk s f_worn[13]
run 0
print "is dumped 1 1"
END
awk '/^height 1 / { on = 100; next } on { on--; n++; bad += !(($1 + 0.02) ^ 2 < 1e-24) } END { exit bad || n != 100 }' top.*.vtk
report 'the dump has the heights' $?

# refusal WHAT MESSAGE EVOLVE [FIELD] [LINE]
refusal() {
	{
		cat in.jet
		echo "${5-}"
		echo 'run 1'
	} >in.no
	for check in '' -check; do
		! "$TSIM" -in in.no -log none $check -var evolve "$3" -var field "${4-base -0.5}" >out 2>&1 && grep -q -- "$2" out
		report "refused $check: $1" $? out
	done
}
refusal 'no end' 'give a .thickness., or' 'evolve yes' ' '
refusal 'open without a base' 'no bottom.*give fix surface/voxel a .base.' 'evolve yes thickness 1 through open' ' '
refusal 'open above the base' 'does not end at the thickness 0.5' 'evolve yes thickness 0.5 through open'
refusal 'thickness without evolve' '.thickness. belongs to.*evolve yes' 'thickness 0.5'
refusal 'layer without evolve' '.layer. belongs to.*evolve yes' 'evolve no layer 0.5'
refusal 'through without evolve' '.through. belongs to.*evolve yes' 'through open'
refusal 'no thickness' 'thickness' 'evolve yes thickness 0'
refusal 'negative layer' 'layer' 'evolve yes layer -1'
refusal 'never' 'evolve_every' 'evolve yes evolve_every 0'
refusal 'two fixes' "recedes by fix worn already" 'evolve yes' 'base -0.5' \
	'fix two all wear/finnie surface s flow_stress 1 evolve yes'
refusal 'a plane' 'is one element and keeps its shape.*surface/voxel' '' 'base -0.5' \
	'fix p all wall/gran model hertz tangential history primitive type 1 zplane -1
fix two all wear/finnie surface p flow_stress 1 evolve yes thickness 1'
finish
