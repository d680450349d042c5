# For shell tests: a folder of their own, counted cases, and the last line they end with.
# shellcheck source=tests/lib_text.sh
. "${top_srcdir:-.}/tests/lib_text.sh" || exit 99
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 99
# Processes of Open MPI that start at the same time must not share a folder.
export OMPI_MCA_orte_tmpdir_base=$work
# LIGGGHTS and LAMMPS are one process, which needs no network: looking for one takes nine tenths of their start. No shared
# memory either, whose name is the same for all processes that start without a daemon (tests/Makefile.inc).
export OMPI_MCA_pml=ob1 OMPI_MCA_btl=self
passed=0
failed=0

# report WHAT STATUS [FILE]: counts a case; where it failed the file is shown
report() {
	if [ "$2" = 0 ]; then
		passed=$((passed + 1))
		return
	fi
	failed=$((failed + 1))
	echo "off: $1"
	[ -n "${3-}" ] && tail -n 20 "$3"
	return 0
}

# same WHAT FILE FILE: byte for byte, and not empty
same() {
	{ [ -s "$2" ] && cmp "$2" "$3"; } >difference 2>&1
	report "$1" $? difference
}

# results WHAT SCRIPT NUMBER WORDS...: a run of a script has so many RESULT lines, all ok; output in `out`
results() {
	local what=$1 script=$2 number=$3
	shift 3
	"$TSIM" -in "$script" -log none "$@" >out 2>&1 </dev/null &&
		[ "$(grep -c '^RESULT .* ok$' out)" = "$number" ] && ! grep -q '^RESULT .* off$' out
	report "$what" $? out
}

# flow_case WHAT CASE -var NAME VALUE ...: the example in examples/flow runs and its RESULT lines hold; these
# are in `lines`, those of all such cases in `all`
flow_case() {
	local what=$1 case=$2
	shift 2
	(cd "$top_srcdir/examples/flow/$case" && "$TSIM" -in in.$case -log none "$@") >out 2>&1 &&
		grep '^RESULT' out >lines && ! grep -q 'off$' lines
	report "$what" $? out
	cat lines >>all 2>/dev/null
}

# resumes WHAT FILTER N: in.whole, on one and on three threads, and in.again after the restart file that in.whole has
# written; the last N rows of numbers that FILTER finds in their output are the same
resumes() {
	local what=$1 filter=$2 n=$3 run
	for run in whole again; do
		"$TSIM" -in in.$run -log none >$run 2>&1
		report "$what: $run" $? $run
		"$filter" $run | tail -n "$n" >rows.$run
	done
	same "$what: restart" rows.whole rows.again
	OMP_NUM_THREADS=3 "$TSIM" -in in.whole -log none >three 2>&1
	"$filter" three | tail -n "$n" >rows.three
	same "$what: threads" rows.whole rows.three
}

# has PROGRAM [PACKAGE]: whether the program is installed. If not, the log says that a part of the test is
# skipped; ./setup counts these lines.
has() {
	command -v "$1" >/dev/null && return
	echo "skipped: needs ${1##*/} (apt-get install ${2-$1})"
	return 1
}

# needs PROGRAM [PACKAGE]: without the program the whole test is skipped
needs() {
	has "$@" || exit 77
}

# python_with MODULE PACKAGE: sets `python` to a Python that has the module
python_with() {
	for python in /usr/bin/python3 python3; do
		"$python" -c "import $1" 2>/dev/null && return
	done
	echo "skipped: needs Python's $1 (apt-get install $2)"
	return 1
}

# wait_for CONDITION...: until the command succeeds, for ten seconds at most
wait_for() {
	local k
	for ((k = 0; k < 1000; k++)); do
		"$@" 2>/dev/null && return
		sleep 0.01
	done
	return 1
}

# The rows of the thermo tables of a log, without the repeated ones where one run follows another.
rows() {
	grep -hE '^ +[0-9]+ +[-+0-9.e ]+$' "$@" | uniq
}

# refused WHAT TEXT ARGUMENTS...: exit status 1 and a message that has the text
refused() {
	local what=$1 text=$2
	shift 2
	"$TSIM" -log none "$@" >out 2>err </dev/null
	[ $? = 1 ] && shows "$text" err
	report "$what" $? err
}

# prints SCRIPT LINES...: the script runs and prints each of the lines, '*TEXT' as a part of one
prints() {
	local script=$1 ok=0 line
	shift
	printf '%s\n' "$script" >in.script
	"$TSIM" -in in.script -log none >out 2>&1 </dev/null || ok=1
	for line in "$@"; do
		says_line "$line" out || { ok=1; echo "missing: $line" >>out; }
	done
	report "$script" $ok out
}

# rejects SCRIPT TEXT: the script fails with a message that has the text
rejects() {
	printf '%s\n' "$1" >in.script
	refused "rejects: $(tail -n 1 in.script)" "$2" -in in.script
}

# agree WHAT SCRIPT: it runs, and in every line `is WHAT value reference [scale]` of its output both agree to 1e-13 of
# the scale, the reference itself where none is given: a reference of 0 needs one, unless the value is 0, too
agree() {
	printf '%s\n' "$2" >in.script
	"$TSIM" -in in.script -log none >out 2>&1 && awk '
		$1 == "is" {
			n++
			d = $3 - $4
			size = NF > 4 ? $5 : $4
			if (size < 0) size = -size
			if (NF < 4 || NF > 5 || !(d <= 1e-13 * size && -d <= 1e-13 * size)) { print "differs: " $0; bad = 1 }
		}
		END { exit bad || !n }' out >>out 2>&1
	report "$1" $? out
}

finish() {
	echo "$passed passed, $failed failed"
	[ "$failed" = 0 ] && [ "$passed" -gt 0 ]
	exit
}
