#!/bin/bash
# The box and what moves at once: change_box, displace_atoms, replicate, moving faces, two dimensions.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

two='units si
boundary p p p
region box block 0 2 0 3 0 4 units box
create_box 2 box
create_atoms 1 single 0.5 1.5 3 units box
create_atoms 2 single 1.9 2.9 3.9 units box
group second id 2'

# does LINE RESULT
does() {
	printf '%s\n' "$two" "$1" >in.script
	# shellcheck disable=SC2016
	echo 'print "box $(lx:%.12g) $(ly:%.12g) $(lz:%.12g) $(xlo:%.12g) at $(x[1]:%.12g) $(y[1]:%.12g) $(z[1]:%.12g) and $(x[2]:%.12g) $(y[2]:%.12g) $(z[2]:%.12g)"' >>in.script
	"$TSIM" -in in.script -log none >out 2>&1
	grep -qxF -- "box $2" out
	report "$1" $? out
}
does 'change_box all x scale 2 remap x scale 2 remap units box' '8 3 4 -3 at -1 1.5 3 and 4.6 2.9 3.9'
does 'change_box all x scale 2 units box' '4 3 4 -1 at 0.5 1.5 3 and 1.9 2.9 3.9'
does 'change_box all x final 0 1 units box' '1 3 4 0 at 0.5 1.5 3 and 0.9 2.9 3.9'
does 'change_box all x scale 1.21 y volume z volume remap units box' \
	'2.42 2.72727272727 3.63636363636 -0.21 at 0.395 1.5 2.90909090909 and 2.089 2.77272727273 3.72727272727'
does 'change_box all x scale 1.1 z volume y scale 1.1 z volume units box' \
	'2.2 3.3 3.30578512397 -0.1 at 0.5 1.5 3 and 1.9 2.9 0.594214876033'
does 'change_box second x delta -0.1 0.2 y volume remap units box' \
	'2.3 2.60869565217 4 -0.1 at 0.5 1.5 3 and 2.085 2.71739130435 3.9'
does 'lattice none 0.5
change_box all x final 0 8 ortho units lattice' '4 3 4 0 at 0.5 1.5 3 and 1.9 2.9 3.9'
does 'change_box all boundary s s s' '1.4004 1.4006 0.9008 0.4998 at 0.5 1.5 3 and 1.9 2.9 3.9'
does 'change_box all boundary m f m x final 1 1.5 z final 3.5 4 units box' \
	'1.4001 3 1.00005 0.49995 at 0.5 1.5 3 and 1.9 2.9 3.9'
does 'displace_atoms all rotate 1 1 1 0 0 1 30 units box' \
	'2 3 4 0 at 0.316987298108 1.18301270189 3 and 0.829422863406 0.0954482671904 3.9'
does 'displace_atoms all ramp x 0 0.7 y 1 2 units box' '2 3 4 0 at 0.85 1.5 3 and 0.6 2.9 3.9'
does 'displace_atoms all move 0.3 0.4 0.5 units box' '2 3 4 0 at 0.8 1.9 3.5 and 0.2 0.3 0.4'
does 'variable d atom id*0.01
variable e equal 0.3
displace_atoms all move v_d v_e 0 units box' '2 3 4 0 at 0.51 1.8 3 and 1.92 0.2 3.9'
does 'displace_atoms second random 0 0 0 7919 units box' '2 3 4 0 at 0.5 1.5 3 and 1.9 2.9 3.9'
does 'replicate 2 1 3' '4 3 12 0 at 0.5 1.5 3 and 1.9 2.9 3.9'
prints "$two
displace_atoms all random 0.1 0.2 0 7919 units box
variable off equal \"abs(x[1]-0.5) < 0.1 && abs(x[1]-0.5) > 0 && abs(y[2]-2.9) < 0.2 && z[1] == 3\"
print \"within \${off}\"" 'within 1'
# identities, groups and crossings of the copies
prints "$two
displace_atoms all move 1.3 0.4 0.5 units box
replicate 2 2 1
print \"copy \$(count(all)) \$(count(second)) \$(x[8]:%.12g) \$(y[8]:%.12g) \$(z[8]:%.12g) \$(type[8])\"" \
	'copy 8 4 1.2 0.3 0.4 2'

# molecules of the copies, and of particles that are appended: those above 0 are numbered on
molecules="$two
fix m all property/atom mol
set group all mol 0
set atom 2 mol 3"
prints "$molecules
replicate 2 1 2
print \"molecules \$(mol[2]) \$(mol[4]) \$(mol[6]) \$(mol[8]) \$(mol[3])\"" 'molecules 3 6 9 12 0'
prints "$molecules
write_data m.data
read_data m.data add append shift 0 0 0 fix m NULL Molecules
print \"molecules \$(mol[2]) \$(mol[4]) \$(mol[3])\"" 'molecules 3 6 0'

# A periodic block of bonded particles, and the same one made larger: equal motion.
block='units si
boundary p p p
lattice sc 0.01'
bonds='set group all diameter 0.008 density 2385
pair_style spring/dashpot
pair_coeff * * stiffness 1000 damping 0.01
bond_style contact
bond_coeff 1 stiffness 2000 damping 0.02 ultimate 1000
create_bonds many all all 1 0.009 0.011'
motion='variable vx atom 0.1*sin(2*PI*x/0.03)+0.05*cos(2*PI*y/0.03)
variable vz atom 0.07*sin(2*PI*(y+z)/0.03)
velocity all set v_vx 0 v_vz
fix move all nve
timestep 1e-5
run 300
compute most all reduce max vx vz fx
print "energy $(ke:%.10g) $(c_most[1]:%.10g) $(c_most[2]:%.10g) $(c_most[3]:%.8g)"'
printf '%s\n' "$block" 'region box block 0 0.03 0 0.03 0 0.03 units box' 'create_box 1 box' 'create_atoms 1 box' \
	"$bonds" 'replicate 2 1 3' "$motion" >in.copied
printf '%s\n' "$block" 'region box block 0 0.06 0 0.03 0 0.09 units box' 'create_box 1 box' 'create_atoms 1 box' \
	"$bonds" "$motion" >in.larger
for way in copied larger; do
	"$TSIM" -in in.$way -log none >out.$way 2>&1
	report "block $way" $? out.$way
	grep '^energy' out.$way >energy.$way
done
shows '  486 bonds' out.copied
report 'all bonds copied' $? out.copied
same 'a copied block is a larger block' energy.copied energy.larger

# Faces that follow: 1e-4 of the first length outside; m never inside the first box; at rebuilds only.
prints 'units si
boundary s m f
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.2 0.3 0.5 units box
create_atoms 1 single 0.8 0.6 0.5 units box
set group all diameter 0.1 density 1000
group right id 2
velocity right set 1 2 0
fix move all nve
neighbor 0.1 bin
timestep 0.01
variable b equal 0.6002
run 0
print "shrunk $(xlo:%.12g) $(lx:%.12g) $(ylo) $(yhi)"
run 30
print "grown $(xlo:%.12g) $(yhi > 1.1 && yhi < 1.2002)"' 'shrunk 0.1999 0.6002 0 1' 'grown 0.1999 1'

rejects "$two
change_box all x volume units box" 'must follow a change'
rejects "$two
change_box all x scale 2 x volume units box" 'must follow a change'
rejects "$two
change_box all xy final 0.1 units box" 'not supported'
rejects "$two
change_box all triclinic" 'not supported'
rejects "$two
change_box all x final 2 1 units box" 'the box would reach'
rejects "$two
change_box all y skale 2 units box" "did you mean 'scale'"
rejects "$two
change_box all boundary p f" 'z is missing'
rejects "$two
change_box all boundary pf f f" 'both faces must be periodic'
# bonds across faces that are no longer periodic
bonded="$two
create_atoms 1 single 0.5 1.5 0.9 units box
set group all diameter 1 density 1
pair_style none
bond_style harmonic
bond_coeff 1 1 1
create_bonds many all all 1 1.85 1.95"
for change in 'boundary p p f' 'z scale 3 boundary p p f' 'z scale 0.8 remap boundary f f f'; do
	rejects "$bonded
change_box all $change" '1 bonds cross the faces of z'
done
does "${bonded#"$two"}
change_box all boundary f f p" '2 3 4 0 at 0.5 1.5 3 and 1.9 2.9 3.9'
rejects "$two
displace_atoms all rotate 0 0 0 0 0 0 30" 'the axis is zero'
rejects "$two
displace_atoms all ramp x 0 1 y 2 2" 'both ends lie at 2'
rejects "$two
replicate 100000 100000 1" 'identities would be needed'
rejects "$two
replicate 0 1 1" 'expected a number from 1'
rejects 'region box prism 0 1 0 1 0 1 0.1 0 0
create_box 1 box' 'tilted faces are not supported'
rejects 'region box block 0 1 0 1 0 1
create_box 1 box angle/types 2' 'no angles'
# change_box and write_data take the present positions, also where the last list is older: of particles that have crossed a periodic
# face, or have left faces of style s behind; at any skin.
travel() { # FACES SKIN LINES...: two particles that have moved by 0.03 since the list was built
	printf '%s\n' "units si
atom_style sphere
boundary $1
newton off
comm_modify vel yes
region bx block -1 1 -1 1 -1 1 units box
create_box 1 bx
create_atoms 1 single 0.98 0 0 units box
create_atoms 1 single -0.5 0 0 units box
set group all diameter 0.1 density 1000
pair_style gran/hooke/history 300 NULL 5 NULL 0.5 1
pair_coeff * *
timestep 1e-3
neighbor $2 bin
fix 1 all nve/sphere
velocity all set 1 0 0 units box
run 30" "${@:3}"
}
for skin in 0.001 0.1; do
	agree "a periodic box grows, skin $skin" "$(travel 'p p p' $skin 'change_box all x delta 0 0.3 units box' \
		"print 'is lo \$(bound(all,xmin)) -0.99 100'" "print 'is hi \$(bound(all,xmax)) -0.47 100'")"
	agree "a periodic face becomes fixed, skin $skin" "$(travel 'p p p' $skin 'change_box all boundary f p p' \
		"print 'is n \$(count(all)) 2'" "print 'is x \$(x[1]) -0.99 100'")"
	agree "a face that shrinks becomes fixed, skin $skin" "$(travel 's f f' $skin 'change_box all boundary f f f' \
		"print 'is n \$(count(all)) 2'" "print 'is hi \$(xhi>=x[1]) 1'")"
	agree "a data file, skin $skin" "$(travel 's p f' $skin 'write_data now.data' 'clear' 'units si' 'atom_style sphere' \
		'boundary f p f' 'read_data now.data' "print 'is n \$(count(all)) 2'" "print 'is x \$(x[1]) 1.01 100'")"
done
finish
