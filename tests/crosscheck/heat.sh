#!/bin/bash
# Conduction of heat by LIGGGHTS 3.8, an independent program: a chain, a plane and a cube of spheres that stand
# still, then spheres that push each other apart; each area of contact; walls.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs liggghts
needs /usr/bin/python3 python3

columns='id type x f_Temp f_heatFlux[0] f_heatSource[0] f_directionalHeatFlux[1] f_directionalHeatFlux[2]'
# agrees WHAT X Y Z STEP WARMS MODEL WORDS LINES...: the last ones more lines of the script
agrees() {
	local what=$1 x=$2 y=$3 z=$4 h=$5 warms=$6 model=$7 words=$8
	shift 8
	printf '%s\n' "$@" >in.more
	printf '%s\n' "${before[@]}" >in.before
	set -- -in "$top_srcdir/tests/crosscheck/in.heat" -var x "$x" -var y "$y" \
		-var z "$z" -var h "$h" -var warms "$warms" -var model "$model" -var words "$words"
	{
		echo "dump d all custom 40 liggghts.dump $columns"
		echo 'dump_modify d sort id format "%d %d %.17g %.17g %.17g %.17g %.17g %.17g"'
	} >in.dump
	liggghts "$@" >err 2>&1 # with -log none it crashes where it reads a mesh
	report "$what: LIGGGHTS" $? err
	{
		echo "dump d all custom 40 tsim.dump $columns"
		echo 'dump_modify d sort id format float %.17g'
	} >in.dump
	"$TSIM" "$@" -log none -screen none 2>err
	report "$what: tsim" $? err
	for file in liggghts.dump tsim.dump; do # bounds are of other precision, fluxes before the first step of walls only
		sed '/BOX BOUNDS/,+3d' $file | awk '/TIMESTEP/ { n++ } n > 1' >kept
		mv kept $file
	done
	/usr/bin/python3 "$top_srcdir/tests/crosscheck/columns.py" liggghts.dump tsim.dump 1e-12 >deviation 2>&1
	report "$what" $? deviation
	echo "$what: $(cat deviation)"
	rm -f ./*.dump
}
before=() # lines before the first run
line=0.0001
plane=0.0037

agrees chain $plane $line $line 1e-3 all hertz 'contact_area overlap'
agrees 'plane, hot one held' $plane $plane $line 1e-3 cold hertz 'contact_area overlap'
agrees 'cube, hot one held' $plane $plane $plane 1e-3 cold hertz 'contact_area overlap'
agrees constant $plane $plane $line 1e-3 all hertz 'contact_area constant 1.3e-7'
agrees projection $plane $plane $line 1e-3 all hertz 'contact_area projection'
for model in hertz hooke; do
	agrees "$model, area corrected" $plane $plane $line 1e-3 all $model 'area_correction yes'
done
agrees 'moving spheres' $plane $plane $plane 1e-6 all hertz 'contact_area overlap' \
	'fix move all nve/sphere' 'velocity hot set 1.3 0.7 -0.3'
agrees 'frozen spheres' $plane $line $line 1e-3 all hertz 'contact_area overlap' \
	'fix hold cold freeze'
wall='fix w all wall/gran model hertz tangential history primitive type 2 zplane'
agrees 'warm plane' $plane $plane $line 1e-3 all hertz 'contact_area overlap' "$wall -0.0004 temperature 400.0"
agrees 'warm plane, constant area' $plane $plane $line 1e-3 all hertz 'contact_area constant 1e-7' \
	"$wall -0.0004 temperature 400.0 contact_area constant 2e-7"
agrees 'warm plane, projection' $plane $plane $line 1e-3 cold hertz 'contact_area overlap' \
	"$wall -0.0004 temperature 400.0 contact_area projection" 'fix hold cold freeze'
cat >plane.stl <<'END'
solid plane
facet normal 0 0 1
outer loop
vertex -0.0009 -0.0009 -0.0004
vertex 0.0059 -0.0009 -0.0004
vertex 0.0059 0.0059 -0.0004
endloop
endfacet
facet normal 0 0 1
outer loop
vertex -0.0009 -0.0009 -0.0004
vertex 0.0059 0.0059 -0.0004
vertex -0.0009 0.0059 -0.0004
endloop
endfacet
endsolid plane
END
before=('fix cad all mesh/surface file plane.stl type 2 temperature 400.0'
	'fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad')
agrees 'warm mesh' $plane $plane $line 1e-3 all hertz 'contact_area overlap'
finish
