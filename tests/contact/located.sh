#!/bin/bash
# Contacts that are located within the step: in a bed errors fall, and threads and restart files change nothing.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.bed <<END
include $top_srcdir/tests/decks/in.located
dump d all custom 1 \${out}.dump id x y z vx vy vz omegax
dump_modify d sort id format "%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
run 0 post no
END
bed() { # NAME LAW LOCATED STEPS: until 0.004 s
	"$TSIM" -in in.bed -log none -screen none -var out "$1" -var law "$2" -var located "$3" \
		-var steps "$4" -var h "$(awk "BEGIN { printf \"%.17g\", 0.004 / $4 }")" 2>err
	report "$1" $? err
}
# error NAME: of the velocities beside those of `fine`, relative, root of mean squares
error() {
	paste -d' ' <(sed -n '/ITEM: ATOMS/,$p' "$1.dump" | tail -n +2) \
		<(sed -n '/ITEM: ATOMS/,$p' fine.dump | tail -n +2) | awk '{
		for (k = 5; k <= 7; k++) { s += ($k - $(k + 8))^2; r += $(k + 8)^2 } }
		END { printf "%.3g", sqrt(s / r) }'
}
# gains LAW STEPS FACTOR: located, errors are smaller by that factor at least
gains() {
	local plain located

	bed fine "$1" yes 6400
	bed plain "$1" no "$2"
	bed located "$1" yes "$2"
	plain=$(error plain)
	located=$(error located)
	echo "$1, $2 steps: $plain, located $located"
	awk "BEGIN { exit !($plain > 1e-3 && $plain > $3 * $located) }"
	report "$1: $plain, located $located: less gain than $3" $?
}
gains 'hooke' 200 12
gains 'hertz' 200 8
gains 'hooke tangential no_history' 200 10
gains 'hertz tangential history tangential_damping off' 200 3
# the law of friction with a dashpot jumps where slip begins: not worse
gains 'hertz tangential history' 200 0.9

# threads
cat >in.threads <<END
package omp \${threads} grain 1
variable law index "hertz tangential history rolling_friction cdt"
include $top_srcdir/tests/decks/in.located
write_restart \${out}.restart
END
export OMP_WAIT_POLICY=passive
for t in 1 2 4; do
	"$TSIM" -in in.threads -log none -screen none -var threads $t -var out t$t 2>err
	report "$t threads" $? err
done
same '2 threads' t1.restart t2.restart
same '4 threads' t1.restart t4.restart

# cut by a restart file; contacts begin and end all the time
"$TSIM" -in in.threads -log none -screen none -var threads 1 -var steps 37 -var out half 2>err
report 'first part' $? err
"$TSIM" -in in.threads -log none -screen none -var threads 1 -var steps 63 -var from half.restart \
	-var out whole 2>err
report 'second part' $? err
same 'run 100 = run 37, restart, run 63' t1.restart whole.restart
sed 's/^run.*/run 37\nrun 63/' "$top_srcdir/tests/decks/in.located" >in.cut
sed "s|include.*|include in.cut|" in.threads >in.cut_threads
"$TSIM" -in in.cut_threads -log none -screen none -var threads 1 -var out cut 2>err
report 'two runs' $? err
same 'run 100 = run 37, run 63' t1.restart cut.restart

# what is poured comes to rest, also where it is damped strongly
cat >in.settle <<'END'
units si
atom_style sphere
boundary p p f
newton off
communicate single vel yes
region box block 0 0.036 0 0.036 -0.001 0.2 units box
create_box 1 box
neighbor 0.002 bin
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.25
fix m3 all property/global coefficientRestitution peratomtypepair 1 ${e}
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
fix m5 all property/global characteristicVelocity scalar 0.3
pair_style gran model hooke tangential history located yes
pair_coeff * *
lattice sc 0.012
region fill block 0 0.0359 0 0.0359 0.006 0.08 units box
create_atoms 1 region fill
set group all diameter 0.01 density 2500
displace_atoms all random 0.0009 0.0009 0.0009 77723 units box
fix g all gravity 9.81 vector 0 0 -1
fix w all wall/gran model hooke tangential history located yes primitive type 1 zplane 0.0
fix mv all nve/sphere
variable mass equal 2500*PI/6*0.01^3
variable s equal sqrt(0.0025)*5e6/(1-0.25^2)/2
variable k equal 16/15*v_s*(15/16*v_mass/2*0.09/v_s)^0.2
variable b equal -ln(v_e)/sqrt(PI^2+ln(v_e)^2)
variable time equal PI/sqrt(v_k/(v_mass/2)*(1-v_b^2))
timestep $(v_time/v_n)
run $(floor(v_n/v_time)) post no
print "at rest $(ke<1e-6)"
END
for setting in '0.5 20' '0.06 50'; do
	set -- $setting
	"$TSIM" -in in.settle -log none -var e "$1" -var n "$2" >settled 2>&1
	grep -q '^at rest 1$' settled
	report "e = $1 with $2 steps per contact comes to rest" $? settled
done

# walls of triangles: a sphere that slips over the edge between two of them while it is in contact
cat >plate.stl <<'END'
solid p
facet normal 0 0 1
outer loop
vertex -2 -2 0
vertex 2 -2 0
vertex 2 2 0
endloop
endfacet
facet normal 0 0 1
outer loop
vertex -2 -2 0
vertex 2 2 0
vertex -2 2 0
endloop
endfacet
endsolid p
END
cat >in.mesh <<'END'
units si
atom_style sphere
newton off
boundary f f f
region box block -3 3 -3 3 -1 1 units box
create_box 1 box
neighbor 0.003 bin
fix a all property/global youngsModulus peratomtype 5e6
fix b all property/global poissonsRatio peratomtype 0.31
fix c all property/global coefficientRestitution peratomtypepair 1 0.4
fix e all property/global characteristicVelocity scalar 0.385
pair_style gran model hooke
pair_coeff * *
variable s equal sqrt(0.0123)*5e6/(1-0.31^2)
variable k equal 16/15*v_s*(15/16*0.0231*0.385^2/v_s)^0.2
variable b equal -ln(0.4)/sqrt(PI^2+ln(0.4)^2)
timestep $(PI/sqrt(v_k/0.0231*(1-v_b^2))/50.385)
fix m all mesh/surface file plate.stl type 1
fix w all wall/gran model hooke located ${located} mesh n_meshes 1 meshes m
create_atoms 1 single 0.097 0.1 0.0124 units box
create_atoms 1 single 0.3 0.1 0.0124 units box
set group all diameter 0.0246 mass 0.0231
velocity all set 1.7 0 -0.7 units box
fix mv all nve/sphere
run 100 post no
print "over the edge $(vx[1]/1.7*(x[1]>0.1)) e $(abs(vz[1]/0.28-1)<1e-7) $(abs(vz[2]/0.28-1)<1e-7)"
END
for located in yes no; do
	"$TSIM" -in in.mesh -log none -var located $located >"mesh.$located" 2>&1
done
grep -q '^over the edge 1 e 1 1$' mesh.yes
report 'a wall of triangles' $? mesh.yes
grep -q '^over the edge 1 e 0 0$' mesh.no
report 'a wall of triangles, not located' $? mesh.no

# refusals
law='units si
newton off
atom_style sphere
boundary f f f
region b block -1 1 -1 1 -1 1 units box
create_box 1 b
create_atoms 1 single 0 0 0
set group all diameter 0.0123 density 2385
timestep 1e-6
'
rejects "${law}pair_style spring/dashpot located yes
pair_coeff * * stiffness 1000 restitution 0.5
fix m all nve/euler
run 1" 'fix nve/euler moves particles by the velocities before the step'
rejects "${law}legacy yes
pair_style spring/dashpot located yes
pair_coeff * * stiffness 1000 restitution 0.5
fix m all nve
run 1" 'located yes: `legacy yes` reproduces'
rejects "${law}fix 1 all property/global youngsModulus peratomtype 5e6
fix 2 all property/global poissonsRatio peratomtype 0.3
fix 3 all property/global characteristicVelocity scalar 1
fix 4 all property/global coefficientRestitution peratomtypepair 1 0.5
fix 5 all property/global coefficientMaxElasticStiffness peratomtypepair 1 2
fix 6 all property/global coefficientAdhesionStiffness peratomtypepair 1 0
fix 7 all property/global coefficientPlasticityDepth peratomtypepair 1 0.1
fix m all nve
pair_style gran model hooke/hysteresis located yes
pair_coeff * *
run 1" 'located yes: the normal law must be'
rejects "${law}pair_style spring/dashpot
pair_coeff * * stiffness 1000 restitution 0.5
fix w all wall/gran located yes primitive type 1 zplane -0.5
run 1" "'located' belongs to a normal model"
finish
