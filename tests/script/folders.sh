#!/bin/bash
# Whatever is written makes its folder, and -check knows that; what is read does not.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
box='units si
region b block 0 1 0 1 0 1 units box
create_box 1 b
create_atoms 1 single 0.5 0.5 0.5 units box
set type 1 diameter 0.1 density 2385
fix m all nve'
printf '%s\n' "$box" 'variable x equal 2
fix p all print 10 "so" file new/print/deep/post.txt
fix a all ave/time 5 2 10 v_x file new/ave/c.txt
print "e" append new/text/x.txt
log new/log/log
dump d all custom 10 new/dump/x*.dump id x
dump v all custom/vtk 10 new/vtk/x*.vtk id x
write_restart new/restart/a.restart
restart 50 new/restarts/a*.restart
thermo_log new/thermo/log
run 100
write_data new/data/data
write_dump all custom new/frame/y.dump id
shell mkdir new/print' >in.all
"$TSIM" -check -in in.all >out 2>&1 </dev/null && shows 'no errors' out && [ ! -e new ]
report '-check knows that folders are made' $? out
"$TSIM" -in in.all -log none >out 2>&1 </dev/null
report 'folders are made' $? out
for file in print/deep/post.txt ave/c.txt text/x.txt log/log dump/x100.dump vtk/x100.vtk restart/a.restart \
	restarts/a50.restart thermo/log data/data frame/y.dump; do
	[ -s new/$file ]
	report "new/$file" $?
done
"$TSIM" -in in.all -log other/log -screen none >out 2>&1 </dev/null && [ -s other/log ]
report 'the log of the command line' $? out

# a file where a folder should be: by -check before, and when it is met
touch file
for line in 'dump d all custom 10 file/x*.dump id x' 'fix p all print 10 "so" file file/a/post.txt' \
	'print "e" file file/a.txt' 'write_restart file/a.restart'; do
	printf '%s\n' "$box" "$line" 'run 100' >in.file
	for way in '' -check; do
		# shellcheck disable=SC2086
		"$TSIM" $way -in in.file -log none >out 2>err </dev/null
		[ $? = 1 ] && cat out err | grep -q 'error: .*file/'
		report "$way $line" $? err
	done
done

# files to be read
for line in 'read_restart nothing/a.restart' 'include nothing/a.in' 'variable x file nothing/a.txt'; do
	rejects "$line" "nothing/a"
	! grep -q mkdir err
	report "no advice: $line" $? err
done
rejects "$box
fix f all mesh/surface file nothing/a.stl type 1" "there is no folder 'nothing'"
! grep -q mkdir err
report 'no advice for meshes' $? err

# scripts beside the one that names them are found from any working folder; those in the working folder come first
mkdir -p beside/parts
printf 'include parts/a\n' >beside/in.main
printf 'include b\ninclude c\n' >beside/parts/a
printf 'print "b beside a"\n' >beside/parts/b
printf 'print "c beside a"\n' >beside/parts/c
printf 'print "c here, n is ${n}"\n' >c
"$TSIM" -in beside/in.main -var n 7 -log none >out 2>&1 </dev/null && shows 'b beside a' out && shows 'c here, n is 7' out
report 'included scripts are found beside the script' $? out
"$TSIM" -sweep 'n=7,8' -in beside/in.main -results swept >out 2>&1 </dev/null
report 'a study knows the variables of such scripts' $? out
rejects 'include nowhere/at/all' "cannot open script 'nowhere/at/all': No such file"
# -check and -explain go with `shell cd` into folders that the run makes, and back.
prints 'shell mkdir post post/deep
shell cd post/deep
print "x" file a.txt
shell cd ../..
shell cd post
shell rm deep/a.txt
shell cd ..
shell rmdir post/deep
shell rmdir post
print "done"' done
"$TSIM" -check -in in.script -log none >out 2>&1 && grep -q 'no errors' out
report '-check of folders that are made' $? out
finish
