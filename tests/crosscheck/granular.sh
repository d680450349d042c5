#!/bin/bash
# Contact laws against LIGGGHTS 3.8, an independent program: uneven spheres collide obliquely with each
# other, a plane and a cylinder, with every law and most combinations.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs liggghts
needs /usr/bin/python3 python3
decks=$top_srcdir/tests/crosscheck

agrees() { # MODEL [WORDS]
	local model=$1 words=$2
	set -- -in "$decks/in.granular" -var decks "$decks" -var steps 6000 \
		-var model "$model" -var words "${words:-limitForce off}"
	model="$model $words"
	liggghts "$@" -var program liggghts -log none -screen none >err 2>&1
	report "$model: LIGGGHTS" $? err
	"$TSIM" "$@" -var program tsim -log none -screen none 2>err
	report "$model: tsim" $? err
	/usr/bin/python3 "$decks/compare.py" liggghts.dump tsim.dump 6000 1e-12 >deviation 2>&1
	report "$model" $? deviation
	echo "$model: $(cat deviation)"
	rm -f ./*.dump
}

for normal in hertz hooke hooke/stiffness hertz/stiffness; do
	agrees "model $normal"
	for tangential in history no_history; do
		agrees "model $normal tangential $tangential"
	done
done
for rolling in cdt epsd epsd2 epsd3; do
	agrees "model hertz tangential history rolling_friction $rolling"
	agrees "model hooke tangential no_history rolling_friction $rolling" 'torsionTorque on'
done
for cohesion in sjkr sjkr2; do
	agrees "model hertz tangential history cohesion $cohesion"
	agrees "model hooke tangential history cohesion $cohesion rolling_friction epsd" 'tangential_reduce on'
done
agrees 'model hertz tangential history' 'limitForce on'
agrees 'model hertz tangential history' 'tangential_damping off'
agrees 'model hooke tangential history' 'ktToKnUser on'
agrees 'model hooke/stiffness tangential history' 'absolute_damping on'
agrees 'model hooke/hysteresis tangential history'
agrees 'model hooke tangential history' 'viscous on'

# spheres that overlap when the run begins: that overlap is the largest one so far
cat >in.overlap <<'END'
units si
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
region b block 0 1 0 1 0 1 units box
create_box 1 b
neighbor 0.001 bin
neigh_modify delay 0
create_atoms 1 single 0.5 0.5 0.5 units box
create_atoms 1 single 0.5099 0.5 0.5 units box
set atom 1 diameter 0.01 density 2500 vx -0.1
set atom 2 diameter 0.01 density 2500 vx 0.1
fix m1 all property/global youngsModulus peratomtype 1e7
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 1
fix m4 all property/global characteristicVelocity scalar 1
fix m5 all property/global coefficientMaxElasticStiffness peratomtypepair 1 4
fix m6 all property/global coefficientAdhesionStiffness peratomtypepair 1 0.5
fix m7 all property/global coefficientPlasticityDepth peratomtypepair 1 0.05
pair_style gran model hooke/hysteresis
pair_coeff * *
timestep 1e-5
fix w all wall/gran model hooke/hysteresis primitive type 1 zplane 0.4951
fix integ all nve/sphere
dump d all custom 1 overlap.${program} id x vx fx fz
dump_modify d sort id format "%d %.16g %.16g %.16g %.16g"
run 20
END
{ liggghts -in in.overlap -var program liggghts -log none && "$TSIM" -in in.overlap -var program tsim -log none; } >out 2>&1
paste overlap.liggghts overlap.tsim | awk '
	NF == 10 && !/[A-Z]/ {
		n++
		for (k = 2; k <= 5; k++)
			if (($k - $(k + 5))^2 > 1e-24 * ($k * $k + 1e-12)) { print; bad = 1 }
	}
	END { exit bad || n < 42 }' >>out
report 'hooke/hysteresis: an overlap before the first step' $? out
finish
