#!/bin/sh
# tsim -check: all errors of a script at once, none that only follow from others, what the script would
# do and write, and nothing done or written.
. "$top_srcdir/tests/lib_cases.sh"

# check NAME: the script is standard input; err and out hold what is said, status the exit status
check() {
	cat >"$1"
	"$TSIM" -check -in "$1" >out 2>err </dev/null
	status=$?
}

# errors WHAT: standard input lists "line:column: part of the message", in order, and no more are told
errors() {
	cat >expected
	sed -n 's/^[^ :]*:\([0-9]*:[0-9]*\): error: /\1: /p' err >found
	n=0
	good=0
	while read -r place text; do
		n=$((n + 1))
		line=$(sed -n "${n}p" found)
		[[ $line = "$place "* ]] && shows "$text" <<<"$line" && continue
		echo "expected $place $text"
		echo "found    $line"
		good=1
	done <expected >>difference
	[ "$(wc -l <found)" = "$n" ] && [ $good = 0 ] && { [ $n = 0 ] || [ $status = 1 ]; }
	report "$1" $? err
}

says() {
	grep -qxF -- "$2" out
	report "$1: $2" $? out
}

check many.in <<'END'
units sj
atom_style granular
boundary f f
regio a block 0 1 0 1 0 1
region bx blok 0 1 0 1 0 1 units box
create_box 2 bx
create_atoms 1 random 10 7 bx
variable k equal 2+
variable n loop 3
label again
fix 1 all gravty 9.81 vector 0 0 -1
fix 2 all gravity 9.81 vector 0 0
fix 3 sme nve
compute c1 all kee
variable e equal c_c1*2
thermo_style custom step c_c1 v_e foo bar
timestep ${k}
print "energy ${e}"
run 100
next n
jump SELF again
jump SELF nowhere
if "${k} > 2" then "prnt hello" "run 10" else "fix 4 all gravity x"
dump d all custom 10 many.in/x.dump id x y z
pair_style spring/dashpot
pair_coeff * * stifness 2
unfix 1
unfix 9
print a
quit
group x typ 1
END
errors 'all errors at once' <<'END'
1:7: units: system is 'sj'
3:1: boundary: z is missing
4:1: unknown command 'regio'; did you mean 'region'?
5:11: unknown region style 'blok'
11:11: unknown fix style 'gravty'
12:11: z is missing
13:7: there is no group 'sme'
14:16: unknown compute style 'kee'
16:35: unknown quantity 'foo'
16:39: unknown quantity 'bar'
8:19: expected a number or a name
22:11: there is no 'label nowhere'
23:21: unknown command 'prnt'
23:66: expected a number or v_name
24:22: 'many.in' is not a folder that can be written to
26:16: unknown keyword 'stifness'
28:7: there is no fix '9'
31:9: group: style is 'typ'
END

ball="region b block 0 1 0 1 0 1 units box
create_box 1 b
create_atoms 1 single 0.5 0.5 0.5 units box
set type 1 diameter 0.1 density 2385"

check good.in <<END
$ball
shell mkdir made
fix m all nve
variable n loop 3
label again
run 100
next n
jump SELF again
if "\$(ke) > 0" then "print 'it moves'" else "jump SELF rest"
print "moved" file made/print.txt
label rest
dump d all custom 50 made/*.dump id x
restart 100 made/a.restart made/b.restart
run 10
write_restart made/end.restart
print "e" append log.extra
log new.log
END
errors 'nothing to complain of' </dev/null
[ "$(ls)" = "$(printf '%s\n' difference err expected found good.in many.in out)" ]
report 'nothing is written or made' $?
says trace '  good.in:9            run 3 times, 300 steps in all of 0.005 from step 0'
says trace '  good.in:11           jump SELF again: taken 2 times'
says trace '  good.in:12           if: any branch; depends on ke, which is known only in a run'
says trace '  good.in:16           dump restart made/a.restart'
says trace '  good.in:18           write_restart made/end.restart'
says trace '  good.in:5            shell mkdir made'
says trace 'no errors'
[ $status = 0 ]
report 'exit status 0' $?

check loops.in <<END
$ball
fix m all nve
label two
run 5
if "\$(ke) > 0.5" then "jump SELF fin"
jump SELF two
label fin
label three
run 7
if "\$(ke) < 0.5" then "jump SELF three"
variable i loop 2000
label four
next i
jump SELF four
label never
jump SELF never
END
errors 'loops that do not end' </dev/null
each='; at least one iteration, their number is known only in a run'
says 'a loop that a run ends' "  loops.in:7           run 5 steps in each iteration of lines 6-9, of 0.005 from step 0$each"
says 'a loop that a run ends' "  loops.in:12          run 7 steps in each iteration of lines 11-13, of 0.005 from step 10 or later$each"
says 'a loop that a run ends' '  loops.in:13          if: any branch; depends on ke, which is known only in a run'
says 'a long loop that runs nothing' '  loops.in:17          jump SELF four: taken 1999 times'
says 'an endless loop' '  loops.in:19          jump SELF never: taken 999 times, not followed further: the loop seems to have no end'

# a loop of many turns is gone through until it reaches no new lines, and the rest is counted
check turns.in <<END
$ball
fix m all nve
variable i loop 1000
label o
variable j loop 3
label n
run 10
next j
jump SELF n
next i
jump SELF o
variable a equal 0
label w
variable a equal \${a}+1
run 5
if "\${a} < 5" then "jump SELF w"
variable b equal 0
label v
variable b equal \${b}+1
run 7
if "\${b} < 50" then "jump SELF v"
run 20 upto
variable i loop 2
print "\$i"
END
errors 'many turns' </dev/null
says 'many turns' '  turns.in:10          run 3000 times, 30000 steps in all of 0.005 from step 0'
says 'many turns' '  turns.in:14          jump SELF o: 1000 iterations; 2 executed, the others counted like the last'
says 'few turns' '  turns.in:18          run 5 times, 25 steps in all of 0.005 from step 30000'
says 'turns that a formula ends' "  turns.in:23          run 7 steps in each iteration of lines 21-24, of 0.005 from step 30025$each"

# what scripts of LIGGGHTS do with values that only a run can give; it runs, too
cat >head.in <<'END'
atom_style granular
boundary f f f
newton off
communicate single vel yes
units si
region reg block -0.05 0.05 -0.05 0.05 0 0.15 units box
create_box 1 reg
neighbor 0.002 bin
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.3
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
timestep 0.00001
fix gravi all gravity 9.81 vector 0 0 -1
fix zwall all wall/gran model hertz tangential history primitive type 1 zplane 0
fix pts1 all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.004
fix pdd1 all particledistribution/discrete 15485867 1 pts1 1
region bc block -0.03 0.03 -0.03 0.03 0.05 0.14 units box
fix ins all insert/pack seed 32452843 distributiontemplate pdd1 vel constant 0 0 -0.5 &
	insert_every once overlapcheck yes all_in yes particles_in_region 100 region bc
fix integr all nve/sphere
compute 1 all erotate/sphere
fix ave all ave/time 10 5 100 c_1
run 1
END
check idioms.in <<END
include head.in
variable n equal count(all)
variable inv equal 1/count(all)
variable top equal bound(all,zmax)
variable h equal \${top}+0.01
variable m equal mass(all)
print "there are \${n}, 1/n = \${inv}, vz \$(vcm(all,z)), top \$(bound(all,zmax):%.3f)"
variable s string \${top}
region upper block INF INF INF INF 0.01 \${h} units box
group up region upper
variable k equal \$(vcm(all,x))/v_n+f_ave*c_1+x[3]+v_m
variable k2 equal (v_k>1||1)*(v_k&&0)
if "\${n} > 100" then "print many" else "print 'few \${s} \$k'"
if "\${k2} == 1" then "print 'not unknown'"
variable word string at_\${top}
if "\${word} == at_1" then "print 'any'" else "print 'branch'"
variable turn equal 0
label loop
run 100
variable kin equal 0*ke
variable turn equal \${turn}+1
if "\${kin} < 1e-9 && \${turn} > 2" then "jump SELF break"
if "\${n} > 10000" then quit
jump SELF loop
label break
unfix ins
variable i loop 3
label again
run 20
next i
jump SELF again
if "\$(bound(up,zmax)) > \${h}" then "variable dz equal 1" "fix pull all addforce 0 0 0" &
elif "\${n} == 0" "variable dz equal 2" else "variable dz equal \${s}"
run \$(ceil(v_dz))
write_restart post.restart
variable lines file made.txt
clear
read_restart post.restart
END
errors 'idioms of LIGGGHTS' <<'END'
36:21: cannot open 'made.txt'
END
sed '/made.txt/d' idioms.in >idioms.run
"$TSIM" -check -in idioms.run >out 2>err
report 'idioms that -check accepts' $? err
says 'idioms' "  idioms.run:19        run 100 steps in each iteration of lines 18-24, of 1e-05 from step 1$each"
says 'idioms' '  idioms.run:16        if: any branch; depends on bound, which is known only in a run'
says 'idioms' '  idioms.run:34        run a number of steps that is known only in a run, each of 1e-05 from step 261 or later; depends on dz, which is known only in a run'
"$TSIM" -in idioms.run -log none >out 2>err
report 'they run' $? err
"$TSIM" -explain -in idioms.run -log none >out 2>err
report '-explain goes the same way' $? err
grep -q '^All runs together: at least .*that depend on results are unknown' out && grep -q '^there are (unknown), 1/n = (unknown)' out
report '-explain says what it does not know' $? out

# a verdict on an unknown value is unknown, and so is what follows from it; one on a known value is known
cat >verdict.in <<'END'
include head.in
variable value equal ke
variable one equal 1
variable verdict string off
if "abs(${value}-1) <= 0.1" then "variable verdict string ok"
print "RESULT energy ${value:%.6g} 1 0.1 ${verdict}"
if "${verdict} == ok" then "variable all string fine" else "variable all string poor"
print 'and all is ${all}'
variable verdict string off
if "abs(${one}-1) <= 0" then "variable verdict string ok"
print "RESULT one ${one} 1 0 ${verdict}"
if "${value} > 1e9" then "print more" elif "${all} == fine" "variable verdict string off"
print "RESULT both ${verdict}"
variable verdict string off
print "RESULT set ${verdict}"
END
"$TSIM" -explain -in verdict.in -log none >out 2>err
report 'verdicts' $? err
grep -E '^(RESULT|and)' out >lines
printf '%s\n' 'RESULT energy (unknown) 1 0.1 (unknown)' 'and all is (unknown)' 'RESULT one 1 1 0 ok' 'RESULT both (unknown)' 'RESULT set off' >expected
same 'verdicts on unknown values' expected lines
"$TSIM" -in verdict.in -log none >out 2>err
grep -E '^(RESULT|and)' out >lines
sed -i 's/energy [^ ]*/energy/' lines
printf '%s\n' 'RESULT energy 1 0.1 off' 'and all is poor' 'RESULT one 1 1 0 ok' 'RESULT both ok' 'RESULT set off' >expected
same 'verdicts of a run' expected lines

# all branches are checked by what they name, too; what one takes away may be there
check branches.in <<END
include head.in
if "\$(ke) > 0" then "fixx" "fix g2 all gravity 9.8 vector 0 0 -1" else "unfix nosuch" "compute q all nokind"
if "\$(ke) > 1" then "unfix ins" else "variable z equal 3"
if "\$(ke) > 2" then "unfix ins"
unfix g2
variable file equal floor(ke)
include part.\${file}
variable y equal v_z*2+f_zwal
print \${y}
group g\${file} typ 1
END
errors 'all branches' <<'END'
2:22: unknown command 'fixx'
2:79: there is no fix 'nosuch'
2:102: unknown compute style 'nokind'
8:24: there is no fix 'zwal'
10:16: group: style is 'typ'
END

# what acts later is read before the first step: by -check and by a run
scene="$ball
fix m all nve
compute pp all property/atom x
compute all all ke"

# early WHAT PLACE MESSAGE: the lines on standard input are refused so by both, without a step
early() {
	{ echo "$scene" && cat; } >early.in
	good=0
	for how in -check -screen; do
		"$TSIM" $how $([ $how = -check ] || echo none) -in early.in -log early.log 2>err >out </dev/null && good=1
		[ "$(grep -c 'error: ' err)" = 1 ] && grep -q "^early.in:$2: error: .*$3" err || good=1
		[ $how = -check ] || ! grep -q '^ *5 ' early.log || good=1
	done
	report "$1" $good err
}
early 'a column of thermo_style' 8:26 "unknown quantity 'foo'" <<'END'
thermo_style custom step foo
run 10
END
early 'a shape in thermo_style' 8:26 'numbers of particles' <<'END'
thermo_style custom step c_pp
run 10
END
early 'a shape in a variable' 8:18 'no scalar' <<'END'
variable n equal c_pp
run 10
END
early 'a command of run every' 8:21 "unknown command 'prnt'" <<'END'
run 10000 every 10 "prnt x"
END
early 'a style in run every' 8:31 "unknown fix style 'gravty'" <<'END'
run 10000 every 10 "fix g all gravty 3"
END
early 'a variable in run every' 8:27 "unknown variable 'z'" <<'END'
run 10000 every 10 "print ${z}"
END
early 'a formula in run every' 8:29 'no scalar' <<'END'
run 10000 every 10 "print $(c_pp)"
END
early 'a formula of a fix' 8:18 "no compute 'nope'" <<'END'
variable w equal c_nope
fix a all ave/time 5000 1 5000 v_w
run 10000
END
early 'a formula of thermo_style' 9:18 "no compute 'nope'" <<'END'
thermo_style custom step v_w
variable w equal c_nope
thermo 5000
run 10000
END
early 'a condition within run every' 8:29 "no compute 'nope'" <<'END'
run 10000 every 5000 "if '$(c_nope) > 1' then 'print x'"
END
early 'a command of if within run every' 8:52 "unknown variable 'z'" <<'END'
run 10000 every 5000 "if '$(ke) > 1e9' then 'print ${z}' else 'print y'"
END
early 'an if in an if within run every' 8:56 "unknown variable 'z'" <<'END'
run 10000 every 5000 "if $(ke)>1 then 'if $(ke)>2 then $z'"
END
early 'an elif within run every' 8:60 'no scalar' <<'END'
run 10000 every 5000 "if '$(ke) < 0' then 'print x' elif $(c_pp) 'print z'"
END
early 'if without then within run every' 8:38 "expected 'then'" <<'END'
run 10000 every 5000 "if '$(ke) < 0' 'print x' 'print y'"
END
early 'a variable in fix print' 8:28 "unknown variable 'nope'" <<'END'
fix p all print 5000 "then ${nope}"
run 10000
END
early 'a formula in fix print' 8:30 'no scalar' <<'END'
fix p all print 5000 "then $(c_pp)"
run 10000
END
early 'a variable of a variable in fix print' 8:18 "no compute 'nope'" <<'END'
variable w equal c_nope
fix p all print 5000 "then ${w}" screen no
run 10000
END
{ echo "$scene"; cat; } >later.in <<'END'
fix p all print 10 "q is ${q} and $(random(0,1,7):%.6f)"
variable debug equal 0
run 20 every 5 "variable q equal step" "if '${debug} == 1' then 'print ${none}'" "compute new all ke" &
	"print $(c_new)" "uncompute new"
END
"$TSIM" -check -in later.in >out 2>err && timeout 20 "$TSIM" -in later.in -log none >out 2>err && grep -q '^q is 10 and' out &&
	grep -q '^q is 20 and' out && [ "$(grep -c '^q is' out)" = 2 ]
report 'fix print of a variable that run every defines' $? err
printf '%s\n' "$scene" 'thermo_style custom step c_later v_w' 'variable w equal c_later*2' 'compute later all ke' \
	'run 20 every 5 "variable q equal ke" "print $q" "reset_timestep 0"' >late.in
"$TSIM" -check -in late.in >out 2>err && timeout 20 "$TSIM" -in late.in -log none >out 2>err &&
	[ "$(grep -cx '0' out)" = 4 ]
report 'what is defined in time, and steps counted anew' $? err
printf '%s\n' "$scene" 'run 20 every 5 "clear"' >clear.in
timeout 20 "$TSIM" -in clear.in -log none >out 2>err
[ $? = 1 ] && grep -q '^clear.in:8:14: error: run: .*`clear`' err
report 'clear in run every' $? err

check follow.in <<'END'
region b block 0 1 0 1 0 one units box
create_box 2 b
create_atoms 1 single 0.5 0.5 0.5 units box
group two type 2
variable x equal nothing
variable y equal v_x+1
compute c two ke
fix f two wall/gran primitive type 1 xplane ${y}
fix a all ave/time 1 1 1 f_f
set type 1 diameter ${x}
bond_coeff 1 stiffness 1 ultimate 1
unfix f
run 10
END
errors 'no error that only follows' <<'END'
1:26: zhi is 'one', expected a number, INF or EDGE
5:18: unknown name 'nothing'
END
shows 'left out' out
report 'says that messages were left out' $? out

# nor a warning that follows from a value known only in a run; one of known values stays
check guess.in <<'END'
region b block 0 0.5 0 0.5 0 0.5 units box
create_box 1 b
create_atoms 1 single 0.1 0.1 0.1 units box
set type 1 diameter 0.1
fix move all nve/sphere
timestep 1e-5
run 10
variable top equal bound(all,zmax)+0.1
create_atoms 1 single 0.1 0.1 ${top} units box
create_atoms 1 single 0.1 0.1 0.7 units box
run 10
END
shows 'no errors' out && shows 'guess.in:10: warning: (0.1 0.1 0.7) lies outside the box' out && ! grep -q 'guess.in:9' out err
report 'no warning that only follows' $? out
shows '1 message was left out that depends' out
report 'counts the warning that was left out' $? out

# what no number makes right stays an error behind a fix that has read an unknown variable, and beside unknown words
cat >known <<'END'
region b block 0 1 0 1 0 1 units box
create_box 1 b
group g empty
variable push equal ke(all)
fix add all addforce v_push 0 0
compute k g ke
region hole sphere 0.5 0.5 0.5 0.1 units box
compute c all reduce/region hole sum vx
thermo_style custom step c_c
run 20
region wide block 0 $(ke) 0 1 0 1 units box
END
while read -r place text; do
	{ cat known && echo "$text"; } | sed 's/; /\n/' >in.known
	read -r message
	check conflict.in <in.known
	errors "$text, behind unknown values" <<<"$place $message"
done <<'END'
12:8: region b block 0 0.5 0 1 0 0.4 units box
there is a region 'b' already
12:8: region wide block 0 1 0 1 0 1 units box
there is a region 'wide' already
12:1: group g delete
group 'g' is in use by compute k
12:13: fix add all gravity 9.81 vector 0 0 -1
fix id 'add' is already in use by style addforce
12:1: create_box 1 b
there is a simulation box already
8:15: region hole delete; run 1
compute c uses region hole
END

# unless what there is depends on them
check perhaps.in <<'END'
region b block 0 1 0 1 0 1 units box
create_box 1 b
region r1 block 0 1 0 1 0 1 units box
fix f1 all nve
group g1 empty
run 20
if "$(ke) > 1" then "region r1 delete"
region r1 block 0 2 0 1 0 1 units box
region r$(ke) block 0 2 0 1 0 1 units box
region n$(ke) block 0 2 0 1 0 1 units box
region n$(temp) block 0 2 0 1 0 1 units box
region q block 0 1 0 1 0 1 units box
region q$(ke) delete
if "$(ke) > 1" then "region s block 0 1 0 1 0 1" else "region s sphere 0 0 0 1"
fix f$(ke) all gravity 9.81 vector 0 0 -1
END
errors 'none that an unknown name makes' <<'END'
END

# a lost name in quotes does not make an error one that follows: it must be what is missing
check alike.in <<'END'
variable stif equal 1 2
region b block 0 1 0 1 0 1 units box
create_box 1 b
pair_style spring/dashpot
pair_coeff * * stif 2385 restitution 0.5
compute stif all ky
END
errors 'misspelt words that are like a lost name' <<'END'
1:23: a variable of style equal takes one word
5:16: unknown keyword 'stif'
6:18: unknown compute style 'ky'
END

printf 'units si\nprnt\nunits sj\n' | "$TSIM" -check >out 2>err
[ $? = 1 ] && [ "$(grep -c '^stdin:' err)" = 2 ]
report 'standard input' $? err

printf 'include other.in\ninclude missing.in\nfixx\n' >outer.in
printf 'fix\nlabel a\nprint x\n' >other.in
"$TSIM" -check -in outer.in >out 2>err
[ "$(grep -c error: err)" = 3 ] && grep -q '^other.in:1:' err && grep -q "^outer.in:2:9: .*'missing.in'" err
report 'included scripts' $? err

# what is refused does not hang what follows
printf '%s\n' 'region box block -1 1 -1 1 -1 1 units box' 'create_box 1 box' 'lattice sc 0.1' 'create_atoms 1 box' \
	'set group all diameter 0.1 density 1' 'bond_style parallel' 'create_bonds gap all all 1 1e-6' \
	'bond_coeff 1 E 1e8 ratio 2.5 sigma_c 2e5 tau_c 2e5 scatter normal seed 4711' 'fix m all nve/sphere' 'run 1' >in.scatter
timeout 60 "$TSIM" -check -in in.scatter >out 2>err
[ $? = 1 ] && grep -q 'in.scatter:8:.* expected .deviation.' err
report 'scatter normal without a deviation' $? err

# numbers are judged where there are no particles yet
printf '%s\n' 'region box block -1 1 -1 1 -1 1 units box' 'create_box 2 box' 'group g empty' 'set group g diameter -0.01' >in.set
refused 'a negative diameter of nobody' 'set: diameter is -0.01, expected a number > 0' -check -in in.set
refused 'a negative diameter of nobody, run' 'set: diameter is -0.01, expected a number > 0' -in in.set
printf '%s\n' 'region box block -1 1 -1 1 -1 1 units box' 'create_box 2 box' 'set type 3 diameter 0.01' >in.set
refused 'a type that does not exist' 'set: there are 2 types of particles, found 3' -check -in in.set

# lengths that follow from steps, times and speeds
printf '%s\n' 'units si' 'region box block 0 1 0 1 0 1 units box' 'create_box 1 box' 'timestep 1e-5' \
	'fix t all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.025' \
	'fix mix all particledistribution/discrete 32452867 1 t 1' \
	'fix face all mesh/surface/planar primitive plate length 0.4 width 0.4 move 0.5 0.5 0.9 type 1' >in.stream
for every in 'insert_every 100' 'insert_every 100 extrude_length 0.2'; do
	printf '%s\n' 'include in.stream' "fix i all insert/stream seed 86028157 distributiontemplate mix nparticles 60 particlerate 5000 $every overlapcheck yes vel constant 0 0 -1 insertion_face face" \
		'fix m all nve/sphere' 'run 1' >in.short
	text='the space behind the face is 0.001 long, expected at least 0.05'
	[ "$every" = 'insert_every 100' ] || text='expected one of insert_every and extrude_length, found both'
	refused "$every, -check" "$text" -check -in in.short
	refused "$every" "$text" -in in.short
done

# Keywords of a fluid that is not there, in columns, variables, texts and commands of a run; a body force that was deleted.
box='units si
region b block 0 1 0 1 0 1
create_box 1 b
timestep 1e-4'
fluid='flow_style projection cells 4 4 4 viscosity 1 density 1'
n=0
while IFS='|' read -r lines text; do
	n=$((n + 1))
	printf '%s\n%b\n' "$box" "$lines" >in.$n
	refused "-check: $lines" "$text" -check -in in.$n
	refused "$lines" "$text" -in in.$n
done <<'END'
thermo_style custom step flow_ke\nrun 2|keyword flow_ke needs a fluid
variable e equal 2*flow_ke\nfix a all ave/time 1 1 1 v_e\nrun 2|keyword flow_ke needs a fluid
fix p all print 1 "$(flow_px)"\nrun 2|keyword flow_px needs a fluid
run 2 every 1 "print '$(flow_cfl)'"|keyword flow_cfl needs a fluid
variable g equal 1\nflow_style projection cells 4 4 4 viscosity 1 density 1 body_force v_g 0 0\nvariable g delete\nrun 2|unknown variable 'g'
END
printf '%s\nvariable e equal 2*flow_ke\nfix p all print 1 "$(v_e)"\nif "1 < 0" then "print $(flow_ke)"\n%s\nrun 1\n' "$box" "$fluid" >in.later
"$TSIM" -check -in in.later >out 2>&1 && "$TSIM" -in in.later -log none >out 2>&1
report 'a fluid that is defined after them' $? out

for deck in drilling; do
	cp "$top_srcdir"/examples/$deck/in.* .
	"$TSIM" -check -in in.$deck >out 2>err
	report "examples/$deck has no errors" $? err
done
cp -r "$top_srcdir"/examples/{flow,film,everyday,rock,polishing} .
for deck in flow/*/in.* film/in.* everyday/in.* rock/in.* polishing/in.{wafer,gap,paml,stribeck}; do
	(cd "${deck%/*}" && "$TSIM" -check -in "${deck##*/}") >out 2>err
	report "examples/$deck has no errors" $? err
	! grep -E 'created no bond|has no particles|never used' out >found
	report "examples/$deck is not warned of what runs have not made, nor of names" $? found
done

# A number in place of one that only a run can give: what would follow from it is no warning of the run after.
check guessed.in <<'END'
units si
boundary p p f
atom_style granular
newton off
region box block 0 25e-6 0 25e-6 -20e-6 50e-6 units box
create_box 1 box
timestep 1e-9
fix pad all surface/voxel gaussian mean 10.5e-6 deviation 4.7e-6 correlation 0 seed 1 type 1 cells 25 25
compute press all surface/contact pad winkler 1e12 pressure 4e4
run 0
variable face equal $(c_press[1])
create_atoms 1 single 5e-6 5e-6 30e-6 units box
set atom 1 diameter 1e-6 density 2000
fix m1 all property/global youngsModulus peratomtype 5e8
fix m2 all property/global poissonsRatio peratomtype 0.2
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.3
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
pair_style gran model hertz tangential history
pair_coeff * *
fix i all nve/sphere
fix wafer all wall/gran model hertz tangential history primitive type 1 zplane ${face}
run 1
END
[ $status = 0 ] && ! grep warning out err
report 'no warning of a wall whose place only a run gives' $? out
says 'it is told' '1 message was left out that depends on values known only in a run'
sed -i 's/zplane ${face}/zplane 1/' guessed.in
"$TSIM" -check -in guessed.in >out 2>err </dev/null
grep -q 'guessed.in:21: warning: this wall is at distance 0.99995 from the box' out
report 'a wall that is given there is warned of' $? out

# After an error the rest is read, not gone through: loops may have lost their end, and particles their size.
check lost.in <<END
$ball
fix m all nve
variable count loop abc
label on
run 10
next count
jump lost.in on
variable n loop 300
label again
variable v\$n equal 1
next n
jump SELF again
print "\${v250}"
fix g all gravty
END
errors 'loops behind an error' <<'END'
6:21: expected a whole number, found 'abc'
17:11: unknown fix style 'gravty'
END
says 'loops behind an error' '  lost.in:10           jump lost.in on: taken 19 times, not followed further'
check again.in <<END
units si
$ball
variable n loop 3
next n
variable n delete
jump SELF
END
errors 'a jump to the first line' <<'END'
1:1: units must come before
END
[ "$(sed -n 's/.*jump SELF: .* \([0-9]*\) executed.*/\1/p' out)" -le 110 ]
report 'a jump to the first line is followed a few times' $? out
# 50 million pairs of particles that have kept the diameter 1
(
	ulimit -v 1500000
	check unset.in <<'END'
boundary f f f
region b block 0 1 0 1 0 1 units box
create_box 1 b
create_atoms 1 random 10000 7 b
set type 1 diameter 0.001 density 2500 0.5
pair_style spring/dashpot
pair_coeff * * stiffness 1 restitution 0.5
fix m all nve
timestep 1e-9
run 10
END
	exit $status
)
status=$?
errors 'the contacts of a scene that lacks a line are not searched' <<'END'
5:40: set: unknown keyword '0.5'
END

# In a branch of which it is unknown whether it is taken: a word that is no name; but not one that may be defined later.
check branch.in <<END
$ball
fix m all nve
run 1
if "\$(ke) > 1" then "variable a equal ke+nan" else "variable a equal ke"
if "\$(ke) > 1" then "variable b equal c_late+v_later+f_latest[1]" else "variable b equal 0"
print "\${a} \${b}"
END
errors 'formulas of variables of branches' <<'END'
7:42: unknown name 'nan'
END
finish
