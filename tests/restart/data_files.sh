#!/bin/bash
# read_data and write_data: the same file again byte for byte, the same mechanics after it, and every
# malformed line refused with its place.
. "${top_srcdir:-.}/tests/lib_cases.sh"

cat >in.make <<'END'
units si
boundary p m f
region box block 0 0.3173 -0.1 0.2385 0 0.7 units box
create_box 3 box
create_atoms 2 random 97 86028157 NULL
variable d atom 0.01+0.002*sin(id)
variable rho atom 2500+13.7*id
set group all diameter v_d density v_rho
set atom 5 type 3 omegay 2.385
velocity all create 1e20 4928459
pair_style spring/dashpot
pair_coeff * * stiffness 2385 restitution 0.5
fix move all nve/sphere
timestep 1e-6
run 3
write_data one.data
write_data one.data.gz nocoeff
print "ke $(ke) erotate $(erotate) mass $(mass(all))"
END
cat >in.again <<'END'
units si
boundary p m f
pair_style spring/dashpot
read_data one.data
write_data two.data
print "ke $(ke) erotate $(erotate) mass $(mass(all))"
END
"$TSIM" -in in.make -log none >make.out 2>&1
report 'write_data runs' $? make.out
"$TSIM" -in in.again -log none >again.out 2>&1
report 'read_data reads it' $? again.out
same 'written, read, written: the same bytes' one.data two.data
grep '^ke' make.out >make.ke
grep '^ke' again.out >again.ke
same 'energies and mass to the last digit' make.ke again.ke
sed 's/one.data/one.data.gz/; s/two/three/' in.again >in.gz
"$TSIM" -in in.gz -log none >gz.out 2>&1
sed '/^PairIJ/,$d' two.data | sed '$d' >two.short
same 'from a compressed file, without coefficients' two.short three.data

# expect WHAT DATA TEXT...: a file of these lines is read, with this output
base='title

2 atoms
1 atom types
0 1 xlo xhi
0 1 ylo yhi
0 1 zlo zhi

Atoms

7 1 0.1 2500 0.25 0.5 0.5
3 1 0.2 1000 0.75 0.5 0.5 0 -2 1'
expect() { # what, script, lines expected
	local what=$1 ok=0
	printf '%s\n' "$2" >in.script
	shift 2
	"$TSIM" -in in.script -log none >out 2>&1 || ok=1
	for line in "$@"; do
		says_line "$line" out || { ok=1; echo "missing: $line"; }
	done
	report "$what" $ok out
}
printf '%s\n' "$base" >base.data
expect 'identities, image flags, masses' 'units si
boundary f p p
read_data base.data group fresh
variable iy atom iy
compute iy all reduce sum v_iy
print "n $(count(fresh)) mass $(mass(all):%.15g) iy $(c_iy)"' \
	'n 2 mass 5.49778714378214 iy -2'
expect 'append with shift and type offset' 'units si
boundary p p p
read_data base.data extra/atom/types 2
read_data base.data add append offset 2 0 shift 0 0 0.25 group more
group third type 3
group late id 10 14
print "n $(count(all)) $(count(third)) $(count(late)) z $(xcm(more,z):%.15g) box $(zhi)"' \
	'n 4 2 2 z 1.70238095238095 box 1.25'
expect 'a number added to the identities' 'read_data base.data
read_data base.data add 100
group late id 103 107
print "late $(count(late))"' 'late 2'
printf '%s\n' "$base" | sed 's/^Atoms/Masses\n\n1 2.385\n\nAtoms # bond/; s/^7.*/7 1 1 0.25 0.5 0.5/; s/^3 .*/3 1 1 1.75 0.5 0.5 0 0 0\n\nBonds # here\n\n1 1 7 3\n\nBond Coeffs\n\n1 stiffness 20 ultimate 3.0/; s/^1 atom types/&\n1 bonds\n1 bond types/' >bond.data
expect 'bonds and their coefficients, wrapped positions' 'boundary p p p
bond_style contact
read_data bond.data
variable ix atom ix
compute ix all reduce sum v_ix
print "mass $(mass(all):%.15g) ix $(c_ix) bonds $(numbonds)"
write_data bond2.data' 'mass 4.77 ix 1 bonds 1'
printf 'title\n0 atoms\n1 atom types\n0 2 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n0 0 0 xy xz yz\n' >empty.data
expect 'an empty box' 'read_data empty.data
run 0
write_data empty2.data' '  0 atoms'
# malformed WHAT SED-PROGRAM TEXT: base.data edited so is refused at this place with these words
malformed() {
	sed "$2" base.data >bad.data
	printf 'boundary f p p\nread_data bad.data\n' >in.script
	refused "$1" "$3" -in in.script
}
malformed 'no header' '3,$d' 'bad.data:2: error: the header ends here, but has no line `LO HI xlo xhi`'
malformed 'no title even' '1,$d' 'the file is empty'
malformed 'count no number' 's/^2 atoms/two atoms/' "bad.data:3:1: error: the number of atoms is 'two', expected an integer"
malformed 'negative count' 's/^2 atoms/-2 atoms/' 'the number of atoms is -2, expected an integer from 0'
malformed 'angles' 's/^1 atom types/&\n3 angles/' 'not supported by tsim'
malformed 'too many types' 's/^1 atom types/20000 atom types/' 'there can be 10000'
malformed 'box upside down' 's/^0 1 ylo/2 1 ylo/' 'bad.data:6:3: error: the upper bound 1 is not above the lower bound 2'
malformed 'tilted box' 's/^Atoms/0.1 0 0 xy xz yz\n\nAtoms/' 'the box is tilted by 0.1'
malformed 'unknown section' 's/^Atoms/Atom/' "bad.data:9:1: error: unknown section 'Atom'; did you mean 'Atoms'?"
malformed 'section of others' 's/^Atoms/Ellipsoids/' 'section Ellipsoids is not supported by tsim'
malformed 'no section Atoms' '/^Atoms/,$d' 'the file ends without section Atoms'
malformed 'too few lines' '$d' 'the file ends after 1 of 2 lines of section Atoms'
malformed 'too few before another' 's/^3 .*/Velocities/' 'section Velocities begins, but section Atoms has only 1 of 2 lines'
malformed 'too many lines' '$s/$/\n4 1 1 1 0 0 0/' 'bad.data:13: error: expected the title of a section'
malformed 'word for a number' 's/2500/dense/' "bad.data:11:9: error: density is 'dense', expected a number"
malformed 'number with a tail' 's/2500/2500x/' "density is '2500x'"
malformed 'nan' 's/2500/nan/' "density is 'nan'"
malformed 'column missing' 's/^7 .*/7 1 0.1 2500 0.25 0.5/' 'bad.data:11: error: z is missing, expected a number'
malformed 'half an image flag' 's/-2 1$//' 'image flag iy is missing'
malformed 'a word too many' 's/-2 1$/-2 1 8/' "bad.data:12:34: error: '8' is one word too many, expected 10"
malformed 'type too large' 's/^3 1/3 2/' 'bad.data:12:3: error: type is 2, expected an integer from 1 to 1'
malformed 'identity 0' 's/^3 1/0 1/' 'id is 0, expected an integer from 1'
malformed 'identity twice' 's/^3 1/7 1/' 'bad.data:12: error: id 7 occurs in line 11 already'
malformed 'no diameter' 's/0\.1 2500/0 2500/' 'diameter is 0, expected a number > 0'
malformed 'outside a fixed face' 's/0\.75/1.75/' 'bad.data:12: error: x = 1.75 lies outside the box'
malformed 'absurd coordinate' '$s/0\.5 0\.5/1e300 0.5/' 'is too far from the box'
malformed 'velocity of nobody' '$s/$/\nVelocities\n\n9 0 0 0 0 0 0/' 'bad.data:15:1: error: id is 9, but there is no such particle'
malformed 'velocity too short' '$s/$/\nVelocities\n\n7 0 0 0 0 0/' 'omegaz is missing'
malformed 'velocities first' 's/^Atoms/Velocities\n\nAtoms/' 'section Velocities must come after section Atoms'
malformed 'bond to itself' 's/^1 atom types/&\n1 bonds\n1 bond types/; $s/$/\nBonds\n\n1 1 3 3/' 'particle 3 is bonded to itself'
malformed 'bond type too large' 's/^1 atom types/&\n1 bonds\n1 bond types/; $s/$/\nBonds\n\n1 2 3 7/' 'type of the bond is 2'
malformed 'bonded twice' 's/^1 atom types/&\n2 bonds\n1 bond types/; $s/$/\nBonds\n\n1 1 3 7\n2 1 7 3/' 'particles 3 and 7 are bonded twice'
malformed 'mass 0' 's/^Atoms/Masses\n\n1 0\n\nAtoms/' 'the mass is 0, expected a number > 0'
malformed 'no mass for points' 's/^Atoms/Atoms # atomic/; s/^7.*/7 1 0 0 0/; s/^3 .*/3 1 0 0 0/' 'type 1 has no mass'
malformed 'coefficients without a style' '$s/$/\nPair Coeffs\n\n1 stiffness 3/' 'bad.data:15:'
malformed 'style of others' 's/^Atoms/Atoms # ellipsoid/' 'atom_style ellipsoid is known, but tsim does not have it'
printf 'title\n2 at\0oms\n' >zero.data
printf 'read_data zero.data' >in.script
refused 'zero byte' 'contains a zero byte' -in in.script
gzip -c one.data | head -c 700 >cut.data.gz
printf 'read_data cut.data.gz' >in.script
refused 'compressed data cut short' "reading 'cut.data.gz' failed" -in in.script
printf 'read_data nowhere.data' >in.script
refused 'no such file' "cannot open 'nowhere.data'" -in in.script
printf 'read_data base.data\nread_data base.data' >in.script
refused 'twice without add' 'use `add append` or `add merge`' -in in.script
printf 'read_data base.data\nread_data base.data add merge' >in.script
refused 'merged with itself' 'there is a particle 7 already' -in in.script
printf 'read_data base.data\nread_data base.data add apend' >in.script
refused 'misspelt' "did you mean 'append'?" -in in.script
printf 'read_data base.data offset 1 0' >in.script
refused 'offset beyond the types' 'type 1 with its offset is more than the 1 there are' -in in.script
printf 'atom_style sper' >in.script
refused 'atom style misspelt' "unknown atom style 'sper'" -in in.script

finish
