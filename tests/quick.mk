# What `make check` leaves out. Quick are all tests but these: those that compare with LIGGGHTS and LAMMPS, and those
# that take more than about five seconds of processor time, as measured with -O3. `make check-full` runs all.
# tests/house/quick.sh fails where a name is not that of a test.
#
#   seconds  test                           quick tests of the same subject
#     107    fuzz/fuzz.sh                   script/mistakes.sh (it compiles the library again)
#      40    restart/restart_every.sh       restart/restart_changes.sh, restart/restart_streams.sh
#      35    rank/ranks.sh                  rank/check_blocks, rank/contract.sh
#      10    rank/balance.sh                rank/check_loads
#      75    rank/contract_ranks.sh         rank/contract.sh
#      14    rank/soak.sh                   rank/contract.sh
#      10    rank/plan.sh                   rank/check_blocks
#       5    rank/pause.sh                  rank/contract.sh
#       8    rank/memory.sh                 rank/contract.sh
#      10    rank/apart.sh                  rank/contract.sh
#       6    rank/bodies.sh                 rank/contract.sh
#       8    rank/create.sh                 rank/contract.sh
#       6    rank/read_data.sh              rank/contract.sh
#       6    rank/timer.sh                  rank/contract.sh
#      27    core/check_alloc               none: each allocation fails once
#      14    script/check_unbreakable       script/check_script, script/mistakes.sh
#       7    program/signal.sh              none: it waits for processes
#      10    script/corpus.sh               script/mistakes.sh
#       8    program/kill.sh                none: it waits for processes
#       8    core/omissions.sh              neigh/check_order
#      12    library/python.sh              library/check_library
#       8    library/ranks.sh               library/check_library
#      10    library/python_types.sh        library/check_library
#       6    library/wheel.sh               library/check_library
#       8    bench/race.sh                  contact/gran_laws.sh
#       7    examples/benchmarks.sh         contact/impacts.sh
#       7    library/check_library_steps    library/check_library
#       7    mesh/cell_regions.sh           region/regions.sh
#       7    energy/energy_ledger.sh        energy/check_energy, energy/energy.sh
#      14    examples/erosion.sh            wear/erosion_laws.sh, impact/exact_impacts.sh
#       9    wear/evolve_voxel.sh           wear/evolve_mesh.sh
#       7    examples/erosion_ladder.sh     insert/jet.sh, coupling/check_drag
#       6    examples/drilling.sh           bond/check_bonds
#       8    examples/polishing.sh          film/check_film, immersed/immersed_surface.sh
#      12    examples/scratch.sh            bond/check_element, bond/parallel.sh
#      48    examples/everyday.sh           mesh/mesh_primitive.sh, shape/check_shapes
#      20    examples/rock.sh               bond/check_element, bond/parallel.sh
#       6    restart/restart.sh             restart/restart_changes.sh, restart/restart_streams.sh
#       6    program/sandbox.sh             house/door.sh
#       5    bond/check_parallel            bond/check_element, bond/parallel.sh
#       6    house/dist.sh                  library/check_library
#       5    house/install.sh               library/check_library
#      18    manual/book.sh                 manual/links.sh
#      14    manual/first_hour.sh           mesh/mesh_primitive.sh
#       4    coupling/momentum.sh           coupling/check_coupling
#      13    thermo/progress.sh             thermo/check_progress
#       8    manual/search.sh               manual/page_order.sh
#      10    report/browser.sh              report/report.sh
#       9    study/sweep.sh                 study/calibrate.sh, study/check_secant
long_tests = \
	tests/fuzz/fuzz.sh \
	tests/rank/contract_ranks.sh \
	tests/examples/everyday.sh \
	tests/rank/ranks.sh \
	tests/restart/restart_every.sh \
	tests/rank/soak.sh \
	tests/crosscheck/space.sh \
	tests/core/check_alloc$(EXEEXT) \
	tests/manual/book.sh \
	tests/rank/apart.sh \
	tests/rank/bodies.sh \
	tests/examples/rock.sh \
	tests/rank/pause.sh \
	tests/house/dist.sh \
	tests/script/check_unbreakable$(EXEEXT) \
	tests/examples/erosion.sh \
	tests/manual/first_hour.sh \
	tests/crosscheck/refusals.sh
crosschecks = $(filter tests/crosscheck/%,$(shell_tests))
slow_tests = \
	$(crosschecks) \
	tests/examples/benchmarks.sh \
	tests/examples/erosion.sh \
	tests/examples/everyday.sh \
	tests/examples/erosion_ladder.sh \
	tests/examples/polishing.sh \
	tests/examples/rock.sh \
	tests/examples/scratch.sh \
	tests/wear/evolve_voxel.sh \
	tests/core/check_alloc \
	tests/library/check_library_steps \
	tests/script/check_unbreakable \
	tests/script/corpus.sh \
	tests/mesh/cell_regions.sh \
	tests/energy/energy_ledger.sh \
	tests/examples/drilling.sh \
	tests/fuzz/fuzz.sh \
	tests/house/dist.sh \
	tests/house/install.sh \
	tests/bond/check_parallel \
	tests/manual/book.sh \
	tests/manual/first_hour.sh \
	tests/program/kill.sh \
	tests/coupling/momentum.sh \
	tests/core/omissions.sh \
	tests/library/python.sh \
	tests/library/ranks.sh \
	tests/library/python_types.sh \
	tests/library/wheel.sh \
	tests/bench/race.sh \
	tests/rank/apart.sh \
	tests/rank/bodies.sh \
	tests/rank/create.sh \
	tests/rank/read_data.sh \
	tests/rank/balance.sh \
	tests/rank/contract_ranks.sh \
	tests/rank/memory.sh \
	tests/rank/pause.sh \
	tests/rank/plan.sh \
	tests/rank/ranks.sh \
	tests/rank/soak.sh \
	tests/rank/timer.sh \
	tests/restart/restart.sh \
	tests/restart/restart_every.sh \
	tests/program/sandbox.sh \
	tests/program/signal.sh \
	tests/thermo/progress.sh \
	tests/manual/search.sh \
	tests/report/browser.sh \
	tests/study/sweep.sh
