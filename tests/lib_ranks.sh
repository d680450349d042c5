# For shell tests that start several ranks, after tests/lib_cases.sh.

# Open MPI: one machine needs no network, and looking for one takes most of the start.
export OMPI_MCA_pml=ob1 OMPI_MCA_btl=self,vader

# on_ranks N COMMAND...
on_ranks() {
	local n=$1
	shift
	timeout 300 mpirun --oversubscribe --allow-run-as-root --bind-to none -np "$n" "$@"
}

# Whether mpirun is there, and the program was built with MPI; says what is missing
has_ranks() {
	has mpirun openmpi-bin || return
	if on_ranks 2 "$TSIM" -version 2>&1 </dev/null | grep -q 'built without MPI'; then
		echo 'skipped: needs a tsim built with MPI (configure --with-mpi)'
		return 1
	fi
}
