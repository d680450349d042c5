#!/bin/bash
# Files that a continued run appends to: a run from the last restart file adds rows behind the others, without a word; one from
# an older restart file writes rows that are there already, and each file is named by a warning. Restart files are written after
# what other outputs write, although the script defines them first.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >scene <<'END'
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
fix m4 all property/global coefficientFriction peratomtypepair 1 0.05
pair_style gran model hertz tangential history
pair_coeff * *
fix move all nve/sphere
fix down all gravity 9.81 vector 0 0 -1
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0
timestep 1e-5
restart 500 at.*
variable e equal ke
variable s equal step
compute k all ke
compute layer all chunk/atom bin/1d z lower 0.25 units box
fix lines all print 50 "$s $e" append lines.txt screen no
fix words all print 50 "energy $e at $s" append words.txt screen no
fix times all ave/time 10 5 50 c_k append times.txt
fix table all ave/time 10 5 50 c_k append table.csv
fix chunks all ave/chunk 10 5 50 layer vz append chunks.txt
fix lags all ave/correlate 10 5 50 c_k c_k append lags.txt
fix counts all ave/histo 10 5 50 -1 1 4 vz mode vector append counts.txt
fix books all energy/ledger every 50 append books.txt
dump grains all custom 50 grains.txt id x y z
dump_modify grains append yes
dump xyz all xyz 50 grains.xyz
dump_modify xyz append yes
thermo 500
END
cat >in.first <<'END'
units si
atom_style sphere
boundary f f f
region box block 0 1 0 1 0 1
create_box 1 box
neighbor 0.02 bin
create_atoms 1 single 0.3 0.5 0.0505
create_atoms 1 single 0.6 0.5 0.2
set group all diameter 0.1 density 2385
include scene
run 1000
END
printf 'read_restart at.1000\ninclude scene\nrun 500\n' >in.on
printf 'read_restart at.500\ninclude scene\nrun 500\n' >in.again
files='lines.txt times.txt table.csv chunks.txt lags.txt counts.txt books.txt grains.txt grains.xyz'

# runs SCRIPT WORDS...: it does; what it says is in `said`
runs() {
	local script=$1
	shift
	"$TSIM" -in "$script" -log none "$@" >said 2>&1 </dev/null
	report "$script $*" $? said
}

# silent WHAT: no warning of rows that are there twice
silent() {
	! grep -q 'already, as of a run' said
	report "$1" $? said
}

runs in.first
silent 'a first run'
[ "$(grep -c '^[0-9]' times.txt)" = 20 ]
report 'rows of the first run' $? times.txt
mkdir kept && cp -- *.txt *.csv *.xyz at.500 kept
runs in.on
silent 'a run that goes on'
[ "$(grep -c '^[0-9]' times.txt)" = 30 ]
report 'rows of both' $? times.txt
[ "$(grep -c 'TIMESTEP' grains.txt)" = 31 ]
report 'frames of both' $? grains.txt
cp kept/* .
runs in.again
for file in $files; do
	grep -q "warning: '$file' has [a-z]* up to step 1000 already" said
	report "again: $file" $? said
done
! grep -q "'words.txt' has" said
report 'lines that do not begin with the step' $? said
cp kept/* .
runs in.again -threads 2
[ "$(grep -c 'already, as of a run' said)" = "$(wc -w <<<"$files")" ]
report 'a warning for each file' $? said
# steps that are counted anew
sed 's/^include/reset_timestep 0\n&/' in.again >in.anew
runs in.anew
silent 'steps that are counted anew'
# the file was removed, or another one is written: nothing is there twice
rm -f -- *.txt *.csv *.xyz
runs in.again
silent 'new files'
finish
