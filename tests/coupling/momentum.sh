#!/bin/bash
# Momentum of particles and fluid together, with void fraction, pressure gradient and drag in a periodic box: constant to
# round-off with form conservative, which is no less accurate than form fv.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.start <<'END'
units si
boundary p p p
newton off
communicate single vel yes
region box block 0 0.004 0 0.004 0 0.004 units box
create_box 1 box
create_atoms 1 random 200 17 box
set group all diameter 0.0003 density 2500
END
# scene FLUID METHOD DRAG [PRESSURE]: momentum is that after the half kick which is still to come
scene() {
	cat <<END
variable x atom mass*vx+0.5*dt*fx
variable y atom mass*vy+0.5*dt*fy
variable z atom mass*vz+0.5*dt*fz
compute p all reduce sum v_x v_y v_z
variable px equal c_p[1]+flow_px
variable py equal c_p[2]+flow_py
variable pz equal c_p[3]+flow_pz
flow_style projection viscosity 1e-3 density 1000 $1
fix e all void_fraction method $2 least 0.01
fix d all $3
fix p all flow/pressure_gradient ${4-}
fix m all nve
timestep 1e-4
END
}
moving='velocity all create 1 2385
velocity all set 0.1 0 -0.05 sum yes'

# drift WHAT LIMIT SCENE-ARGUMENTS: over 0.01 s, by the largest momentum
drift() {
	local what=$1 limit=$2
	shift 2
	{ cat in.start; echo "$moving"; scene "$@"; cat <<'END'
run 1
variable x0 equal $(v_px:%.17g)
variable y0 equal $(v_py:%.17g)
variable z0 equal $(v_pz:%.17g)
variable u0 equal $(flow_px:%.17g)
run 100
print "drift $((abs(v_px-v_x0)+abs(v_py-v_y0)+abs(v_pz-v_z0))/abs(v_x0)) exchanged $((flow_px-v_u0)/v_x0)"
END
	} >in.drift
	"$TSIM" -in in.drift -log none >out 2>&1 </dev/null
	awk -v limit="$limit" '/^drift/ { n++; exit !($2 <= limit && $2 > limit * low && $4 > 0.3) }
		END { if (!n) exit 1 }' low="${LOW-0}" out
	report "$what" $? out
}

for time in euler rk2 rk3 'rk3 substeps 3' 'euler substeps auto'; do
	drift "$time" 1e-13 "cells 4 4 4 form conservative time $time" divided 'drag/di_felice scheme exact'
done
drift 'fine cells, kernel, explicit drag' 1e-13 'cells 8 8 8 form conservative time rk2' kernel 'drag/wen_yu lagged yes'
drift 'cells that differ, central' 1e-13 'cells 4 8 5 form conservative convection central' divided 'drag/gidaspow scheme implicit interpolation cell'
drift 'donor' 1e-13 'cells 5 5 5 form conservative convection donor gamma 0.7' divided 'drag/stokes scheme exact'
drift 'cubista' 1e-13 'cells 5 5 5 form conservative convection cubista time rk3' divided 'drag/stokes scheme exact'
drift 'method centre' 1e-13 'cells 5 5 5 form conservative' centre 'drag/stokes scheme exact'
LOW=0.01
# form fv does not
drift 'form fv' 0.01 'cells 4 4 4' divided 'drag/di_felice scheme exact'
# nor a gradient that is taken elsewhere than the volume is
drift 'interpolation linear' 0.01 'cells 4 4 4 form conservative' divided 'drag/di_felice scheme exact' 'interpolation linear'
unset LOW

# ---- graded cells
{ cat in.start | sed 's/boundary p p p/boundary p f f/'; echo "$moving"
  scene 'cells 4 8 5 form conservative time rk3' divided 'drag/di_felice scheme exact' | sed '/^fix e/i flow_grid y tanh 1.2\nflow_boundary ylo slip\nflow_boundary yhi slip\nflow_boundary zlo slip\nflow_boundary zhi slip'
  cat <<'END'
fix lid all wall/region
END
} | sed '/wall.region/d; s/^create_atoms.*/region in block 0 0.004 0.0005 0.0035 0.0005 0.0035 units box\ncreate_atoms 1 random 150 17 in/; s/0.1 0 -0.05/0.1 0 0/; s/create 1 2385/create 1e-9 2385/' >in.graded
cat >>in.graded <<'END'
run 1
variable x0 equal $(v_px:%.17g)
run 50
print "drift $(abs(v_px-v_x0)/abs(v_x0))"
END
"$TSIM" -in in.graded -log none >out 2>&1 </dev/null
awk '/^drift/ { n++; exit !($2 < 1e-13) } END { if (!n) exit 1 }' out
report 'graded cells between slip faces, along them' $? out

# ---- discs, and what they exchange with the fluid, are by unit of depth: the depth of the box does not matter
for depth in 1 0.001 70; do
	for fluid in 'form conservative' 'form fv'; do
		{ sed "s/^boundary/dimension 2\nboundary/; s/0 0.004 units/$(awk "BEGIN { print -$depth / 2, $depth / 2 }") units/; s/200 17/60 17/" in.start
		  echo 'velocity all set 0.1 0.03 0'
		  scene "cells 4 5 1 $fluid time rk2" divided 'drag/di_felice scheme exact'
		  cat <<END
run 1
variable x0 equal \$(c_p[1]+flow_px/$depth:%.17g)
run 40
print "discs \$(c_p[1]:%.10g) \$(c_p[2]:%.10g) \$(flow_px/$depth:%.10g) $fluid"
print "drift \$(abs(c_p[1]+flow_px/$depth-v_x0)/v_x0)"
END
		} >in.discs
		"$TSIM" -in in.discs -log none >out 2>&1 </dev/null
		[ "$fluid" = 'form fv' ] || awk '/^drift/ { n++; exit !($2 < 1e-13) } END { if (!n) exit 1 }' out
		report "discs, depth $depth, $fluid" $? out
		grep '^discs' out >>"discs.$depth"
	done
done
same 'discs in a thin box' discs.1 discs.0.001
same 'discs in a deep box' discs.1 discs.70

# ---- particles and fluid that move alike: form conservative keeps the uniform flow as well as fv does
for form in fv conservative; do
	{ cat in.start; echo 'velocity all set 0.1 0.05 0'
	  scene "cells 6 6 6 time rk2 form $form" kernel 'drag/stokes' | sed '/^fix d/d; s/^fix e/flow_set velocity 0.1 0.05 0\nfix e/'
	  cat <<'END'
compute u all flow/plane z 0.0021 values vx vy
variable off vector abs(c_u[1]-0.1)+abs(c_u[2]-0.05)
run 100
print "off $(max(v_off)/0.1)"
END
	} >in.alike
	"$TSIM" -in in.alike -log none 2>&1 </dev/null | awk '/^off/ { print $2 }'
done >alike
awk 'NR == 1 { fv = $1 } NR == 2 { n++; exit !(fv > 0 && $1 < 1.1 * fv && $1 < 0.03) } END { if (!n) exit 1 }' alike
report 'a uniform flow' $? alike

# ---- a bed that is held has the pressure drop of Ergun's equation, whatever the step
bed() {
	cat <<END
units si
boundary p p f
newton off
communicate single vel yes
region box block 0 0.01 0 0.01 0 0.06 units box
region bed block 0 0.01 0 0.01 0.02 0.04 units box
create_box 1 box
lattice sc 0.0011
create_atoms 1 region bed
set group all diameter 0.001 density 2385
fix hold all freeze
flow_style projection cells 1 1 15 viscosity 1e-3 density 1000 form $1
flow_boundary zlo inlet velocity 0 0 0.013
flow_boundary zhi outlet
fix e all void_fraction
fix d all drag/ergun interpolation cell
fix p all flow/pressure_gradient
compute p all flow/probe 0.005 0.005 0.01 0.005 0.005 0.05 values p
timestep $2
run 300
print "drop \$(c_p[1][1]-c_p[2][1]:%.9g)"
END
}
for way in 'fv 1e-3' 'conservative 1e-3' 'conservative 0.04'; do
	bed $way >in.bed
	"$TSIM" -in in.bed -log none 2>&1 </dev/null | grep '^drop [1-9]'
done >drops
awk '{ drop[NR] = $2 } END { if (NR != 3) exit 1
	exit !((drop[2] / drop[1] - 1)^2 < 1e-6 && (drop[3] / drop[2] - 1)^2 < 1e-16) }' drops
report 'pressure drop of a held bed, by steps of 1 and 40 ms' $? drops

# ---- a body floats in the pressure of the fluid's weight
{ cat in.start | sed 's/boundary p p p/boundary p p f/; s/^create_atoms.*/create_atoms 1 single 0.0017 0.0021 0.0018 units box/; s/density 2500/density 1000/'
  scene 'cells 4 4 4 form conservative body_force 0 0 -9.81' divided 'drag/stokes' | sed '/^fix d/d'
  cat <<'END'
run 20
print "lift $(f_p[3]/(mass(all)*9.81):%.9g)"
END
} >in.float
prints "$(cat in.float)" 'lift 1'

# ---- cut in two by a restart file, and on threads
whole="thermo_modify format float %.17g
thermo_style custom step flow_ke flow_px c_p[1] c_p[2] v_px
thermo 5"
{ cat in.start; echo "$moving"; scene 'cells 4 4 4 form conservative time rk2 substeps 2' divided 'drag/di_felice scheme exact'; echo "$whole"; printf 'run 10\nwrite_restart r\nrun 10\n'; } >in.whole
{ echo 'read_restart r'; scene 'cells 4 4 4 form conservative time rk2 substeps 2' divided 'drag/di_felice scheme exact'; echo "$whole"; echo 'run 10'; } >in.again
"$TSIM" -in in.whole -log none >out 2>&1 </dev/null && rows out | tail -n 2 >rows.whole
report 'runs' $? out
"$TSIM" -in in.again -log none >out 2>&1 </dev/null && rows out | tail -n 2 >rows.again
report 'goes on' $? out
same 'continued from a restart file' rows.whole rows.again
sed '1i package omp 3 grain 1' in.whole >in.threads
OMP_WAIT_POLICY=passive "$TSIM" -in in.threads -log none >out 2>&1 </dev/null && rows out | tail -n 2 >rows.threads
report 'on 3 threads' $? out
same 'threads' rows.whole rows.threads

# ---- without void fraction it is form fv
for form in fv conservative; do
	printf '%s\n' 'units si' 'boundary f f p' 'region box block 0 1 0 1 0 1 units box' 'create_box 1 box' \
		"flow_style projection cells 8 8 1 viscosity 0.01 density 1 time rk3 form $form" 'flow_boundary yhi wall velocity 1 0 0' \
		'timestep 0.01' 'run 20' 'print "ke $(flow_ke:%.17g)"' >in.lid
	"$TSIM" -in in.lid -log none 2>&1 </dev/null | grep '^ke' >lid.$form
done
same 'without void fraction' lid.fv lid.conservative

# ---- what it does not go with
for words in 'time ab2' 'every 2'; do
	rejects "$(cat in.start; scene "cells 4 4 4 form conservative $words" divided 'drag/stokes scheme exact'; echo 'run 1')" \
		'form conservative goes with time euler, rk2 or rk3 and every 1'
done
rejects "$(cat in.start; scene 'cells 4 4 4' divided 'drag/stokes scheme exact' 'interpolation volume' | sed '/^fix e/d'; echo 'run 1')" \
	'interpolation volume needs a fix void_fraction'
finish
