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
finish
