#!/bin/bash
# Bonds of LAMMPS' package BPM: what scripts say, refused input, the list of broken bonds, the energy ledger.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.two <<'END2'
units lj
atom_style bpm/sphere
boundary f f f
newton on off
region box block -2 2 -2 2 -2 2 units box
create_box 1 box bond/types 1 extra/bond/per/atom 4
create_atoms 1 single 0 0 0 units box
create_atoms 1 single 1.1 0 0 units box
create_bonds single/bond 1 1 2
fix 1 all nve/bpm/sphere
timestep 1e-3
END2
bad() { # WHAT TEXT LINES
	printf 'include in.two\n%s\nrun 0\n' "$3" >in.bad
	refused "$1" "$2" -in in.bad
	refused "$1, -check" "$2" -check -in in.bad
}
hooke='pair_style gran/hooke/history 1.0 NULL 0.5 NULL 0.1 1
pair_coeff 1 1'
spring='bond_style bpm/spring'
bad 'no special_bonds' 'needs `special_bonds lj 0 1 1 coul 1 1 1`' "$hooke
$spring
bond_coeff 1 1 0.1 0"
bad 'special_bonds with overlay' 'overlay/pair yes contradicts special_bonds' "$hooke
special_bonds lj 0 1 1 coul 1 1 1
$spring overlay/pair yes
bond_coeff 1 1 0.1 0"
bad 'break no with smooth' '`break no` needs `smooth no`' "$spring break no
bond_coeff 1 1 0.1 0"
bad 'break/no with smooth' '`break no` needs `smooth no`' 'bond_style bpm/rotational break/no
bond_coeff 1 1 1 1 1 1 1 1 1 1 1 1 1'
bad 'volume factor' 'volume/factor yes is not supported' "$spring volume/factor yes
bond_coeff 1 1 0.1 0"
bad 'too few numbers' 'gamma' "$spring
bond_coeff 1 1 0.1"
bad 'eleven numbers' 'gamma_t' 'bond_style bpm/rotational
bond_coeff 1 1 1 1 1 1 1 1 1 1 1 1'
bad 'no strain' 'epsilon_c is 0, expected' "$spring
bond_coeff 1 1 0 1"
bad 'store/local without a quantity' 'expected store/local FIX N QUANTITIES' "$spring store/local broken 100
bond_coeff 1 1 0.1 1"
bad 'store/local: x/ref' "'x/ref'" "$spring store/local broken 100 time x/ref
bond_coeff 1 1 0.1 1"
bad 'anharmonic' 'anharmonic yes is not supported' 'pair_style bpm/spring anharmonic yes
pair_coeff 1 1 1 1 1'
bad 'a cutoff that is not the contact' 'the cutoff of types 1 and 1 is 1.5, but their radii add up to 1' 'special_bonds lj 0 1 1
pair_style bpm/spring
pair_coeff 1 1 1 1.5 1'
bad 'no coefficients' 'no `bond_coeff 1' "$spring"

contact='bond_style contact
bond_coeff 1 stiffness 1 ultimate 1'
bad 'create: bond type' 'there is no bond type 2' "$contact
fix join all bond/create 1 1 1 0.8 2"
bad 'create: particle type' 'particle type 3, but there are only 1' "$contact
fix join all bond/create 1 1 3 0.8 1"
bad 'create: iparam' 'iparam and jparam must be the same' "$contact
fix join all bond/create 1 1 1 0.8 1 iparam 2 1"
bad 'create: newtype' 'expected iparam MAXBOND NEWTYPE' "$contact
fix join all bond/create 1 1 1 0.8 1 iparam 2 7 jparam 2 7"
bad 'create: prob' 'expected prob FRACTION SEED' "$contact
fix join all bond/create 1 1 1 0.8 1 prob 1.5 85784"
bad 'break: prob' 'expected prob FRACTION SEED' "$contact
fix cut all bond/break 1 1 0.8 prob 0.5"
bad 'break: bond type' 'bond type 3, but there are 1' "$contact
fix cut all bond/break 1 3 0.8"

# each broken bond once in a dump every N steps, at the step at which it broke; of bonds that break at steps 1, 3, 11
cat >in.list <<'END2'
include in.two
create_atoms 1 single 0 0.6 0 units box
create_atoms 1 single 0 -0.6 0 units box
create_atoms 1 single 0 0 1 units box
create_bonds single/bond 1 1 3
create_bonds single/bond 1 1 4
create_bonds single/bond 1 1 5
bond_style bpm/spring store/local broken 10 time id1 id2
bond_coeff 1 1e-9 0.1 0
dump d all local 10 broken.txt f_broken[1] f_broken[2] f_broken[3]
set atom 2 vx 130
set atom 3 vy 20.5
set atom 4 vy -5.5
run 30 unsafe yes
END2
"$TSIM" -in in.list -log none >out 2>&1
awk '/ENTRIES f/ { on = 1; next } /^ITEM/ { on = 0 } on' broken.txt >found
printf '%s\n' '1 1 2 ' '3 1 3 ' '11 1 4 ' >expected
same 'broken bonds' expected found

# the ledger of energy closes with smoothing, dashpots and breakage; no drift of the central spring without dashpots
for deck in bpm bpm_spring; do
	sed 's/tolerance 1/tolerance 0.002/; s/summary no//; /^pair_/d; /bond\/create/d; /bond\/break/d; s/f_join.*f_cut.2.//' "$top_srcdir/tests/decks/in.$deck" >in.ledger
	"$TSIM" -in in.ledger -var out ledger -log none >out 2>&1 &&
		awk '/closure/ { for (k = 1; k < NF; k++) if ($k == "of") x = $(k - 1); n = x < 1e-12 && x > -1e-12 }
			/tolerance|the energy drift/ { bad = 1 } END { exit !n || bad }' out
	report "ledger of $deck" $? out
	awk '/^ +200 / && $5 > 10 { n++ } END { exit !n }' out
	report "bonds of $deck break" $? out
done
# a bond with moments, without dashpots, is pulled until it breaks: with smoothing it takes (1 - 1/3) k r_c^2/2, all of it when it breaks
cat >in.pulled <<'END2'
units lj
atom_style bpm/sphere
special_bonds lj 0 1 1 coul 1 1 1
newton off
boundary s s s
region box block -3 3 -3 3 -3 3 units box
create_box 1 box bond/types 1 extra/bond/per/atom 2
create_atoms 1 single -0.5 0 0 units box
create_atoms 1 single 0.5 0 0 units box
set group all diameter 0.9 density 1
set atom 1 vx -0.25
set atom 2 vx 0.25
timestep 0.0005
pair_style bpm/spring
pair_coeff * * 1 0.9 0
bond_style bpm/rotational
bond_coeff 1 1.0 0.2 0.02 0.02 0.1 0.1 0.01 0.01 0 0 0 0
create_bonds single/bond 1 1 2
fix i all nve/bpm/sphere
fix led all energy/ledger
thermo_modify norm no
thermo_style custom step ke ebond bonds f_led[16] f_led[17]
thermo 100
run 800
END2
"$TSIM" -in in.pulled -log none >out 2>&1
rows out | awk '$4 == 1 && !($2 + $3 - was < 1e-8 && was - $2 - $3 < 1e-8) && NR > 1 { bad = 1 } NR == 1 { was = $2 + $3 }
	!($5 < 1e-12 && $5 > -1e-12) { bad = 1 } { broken = $6 } END { exit bad || !(broken > 0.003332 && broken < 0.003334) }'
report 'pulled apart' $? out

# w = 1 - B^4 multiplies all loads: those that compute bond/local shows, and that of the bond that breaks
cat >in.rotational <<'END2'
units si
atom_style sphere
newton off
boundary f f f
region box block -1 1 -1 1 -1 1
create_box 1 box
create_atoms 1 single 0 0 0
create_atoms 1 single 0.002 0 0
set group all diameter 0.002 density 2500
special_bonds lj 0 1 1 coul 1 1 1
bond_style bpm/rotational
bond_coeff 1 1000 500 1e-3 1e-3 0.5 0.5 5e-6 5e-6 0 0 0 0
create_bonds many all all 1 0 0.0021
group a id 1
group b id 2
fix a a freeze
timestep 1e-6
END2
agree 'columns of a twisted bond' 'include in.rotational
fix m b move rotate 0.002 0 0 1 0 0 0.1
compute b all bond/local twist tx ratio
compute r all reduce sum c_b[1] c_b[2] c_b[3]
run 60 unsafe yes
variable t equal 1e-3*2*PI*6e-4
variable B equal v_t/5e-6
print "is B $(c_r[3]) $(v_B) 10"
print "is twist $(c_r[1]) $(v_t*(1-v_B^4)) 1e-5"
print "is tx $(c_r[2]) $(v_t*(1-v_B^4)) 1e-5"'
agree 'column of a sheared bond' 'include in.rotational
bond_coeff 1 1000 500 1e-3 1e-3 1e9 5e-3 5e-6 5e-6 0 0 0 0
displace_atoms b move 0 6e-6 0
compute b all bond/local shear ratio
compute r all reduce sum c_b[1] c_b[2]
thermo_style custom step c_r[*]
run 0
variable s equal 500*0.002*6e-6/sqrt(0.002^2+6e-6^2)
variable B equal v_s/5e-3
print "is shear $(c_r[1]) $(v_s*(1-v_B^4))"'
prints 'include in.rotational
fix m b move linear 0.1 0 0
fix crack all bond/breakage
compute f all reduce sum f_crack[9]
thermo_style custom step bonds c_f
run 6000 unsafe yes
print "$(bonds) bonds, $(abs(c_f)<0.5*5e-3)"' '0 bonds, 1'

# Stretched, then sheared, back and back: the forces do work on a closed way, which the ledger books with the dashpots
cat >in.loop <<'END2'
include in.rotational
bond_coeff 1 1000 500 1e-3 1e-3 0.5 0.5 5e-4 5e-4 0 0 0 0
fix e all energy/ledger
thermo_style custom step f_e[16] f_e[20] f_e[21] f_e
thermo 1000
fix m b move linear 0.2 0 0
run 1000 post no
unfix m
fix m b move linear 0 0.4 0
run 1000 post no
unfix m
fix m b move linear -0.2 0 0
run 1000 post no
unfix m
fix m b move linear 0 -0.4 0
run 1000 post no
END2
"$TSIM" -in in.loop -log none >out 2>&1
rows out | tail -n 1 | awk '{ ok = $5 < 1e-3 && $5 > -1e-3 } END { exit !ok }' && ! grep -q 'the energy drift' out
report 'ledger of a closed way' $? out
finish
