#!/bin/bash
# The same scenes by LIGGGHTS 3.8, an independent program: pair_style spring/dashpot with `damping` is
# its `gran model hooke/stiffness tangential off absolute_damping on`. Positions, velocities and
# forces are compared frame by frame.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs liggghts
needs /usr/bin/python3 python3
decks=$top_srcdir/tests/crosscheck

# agrees WHAT SCENE 'ARGUMENTS OF compare.py' VARIABLES...
agrees() {
	local what=$1 scene=$2 limits=$3
	shift 3
	set -- -in "$decks/in.crosscheck" -var decks "$decks" -var scene "$scene" "$@"
	liggghts "$@" -var program liggghts -log none -screen none >err 2>&1
	report "$what: LIGGGHTS" $? err
	"$TSIM" "$@" -var program tsim -log none -screen none 2>err
	report "$what: tsim" $? err
	# shellcheck disable=SC2086
	/usr/bin/python3 "$decks/compare.py" liggghts.dump tsim.dump $limits >deviation 2>&1
	report "$what" $? deviation
	echo "$what: $(cat deviation)"
	rm -f ./*.dump
}

# N spheres on a jittered lattice, as a script both programs read; and their velocities.
spheres() {
	awk 'BEGIN {
		srand(20231)
		for (n = 0; n < 200; n++) {
			x = 0.011 + 0.0191 * (n % 5) + 0.0003 * rand()
			y = 0.012 + 0.0187 * (int(n / 5) % 5) + 0.0004 * rand()
			z = 0.017 + 0.0283 * int(n / 25) + 0.0037 * rand()
			type = n % 3 == 0 ? 1 : 2
			printf "create_atoms %d single %.9g %.9g %.9g units box\n", type, x, y, z
		}
		print "set type 1 diameter 0.0173 density 2470"
		print "set type 2 diameter 0.0157 density 1830"
		for (n = 1; n <= 200; n++)
			printf "group g%d id %d\n", n % 20, n >"groups"
		for (n = 0; n < 20; n++)
			printf "velocity g%d set %.9g %.9g %.9g\n", n, 2 * rand() - 1, 2 * rand() - 1,
				2 * rand() - 1 >"set"
	}' >spheres
	cat groups set >velocities
}
spheres

for damping in 0 0.37 2.113; do
	v="-var stiffness 2385 -var damping $damping -var steps 5000 -var every 7"
	# shellcheck disable=SC2086
	agrees "head-on, damping $damping" collision '5000 1e-13' $v -var y 0.0203
	# shellcheck disable=SC2086
	agrees "offset, damping $damping" collision '5000 1e-13' $v -var y 0.0117
done
for damping in 0 0.37 2.113; do
	agrees "walls, damping $damping" walls '30000 1e-10' -var stiffness 2385 \
		-var damping "$damping" -var steps 30000 -var every 50
done
agrees 'settling' settling '2000 1e-10 0.01' -var stiffness 23850 -var damping 6.13 -var steps 12000 \
	-var every 100
agrees 'periodic gas' gas '2000 1e-10 0.02' -var stiffness 23850 -var damping 0 -var steps 4000 \
	-var every 100
agrees 'discs in a plane' plane '2000 1e-10 0.02' -var stiffness 2385 -var damping 0.37 -var steps 3000 \
	-var every 50
finish
