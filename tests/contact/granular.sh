#!/bin/bash
# Scenes with friction: a run cut by restart files is the whole run, contacts with walls and partners
# included; the loop for any law and the specialised one, one thread and two give the same bytes.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.heap <<'END'
units		si
atom_style	granular
boundary	f f f
region		box block -0.1 0.1 -0.1 0.1 -0.01 0.3 units box
if "${from} == none" then "create_box 2 box" &
	"lattice sc 0.0213" &
	"region pile block -0.06 0.06 -0.06 0.06 0.01 0.15 units box" &
	"create_atoms 1 region pile" &
	"set group all diameter 0.0197 density 2385" &
	"velocity all set 0.4 0.3 -0.7 units box" &
	"set region pile type/fraction 2 0.4 20233" &
else "read_restart ${from}"
fix		m1 all property/global youngsModulus peratomtype 5.31e6 7.77e6
fix		m2 all property/global poissonsRatio peratomtype 0.45 0.31
fix		m3 all property/global coefficientRestitution peratomtypepair 2 0.73 0.61 0.61 0.53
fix		m4 all property/global coefficientFriction peratomtypepair 2 0.17 0.31 0.31 0.41
fix		m5 all property/global coefficientRollingFriction peratomtypepair 2 0.053 0.11 0.11 0.21
fix		m7 all property/global characteristicVelocity scalar 1.37
fix		m6 all property/global coefficientRollingViscousDamping peratomtypepair 2 0.51 0.2 0.2 0.3
neighbor	0.002 bin
pair_style	gran ${model} ${words}
pair_coeff	* *
fix		pull all gravity 9.81 vector 0.1 0.0 -1.0
fix		floor all wall/gran ${model} primitive type 1 zplane 0.0
fix		side all wall/gran ${model} primitive type 2 zcylinder 0.09 0.0 0.0
fix		move all nve/sphere
timestep	5e-5
thermo_style	custom step atoms ke erotate fmax
thermo_modify	format float %.17g
thermo		50
run		${last} upto
write_restart	${out}.restart
END
heap() { # NAME LAST FROM MODEL WORDS [THREADS]
	"$TSIM" -in "in.${scene:-heap}" -log "$1.log" -screen none -threads "${6:-1}" -var out "$1" -var last "$2" \
		-var from "$3" -var model "$4" -var words "${5:-limitForce off}" 2>err
	report "$1: $4 $5" $? err
}

for model in 'model hertz tangential history' 'model hooke tangential history' 'model hertz tangential no_history' \
	'model hooke tangential no_history' 'model hooke tangential history rolling_friction epsd'; do
	heap whole 1000 none "$model"
	grep -qE '^ +1000 +[1-9]' whole.log
	report 'particles are there at the end' $? whole.log
	heap a 437 none "$model"
	heap b 731 a.restart "$model"
	heap c 1000 b.restart "$model"
	same "$model: cut in three" whole.restart c.restart
	heap generic 1000 none "$model" generic
	rows whole.log >whole.rows
	rows generic.log >generic.rows
	same "$model: specialised loop and the loop for any law" whole.rows generic.rows
	heap two 1000 none "$model" '' 2
	same "$model: two threads" whole.restart two.restart
done

# contacts of equal particles share R* and m*; but not where only sizes or only densities differ, or change on the way
mixed() { # SCENE WHAT CHANGE: WHAT of a third of the particles is another, later that of a type
	sed "/set group all/a\\
	\"region some block -0.06 -0.02 -0.06 0.06 0.01 0.15 units box\" \&\\
	\"set region some $2\" \&
/^run/i\\
run 300\\
set type 2 $3" in.heap >"in.$1"
}
mixed sizes 'diameter 0.0183' 'diameter 0.0191'
mixed densities 'density 7130' 'density 3170'
for scene in sizes densities; do
	for model in 'model hertz tangential history' 'model hooke tangential history rolling_friction epsd'; do
		heap whole 1000 none "$model"
		heap generic 1000 none "$model" generic
		rows whole.log >whole.rows
		rows generic.log >generic.rows
		same "$scene, $model: specialised loop and the loop for any law" whole.rows generic.rows
	done
done
unset scene

sed '/fix		m4/d' in.heap >in.none
refused 'a property is missing' 'needs `fix ID all property/global coefficientFriction' \
	-in in.none -var from none -var last 0 -var out x -var model 'model hertz tangential history' \
	-var words 'limitForce off'
sed 's/0.31 0.31 0.41/0.31 0.32 0.41/' in.heap >in.none
refused 'not symmetric' 'the value of types 2 and 1 must be that of types 1 and 2' \
	-in in.none -var from none -var last 0 -var out x -var model 'model hertz' -var words 'limitForce off'
sed 's/peratomtype 5.31e6 7.77e6/peratomtype 5.31e6/' in.heap >in.none
refused 'too few types' 'youngsModulus has values for 1 types, but there is a type 2' \
	-in in.none -var from none -var last 0 -var out x -var model 'model hertz' -var words 'limitForce off'
sed '/fix		m7/d' in.heap >in.none
refused 'one number for all is missing' 'property/global characteristicVelocity scalar' \
	-in in.none -var from none -var last 0 -var out x -var model 'model hooke' -var words 'limitForce off'
printf "%s\n" "region b block 0 1 0 1 0 1" "create_box 1 b" "fix m all property/global youngsModulus peratomtype 5e6" "if property_youngsModulus then \"print given\"" \
	"if property_poissonsRatio then \"print too\" else \"print alone\"" >in.given
"$TSIM" -in in.given -log none >out 2>err && grep -q "^given" out && grep -q "^alone" out
report "if property_NAME" $? err
finish
