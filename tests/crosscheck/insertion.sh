#!/bin/bash
# Insertion against LIGGGHTS 3.8: the same particles at the same places, step by step.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs liggghts
needs /usr/bin/python3 python3
decks=$top_srcdir/tests/crosscheck
triangle() { # nine coordinates
	printf 'facet normal 0 0 1\nouter loop\nvertex %s %s %s\nvertex %s %s %s\nvertex %s %s %s\nendloop\nendfacet\n' "$@"
}
{
	echo 'solid face'
	triangle 0.2 0.15 0.8 0.8 0.15 0.8 0.8 0.65 0.8
	triangle 0.2 0.15 0.8 0.8 0.65 0.8 0.3 0.6 0.8
	triangle 0.8 0.15 0.8 0.9 0.3 0.8 0.8 0.65 0.8
	echo 'endsolid face'
} >face.stl

agrees() { # FACES STYLE MIXTURE WORDS [COMMAND]
	local faces=$1 words="$2 seed 32452867 distributiontemplate $3 $4" then=${5:-print .}
	set -- -in "$decks/in.insertion" -var decks "$decks" -var faces "$faces" -var words "$words" \
		-var then "$then"
	# it crashes where it has no screen or no log to tell of insertions
	liggghts "$@" -var mesh mesh/surface/planar -var program liggghts -log liggghts.log >err 2>&1
	report "$words: LIGGGHTS" $? err
	"$TSIM" -legacy "$@" -var mesh mesh/surface -var program tsim -log none -screen none 2>err
	report "$words: tsim" $? err
	/usr/bin/python3 "$decks/compare.py" liggghts.dump tsim.dump 300 1e-12 >deviation 2>&1
	report "$words" $? deviation
	echo "$faces $words: $(cat deviation)"
	/usr/bin/python3 "$decks/columns.py" liggghts.numbers tsim.numbers 1e-12 >deviation 2>&1
	report "$words: number and mass" $? deviation
	rm -f ./*.dump ./*.numbers
}

agrees 'f f f' insert/pack two 'insert_every once all_in yes maxattempt 200 region block particles_in_region 90'
agrees 'f f f' insert/pack three 'insert_every 60 all_in yes vel uniform 0 0 0.2 0.4 0.3 0.2 region tube volumefraction_region 0.17'
agrees 'f f f' insert/pack two 'insert_every 40 all_in no vel gaussian 0 0 0.2 0.4 0.3 0.2 omega constant 1 -2 3 region ball mass_in_region 30'
agrees 'f f m' insert/pack three 'insert_every 100 all_in yes region cone volumefraction_region 0.13'
agrees 'f f f' insert/pack three 'insert_every 50 start 30 random_distribute uncorrelated all_in yes region both particles_in_region 70' 'run 35'
agrees 'f f f' insert/pack one 'insert_every once overlapcheck no vel constant 0.1 0.2 0.3 region many particles_in_region 90'
agrees 'f f f' insert/pack three 'insert_every 30 maxattempt 7 orientation random vel constant 0.1 0.2 0.3 region block volumefraction_region 0.33'
agrees 'f f f' insert/rate/region three 'nparticles 90 particlerate 20000 insert_every 70 all_in yes vel uniform 0 0 -2 0.4 0.3 0.2 region tube'
agrees 'f f m' insert/rate/region two 'mass 60 massrate 20000 insert_every 50 region cone'
stream='vel constant 1 -2 -50 omega constant 1 -2 3 overlapcheck yes'
agrees 'f f f' insert/stream two "nparticles 60 $stream particlerate 15000 insertion_face face extrude_length 0.2"
agrees 'm m m' insert/stream three "nparticles INF $stream massrate 12000 insertion_face face extrude_length 0.3 parallel yes"
agrees 'p p f' insert/stream one 'nparticles INF vel constant 0 0 60 overlapcheck no insert_every 120 particlerate 9000 insertion_face face duration 60'
agrees 'f f f' insert/stream two 'mass 50 vel uniform 1 -2 -50 0.5 2 7 overlapcheck yes all_in yes orientation random particlerate 15000 start 7 insertion_face face extrude_length 0.2' 'run 10'

cat >stone <<'END'
# x y z r
0 0 0 10
12 0 0 8
15 11 3 9
END
falls() { # TEMPLATE MOVE
	local what=$1
	set -- -in "$decks/in.clumps" -var decks "$decks" -var template "$1" -var move "$2"
	liggghts "$@" -var program liggghts -log liggghts.log >err 2>&1
	"$TSIM" -legacy "$@" -var program tsim -log none -screen none 2>err
	report "$what: tsim" $? err
	/usr/bin/python3 "$decks/compare.py" liggghts.dump tsim.dump 1001 1e-9 >deviation 2>&1
	report "$what" $? deviation
	echo "$what: $(cat deviation)"
	rm -f ./*.dump
}
falls 'multiplespheres 15485863 atom_type 1 density constant 2500 nspheres 2 ntry 20000 spheres 0 0 0 0.01 0.0201 0.003 0 0.009' nve/sphere
falls 'multisphere 15485863 atom_type 1 density constant 2500 nspheres 3 ntry 20000 spheres file stone scale 0.001 type 1' multisphere
finish
