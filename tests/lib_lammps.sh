# For crosschecks with LAMMPS: the same deck by both programs.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs lmp lammps
needs /usr/bin/python3 python3

# both WHAT OPTIONS...: runs the deck by both, which name their frames by the variable out; words go to said.*
both() {
	local what=$1
	shift
	lmp "$@" -var out lmp >said.lmp 2>&1
	report "$what: LAMMPS" $? said.lmp
	"$TSIM" -legacy "$@" -var out tsim >said.tsim 2>&1
	report "$what: tsim" $? said.tsim
	sed -i '/BOX BOUNDS/,+3d' lmp.dump tsim.dump # of other precision
}

# same_frames WHAT WITHIN: all columns of both
same_frames() {
	/usr/bin/python3 "$top_srcdir/tests/crosscheck/columns.py" lmp.dump tsim.dump "$2" >deviation 2>&1
	report "$1" $? deviation
	echo "$1: $(head -n 1 deviation)"
	rm -f ./*.dump
}
