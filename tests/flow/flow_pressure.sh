#!/bin/bash
# Pressures given at outlets and inlets: what is exact comes out to round-off with all schemes and solvers - a plug of
# fluid pushed by a pressure that grows, a fluid at rest under gravity -, levels cost no digits, runs can be cut and
# shared among threads, and what cannot be meant is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# small WHAT LIMIT [WORDS...]: tsim runs in.script with them, and every `is VALUE` it prints is below the limit
small() {
	local what=$1 limit=$2
	shift 2
	"$TSIM" -in in.script -log none "$@" >out 2>&1 </dev/null &&
		awk -v limit="$limit" '$1 == "is" { n++; if (!($2 < limit && -$2 < limit)) bad = 1 }
			END { exit bad || !n }' out
	report "$what $*" $? out
}

# ---- a plug between slip faces: rho L du/dt = P(t) is exact for a P linear in time
cat >in.script <<'END'
units si
boundary f f p
dimension 2
region box block 0 2 0 1 -0.5 0.5 units box
create_box 1 box
variable scheme index "time euler"
variable solver index "direct"
variable level index 0
variable push equal v_level+3*time
variable grid index "flow_grid y tanh 1"
flow_style projection cells 8 6 1 viscosity 0.01 density 2.5 ${scheme}
pressure_style ${solver}
${grid}
flow_boundary xlo inlet pressure v_push
flow_boundary xhi outlet pressure ${level}
flow_boundary ylo slip
flow_boundary yhi slip
timestep 0.01
compute p all flow/probe 0.7 0.3 0
compute in all flow/flux xlo
run 60
run 40
print "is $(c_p[1]/0.3-1)"
print "is $(c_in[1]/0.3-1)"
print "is $(flow_div)"
END
for scheme in 'time euler' 'time ab2' 'time rk2' 'time rk3' 'time ab2 viscous implicit' 'viscous backward' \
	'time rk3 substeps 3' 'every 5' 'time rk2 form fd'; do
	small 'plug' 1e-12 -var scheme "$scheme"
done
for solver in direct cg 'cg preconditioner multigrid tolerance 1e-13' 'multigrid tolerance 1e-13' 'sor tolerance 1e-13'; do
	small 'plug' 1e-11 -var solver "$solver" -var level 17
done
small 'plug, graded' 1e-12 -var grid 'flow_grid x tanh 2'
# a level of 1e5 costs digits neither with an iteration nor without
for solver in direct multigrid; do
	small 'level' 1e-8 -var solver "$solver" -var level 101325
done

# ---- fluid that moves along outlets, through which nothing passes, or so little that its sign is that of round-off
sed '/^boundary/s/f f p/p f p/; /^variable \(level\|push\|grid\)/d; /^\${grid}/d; /^compute/d; /^run/d; /^print/d; /^flow_boundary/d' in.script >in.along
cat >>in.along <<'END'
variable push index 0
flow_boundary ylo outlet pressure ${push}
flow_boundary yhi outlet
flow_set velocity 1 0 0
run 30
print "is $(flow_px/5-1)"
END
mv in.script in.plug
mv in.along in.script
for scheme in 'time euler' 'time rk2 form fd' 'time ab2 viscous implicit' 'viscous backward'; do
	for push in 0 1e-13 -1e-13; do
		small 'along outlets' 1e-11 -var scheme "$scheme" -var push $push
	done
done
mv in.plug in.script

# ---- P sin(w t): the error falls with the square of the step
sed -i 's/^variable push.*/variable push equal 3*sin(5*time)/; s/^timestep.*/variable n index 50\ntimestep $(1\/v_n)/
	s/^run 60.*/run ${n}/; /^run 40/d; /^print/d; /^compute in/d' in.script
echo 'print "error $(abs(c_p[1]-3*(1-cos(5))/5/5))"' >>in.script
for scheme in euler ab2 rk2 rk3; do
	for n in 50 100; do
		"$TSIM" -in in.script -log none -var scheme "time $scheme" -var n $n | grep "^error"
	done >errors 2>err
	awk '{ e[NR] = $2 } END { exit !(NR == 2 && e[2] > 0 && e[2] < 1e-3 && log(e[1] / e[2]) / log(2) > 1.95) }' errors
	report "oscillating plug, $scheme" $? errors
done

# ---- at rest under gravity, with outlets at the sides and below
cat >in.script <<'END'
units si
boundary f f f
region box block 0 2 0 0.3 0 1 units box
create_box 1 box
variable scheme index "time euler"
variable solver index "direct"
variable more index "flow_boundary zlo outlet pressure 101325 hydrostatic yes"
flow_style projection cells 8 3 6 viscosity 0.01 density 1000 body_force 1.3 0 -9.81 ${scheme}
pressure_style ${solver}
flow_grid z tanh 1.5
flow_boundary xlo inlet pressure 101325 hydrostatic yes
flow_boundary xhi outlet pressure 101325 hydrostatic yes
${more}
timestep 0.01
run 100
compute p all flow/probe 1.0 0.1 0.25
compute side all flow/force xhi
print "is $(flow_cfl)"
print "is $(c_p[4]/(101325+1000*(9.81*0.75+1.3))-1)"
print "is $(c_side[1]/(0.3*(101325+1000*(9.81*0.5+1.3*2)))-1)"
END
for scheme in 'time euler' 'time ab2' 'time rk2' 'time rk3' 'time rk3 substeps 3'; do
	small 'rest' 1e-12 -var scheme "$scheme"
done
small 'rest' 1e-12 -var solver cg
small 'rest' 1e-12 -var solver 'multigrid tolerance 1e-13'
small 'rest' 1e-12 -var solver 'sor tolerance 1e-13'
small 'rest, walls' 1e-12 -var more 'flow_boundary zlo wall'
small 'rest, steps in between' 1e-12 -var more 'run 13'

# among particles that take room: the same
cat >in.script <<'END'
units si
atom_style granular
boundary f p f
region box block 0 0.02 0 0.01 0 0.03 units box
create_box 1 box
lattice sc 0.0025
region bed block INF 0.014 INF INF 0 0.015 units box
create_atoms 1 region bed
set group all diameter 0.0022 density 2500
pair_style none
flow_style projection cells 8 4 9 viscosity 1.0e-3 density 1000 body_force 0 0 -9.81
flow_boundary xlo inlet pressure 5 hydrostatic yes
flow_boundary xhi outlet pressure 5 hydrostatic yes
pressure_style cg tolerance 1e-14
fix room all void_fraction
fix drag all drag/di_felice
timestep 1e-4
compute p all flow/probe 0.004 0.004 0.004
run 20
print "is $(flow_cfl)"
print "is $(c_p[4]/(5+9810*0.026)-1)"
END
small 'rest in a bed' 1e-11

# ---- the level where nothing gives it, and what flow/vtk writes
cavity='units si
boundary f f p
dimension 2
region box block 0 1 0 1 -0.5 0.5 units box
create_box 1 box
flow_style projection cells 8 8 1 viscosity 0.1 density 1 pressure_level LEVEL WORDS
flow_boundary yhi wall velocity 1 0 0
pressure_style STYLE
timestep 0.003
compute p all flow/plane z 0 values p
variable at vector c_p[1]
run 20
print "mean $(ave(v_at):%.8f) ke $(flow_ke:%.12f)"
write_dump all flow/vtk end.vti'
for words in '' 'viscous implicit' 'time rk3'; do
	for style in direct cg multigrid; do
		script=${cavity/WORDS/$words} script=${script/STYLE/$style}
		printf '%s\n' "${script/LEVEL/0}" >in.script
		ke=$("$TSIM" -in in.script -log none | sed -n 's/^mean.*ke/ke/p')
		prints "${script/LEVEL/4711}" "mean 4711.00000000 $ke"
	done
done
grep -aq 'Name="pressure"' end.vti
report 'pressure in a file' $? out

# ---- cut by a restart file: byte for byte
cat >scene <<'END'
units si
boundary f f p
region box block 0 1 0 0.5 0 0.25 units box
create_box 1 box
END
rest() {
	cat <<END
variable yy internal 0
variable push equal 0.7+sin(40*time)+v_yy
variable fall equal -3-time
flow_style projection cells 7 6 5 viscosity 0.1 density 2.385 body_force 0 v_fall 0 $1
pressure_style $2
flow_boundary xlo inlet pressure v_push set y yy hydrostatic yes
flow_boundary xhi outlet hydrostatic yes
flow_boundary yhi outlet pressure 0.3
region ball cylinder z 0.4 0.2 0.15 INF INF
fix body all immersed/boundary region ball min_cells 2
dump i all flow/vtk 10 s*.vti
compute in all flow/force xlo
thermo 10
thermo_style custom step flow_ke flow_div c_in[1] f_body[1]
thermo_modify format float %.17g
timestep 2e-3
END
}
while read -r solver words; do
	rm -rf whole again
	mkdir whole again
	{ cat scene; rest "$words" $solver; printf 'run 23\nwrite_restart ../restart\nrun 17\n'; } >whole/in
	{ echo 'read_restart ../restart'; rest "$words" $solver; echo 'run 17'; } >again/in
	(cd whole && "$TSIM" -in in -log none) >whole/out 2>&1 && (cd again && "$TSIM" -in in -log none) >again/out 2>&1
	report "$words $solver runs" $? whole/out
	rows whole/out | tail -n 2 >whole/rows
	rows again/out | tail -n 2 >again/rows
	same "$words $solver: the log" whole/rows again/rows
	same "$words $solver: fields" whole/s40.vti again/s40.vti
done <<'END'
direct time ab2 viscous implicit
cg time rk3
multigrid every 3 substeps 2
END
{ echo 'package omp ${threads} grain 1'; cat scene; rest '' cg; echo 'run 7'; } >in.threads
for threads in 1 2 3; do
	OMP_WAIT_POLICY=passive "$TSIM" -in in.threads -log log.$threads -screen none -var threads $threads 2>err
	report "$threads threads" $? err
	rows log.$threads >rows.$threads
	same "table on $threads threads" rows.1 rows.$threads
done

# ---- refused
fluid='units si
boundary f f p
region box block 0 1 0 0.5 0 0.25 units box
create_box 1 box
timestep 1e-4
flow_style projection cells 8 6 5 viscosity 0.1 density 2'
rejects "$fluid body_force 0 -9.81 0
flow_boundary xhi outlet
run 1" 'flow_boundary xhi: the body_force of flow_style acts along this face, along y,'
rejects "variable g equal -10*step
$fluid body_force 0 v_g 0
flow_boundary xhi outlet pressure 3
run 4" 'or `hydrostatic no` if the pressure outside is uniform'
rejects "$fluid pressure_level 5
flow_boundary xhi outlet
run 1" 'pressure_level is for a fluid without open faces'
rejects "$fluid
flow_boundary xhi wall pressure 3" 'at wall faces no pressure is given'
rejects "$fluid
flow_boundary xhi inlet velocity 1 0 0 hydrostatic yes" 'at inlet faces no pressure is given'
rejects "$fluid
flow_boundary xhi inlet velocity 1 0 0 pressure 3" 'a velocity or a pressure, not both'
rejects "$fluid
flow_boundary xhi inlet" 'an inlet needs a velocity or a pressure'
rejects "$fluid
flow_boundary xhi outlet set y yy" 'together with velocity or pressure only'
rejects "$fluid
flow_boundary xhi outlet pressure v_none
run 1" "unknown variable 'none'"
rejects "variable p equal sqrt(-step)
$fluid
flow_boundary xhi outlet pressure v_p
run 3" 'sqrt is not a real number'
# what can be meant runs: normal to the face, along a periodic axis, by a formula, or said
for line in "$fluid body_force -9.81 0 0
flow_boundary xhi outlet" "$fluid body_force 0 0 -9.81
flow_boundary xhi outlet" "$fluid body_force 0 -9.81 0
flow_boundary xhi outlet hydrostatic no" "variable y internal 0
variable p equal 19.62*(0.5-v_y)
$fluid body_force 0 -9.81 0
flow_boundary xhi outlet pressure v_p set y y"; do
	prints "$line
run 2
print \"went\"" 'went'
done
# ---- fluid that is driven from each face in turn: P t/(rho L), with all schemes
cat >in.driven <<'END'
units si
boundary f f f
region box block 0 2.5 0 2.5 0 2.5 units box
create_box 1 box
flow_style projection cells 10 10 10 viscosity 0.01 density 2 convection ${scheme}
variable around index xlo xhi ylo yhi zlo zhi
label around
flow_boundary ${around} slip
next around
jump SELF around
flow_boundary ${in} inlet pressure 3
flow_boundary ${out} outlet
compute f all flow/flux ${axis} 1.25
timestep 0.02
run 50
print "is $(abs(c_f[1])/(3*time/2/2.5*2.5^2)-1)"
END
cp in.driven in.script
for axis in x y z; do
	for ends in 'lo hi' 'hi lo'; do
		read -r from to <<<"$ends"
		for scheme in donor central quick cubista; do
			small 'driven from' 1e-9 -var axis $axis -var in $axis"$from" -var out $axis"$to" -var scheme $scheme
		done
	done
done
finish
