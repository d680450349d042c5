#!/bin/bash
# What doc/language.md says about scripts of somebody else holds: without options, with -shell yes, and with -sandbox,
# where the kernel helps and where it does not. Each sentence there has a case here that tries to break it.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

mkdir -p home/run home/script home/other
cd home/run || exit 99
echo 'secret 17' >../other/secret
echo 'units si' >../script/in.part
here=$(pwd -P)

# script LINES: runs them from the folder beside; what it says is in out and err
script() {
	printf '%s\n' "$1" >../script/in.script
	shift
	timeout -s KILL 60 "$TSIM" -in ../script/in.script "$@" >../out 2>../err </dev/null
}
# stops WHAT LINES TEXT OPTIONS: with a message that has the text
stops() {
	local what=$1 text=$3
	script "$2" "${@:4}"
	[ $? = 1 ] && shows "$text" ../err
	report "$what" $? ../err
}
# runs WHAT LINES OPTIONS
runs() {
	local what=$1
	script "$2" "${@:3}"
	report "$what" $? ../err
}
unharmed() {
	[ "$(cat ../other/secret)" = 'secret 17' ] && [ "$(ls ../other)" = secret ] && [ -d ../other ]
	report "$1: nothing has changed elsewhere" $?
}

# ---- without options: what removes, moves and sets obeys -shell
outside="below '$here', where tsim was started"
stops 'rm above' 'shell rm ../other/secret' "$outside"
stops 'rm with a full path' "shell rm $here/../other/secret" "$outside"
stops 'rmdir above' 'shell rmdir ../other' "$outside"
stops 'mv from above' 'shell mv ../other/secret here' "$outside"
stops 'mv to above' 'shell mv file ../other/file' "$outside"
stops 'after cd' $'shell cd ..\nshell rm other/secret' "$outside"
stops 'the folder itself' 'shell mv . ../moved' "$outside"
ln -s ../other link
stops 'rm through a link' 'shell rm link/secret' "$outside"
stops 'mv through a link' 'shell mv link/secret here' "$outside"
stops 'putenv' 'shell putenv TS_TEST=1' 'only with the option -shell yes'
stops 'a program' 'shell touch file' 'only with the option -shell yes'
stops 'checked too' 'shell rm ../other/secret' "$outside" -check
stops 'putenv, checked too' 'shell putenv TS_TEST=1' 'only with the option -shell yes' -check
unharmed 'without options'
runs 'mkdir and cd stay' $'shell mkdir ../made/deep\nshell cd ../made\nshell cd ../run\nshell mkdir sub'
runs 'a link goes itself' 'shell rm link'
[ ! -L link ] && [ -d ../other ]
report 'and not what it leads to' $?
runs 'below it is free' $'print a file sub/a\nshell mv sub/a b\nshell rm b\nshell rmdir sub\nshell rm none'
runs '-shell yes lifts it' $'shell putenv TS_TEST=1\nshell rmdir ../made/deep\nshell touch file\nshell mv file ../made/file
shell rm ../made/file\nshell rmdir ../made' -shell yes
[ ! -e ../made ]
report '-shell yes has removed' $?

# ---- -sandbox, with all that the kernel has and without
grain='boundary p p p
region box block 0 1 0 1 0 1
create_box 1 box
create_atoms 1 single 0.5 0.5 0.5
set group all diameter 0.1 density 1
fix move all nve'
for kernel in yes no; do
	with=(-sandbox kernel $kernel)
	s="kernel $kernel"
	reads='a script reads only below'
	writes="a script writes only below '$here'"

	# reading
	runs "$s: the script's own folder" $'include ../script/in.part\nvariable f file ../script/in.part' "${with[@]}"
	for path in ../other/secret "$here/../other/secret" /etc/passwd /proc/self/environ /proc/self/cwd/../other/secret \
		/dev/zero ../script/../other/secret; do
		stops "$s: variable file $path" "variable f file $path" "$reads" "${with[@]}"
		stops "$s: include $path" "include $path" "$reads" "${with[@]}"
		stops "$s: jump $path" "jump $path" "$reads" "${with[@]}"
		stops "$s: is_file($path)" "print \$(is_file($path))" "$reads" "${with[@]}"
	done
	stops "$s: read_data" 'read_data ../other/secret' "$reads" "${with[@]}"
	stops "$s: read_restart" 'read_restart ../other/secret' "$reads" "${with[@]}"
	stops "$s: read_dump" "$grain"$'\nread_dump ../other/secret 0 x' "$reads" "${with[@]}"
	stops "$s: a mesh" "$grain"$'\nfix m all mesh/surface file ../other/secret type 1' "$reads" "${with[@]}"
	stops "$s: a material" "$grain"$'\nmaterial 1 file ../../other/secret' 'secret' "${with[@]}"
	ln -s ../other/secret ../script/link
	ln -s ../other ../script/links
	ln ../other/secret ../script/hard 2>/dev/null
	mkfifo ../script/pipe
	stops "$s: a link to a file" 'variable f file ../script/link' "$reads" "${with[@]}"
	stops "$s: a link to a folder" 'variable f file ../script/links/secret' "$reads" "${with[@]}"
	stops "$s: a hard link" 'variable f file ../script/hard' 'has other names (hard links)' "${with[@]}"
	stops "$s: a pipe" 'variable f file ../script/pipe' 'plain files only' "${with[@]}"
	rm ../script/{link,links,hard,pipe}
	echo mine >mine
	stops "$s: a file in the folder of the run" 'variable f file mine' "$reads" "${with[@]}"
	stops "$s: that is added to" $'print a append mine\nvariable f file mine' "$reads" "${with[@]}"
	runs "$s: what it has written" $'print 17 file own\nshell mv own own2\nvariable f file own2' "${with[@]}"
	rm -f mine own2

	# writing
	for path in ../other/new ../other/secret ../script/new "$here/../other/new" /tmp/ts_sandbox_$$ /proc/self/comm \
		/dev/shm/ts_sandbox_$$ sub/../../other/new; do
		mkdir -p sub
		stops "$s: print to $path" "print a file $path" "$writes" "${with[@]}"
		stops "$s: print append $path" "print a append $path" "$writes" "${with[@]}"
		stops "$s: log $path" "log $path" "$writes" "${with[@]}"
		stops "$s: a dump to $path" "$grain"$'\n'"dump d all custom 1 $path id"$'\nrun 1' "$writes" "${with[@]}"
		stops "$s: write_restart $path" "$grain"$'\n'"run 0"$'\n'"write_restart $path" "$writes" "${with[@]}"
	done
	stops "$s: averages" "$grain"$'\ncompute k all ke\nfix a all ave/time 1 1 1 c_k file ../other/new\nrun 1' "$writes" "${with[@]}"
	stops "$s: mkdir" 'shell mkdir ../other/new' "$writes" "${with[@]}"
	stops "$s: mkdir from a full path" "shell mkdir $here/../other/new" "$writes" "${with[@]}"
	stops "$s: mv" 'shell mv ../other/secret here' "$outside" "${with[@]}"
	stops "$s: rm" 'shell rm ../other/secret' "$outside" "${with[@]}"
	stops "$s: cd" 'shell cd ../other' "$reads" "${with[@]}"
	stops "$s: cd up" 'shell cd ..' "$reads" "${with[@]}"
	runs "$s: cd and back" $'shell mkdir a/b\nshell cd a/b\nprint x file y\nshell rm y\nshell cd ../..\nshell rmdir a/b a' "${with[@]}"
	[ ! -e a ]
	report "$s: and there it acts" $?
	ln -s ../other link
	ln -s ../other/secret linked
	ln -s ../other/new dangling
	ln ../other/secret hard 2>/dev/null
	mkfifo pipe
	stops "$s: through a link to a folder" 'print a file link/new' "$writes" "${with[@]}"
	stops "$s: through a link to a file" 'print a file linked' "$writes" "${with[@]}"
	stops "$s: through a link to nothing" 'print a file dangling' 'cannot open' "${with[@]}"
	stops "$s: into a hard link" 'print a file hard' 'has other names (hard links)' "${with[@]}"
	stops "$s: adding to a hard link" 'print a append hard' 'has other names (hard links)' "${with[@]}"
	stops "$s: into a pipe" 'print a file pipe' "cannot open 'pipe'" "${with[@]}"
	runs "$s: /dev/null" 'print a file /dev/null' "${with[@]}"
	rm -rf link linked dangling hard pipe sub
	timeout -s KILL 60 "$TSIM" "${with[@]}" -in ../script/in.part -log ../other/log >../out 2>../err
	[ $? != 0 ] && shows "$writes" ../err
	report "$s: -log" $? ../err
	timeout -s KILL 60 "$TSIM" "${with[@]}" -in ../script/in.part -screen ../other/screen >../out 2>../err
	[ $? != 0 ] && shows "$writes" ../err
	report "$s: -screen" $? ../err
	unharmed "$s"
	[ ! -e /tmp/ts_sandbox_$$ ] && [ ! -e /dev/shm/ts_sandbox_$$ ] && [ "$(ls ../script)" = $'in.part\nin.script' ]
	report "$s: nothing was written elsewhere" $?

	# environment, processes
	export TS_SECRET=17
	stops "$s: variable getenv" $'variable e getenv TS_SECRET\nprint $e' 'does not see the environment' "${with[@]}"
	stops "$s: variable getenv, checked" $'variable e getenv TS_SECRET\nprint $e' 'does not see the environment' \
		"${with[@]}" -check
	stops "$s: putenv" 'shell putenv A=1' 'putenv' "${with[@]}"
	stops "$s: shell" 'shell ls' 'only with the option -shell yes' "${with[@]}"
	for other in '-shell yes' '-crosscheck lammps' -advise; do
		# shellcheck disable=SC2086
		script 'print a' "${with[@]}" $other
		[ $? = 2 ] && shows 'cannot be given together' ../err
		report "$s: with $other" $? ../err
	done

	# limits
	stops "$s: disk" $'variable n loop 100000\nlabel again\nprint "0123456789" append many screen no\nnext n\njump SELF again' \
		"has written all that -sandbox allows" "${with[@]}" disk 1e-5
	[ "$(stat -c %s many)" -le 10000 ]
	report "$s: and no more" $?
	rm -f many
	stops "$s: files" $'variable n loop 100000\nlabel again\nprint a file many$n screen no\nnext n\njump SELF again' \
		"has written all that -sandbox allows" "${with[@]}" disk 1e-4
	[ "$(find . -name 'many*' | wc -l)" -le 25 ]
	report "$s: so many" $?
	rm -f many*
	stops "$s: folders" $'variable n loop 100000\nlabel again\nshell mkdir many/$n\nnext n\njump SELF again' \
		"has written all that -sandbox allows" "${with[@]}" disk 1e-4
	rm -rf many
	script "$grain"$'\nrun 2000000000' "${with[@]}" time 1
	[ $? = 152 ] && shows 'the processor time that -sandbox allows' ../err && [ -s tsim.interrupted.restart ]
	report "$s: time" $? ../err
	rm -f tsim.interrupted.restart
	if ! "$TSIM" -in ../script/in.part -log none 2>&1 | grep -q ERROR && ! nm "$TSIM" 2>/dev/null | grep -q __asan_init; then
		stops "$s: memory" $'units si\nregion box block 0 1 0 1 0 1\ncreate_box 1 box\nlattice sc 0.002\ncreate_atoms 1 box' \
			'memory' "${with[@]}" memory 0.3
	fi
	rm -f log.tsim
done

# who keeps it so is said
script 'print a' -sandbox kernel no
shows 'files are kept by tsim alone' ../out && shows 'sockets are kept away by tsim alone' ../out
report 'says that the kernel does not help' $? ../out
script 'print a' -sandbox
grep -qE 'files are kept by (the kernel \(Landlock [0-9]+\) and by tsim|tsim alone.*no Landlock)' ../out
report 'says who helps' $? ../out
shows "reads below '$(cd ../script && pwd -P)'" ../out && shows "writes below '$here'" ../out
report 'says where' $? ../out
script 'print a' -sandbox memory none
[ $? = 2 ] && shows memory ../err
report 'a wrong word' $? ../err
script "$grain"$'\nrun 10' -sandbox -explain
report 'with -explain' $? ../err
shows 'about' ../out
report 'which prices' $? ../out
script "$grain"$'\nrun 10' -sandbox -threads 2
report 'with threads' $? ../err
echo 'print "from standard input"' | "$TSIM" -sandbox >../out 2>../err
report 'from standard input' $? ../err
cd "$work" || exit 99
finish
