# What `make check` leaves out. Quick are all tests but these: those that compare with LIGGGHTS and LAMMPS, and those
# that take more than about five seconds of processor time, as measured with -O3. `make check-full` runs all.
# tests/quick.sh fails where a name is not that of a test.
#
#   seconds  test                       quick tests of the same subject
#     120    fuzz/fuzz.sh               decks/mistakes.sh (it compiles the library again)
#      48    restart_every.sh           restart_changes.sh, restart_streams.sh
#      27    check_alloc                none: each allocation fails once
#      14    check_unbreakable          check_script, decks/mistakes.sh
#      12    signal.sh                  none: it waits for processes
#      10    corpus.sh                  decks/mistakes.sh
#       8    kill.sh                    none: it waits for processes
#       8    omissions.sh               check_order
#       8    python.sh                  check_library
#       8    race.sh                    decks/gran_laws.sh
#       7    benchmarks.sh              decks/impacts.sh
#       7    check_library_steps        check_library
#       7    decks/cell_regions.sh      decks/regions.sh
#       7    decks/energy_ledger.sh     check_energy, decks/energy.sh
#       6    drilling.sh                check_bonds
#       6    restart.sh                 restart_changes.sh, restart_streams.sh
#       6    sandbox.sh                 door.sh
#       5    install.sh                 check_library
#       4    momentum.sh                check_coupling
crosschecks = $(filter tests/crosscheck/%,$(shell_tests))
slow_tests = \
	$(crosschecks) \
	tests/benchmarks.sh \
	tests/check_alloc \
	tests/check_library_steps \
	tests/check_unbreakable \
	tests/corpus.sh \
	tests/decks/cell_regions.sh \
	tests/decks/energy_ledger.sh \
	tests/drilling.sh \
	tests/fuzz/fuzz.sh \
	tests/install.sh \
	tests/kill.sh \
	tests/momentum.sh \
	tests/omissions.sh \
	tests/python.sh \
	tests/race.sh \
	tests/restart.sh \
	tests/restart_every.sh \
	tests/sandbox.sh \
	tests/signal.sh
