#!/bin/bash
# Limits of the time step of fixes that hold and brake particles: of each one, of several on the same particle, and
# together with contacts.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.grains <<'END'
units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
region box block -1 1 -1 1 -1 1 units box
create_box 2 box
create_atoms 1 single 0 0 0 units box
create_atoms 2 single 0.5 0 0 units box
set type 1 diameter 0.2 density 1000
set type 2 diameter 0.3 density 1500
group light type 1
group heavy type 2
variable m equal 1000*PI*0.2^3/6
variable M equal 1500*PI*0.3^3/6
variable K equal 23.85
variable soft index 71.3
fix n all nve/sphere
pair_style spring/dashpot
pair_coeff * * stiffness $(v_soft) damping 0
timestep 1e-4
END

# limit WHAT TEXT VALUE LINES...: of in.grains and these lines -explain lists a limit with the text, of this value (a formula)
limit() {
	local what=$1 text=$2 value=$3
	shift 3
	printf '%s\n' 'include in.grains' "$@" "print \"WANTED \$($value:%.6g)\"" 'run 0' >in.limit
	"$TSIM" -explain -in in.limit -log none >out 2>&1
	awk -v text="$text" '/^WANTED/ { wanted = $2 } index($0, text) && !n++ { sub(/^ *->/, ""); found = $1 }
		END { d = found - wanted; if (d < 0) d = -d; ok = wanted > 0 && d <= 2e-5 * wanted; print "found", found, "wanted", wanted; exit !ok }' out >found
	report "$what" $? found
}
limit 'spring/self, of the lightest' 'fix spring/self a, on particle 1 of' '2*sqrt(v_m/v_K)' 'fix a all spring/self ${K}'
limit 'tether: of the whole group' 'fix spring, 2 sqrt(m/K)' '2*sqrt((v_m+v_M)/v_K)' 'fix a all spring tether ${K} 0 0 0 0'
limit 'couple: the reduced mass' 'fix spring, 2 sqrt(m/K)' '2*sqrt(v_m*v_M/(v_m+v_M)/v_K)' \
	'fix a light spring couple heavy ${K} 0 0 0 0'
limit 'viscous' 'fix viscous a, on particle 1 of' '2*v_m/7.13' 'fix a all viscous 7.13'
limit 'viscous, of the type that is braked most' 'fix viscous a, on particle 2 of' '2*v_M/(7.13*9)' 'fix a all viscous 7.13 scale 2 9'
limit 'viscous/sphere' 'fix viscous/sphere a, on particle 1 of' '2*0.4*v_m*0.1^2/7.13' 'fix a all viscous/sphere 7.13'
limit 'langevin' 'fix langevin a, on particle 1 of' '2*0.37' 'fix a all langevin 300 300 0.37 86028157'
limit 'langevin, of the type with the shortest time' 'fix langevin a, on particle 2 of' '2*0.37*0.5' \
	'fix a all langevin 300 300 0.37 86028157 scale 2 0.5'

limit 'two springs' 'fix spring/self a, fix spring/self b together, on particle 1' '2*sqrt(v_m/(4*v_K))' \
	'fix a all spring/self ${K}' 'fix b all spring/self $(3*v_K)'
limit 'two springs of one particle only' 'fix spring/self b together, on particle 2' '2*sqrt(v_M/(6*v_K))' \
	'fix a all spring/self ${K}' 'fix b heavy spring/self $(5*v_K)'
limit 'springs across each other' 'fix spring/self b together' '2*sqrt(v_m/(3*v_K))' \
	'fix a all spring/self ${K} x' 'fix b all spring/self $(3*v_K) yz'
limit 'a spring and a dashpot' 'fix viscous b together' '2/(sqrt(v_K/v_m+(7.13/2/v_m)^2)+7.13/2/v_m)' \
	'fix a all spring/self ${K}' 'fix b all viscous 7.13'
limit 'two dashpots' 'fix langevin b together' '2/(7.13/v_m+1/0.37)' 'fix a all viscous 7.13' \
	'fix b all langevin 300 300 0.37 86028157'
limit 'two dashpots of the rotation' 'fix viscous/sphere b together' '2/(3*7.13/(0.4*v_m*0.1^2))' \
	'fix a all viscous/sphere 7.13' 'fix b all viscous/sphere $(2*7.13)'
limit 'a tether of the particle alone' 'fix spring a, fix spring/self b together' '2*sqrt(v_m/(3*v_K))' \
	'fix a light spring tether ${K} 0 0 0 0' 'fix b light spring/self $(2*v_K)'

fluid='flow_style uniform velocity 0 0 0 viscosity 3.3 density 1000'
c='(3*PI*3.3*0.2)'
limit 'a spring and explicit drag' 'fix drag/stokes d together, on particle 1' "2/(sqrt(v_K/v_m+($c/2/v_m)^2)+$c/2/v_m)" \
	"$fluid" 'fix a all spring/self ${K}' 'fix d all drag/stokes'
limit 'explicit drag across a spring' 'fix drag/stokes d together, on particle 1' "2*v_m/$c" \
	"$fluid" 'fix a all spring/self 1 xz' 'fix d all drag/stokes axes y'
limit 'two explicit drags' 'fix drag/stokes e together, on particle 1' "v_m/$c" "$fluid" 'fix d all drag/stokes' 'fix e all drag/stokes'
limit 'explicit drag alone' 'explicit fix drag/stokes, 2 tau' "2*v_m/$c" "$fluid" 'fix d all drag/stokes'
limit 'drag that relaxes has no limit' 'fix spring/self a, on particle 1 of' '2*sqrt(v_m/v_K)' "$fluid" 'fix a all spring/self ${K}' \
	'fix d all drag/stokes scheme exact'
limit 'with added mass' 'fix spring/self a, on particle 1 of' '2*sqrt(1.5*v_m/v_K)' "$fluid" 'fix a all spring/self ${K}' \
	'fix e all added_mass'
limit 'the torque of lift/magnus' 'fix lift/magnus l, on particle 1' '1000*0.2^2/(30*3.3)' "$fluid" 'fix l all lift/magnus'
limit 'the torque and a dashpot' 'fix lift/magnus l together, on particle 1' '2/(30*2*3.3/(1000*0.2^2)+7.13/(0.4*v_m*0.1^2))' "$fluid" \
	'fix a all viscous/sphere 7.13' 'fix l all lift/magnus'
limit 'lift without torque' 'fix viscous/sphere a, on particle 1' '2*0.4*v_m*0.1^2/7.13' "$fluid" 'fix a all viscous/sphere 7.13' \
	'fix l all lift/magnus torque no'
limit 'drag of another program' 'fix couple/cfd/force/implicit d together, on particle 1' \
	'2/(sqrt(v_K/v_m+(7.13/2/v_m)^2)+7.13/2/v_m)' 'fix k all property/atom Ksl scalar yes no no 7.13' 'fix a all spring/self ${K}' \
	'fix c all couple/cfd couple_every 1 mpi' 'fix d all couple/cfd/force/implicit'
limit 'a contact of held particles' 'contacts together with fix spring/self' '2*sqrt(v_m/(2*71.3+v_K))' \
	'set atom 2 type 1' 'set type 1 diameter 0.2 density 1000' 'set atom 2 x 0.199' 'fix a all spring/self ${K}'
limit 'a contact across the springs' 'contacts together with fix spring/self' '2*sqrt(v_m/(2*71.3))' \
	'set atom 2 type 1' 'set type 1 diameter 0.2 density 1000' 'set atom 2 x 0.199' 'fix a all spring/self ${K} y'

# Those of the same particle end a run; of a group that is more than the particle they are advice.
for h in 0.99 1.01; do
	printf '%s\n' 'include in.grains' 'velocity light set 1e-6 0 0' 'fix a all spring/self ${K}' 'fix b all viscous 7.13' \
		"timestep \$($h*2/(sqrt(v_K/v_m+(7.13/2/v_m)^2)+7.13/2/v_m))" 'run 500' 'print "bounded $(abs(x[1])<1e-6)"' >in.$h
done
"$TSIM" -in in.0.99 -log none -var soft 1e-3 >out 2>&1 && grep -q '^bounded 1$' out
report 'stable below the limit' $? out
refused 'above the limit' 'of fix spring/self a, fix viscous b together, on particle 1 of type 1' -in in.1.01 -var soft 1e-3
refused 'above the limit, -check' 'of fix spring/self a, fix viscous b together' -check -in in.1.01 -var soft 1e-3
printf '%s\n' 'include in.grains' 'fix a all spring tether ${K} $(xcm(all,x)) 0 0 0' 'fix b all spring/self ${K}' \
	'timestep $(2*sqrt(v_m/(1.1*v_K)))' 'run 3' >in.advice
"$TSIM" -in in.advice -log none -var soft 1e-3 >out 2>&1 &&
	grep -q 'warning: the time step .* exceeds the recommended limit .* of fix spring a, fix spring/self b together' out
report 'advice' $? out
# with added damping of the rotation: the spin decays at 0.99 of the limit, a step beyond it is refused
for h in 0.99 1.01; do
	printf '%s\n' 'include in.grains' "$fluid" 'set type 1 omega 10 0 0' 'fix l all lift/magnus' "timestep \$($h*1000*0.2^2/(30*3.3))" \
		'run 500' 'print "decayed $(abs(omegax[1])<1)"' >in.$h
done
"$TSIM" -in in.0.99 -log none -var soft 1e-9 >out 2>&1 && grep -q '^decayed 1$' out
report 'spin below the limit' $? out
refused 'spin above the limit' 'the stability limit 0.40404 of fix lift/magnus l, on particle 1 of type 1' -in in.1.01 -var soft 1e-9
# frozen particles do not move
printf '%s\n' 'include in.grains' 'fix a light spring/self ${K}' 'fix b light viscous 7.13' 'fix hold light freeze' 'run 3' >in.frozen
"$TSIM" -explain -in in.frozen -log none >out 2>&1 && ! grep -q 'fix spring/self a' out && grep -q 'time step' out
report 'not of frozen particles' $? out
sed 's,nve/sphere,nve/noforce,' in.grains >in.straight
printf '%s\n' 'include in.straight' 'fix a light spring/self ${K}' 'fix b light viscous 7.13' 'run 3' >in.noforce
"$TSIM" -explain -in in.noforce -log none >out 2>&1 && ! grep -q 'fix spring/self a' out && grep -q 'time step' out
report 'not of particles that obey no force' $? out
finish
