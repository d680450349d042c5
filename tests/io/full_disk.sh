#!/bin/bash
# A disk that fills up while something is written: the run stops with the name of the file and the reason,
# and what was written before is whole. Also a limit of file size, and a reader of the screen that goes.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# 30 balls fly; enough to write for all of these
cat >scene <<'END'
units si
boundary p p p
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 random 30 86028157 box
set type 1 diameter 0.01 density 1000
velocity all set 1.3 0.2 0.1
pair_style spring/dashpot
pair_coeff * * stiffness 100 restitution 0.5
bond_style contact
bond_coeff 1 stiffness 10 ultimate 1e-9
fix move all nve
timestep 1e-4
thermo 10000
compute k all ke
variable long equal step
END
text=$(head -c 300 /dev/zero | tr '\0' x)

# case WHAT FILE LINE...: the lines make a run write too much to the file
full() {
	local what=$1 file=$2 limit_text=$3
	shift 3
	rm -f out.*
	{
		echo "include scene"
		printf '%s\n' "$@"
	} >in.full
	for how in "${ways[@]}"; do
		rm -rf small/* out.*
		"$how" "$file" -in in.full >out 2>err
		[ $? = 1 ] && grep -qE -- "$limit_text" err
		report "$what: $how" $? err
	done
}

# the file may have 24 kB
file_size() {
	local file=$1
	shift
	(
		ulimit -f 24
		exec "$TSIM" -var file "$file" -log none -screen none "$@"
	)
}
# the disk has 40 kB
disk() {
	local file=$1
	shift
	"$TSIM" -var file "small/$file" -log none -screen none "$@"
}
ways=(file_size)
mkdir small
if mount -t tmpfs -o size=40k tmpfs small 2>/dev/null; then
	trap 'umount "$work/small"; rm -rf "$work"' EXIT
	ways+=(disk)
else
	echo 'no small disk can be mounted here: limits of file size only'
fi
reason='(File too large|No space left on device)'

full dump out.dump "out.dump' failed: $reason" 'dump d all custom 1 ${file} id x y z' 'run 1000'
full 'compressed dump' out.gz "out.gz' failed" 'dump d all custom 1 ${file} id x y z' 'run 3000'
full 'dump of bonds' out.bonds "out.bonds' failed: $reason" 'create_bonds many all all 1 0 0.4' \
	'compute b all bonds' 'dump d all local 1 ${file} c_b[1] c_b[2] c_b[4]' 'run 100'
full 'dump for ParaView' 'out.*.vtp' "out.0.vtp' failed: $reason" 'create_atoms 1 random 3000 7 box' \
	'set group all diameter 1e-3' 'timestep 1e-7' 'dump d all custom/vtk 1 ${file} id vx vy vz' 'run 10'
full 'dump of a fluid' 'out.*.vti' "out.0.vti' failed: $reason" \
	'flow_style projection cells 16 16 16 viscosity 1 density 1' 'variable u equal random(0,1,7)' \
	'flow_set velocity v_u 0 0' 'dump d all flow/vtk 1 ${file}' 'run 10'
full 'dump of pictures' 'out.*.ppm' "out.0.ppm' failed: $reason" 'dump d all image 1 ${file} type type' 'run 10'
full write_dump out.dump "out.dump' failed: $reason" 'create_atoms 1 random 3000 7 box' \
	'write_dump all custom ${file} id x y z'
full write_data out.data "out.data' failed: $reason" 'create_atoms 1 random 3000 7 box' \
	'write_data ${file}'
full 'a restart file' out.restart "out.restart' failed: $reason" 'create_atoms 1 random 3000 7 box' \
	'write_restart ${file}'
full 'restart files in a run' out.restart "out.restart' failed: $reason" \
	'create_atoms 1 random 3000 7 box' 'set group all diameter 1e-3' 'timestep 1e-7' 'dump d all restart 5 ${file}' \
	'run 100'
full thermo_log out.thermo "out.thermo' failed: $reason" 'thermo 1' 'thermo_log ${file}' 'run 3000'
full 'fix print' out.print "out.print.* $reason" "fix p all print 1 '$text' file \${file} screen no" \
	'run 3000'
full print out.text "out.text.* $reason" 'label a' "print '$text' append \${file}" 'jump SELF a'
full 'averages' out.ave "out.ave' failed: $reason" 'fix a all ave/time 1 1 1 c_k file ${file}' 'run 5000'
full 'broken bonds' out.broken "out.broken' failed: $reason" 'create_atoms 1 random 60 7 box' \
	'variable u atom random(-1,1,5)' 'velocity all set v_u 0 0' 'set group all diameter 0.01' 'timestep 1e-6' \
	'create_bonds many all all 1 0 0.4' 'fix b all bond/breakage file ${file}' 'run 3000'

# what is there is whole up to the last frame, and a run without limits begins with it
printf 'include scene\ndump d all custom 1 ${file} id x y z\nrun 1000\n' >in.full
file_size cut.dump -in in.full >out 2>err
"$TSIM" -in in.full -var file whole.dump -log none -screen none
head -c "$(stat -c %s cut.dump)" whole.dump >begin
same 'a dump up to the limit' begin cut.dump
awk '/^ITEM: ATOMS/ { left = 30; next } left && !/^ITEM/ { left-- } END { exit left != 0 }' cut.dump
report 'it ends with a whole frame' $?
for how in "${ways[@]}"; do
	rm -rf small/* out.*
	printf 'include scene\ndump d all custom 1 ${file} id x y z\nrun 3000\n' >in.full
	"$how" out.gz -in in.full >out 2>err
	mv small/out.gz . 2>/dev/null
	zcat out.gz 2>/dev/null | awk '/^ITEM: ATOMS/ { left = 30; n++; next } left && !/^ITEM/ { left-- } END { exit left != 0 || n < 10 }'
	report "a .gz dump ends with a whole frame: $how" $?
	printf 'include scene\nrerun out.gz dump x y z\n' >in.full
	"$TSIM" -in in.full -log none >out 2>err && ! grep -q 'is skipped' out && grep -qE 'Rerun of [1-9][0-9]+ frames' out
	report "and can be read: $how" $? err
done
rm -rf small/* out.*

# log and screen
printf 'include scene\nthermo 1\nrun 3000\n' >in.full
(ulimit -f 24 && exec "$TSIM" -in in.full -log out.log -screen none) >out 2>err
[ $? = 1 ] && grep -q "log file.*File too large" err
report 'a log that grows too large' $? err
(ulimit -f 24 && exec "$TSIM" -in in.full -log none -screen out.screen) >out 2>err
[ $? = 1 ] && grep -q "screen.*File too large" err
report 'a screen file that grows too large' $? err
"$TSIM" -in in.full -log none >/dev/full 2>err
[ $? = 1 ] && grep -q "screen.*No space left" err
report 'a screen that is full' $? err
"$TSIM" -in in.full -log pipe.log 2>err | head -n 12 >out
[ "${PIPESTATUS[0]}" = 1 ] && shows 'Broken pipe' err && shows 'Broken pipe' pipe.log
report 'a reader of the screen that goes' $? err

# places where nothing can be written
touch file
for what in 'dump d all custom 1 file/x id' 'write_restart file/x' 'write_data file/x' \
	'thermo_log file/x' "print a file file/x" 'fix a all ave/time 1 1 1 c_k file file/x' 'log file/x'; do
	printf 'include scene\n%s\nrun 2\n' "$what" >in.full
	"$TSIM" -in in.full -log none >out 2>err
	[ $? = 1 ] && grep -qE "file/x'.*(Not a directory|is no folder)" err
	report "$what" $? err
done
# An interrupt while files cannot grow ends at once: the state is not saved, what was written is kept, no rest of a file
# that could not be written is left.
rm -rf out.* small/*
mkdir inner
printf 'include scene\ndump d all custom 1000000000 out.frame id x y z\nrun 1000000000\n' >in.full
(
	ulimit -f 2
	exec timeout -k 20 -s INT 0.5 "$TSIM" -in in.full -log none -screen none -restart-on-signal inner/state
) 2>err
[ $? = 124 ] && shows 'stopped on request' err && grep -qE "inner/state.*$reason" err &&
	[ "$(grep -c . out.frame)" = 39 ] && [ -z "$(ls inner)" ]
report 'an interrupt when the state cannot be saved' $? err
finish
