#!/bin/bash
# fix wall/gran/region, by LAMMPS: shapes from within and without, open faces, unions, moving and turning ones (about
# unit vectors: of others LAMMPS takes the length into the speed).
# shellcheck source=tests/lib_lammps.sh
. "$top_srcdir/tests/lib_lammps.sh" || exit 99

agrees() { # WAY LAW REGION...
	local way=$1 law=$2 what
	shift 2
	what="$law: $*"
	printf '%s\n' "$@" >shape
	both "$what" -in "$top_srcdir/tests/crosscheck/in.lammps_regions" -log none -screen none \
		-var way "$way" -var wall "$law" -var skin 0.02
	same_frames "$what" 1e-11
}
hooke='hooke/history 1e4 NULL 50 NULL 0.5 1'
hertz='hertz/history 1e6 NULL 50 NULL 0.5 1'
granular='granular hertz/material 1e6 0.7 0.3 tangential mindlin_rescale NULL 1.0 0.5 damping tsuji rolling sds 1e3 1 0.1 twisting marshall'

agrees 1 "$hertz" 'region w block -0.4 0.5 -0.45 0.4 -0.4 0.42 units box'
agrees -1 "$hertz" 'region w block -0.1 0.15 -0.12 0.1 -0.1 0.12 side out units box'
agrees 1 "$hooke" 'region w block -0.4 0.5 -0.45 0.4 -0.2 0.3 open 6 units box'
agrees 1 "$granular" 'region w cylinder z 0.02 -0.01 0.45 -0.4 0.42 units box'
agrees -1 "$hertz" 'region w cylinder y 0.02 -0.01 0.1 -0.1 0.12 side out units box'
agrees 1 "$hooke" 'region w cylinder x 0.02 -0.01 0.3 -0.2 0.2 open 1 open 2 units box'
agrees 1 "$granular" 'region w sphere 0.02 -0.01 0.03 0.48 units box'
agrees -1 "$granular" 'region w sphere 0.02 -0.01 0.03 0.12 side out units box'
agrees 1 "$hertz" 'region w plane 0.02 -0.01 -0.4 0.1 0.2 1 units box'
agrees 1 "$hertz" 'region w cone z 0.02 -0.01 0.3 0.55 -0.45 0.42 units box'
agrees -1 "$hooke" 'region w cone z 0.02 -0.01 0.2 0.05 -0.12 0.15 side out units box'
agrees 1 "$hooke" 'region c cone z 0 0 0.15 0.5 -0.5 -0.1 open 1 open 2 units box' \
	'region t cylinder z 0 0 0.5 -0.1 0.5 open 1 units box' 'region w union 2 c t'
agrees 1 "$hertz" 'region c cylinder z 0 0 0.5 -0.5 0.45 units box' \
	'region a block -0.4 0.4 -0.05 0.05 -0.5 -0.42 side out units box' 'region w intersect 2 c a'
agrees 1 "$granular" 'variable a equal 2.3*time' \
	'region w cylinder z 0.02 -0.01 0.45 -0.4 0.42 rotate v_a 0.1 0.2 0 0.48 0.64 0.6 units box'
agrees 1 "$hooke" 'variable y equal 0.05*sin(20*time)' 'variable z equal 0.3*time' \
	'region w block -0.4 0.5 -0.45 0.4 -0.4 0.42 move NULL v_y v_z units box'
blades='rotate v_a 0.1 0.2 0 0 0 1 units box'
# without losses: LAMMPS does not see the velocity of members
agrees 1 'hertz/history 1e6 0 0 0 0 0' 'variable a equal 2.3*time' 'region c cylinder z 0 0 0.5 -0.45 0.45 units box' \
	"region a block -0.4 0.4 -0.05 0.05 -0.5 -0.32 side out $blades" \
	"region b block -0.05 0.05 -0.4 0.4 -0.5 -0.32001 side out $blades" 'region w intersect 3 c a b'
finish
