#!/bin/bash
# Cells that are too wide for the flow are told once, at the end of a run, with numbers; flows that are right are not, however
# high the cell Reynolds number is.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# scene CELLS RE CONVECTION FACES [UNIT]: a flow in a box of 2 x 1 units, at time 8 in units of the speed
scene() {
	local m=${5-1}
	cat <<END
units si
boundary f f p
dimension 2
variable m equal $m
region box block 0 \$(2*v_m) 0 \$(v_m) \$(-0.5*v_m) \$(0.5*v_m) units box
create_box 1 box
flow_style projection cells $((2 * $1)) $1 1 viscosity \$(v_m/$2) density 1 convection $3 time rk3 substeps auto courant 0.4
variable yy internal 0
variable jet equal ternary(v_yy<0.5*v_m,1,0)
$4
timestep \$(0.02*v_m)
run 300
run 100
END
}

# told WHAT SCRIPT [TEXT ...]: found once, with these texts; without texts: not at all
told() {
	local what=$1 ok=0
	printf '%s\n' "$2" >in.script
	shift 2
	"$TSIM" -in in.script -log run.log -screen none >out 2>&1 </dev/null || ok=1
	grep '(review: flow_resolution)' run.log >told
	[ "$(grep -c . told)" = $(($# > 0)) ] || ok=1
	for text in "$@"; do
		shows "$text" told || ok=1
	done
	report "$what" $ok told
}

jet='flow_boundary xlo inlet velocity v_jet 0 0 set y yy
flow_boundary xhi outlet
flow_boundary ylo slip
flow_boundary yhi slip'
told 'a jet, its edges thinner than a cell' "$(scene 8 2000 central "$jet")" 'in.script:7: warning' 'alternates from cell to cell' \
	'use `convection quick`'
told 'the same in micrometres' "$(scene 8 2000 central "$jet" 1e-6)" 'alternates from cell to cell'
told 'the same in kilometres' "$(scene 8 2000 central "$jet" 1e3)" 'alternates from cell to cell'
told 'quick' "$(scene 16 2000 quick "$jet")" 'alternates' 'use `convection cubista`'
told 'upwind smears, but does not alternate' "$(scene 8 2000 'donor gamma 1' "$jet")"
told 'a jet that spreads' "$(scene 16 100 central "$jet")"
told 'a uniform flow, cell Reynolds number 2500' "$(scene 8 20000 central 'flow_boundary xlo inlet velocity 1 0 0
flow_boundary xhi outlet
flow_boundary ylo slip
flow_boundary yhi slip')"

lid='flow_boundary yhi wall velocity 1 0 0'
told 'a lid, 8 cells' "$(scene 8 200 central "$lid")" 'beside the wall' 'use more cells along'
told 'a lid, 32 cells' "$(scene 32 100 central "$lid")"
told 'a lid that has just started' "$(scene 8 200 central "$lid" | sed 's/run 300/run 2/; s/run 100/run 2/')"
told 'the layer of a wall' "$(scene 16 5000 quick 'flow_boundary xlo inlet velocity 1 0 0
flow_boundary xhi outlet')" 'beside the wall ylo' 'y+ = '
for cells in 3 6; do
	(cd "$top_srcdir/examples/flow/poiseuille" &&
		"$TSIM" -in in.poiseuille -var drive force -var N $cells -log none) 2>&1 </dev/null | grep -c '(review: flow_resolution)'
done >counts
printf '1\n0\n' >expected
same 'three cells across a channel' counts expected

# ---- as other findings
scene 8 2000 central "$jet" | sed '1i review error flow_resolution' >in.script
refused 'as an error' '(review: flow_resolution)' -in in.script -log none -screen none
told 'left out' "review off flow_resolution
$(scene 8 2000 central "$jet")"
# at rest under its weight, in two dimensions and in three, with cells of several widths; flows as slow are no round-off
rest='units si
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 1 box
flow_style projection cells 8 8 8 viscosity 1 density 1 body_force 1 0.7 -9.81
timestep 1e-4
run 1000'
told 'a fluid at rest' "$rest"
told 'a fluid at rest, solved for by iterations' "${rest/timestep/pressure_style cg
timestep}"
told 'a fluid at rest beside narrow cells' "${rest/timestep/flow_grid x tanh 1.5
timestep}"
told 'a slow lid above it' "${rest/timestep/flow_boundary zhi wall velocity 1e-9 0 0
timestep}" 'beside the wall'
finish
