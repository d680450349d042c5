#!/bin/bash
# pair_style granular: rebounds, adhesion, energies, mixtures, and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

pair() { # LAWS...: two equal spheres that are about to touch
	printf '%s\n' "units si
boundary f f f
region box block -1 1 -1 1 -1 1 units box
create_box 2 box
create_atoms 1 single 0 0 0 units box
create_atoms 2 single 0.20001 0 0 units box
set type * diameter 0.2 density 2385
set atom 2 vx -1
fix move all nve/sphere
timestep 2e-6
pair_style granular"
	printf 'pair_coeff %s\n' "$@"
}
smooth='tangential linear_nohistory 0 0'

# a dashpot alpha sqrt(m k_a) rebounds with exp(-pi/sqrt(5/alpha^2 - 1)) (T. Antypov, J. A. Elliott, EPL 94 (2011) 50004)
agree 'restitution by tsuji' "$(pair "* * hertz/material 1e8 0.61 0.3 $smooth damping tsuji")
run 6000
variable a equal 1.2728-4.2783*0.61+11.087*0.61^2-22.348*0.61^3+27.467*0.61^4-18.022*0.61^5+4.8218*0.61^6
variable e equal exp(-PI/sqrt(5/v_a^2-1))
print \"is e \$(abs((vx[2]-vx[1])/v_e-1)<1e-3) 1\""

for law in 'hooke 1e6 0.61' 'hertz 1e8 0.61' 'hertz/material 1e8 0.61 0.3'; do
	agree "restitution: $law" "$(pair "* * $law $smooth damping coeff_restitution heat none")
run 12000
print \"is e \$(abs((vx[2]-vx[1])/0.61-1)<2e-3) 1\""
done

# F = -k delta - d m v, a damped oscillator: e = exp(-pi d/2/sqrt(k/m - d^2/4))
agree 'restitution of a spring with a dashpot' "$(pair "* * hooke 1e6 100 $smooth damping mass_velocity")
variable m equal mass(all)/4
variable e equal exp(-PI*50/sqrt(1e6/v_m-2500))
run 12000
print \"is e \$(abs((vx[2]-vx[1])/v_e-1)<2e-3) 1\""

# without losses no energy is lost, whatever pulls
for law in 'hooke 1e6 0' 'hertz 1e8 0' 'hertz/material 1e8 0 0.3' 'dmt 1e8 0 0.3 20' 'jkr 1e8 0 0.3 20'; do
	agree "energy: $law" "$(pair "* * $law $smooth")
thermo_style custom step pe
run 20
variable was equal \$(ke+pe)
run 1400
print \"is stored \$(pe>0.3*ke) 1\"
print \"is energy \$(abs((ke+pe)/v_was-1)<2e-6) 1\""
done

# surfaces that have met part at 3 pi w R with delta = -0.5724 (pi w/E)^(2/3) R^(1/3)..., not before
agree 'adhesion' "$(pair "* * jkr 1e7 0 0.3 20 $smooth")
velocity all set 0 0 0
unfix move
group one id 1
group two id 2
fix hold one move linear 0 0 0
displace_atoms two move -0.0002 0 0 units box
fix pull two move linear 0.05 0 0
variable q equal PI*20/(1e7/2/(1-0.09))
variable reach equal (2*2.25^(1/6)-2.25^(2/3))*v_q^(2/3)*0.05^(1/3)
variable f equal fx[1]
variable at equal x[2]-0.2
run 0
run \$(floor((v_reach-v_at)/0.05/2e-6)-1)
print \"is pull \$(abs(v_f/(3*PI*20*0.05)-1)<1e-5) 1\"
run 4
print \"is nothing \${f} 0\""

# what is not given is mixed: geometric means, elasticities as springs in series
prints "$(pair "1 1 hooke 1e6 100 tangential linear_history 3e5 0.5 0.3" "2 2 hooke 4e6 900 tangential linear_history 27e5 0.125 0.12")
set atom 1 vy 0.5
run 300
print \"f \$(fx[1]:%.12g) \$(fy[1]:%.9g)\"
clear
$(pair "* * hooke 2e6 300 tangential linear_history 9e5 0.25 $(awk 'BEGIN { printf "%.17g", sqrt(0.036) }')")
set atom 1 vy 0.5
run 300
print \"f \$(fx[1]:%.12g) \$(fy[1]:%.9g)\"" >/dev/null
[ "$(grep '^f ' out | uniq | wc -l)" = 1 ] && [ "$(grep -c '^f -' out)" = 2 ]
report 'mixed and given' $? out
agree 'materials in series' "$(pair "1 1 hertz/material 1e7 0 0.3 $smooth" "2 2 hertz/material 3e7 0 0.2 $smooth")
run 300
variable d equal 0.2-x[2]+x[1]
variable y equal 1/((1-0.09)/1e7+(1-0.04)/3e7)
print \"is f \$(fx[2]) \$(4/3*v_y*sqrt(0.05*v_d)*v_d)\""

# LAMMPS' hybrid in front of one style
agree 'hybrid' "$(pair '* * hooke 1e6 0.61 tangential linear_nohistory 0 0 damping coeff_restitution' |
	sed 's/^pair_style granular/pair_style hybrid granular/; s/^pair_coeff \* \*/& granular/')
run 12000
print \"is e \$(abs((vx[2]-vx[1])/0.61-1)<2e-3) 1\""
rejects 'pair_style hybrid granular gran model hertz' 'all pairs have the same contact law'
rejects 'pair_style hybrid/overlay granular lj/cut 1' 'lj/cut'
rejects 'pair_style hybrid' 'expected a pair style behind it'
rejects "$(pair '* * hooke 1e5 1')
run 1" "keyword 'tangential' is missing"
rejects "$(pair '* * hooke 1e5 1 tangential mindlin NULL 1 0.5')
run 1" 'NULL needs a normal law with material constants'
rejects "$(pair '* * hook 1e5 1 tangential linear_nohistory 1 0.5')" "did you mean 'hooke'?"
rejects "$(pair '* * hooke 1e5 1 tangential linear 1 0.5')" "tangential is 'linear'"
rejects "$(pair '* * hooke 1e5 1 tangential linear_history 1 0.5')" 'mu is missing'
rejects "$(pair "* * jkr 1e5 1 0.3 1 $smooth limit_damping")" 'does not go with jkr, which attracts'
rejects "$(pair "* * dmt 1e5 1 0.3 1 $smooth damping coeff_restitution")" 'does not go with dmt, which attracts'
rejects "$(pair "* * hooke 1e5 1.2 $smooth damping coeff_restitution")" 'is a coefficient of restitution, 1.2, expected a number > 0'
rejects "$(pair "* * hooke 1e5 1.2 $smooth damping tsuji")" 'is a coefficient of restitution, 1.2, expected a number >= 0'
rejects "$(pair "* * hooke 1e5 1 $smooth heat area 1")" 'heat area is not supported'
rejects "$(pair "* * hooke 1e5 1 $smooth twisting marshall")" 'linear_nohistory has none'
rejects "$(pair "1 1 hooke 1e5 1 $smooth" "2 2 hertz 1e5 1 $smooth")
run 1" 'types 1 and 2 have different laws, which cannot be mixed'
rejects "$(pair "1 1 hooke 1e5 1 $smooth")
run 1" 'there is no `pair_coeff 1 2 ...`'
rejects "$(pair "* * hooke 1e9 1 $smooth")
timestep 1e-3
run 1" 'exceeds the stability limit'
rejects "$(pair "* * hooke 1e5 1 $smooth")
fix w all wall/gran granular hooke 1e5 1 tangential linear_history 1 0.5 zplane 0.0 NULL" 'mu is missing'
rejects "$(pair "* * hooke 1e5 1 $smooth")
fix w all wall/gran granular hooke 1e5 1 $smooth hooke 1 NULL 1 NULL 1 1 zplane 0.0 NULL" 'zplane'
finish
