#!/bin/bash
# tsim -crosscheck with a stand-in for the other program: what is compared, what is said, the exit status.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

mkdir case
cd case || exit 99
cat >in.fall <<'END'
variable drop equal ${height}
include parts/in.material
region box block -1 1 -1 1 0 2 units box
create_box 1 box
create_atoms 1 single 0 0 ${drop} units box
set atom 1 diameter 0.1 density 2385
fix g all gravity 9.81 vector 0 0 -1
fix i all nve/sphere
thermo_style custom step atoms ke cpu
thermo 100
dump d all custom 100 post/d*.txt id x y z
variable z equal xcm(all,z)
fix p all print 100 "z ${z}" file z.txt screen no
timestep 1e-4
run 300
END
mkdir parts post
echo 'units si' >parts/in.material
echo old >post/d7.txt
touch before
# another program: tsim itself, after which an awk program may change what it wrote
cat >../peer <<'END'
#!/bin/sh
echo "$@" >>"$PEER_CALLS"
unset LD_PRELOAD # of stdbuf, which AddressSanitizer refuses
"$TSIM" "$@" -log none || exit 1
[ -z "$PEER_CHANGE" ] || sh -c "$PEER_CHANGE"
exit "${PEER_STATUS:-0}"
END
chmod +x ../peer
export PEER_CALLS=$work/calls PEER_CHANGE='' PEER_STATUS=0 TSIM

# crosscheck WHAT STATUS TEXT WORDS...: exit status and a line of what is said
crosscheck() {
	local what=$1 status=$2 text=$3
	shift 3
	"$TSIM" -crosscheck liggghts peer ../peer "$@" -in in.fall -var height 1.25 >../out 2>&1
	[ $? = "$status" ] && grep -qE -- "$text" ../out
	report "$what" $? ../out
}

crosscheck 'a program agrees with itself' 0 '^agree: [0-9]+ columns within 1e-06( |$)'
grep -qxF -- '-in in.fall -var height 1.25' "$work/calls"
report 'the variables are passed on' $? "$work/calls"
grep -qE '^z\.txt: 3 lines\>' ../out && grep -qE '^post/d\*\.txt: 4 steps\>' ../out &&
	grep -qE '^thermo: 4 steps, wall times not compared' ../out
report 'all outputs are compared' $? ../out
[ "$(find . -newer before -type f)" = '' ] && [ "$(cat post/d7.txt)" = old ]
report 'nothing is written where the user is' $?

PEER_CHANGE='sed -i "s/^1 0 0 .*/1 0 0 1.2/" post/d200.txt'
crosscheck 'a dump differs from some step on' 3 '^differ: z of post/d\*\.txt differs by more than 1e-06 of its range at step 200( |,|;|$)'
crosscheck 'but not by more than the tolerance' 0 '^agree' tolerance 1
crosscheck 'and its statistics are near' 0 '^agree: .* at step 200; statistics from there differ by at most' until 199 statistics 0.6
crosscheck 'or not near enough' 3 '^differ' until 199 statistics 0.001
crosscheck 'or it diverges too early' 3 '^differ' until 200 statistics 0.6
PEER_CHANGE='rm z.txt'
crosscheck 'a file is missing' 1 '^only tsim wrote z.txt'
PEER_CHANGE='echo 1 >more.txt'
crosscheck 'one too many' 1 '^only liggghts wrote more.txt'
PEER_CHANGE='sed -i "s/ATOMS id x y z/ATOMS id x y w/" post/*.txt'
crosscheck 'a column is missing' 1 '^failed: columns are missing'
PEER_CHANGE='rm post/d200.txt'
crosscheck 'one of many is missing' 1 '^only tsim wrote post/d200.txt'
PEER_CHANGE=': >z.txt'
crosscheck 'a file that the other program leaves empty' 0 '^left empty by liggghts, not compared: z.txt'
grep -q '^agree' ../out && ! grep -q '^z.txt' ../out
report 'is no difference' $? ../out
PEER_CHANGE=': >post/d200.txt'
crosscheck 'one of many that is empty' 0 '^left empty by liggghts, not compared: post/d200.txt'
grep -q '^post/d\*\.txt: 3 steps\>' ../out
report 'the others are compared' $? ../out
PEER_CHANGE='for f in post/*.txt; do sed -i "/^ITEM: NUMBER/{n;s/1/0/}; /^1 0 0/d" "$f"; done'
crosscheck 'frames that only one program leaves without rows' 3 '4 unmatched rows'
cp in.fall in.all
sed -i 's/^dump.*/group none empty\ndump d none custom 100 post\/d*.txt id x y z/' in.fall
PEER_CHANGE=''
crosscheck 'frames without rows in both programs' 0 '^post/d\*\.txt: 4 steps, empty in both'
sed 's/^run/compute e all pe\nfix a all ave\/time 100 1 100 c_e file e.txt\n&/' in.all >in.fall
PEER_CHANGE='sed -i "s/^\([0-9][0-9]*\) .*/\1 7/" e.txt'
crosscheck 'the elastic energy of contacts' 0 '^  c_e .* intended difference, see -help legacy'
sed -i 's/compute e all pe/compute e all ke/' in.fall
crosscheck 'another energy' 3 '^differ: c_e of e.txt'
mv in.all in.fall
PEER_CHANGE='echo ERROR: no such thing'
PEER_STATUS=3
crosscheck 'the other program fails' 1 'ERROR: no such thing'
crosscheck 'which is said' 1 '^failed: the other program did not complete the script'
PEER_STATUS=0 PEER_CHANGE=''
crosscheck 'all can be kept' 0 'files kept in run' keep run
[ -f run/tsim/post/d300.txt ] && [ -f run/liggghts.screen ] && [ ! -f run/tsim/post/d7.txt ]
report 'and is there' $?
crosscheck 'in a new folder' 1 "folder 'run' exists" keep run
crosscheck 'no such program' 2 "did you mean 'tolerance'" tolerence 1

"$TSIM" -crosscheck liggghts peer ../missing -in in.fall >../out 2>&1
[ $? = 4 ] && grep -q "program '../missing' not found" ../out
report 'the program is missing' $? ../out
PATH=/nowhere "$TSIM" -crosscheck lammps -in in.fall >../out 2>&1
[ $? = 4 ] && grep -q 'lammps is not installed: not found in the PATH: lmp, .*apt-get install lammps' ../out
report 'the program is not installed' $? ../out
echo 'run here' >in.wrong
"$TSIM" -crosscheck liggghts peer ../peer -in in.wrong >../out 2>&1
[ $? = 1 ] && shows "in.wrong:1:1: error:" ../out && grep -q '^failed: neither program completed the script' ../out
report 'the script is wrong' $? ../out
"$TSIM" -crosscheck liggghts peer ../peer -in in.none >../out 2>&1
[ $? = 1 ] && shows "in.none" ../out
report 'there is no script' $? ../out
"$TSIM" -crosscheck lamps -in in.fall >../out 2>&1
[ $? = 2 ] && shows "expected one of liggghts, lammps" ../out
report 'an unknown program' $? ../out
"$TSIM" -crosscheck liggghts >../out 2>&1
[ $? = 2 ] && shows 'needs a script' ../out
report 'no script' $? ../out
cd "$work" || exit 99
finish
