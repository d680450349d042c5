# For shell tests that start several ranks, after tests/lib_cases.sh.

# Open MPI: ranks of one machine pass messages through shared memory; no network is looked for.
export OMPI_MCA_btl=self,vader

# on_ranks N COMMAND...
on_ranks() {
	local n=$1
	shift
	timeout 300 mpirun --oversubscribe --allow-run-as-root --bind-to none -np "$n" "$@"
}

# numbers_of FIRST TURN: of ranks on which a scene runs: TS_RANKS, if that is set to numbers (2x2: two ranks of two threads);
# otherwise FIRST and, by turns, 3 (a rank between two others), 4 (blocks that meet at an edge) or 7 (blocks that are thinner
# than the reach of contacts, or empty)
numbers_of() {
	local turns=(3 4 7)
	if [ "${TS_RANKS:-turns}" = turns ]; then
		echo "$1 ${turns[$2 % 3]}"
	else
		echo "$TS_RANKS"
	fi
}

# Whether mpirun is there, and the program was built with MPI; says what is missing
has_ranks() {
	has mpirun openmpi-bin || return
	if on_ranks 2 "$TSIM" -version 2>&1 </dev/null | grep -q 'built without MPI'; then
		echo 'skipped: needs a tsim built with MPI (configure --with-mpi)'
		return 1
	fi
}
