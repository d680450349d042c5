#!/bin/bash
# Particles may have any identities up to 2147483646: tables grow with the number of particles, not with the
# largest identity, and everything that asks for particles by identity finds them. Outputs of computes are
# evaluated once for all that is read of them at a time.
. "$top_srcdir/tests/lib_cases.sh"

cat >in.data <<'END'
three particles

3 atoms
2 atom types
2 bonds
1 bond types
0 1 xlo xhi
0 1 ylo yhi
0 1 zlo zhi

Atoms # hybrid

2147483645 1 0.5 0.5 0.5 0.1 2385 1
1000 2 0.4 0.5 0.5 0.1 2385 1
7 1 0.6 0.5 0.5 0.1 2385 1

Velocities

1000 0.2385 0 0 0 0 0
7 -0.1 0 0 0 0 0
2147483645 0 0.3 0 0 0 0

Bonds

1 1 7 2147483645
2 1 1000 2147483645
END
cat >in.begin <<'END'
units si
atom_style hybrid sphere bond
boundary f f f
read_data in.data
pair_style spring/dashpot
pair_coeff * * stiffness 2385 restitution 0.5
bond_style contact
bond_coeff 1 stiffness 2385 ultimate 1e9
special_bonds lj/coul 1 1 1
fix move all nve
timestep 1e-5
END
# memory is bounded, except under a sanitizer
nm "$TSIM" 2>/dev/null | grep -q __asan_init || ulimit -v 2000000

prints "$(cat in.begin)
compute nb all nbond/atom
compute sum all reduce sum c_nb
run 200
write_data out.data nocoeff
print \"bonds \$(c_sum) vy \$(vy[2147483645]:%.3f) last \$(x[1000]<0.5)\"" 'bonds 4 vy 0.300 last 1'
sed -n '/^Atoms/,/^Velocities/p' out.data | awk 'NF > 5 { print $1 }' | tr '\n' ' ' >ids
grep -q '^7 1000 2147483645 $' ids
report 'write_data goes by identity' $? ids
prints "$(sed 's/in.data/out.data/' in.begin)
delete_atoms overlap 0.15 all all
print \"left \$(count(all)) \$(x[7]>0)\"" 'left 2 1'
prints "$(cat in.begin)
replicate 1 1 1
delete_bonds all bond 1 remove
create_bonds single/bond 1 1000 2147483645
print \"bonds \$(numbonds)\"" 'bonds 1'
rejects "$(cat in.begin)
replicate 2 1 1" 'replicate'
rejects "$(cat in.begin)
create_atoms 1 random 5 7 NULL" 'too many particles'

# a compute draws its random numbers once for both columns that are read
cat >in.once <<'END'
units si
region b block 0 1 0 1 0 1 units box
create_box 1 b
create_atoms 1 random 10 86028157 b
set type 1 diameter 0.01
variable a atom random(0,1,5)
compute c all reduce sum v_a v_a
variable same equal c_c[1]-c_c[1]
variable d equal c_c[1]-c_c[2]
timestep 1e-9
fix move all nve
fix p all print 1 "now $(v_same) $(v_d==0)" screen yes
thermo_style custom step c_c[1] c_c[2] c_c[1]
run 1
END
prints "$(cat in.once)" 'now 0 0'
awk '$1 == "0" && NF == 4 { ok = ($2 == $4 && $2 != $3); exit } END { exit !ok }' out
report 'a row reads a compute once' $? out
finish
