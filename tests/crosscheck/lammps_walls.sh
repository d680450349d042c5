#!/bin/bash
# fix wall/gran in LAMMPS' words, by LAMMPS: its laws, two planes, wiggle, shear.
# shellcheck source=tests/lib_lammps.sh
. "$top_srcdir/tests/lib_lammps.sh" || exit 99

agrees() { # FACES SKIN WALL
	both "$3" -in "$top_srcdir/tests/crosscheck/in.lammps_walls" -log none -screen none \
		-var faces "$1" -var skin "$2" -var wall "$3"
	same_frames "$3" 1e-11
}
planes='p p f'
cylinder='f f f'
hooke='hooke/history 1e5 NULL 50 NULL 0.5 1'
agrees "$planes" 0.01 'hooke 1e5 NULL 50 NULL 0.5 1 zplane 0.0 NULL'
agrees "$planes" 0.01 "$hooke zplane 0.0 0.4"
agrees "$planes" 0.01 "hooke/history 1e5 3e4 50 10 0.5 0 limit_damping zplane NULL 0.4"
agrees "$planes" 0.01 'hertz/history 1e7 NULL 50 NULL 0.5 1 zplane 0.0 0.4'
for skin in 0.001 0.1; do
	agrees "$planes" $skin "$hooke zplane 0.0 0.4 wiggle z 0.02 0.07"
done
agrees "$planes" 0.01 "$hooke zplane 0.0 0.4 wiggle x 0.02 0.07"
agrees "$planes" 0.01 "$hooke zplane 0.0 0.4 shear x 0.4"
agrees "$cylinder" 0.01 "$hooke zcylinder 0.5 shear z 0.4"
agrees "$cylinder" 0.01 "$hooke zcylinder 0.5 wiggle z 0.2 0.7"
agrees "$cylinder" 0.01 'hertz/history 1e7 NULL 50 NULL 0.5 1 zcylinder 0.5'

tangential='tangential linear_history 1e4 1 0.5' mindlin='tangential mindlin NULL 1.0 0.5'
sds='rolling sds 1e4 10 0.1' tsuji='damping tsuji' floor='zplane 0.0 NULL'
agrees "$planes" 0.01 "granular hooke 1e5 50 tangential linear_nohistory 1 0.5 damping mass_velocity zplane 0.0 0.4"
agrees "$planes" 0.01 "granular hooke 1e5 50 $tangential damping velocity zplane 0.0 0.4"
agrees "$planes" 0.01 "granular hertz/material 1e7 0.7 0.3 $mindlin $tsuji $floor"
agrees "$planes" 0.01 "granular hertz 1e7 40 tangential mindlin_rescale/force 1e6 1.0 0.5 $sds twisting marshall $floor"
agrees "$planes" 0.01 "granular hertz 1e7 40 tangential mindlin/force 1e6 1.0 0.5 twisting sds 30 0.1 0.01 $floor"
agrees "$planes" 0.01 "granular dmt 1e7 0.7 0.3 5 ${mindlin/0.5/0} $tsuji $floor"
agrees "$cylinder" 0.01 "granular hertz/material 1e7 0.7 0.3 $mindlin $tsuji $sds twisting marshall zcylinder 0.5"

# one sphere until it parts: LAMMPS' sticky walls give nan to those that do not touch
both jkr -in "$top_srcdir/tests/crosscheck/in.lammps_sticks" -log none -screen none
same_frames jkr 1e-12
finish
