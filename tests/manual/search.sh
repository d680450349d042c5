#!/bin/bash
# Questions of powder engineers, drillers and tribologists, and the page that must be among the first hits of
# `tsim -help`.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# hits WORDS: the pages found, one a line
hits() {
	# shellcheck disable=SC2086
	"$TSIM" -help $1 | sed -n 's/^  tsim -help \([^ ]* [^ ]*\|[^ ]*\).*/\1/p' | sed 's/ *$//'
}
while IFS='|' read -r words most page; do
	hits "$words" | head -n "$most" >found
	grep -qxF -- "$page" found
	report "$words: $page among the first $most" $? found
done <<'END'
angle of repose|1|compute repose/angle
rotating drum|2|examples/everyday/in.drum
lubrication film|2|flow reynolds
heat conduction between grains|2|fix heat/gran
bonds break|4|fix bond/break
picture of a mesh|1|dump image
wear of a wall|4|fix wear/archard
flow through a hopper|2|examples/everyday/in.hopper
restart file|4|command restart
granular temperature|1|compute temp/granular
wet powder|3|doc/bridges
sandblasting|2|doc/erosion
bond strength|3|doc/bonds
what tsim cannot do|2|doc/cannot
wear rate|1|fix wear/archard
particle size distribution|1|fix particledistribution/discrete
surface roughness|1|fix surface/voxel
bulk density|1|compute bed/height
coefficient of restitution|1|fix property/global
rolling friction|1|doc/theory-rolling
angle of internal friction|3|compute stress/region
flow rate of a hopper|1|examples/everyday/in.hopper
power draw of a mill|1|fix mesh/surface/stress
mixing index|1|compute mixing
segregation|1|compute mixing
residence time|1|fix property/atom/regiontracer/time
non-spherical particles|2|fix multisphere
import STL|1|fix mesh/surface
vibrating screen|1|fix move/mesh
conveyor belt|1|fix mesh/surface
compress a tablet|1|examples/everyday/in.compaction
shear cell|1|examples/everyday/in.shear
cohesion energy density|2|pair gran
capillary force|1|doc/bridges
Hertz contact|1|pair gran
Young's modulus|3|fix property/global
heat transfer to wall|1|fix heat/gran
particle breakage|2|fix bond/break
particle charge|1|doc/cannot
fluidization velocity|1|examples/flow/fluidisation/in.fluidisation
pressure drop|2|examples/flow/fluidisation/in.fluidisation
terminal velocity|1|examples/flow/settling/in.settling
drag model|1|doc/theory-drag
critical time step|2|fix check/timestep/gran
lost particles|1|command thermo_modify
periodic boundary|1|command boundary
save and restart|2|command read_restart
export to ParaView|1|dump custom/vtk
colour by velocity|1|dump image
spindle speed|1|fix move/mesh
bit wear|2|fix wear/archard
weight on bit|1|fix drill/bit
rate of penetration|2|fix drill/bit
uniaxial compressive strength|1|examples/rock/in.ucs
Brazilian tensile test|1|examples/rock/in.brazilian
specific energy of drilling|2|doc/rock
crack growth|1|fix bond/break
Stribeck curve|1|examples/polishing/in.stribeck
film thickness|1|flow reynolds
material removal rate|1|compute active/paml
friction coefficient measurement|1|examples/everyday/in.shear
color of grains|2|dump image
END

# exact names are shown as pages, not as hits; endings and the order of words do not matter
"$TSIM" -help gravity | grep -q '^fix gravity: '
report 'an exact name' $?
[ "$(hits 'rotating drums' | sort)" = "$(hits 'drum rotation' | sort)" ]
report 'endings and order' $?
"$TSIM" -help doc/film | grep -q '^doc/film: ' && "$TSIM" -help examples/everyday/in.heap | grep -q 'angle of repose'
report 'pages of doc/ and examples' $?
while IFS='|' read -r words text; do
	# shellcheck disable=SC2086
	"$TSIM" -help $words >out 2>err
	[ $? = 2 ] && shows "$text" err
	report "-help $words" $? err
done <<'END'
angle of repoze|did you mean 'repose'
of the|no words to search for
gravty|did you mean 'gravity'
END
# styles of LAMMPS that tsim lacks: what to write instead, or that there is none
"$TSIM" -help fix indent | grep -q 'fix indent of .*write'
report 'a fix of LAMMPS' $?
"$TSIM" -help fix sieve/curve 2>err
[ $? = 2 ] && shows "there is no fix 'sieve/curve'" err
report 'a fix of no program' $? err
"$TSIM" -help compute permeability | grep -q "^there is no compute 'permeability'; 'permeability' is found on"
report 'a compute that tsim lacks, and pages about its word' $?
# a word that no page has is left out, unless it is misspelled by a letter
"$TSIM" -help quaternionic gravity >out && shows "has the word 'quaternionic'" out &&
	[ "$(hits 'quaternionic gravity' | head -n 1)" = 'fix gravity' ]
report 'an unknown word beside a known one' $? out
[ "$(hits hopper | wc -l)" -le 8 ]
report 'eight hits at most' $?
finish
