#!/bin/bash
# The language: the same script through tsim, LIGGGHTS and LAMMPS prints the same lines.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
export CROSSCHECK=north

# prints PROGRAM SCRIPT FILE [LETTERS]: lines whose first word begins with one of the letters
prints() {
	"$1" -log none -in "$2" >screen 2>&1 </dev/null
	grep -E "^[${4:-R}]([ _]|$)" screen >"$3"
}

# near WHAT FILE FILE: the same words, numbers to twelve digits
near() {
	awk 'NR == FNR { line[NR] = $0; n = NR; next }
		{ m = split(line[FNR], a); bad += m != NF
		  for (k = 1; k <= NF; k++) {
			d = a[k] - $k
			if (a[k] != $k && !(d * d <= 1e-24 * $k * $k && $k + 0 != 0)) {
				bad++
				print a[k], "is not", $k, "in line", FNR
			}
		  } }
		END { exit bad || n != FNR || !n }' "$2" "$3" >difference 2>&1
	report "$1" $? difference
}

printf '1.5\n# note\n\nword second\n2.5e3 x\n' >values.txt
printf 'print "R included"\nvariable inc index 4 5\nprint "R ${inc}"\n' >in.included
printf 'print "R lost"\nlabel there\nprint "R jumped"\nquit\nprint "R late"\n' >in.jumped

# What all three have in common: lines, quotes, substitution, variables, formulas, loops, conditions, files.
cat >in.common <<'END'
# comment that swallows the next line &
print "R lost"
print "R one &
  two"
print "R plain" # comment "with quote
print 'R single "inside"'
variable a index 7 8
variable long index 2.385
variable s string "a b"
print "R $a ${a}${long} ${s} $(1/3)"
variable eq equal 1/3
print "R ${eq}"
variable fz equal ${long}/2
variable fl equal v_long/2
variable long delete
variable long index 10
print "R ${fz} ${fl}"
print "R $(-2^2) $(2^3^2) $(2^-1) $(-3%2) $(7%5*2) $(2-3-4) $(84/7/3) $(1+2*3^2)"
print "R $(1<2==3<4) $(2==2>1) $(!0+3) $(!(2>1)) $(1||0&&0) $(3!=3) $(1e3+1.5e-3) $(.5+5.)"
print "R $(sqrt(2)) $(exp(1)) $(ln(10)) $(log(1000)) $(abs(-2.5)) $(sin(0.3)) $(cos(0.3)) $(tan(0.3))"
print "R $(asin(0.3)) $(acos(0.3)) $(atan(0.3)) $(atan2(-1,-2)) $(ceil(2.1)) $(floor(-2.1)) $(round(2.5)) $(round(-2.5)) $(PI)"
variable big equal 1e20
variable neg equal -0.0
variable i equal 123456789012
print "R ${big} ${neg} ${i} $(1e20) $(0.1) $(123456789) $(1e5) $(1e-7)"
variable n loop 3
label top
variable m loop 2 4
label inner
print "R $n $m"
next m
jump SELF inner
next n
jump SELF top
print "R end"
variable p loop 8 10 pad
variable w loop 4 6
label again
print "R $p$w"
next p w
jump SELF again
variable w index fresh
print "R $w"
if "$a == 7" then "print 'R yes'" else "print 'R no'"
if "$a > 7 && 1 < 2" then "print 'R yes'" elif "$a >= 7" "print 'R elif'" else "print 'R no'"
variable t string drill
variable e getenv CROSSCHECK
print "R ${e}"
variable b1 equal 2
variable b1 equal v_b1x*1
variable b1x equal 5
print "R ${b1}"
variable t string other
print "R $t"
variable uni universe q r
print "R ${uni}"
variable ul uloop 2
print "R ${ul}"
variable wo world single
print "R ${wo}"
shell mkdir sub
shell mkdir sub
shell cd sub
print "R there" file in.inner
shell cd ..
label skip
jump SELF over
print "R never ${nothing}"
label over
variable f file values.txt
label more
print "R f $f"
next f
jump SELF more
include in.included
print "R after"
variable d equal "2 + 3 * (4 - 1)"
print "R $d"
if "(1 < 2) && !(3 < 2)" then "print 'R nested'"
if 1 then "print 'R one word'"
if "0" then "print 'R zero'"
variable str string "with # hash"
print "R ${str}"
print "R a	tab  two blanks"
print 'R $a not here'
print R_word
variable q equal 5
print "R $q$q ${q}x"
variable v1 equal v_q*2
variable q equal 6
print "R ${v1}"
jump in.jumped there
print "R never"
END
prints "$TSIM" in.common tsim.lines
[ "$(wc -l <tsim.lines)" = 50 ]
report 'tsim prints all lines' $? tsim.lines
for program in liggghts lmp; do
	has $program "${program/lmp/lammps}" || continue
	prints $program in.common $program.lines
	diff $program.lines tsim.lines >difference
	report "the same lines from $program" $? difference
done

# What only LAMMPS has besides.
cat >in.lammps <<'END'
print """R three "double" 'single'
R lines"""
variable a index abc
if "$a == abc" then "print 'R same'" else "print 'R differ'"
if "$a != xyz && (1 < 2 || 0)" then "print 'R words'"
if "1 |^ 0" then "print 'R xor'"
if "1 |^ 1" then "print 'R xor'" else "print 'R not xor'"
variable x equal 22/7
variable f format x %10.4f
print "R ${f} $(v_x:%.3f) $(v_x*2:%08.2e) $(1/3:%.4g)"
variable x2 internal 2.5
print "R ${x2} $(v_x2*2)"
variable n loop 3
label top
print "R $n"
next n
jump SELF top
variable file file values.txt
variable i loop 5
if "$i > 3" then "print 'R a'" elif "$i == 2" "print 'R b'" elif "$i == 1" "print 'R c'" "print 'R d'" else "print 'R e'"
print "R print" append out.txt screen no
print 'R $(1+1)'
variable s string 'single "d" quotes'
print "R ${s}"
partition yes 1 print "R partition"
partition no 1 print "R not"
END
# Sequences of steps; in pieces, since LAMMPS limits the calls of a variable.
cat >in.steps <<'END'
region box block -1 1 -1 1 -1 1 units box
create_box 1 box
variable i index STEPS
label a
reset_timestep $i
print "R $i $(stagger(100,10)) $(logfreq(10,4,10)) $(logfreq2(100,18,10)) $(logfreq2(10,7,3)) $(stride(100,1000,7)) $(stride(0,1000,13)) $(stride2(0,1000,100,140,180,7)) $(stride2(60,1010,50,100,560,9))"
next i
jump SELF a
END
cat >in.log3 <<'END'
region box block -1 1 -1 1 -1 1 units box
create_box 1 box
variable i index 0 9 10 11 55 99 100 101 144 199 400 430
label a
reset_timestep $i
print "R $i $(logfreq3(10,25,1000)) $(logfreq3(7,9,431))"
next i
jump SELF a
END
if has lmp lammps; then
	prints lmp in.lammps lmp.lines
	prints "$TSIM" in.lammps tsim.lines
	diff lmp.lines tsim.lines >difference
	report 'the same lines where only LAMMPS has the words' $? difference
	for steps in '0 1 9 10 11 55 60 99 100 101' '140 144 145 150 174 175 176 179 180 181' \
		'199 499 500 549 555 556 559 560 546'; do
		sed "s/STEPS/$steps/" in.steps >in.some
		prints lmp in.some lmp.lines
		prints "$TSIM" in.some tsim.lines
		same "sequences of steps at $steps" lmp.lines tsim.lines
	done
	prints lmp in.log3 lmp.lines
	prints "$TSIM" in.log3 tsim.lines
	same 'logfreq3' lmp.lines tsim.lines
fi

# Formulas of particles and groups, and texts that are substituted anew in a run.
cat >head <<'END'
atom_style sphere
atom_modify map array
units si
boundary f f f
region box block -1 1 -1 1 -1 1 units box
create_box 1 box
create_atoms 1 single 0.385 0 0.2 units box
create_atoms 1 single -0.3 0.4 0 units box
create_atoms 1 single 0.1 -0.7 0.3 units box
create_atoms 1 single -0.5 0.1 -0.6 units box
set atom 1 diameter 0.1 density 2385
set atom 2 diameter 0.12 density 2000
set atom 3 diameter 0.2 density 2385
set atom 4 diameter 0.17 density 1385
velocity all set 1.5 2.385 -3.1 units box
set atom 2 vx 0.3
set atom 3 vy -2.3
set atom 4 vz 4.7
region half block 0 1 INF INF INF INF units box
group some id 1 2 4
print "G $(count(all)) $(count(some,half)) $(mass(some)) $(mass(all,half)) $(ke(some)) $(ke(all,half))"
print "G $(xcm(some,x)) $(xcm(all,z,half)) $(vcm(all,y)) $(bound(all,ymin)) $(bound(all,ymin,half))"
print "G $(gyration(all)) $(gyration(some)) $(angmom(all,x)) $(angmom(some,z)) $(vcm(all,x,half))"
print "G $(inertia(all,xx)) $(inertia(all,xy)) $(inertia(all,yz)) $(inertia(some,zz)) $(inertia(all,xz,half))"
print "G $(omega(all,x)) $(omega(all,y)) $(omega(some,z)) $(mass(all)*vcm(all,z))"
print "G $(x[2]+vx[3]*id[4]) $(mass[2]) $(vz[4])"
variable w atom x*vy+(type==1)-z^2*gmask(some)+rmask(half)*10+grmask(some,half)*100
variable k equal 3
print "G $(v_w[1]) $(v_w[2]) $(v_w[3]) $(v_w[4]) $(v_k^2)"
END
cat >tail <<'END'
fix move all nve/sphere
timestep 1e-5
variable st equal step
variable c equal "v_st*2+1"
fix out all print 2 "P ${st} ${c} $(v_c/2)" screen yes
thermo_style custom step
run 4 every 2 "print 'E $(step) ${st}'"
run 0
variable r equal ramp(2,5)
variable d equal vdisplace(1,100)
variable sw equal swiggle(1,2,0.00007)
variable cw equal cwiggle(1,2,0.00007)
variable sg equal stagger(10,3)
variable lo equal logfreq(1,3,10)
fix more all print 1 "P ${st} ${r} ${d} ${sw} ${cw} ${sg} ${lo}" screen yes
run 7
END
cat >liggghts.law <<'END'
neighbor 0.01 bin
neigh_modify delay 0
fix a all property/global kn peratomtypepair 1 1
fix b all property/global kt peratomtypepair 1 1
fix c all property/global gamman peratomtypepair 1 0
fix d all property/global gammat peratomtypepair 1 0
pair_style gran model hooke/stiffness tangential off
pair_coeff * *
END
cat head tail >in.tsim
prints "$TSIM" in.tsim tsim.lines GPE
if has liggghts; then
	{ printf 'newton off\ncommunicate single vel yes\n' && cat head liggghts.law tail; } >in.liggghts
	prints liggghts in.liggghts liggghts.lines GPE
	near 'groups, particles and texts of a run as in LIGGGHTS' liggghts.lines tsim.lines
fi
if has lmp lammps; then
	cp head in.lammps
	prints lmp in.lammps lmp.lines G
	grep '^G' tsim.lines >tsim.groups
	near 'groups and particles as in LAMMPS' lmp.lines tsim.groups
fi
# Accepted and refused alike, with the same lines; @ begins a new line.
cat >cases <<'END'
print "a"b
print a b
variable x equal 1 + 2
variable x equal "1 + 2"@print "R ${x}"
variable x index@print "R"
variable x loop 0@print "R"
variable x loop 3 1@print "R"
variable x loop 1 3 pad@print "R $x"
variable x string a b@print "R $x"
variable x equal v_x@print "R $x"
variable a-b equal 1@print "R"
variable x delete@print "R"
variable x equal 1@variable x index 2@print "R $x"
variable x equal 1@variable x string 2@print "R $x"
print "R ${nothing}"
print "R $(1+)"
print "R $(1 2)"
print "R $(1/0)"
print "R $(sqrt(-1))"
print "R $(ln(0))"
print "R $(asin(2))"
print "R $(2^0.5^2)"
print "R $(1e3.5)"
print "R $(.5)"
print "R $(5.)"
print "R $(--5)"
print "R $(!0)"
print "R $(!!5)"
print "R $(2--3)"
print "R $(2*-3)"
print "R $(1<2<3)"
print "R $(5%3)"
print "R $(-5%3)"
print "R $(5.5%2)"
print "R $(sqrt(4))"
print "R $(SQRT(4))"
print "R $( 1 + 2 )"
print "R $(atan2(1,1))"
print "R $(ceil(-0.5))"
if "1" then "print 'R a'"
if "1 = 1" then "print 'R a'"
if "1 & 1" then "print 'R a'"
if "1 == 1.0" then "print 'R a'"
if "-1 < 0" then "print 'R a'"
if "(1)" then "print 'R a'"
if "!0" then "print 'R a'"
if "1e2 == 100" then "print 'R a'"
if "1 < 2 < 3" then "print 'R a'"
if "2 > 1 == 1" then "print 'R a'"
if "1 == 1" print
if "1 == 1" then print
if "0 || 1 && 0" then "print 'R a'" else "print 'R b'"
variable x index 1@next x@jump SELF nowhere@print "R"
label a@print "R"
jump SELF b@print "R"
echo maybe
log
unknown_command
print
variable x equal PI@print "R $x"
variable x atom 1@print "R $x"
variable x equal 2@variable y equal $x^2@print "R $y ${y}"
print 'R ${x}'
variable x index "a b" c@print "R $x"
print "R a &@   b"
print "R" "S"
variable x universe a b@print "R $x"
variable x world a b@print "R $x"
variable x file nothing@print "R"
print "R $(stagger(5,7))"
print "R $(abs(-2),3)"
print "R $(floor(2.7)"
print "R $(v_y)"
variable x equal 1@print "R $(v_x[1])"
print "R a  &@   b"
print R&@a
print "R a" & # c@print "R b"
variable x index 5@print "R ${x}$x$x"
variable xy index 5@variable x index 7@print "R $xy"
variable x index 5@print "R $x.$x-$x"
variable x index 5@print R$x
variable x index "5 6"@print R$x
variable x index "5 6"@variable y index $x@print "R $y"
variable x string '$y'@variable y index 3@print "R ${x}"
variable x string "a # b"@print "R ${x}"
print "R # not comment" # comment
print R#x
print 'R # x'
print "R it's"
print 'R say "hi"'
	print	"R	tab"
print "R ${x"
print "R $"
print "R $ x"
print "R $$"
variable x equal 3@print "R $((v_x))"
variable x equal 3@print "R $(v_x*(2+1))"
variable x equal "3 # 4"@print "R $x"
variable x index 1 &@ 2 &@ 3@next x@next x@print "R $x"
if "1 == 1" then &@"print 'R a'" &@else &@"print 'R b'"
variable n loop 3@label l@print "R $n"@if "$n == 2" then "jump SELF out"@next n@jump SELF l@label out@print "R out $n"
variable n loop 2@label l@variable m loop 2@label k@print "R $n$m"@next m@jump SELF k@next n@jump SELF l
variable n loop 2@label l@if "$n == 1" then "print 'R one'" "next n" "jump SELF l" "print 'R no'"@print "R end $n"
variable n loop 3 5 pad@print "R $n"
variable n loop 08 11 pad@print "R $n"
variable n loop 1000 pad@print "R $n"
variable x equal 2@variable y equal v_x^2@variable x equal 3@print "R ${y}"
variable x equal 1e-5@print "R ${x}"
variable x equal 123456.789@print "R ${x}"
variable x equal 1234567890123456789@print "R ${x}"
variable x equal 0.1+0.2@print "R ${x} $(0.1+0.2)"
variable x equal -5@print "R ${x} $(v_x)"
variable x equal (1==1)@print "R ${x}"
variable x index 007@print "R ${x} $(v_x)"
variable x index 1e3@print "R $(v_x+1)"
log x.log@print "R"
include nothing.in
jump nothing.in
label@print "R"
next
variable
variable x
variable x equal@print "R"
variable x string ""@print "R ${x}|"
print ""@print "R"
  # only comment@print "R"
&@print "R"
print "R a" &@
if "1" then "variable z equal 4"@print "R $z"
if "1" then "variable z equal 4" "print 'R ${z}'"
variable z equal 4@if "${z} == 4" then "variable z equal 5" "print 'R $z'"
variable z index 4@if "$z > 3" then "print 'R a $z'" else "print 'R b $z'"
END
verdict() { # PROGRAM
	if timeout 60 "$1" -log none -in in.case >screen 2>&1 </dev/null; then echo accepted; else echo refused; fi
	grep -a '^R' screen | grep -v ' (\./src/' # LIGGGHTS' errors begin with chance letters at times
}
if has liggghts; then
	while IFS= read -r line; do
		printf '%s\n' "$line" | tr '@' '\n' >in.case
		verdict liggghts >liggghts.case
		verdict "$TSIM" >tsim.case
		diff liggghts.case tsim.case >difference
		report "alike: $line" $? difference
	done <cases
fi
finish
