#!/bin/bash
# Words of neigh_modify, comm_modify, communicate, processors and atom_modify; set of named numbers.
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# Two pairs that touch: 1-2 in x, 3-4 across the face in x; molecules 7, 7 and 7, 8.
four='units si
boundary p p p
region box block 0 1 0 1 0 1 units box
create_box 2 box
create_atoms 1 single 0.5 0.5 0.5 units box
create_atoms 2 single 0.57 0.5 0.5 units box
create_atoms 1 single 0.02 0.2 0.2 units box
create_atoms 1 single 0.95 0.2 0.2 units box
set group all diameter 0.11 density 1000
fix m all property/atom mol
set atom 1*3 mol 7
set atom 4 mol 8
group low id 1 2
group high id 3 4
pair_style spring/dashpot
pair_coeff * * stiffness 100 restitution 0.5
compute nc all contacts
timestep 1e-5'
count='run 0
print "contacts $(c_nc)"'
contacts() { # number, neigh_modify words
	prints "$four
neigh_modify $2
$count" "contacts $1"
}
contacts 2 'delay 0 every 1 check yes binsize 0.1 page 100000 one 2000 once no cluster no collection/type 2 1 2 collection/interval 2 1.5 2.5'
contacts 1 'include low'
contacts 1 'include high exclude type 1 2'
contacts 2 'include all'
contacts 1 'exclude type 1 2 check yes'
contacts 0 'exclude type 1 2 delay 0 exclude group high high check yes'
contacts 1 'exclude group all all exclude none exclude type 1 2 every 1'
contacts 1 'exclude molecule/intra all'
contacts 1 'exclude molecule all'
contacts 1 'exclude molecule/inter all'
contacts 2 'exclude molecule/inter low exclude molecule/intra high'
contacts 0 'exclude molecule/inter all exclude molecule/intra all'
rejects "$four
neigh_modify exclude type 1" 'expected type m n, group a b'
rejects "$four
neigh_modify exclude atoms 1 2" 'expected type m n, group a b'
rejects "${four/fix m all property\/atom mol/fix m all property\/atom d_mol}
neigh_modify exclude molecule all" 'particles belong to no molecules'

# The settings outlive a restart.
cat >in.one <<END
$four
neigh_modify include high
run 0
write_restart kept.restart
END
"$TSIM" -in in.one -log none >out 2>&1
report 'writes what is included' $? out
prints 'read_restart kept.restart
fix m all property/atom mol
pair_style spring/dashpot
pair_coeff * * stiffness 100 restitution 0.5
compute nc all contacts
timestep 1e-5
run 0
print "contacts $(c_nc)"' 'contacts 1'

prints "comm_modify mode multi cutoff 0.1 cutoff/multi 1 0.2 cutoff/multi * 0.3 reduce/multi vel no
communicate multi cutoff 0.1 vel yes group all
processors * 2 1 grid twolevel 2 * * * map xyz part 1 2 multiple
atom_modify map hash sort 1000 0.25 id yes
print done" done
rejects "$four
comm_modify group low" 'contacts of the others across periodic faces'
rejects "$four
communicate single group low" 'contacts of the others across periodic faces'
rejects 'processors 2 2' 'expected three numbers of processes, found 2'
rejects 'processors 2 2 x' "found 'x', expected three numbers"
rejects 'atom_modify id no' 'particles always have atom IDs'
rejects 'atom_modify sort 10' 'sort takes a number of steps'

prints "$four
fix p all property/atom d_age i_mark d2_q 3
set group low d_age 2.5 vx 1.5 i_mark 3 d2_q[2] 1.25
set atom 4 property/atom d2_q 1 2 3
variable twice atom 2*d_age+id
set atom 3 d_age v_twice
compute two all property/atom d2_q[2]
compute sums all reduce sum d_age i_mark c_two mol
print 'sums \$(c_sums[1]) \$(c_sums[2]) \$(c_sums[3]) \$(c_sums[4])'" 'sums 8 6 4.5 29'
rejects "$four
set atom 3 d_age 1" "no fix keeps a property 'd_age'"
rejects "$four
fix p all property/atom i_mark d2_q 3
set atom 3 i_mark 1.5" 'is an integer, found 1.5'
rejects "$four
fix p all property/atom i_mark d2_q 3
set atom 3 d2_q[4] 1.5" 'has the numbers [1] to [3], not [4]'
rejects "$four
fix p all property/atom i_mark d2_q 3
set atom 3 d2_q 1.5" "takes 3 numbers, but 1 are given"

prints "$four
group a molecule 7
group b molecule > 7
group c id 3
group c include molecule
set mol 7 vx 1.5
set mol 8* vy 2.5
dump d all custom 1 mol.dump id mol vx vy
run 0" '3 atoms in group a' '1 atoms in group b' '3 atoms in group c'
printf '1 7 1.5 0 \n2 7 1.5 0 \n3 7 1.5 0 \n4 8 0 2.5 \n' >want
tail -n 4 mol.dump >got
same 'molecules in a dump' got want
rejects "$four
group a molecule 8
neigh_modify exclude molecule a
group a delete" "group 'a' is used by neigh_modify"

# A box that could not be made in two dimensions does not nest the check.
cat >in.two <<'END'
dimension 2
read_data nothing.data
set type 1 mass 1
END
refused 'check in two dimensions' "nothing.data" -check -in in.two
shows nested err
report 'nothing is nested' $((1 - $?)) err
finish
