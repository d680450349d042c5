#!/bin/bash
# read_data: sections that fix property/atom gets, bare add, words of molecules.
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >three.data <<'END'
three spheres

3 atoms
2 atom types
4 crossterms
0 1 xlo xhi
0 1 ylo yhi
0 1 zlo zhi

Atoms # sphere

1 1 0.1 1000 0.2 0.2 0.2
2 1 0.1 1000 0.4 0.2 0.2
9 2 0.1 1000 0.6 0.2 0.2

Molecules

9 5
1 7
2 7

My Marks

1 0.5 3 1e2
9 2.385 4 -1
2 1.5 -3 0

Velocities

1 0 0 0 0 0 0
2 0 0 1 0 0 0
9 0 0 0 0 0 0
END
head='units si
fix m all property/atom mol
fix p all property/atom d_age i2_mark 2'
sums='compute two all property/atom i2_mark[1] i2_mark[2]
compute s all reduce sum d_age c_two[1] c_two[2] mol vz
print "sums $(c_s[1]) $(c_s[2]) $(c_s[3]) $(c_s[4]) $(c_s[5])"'
prints "$head
read_data three.data fix m NULL Molecules fix p crossterms \"My Marks\" extra/angle/types 2 extra/dihedral/types 1 &
extra/improper/types 1 extra/angle/per/atom 3 extra/dihedral/per/atom 3 extra/improper/per/atom 3 extra/special/per/atom 2
$sums" 'sums 4.3849999999999997868 4 99 19 1' '*3 lines'
prints "$head
read_data three.data fix m NULL Molecules fix p crossterms \"My Marks\"
read_data three.data add 100 shift 0 0 0.3 fix m NULL Molecules fix p crossterms \"My Marks\"
group far id 109
compute m all property/atom mol
compute f far reduce sum c_m d_age
print \"far \$(c_f[1]) \$(c_f[2]:%.15g)\"" 'far 5 2.385'
rejects "$head
read_data three.data fix m NULL Molecules" "three.data:5:"
rejects "$head
read_data three.data fix m crossterms Molecules" "unknown section 'My'"
rejects "$head
read_data three.data fix m NULL" 'fix takes the name of a fix, a text of the header or NULL'
rejects "$head
read_data three.data fix m NULL Molecules fix p crossterms \"My Marks\"
fix n all nve
read_data three.data add 100 fix n NULL Molecules" "is of style nve, expected property/atom"
rejects "$head
read_data three.data fix q NULL Molecules" "there is no fix 'q'"
sed 's/^9 2.385 4 -1/9 2.385 4/' three.data >short.data
rejects "$head
read_data short.data fix m NULL Molecules fix p crossterms \"My Marks\"" 'My Marks'
sed 's/^9 2.385 4 -1/8 2.385 4 -1/' three.data >other.data
rejects "$head
read_data other.data fix m NULL Molecules fix p crossterms \"My Marks\"" 'there is no such particle in section Atoms'

# written, read, written: the same bytes
prints "$head
fix hidden all property/atom d_none writedata no
read_data three.data fix m NULL Molecules fix p crossterms \"My Marks\"
write_data one.data
write_data bare.data nofix
clear
$head
read_data one.data fix m NULL Molecules fix p NULL p
write_data two.data" '*3 lines'
same 'sections come back' one.data two.data
grep -q 'Molecules\|^p$' bare.data
report 'nofix' $((1 - $?)) bare.data

# LIGGGHTS: `add` alone puts the particles into the box there is, under their own identities
sed -e '/^4 cross/d; /^Molecules/,/^2 1.5/d; s/^9 2/4 2/; s/^9 0/4 0/; s/^1 1/5 1/; s/^1 0 0/5 0 0/; s/^2 1/6 1/; s/^2 0 0/6 0 0/' three.data >plain.data
box='units si
boundary f f f
region box block 0 0.9 0 1 0 1 units box
create_box 2 box
create_atoms 1 single 0.5 0.8 0.5 units box'
prints "$box
read_data plain.data add group new
print \"there \$(atoms) \$(xhi:%.15g) \$(count(new))\"" 'there 4 0.9 3'
sed -i 's/0.6 0.2 0.2/0.95 0.2 0.2/' plain.data
rejects "$box
read_data plain.data add" 'lies outside the box'
rejects "$box
read_data plain.data add merge append" "add takes one word"

# a first value `none` is 0
prints "$box
fix av all property/atom heatAv vector no yes no none 2.5
compute s all reduce sum f_av[1] f_av[2]
print \"first \$(c_s[1]) \$(c_s[2])\"" 'first 0 2.5'
finish
