#!/bin/bash
# Programs that have initialised MPI: the C library and the Python module on several ranks give the bits of one process.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
[ -f "$top_builddir/libtsim_mpi.so" ] || { echo 'skipped: built without the shared library or MPI (configure --with-mpi)'; exit 77; }
# shellcheck source=tests/lib_ranks.sh
. "$top_srcdir/tests/lib_ranks.sh" || exit 99
has_ranks || exit 77
export OMP_NUM_THREADS=1
sed -e '/^dump/d; /^run/d; /^fix mean/d' "$top_srcdir/tests/rank/scenes/in.bed" >in.bed
echo 'run 100' >>in.bed

# As most programs are compiled: with copies of the objects of MPI in the program itself.
# shellcheck disable=SC2046,SC2086
$CC -Wall -Wextra -Werror -I"$top_srcdir/src" $CFLAGS -fPIE $(pkg-config --cflags mpi-c) "$top_srcdir/tests/library/ranks.c" \
	"$top_builddir/libtsim_mpi.so" -Wl,-rpath,"$work" $(pkg-config --libs mpi-c) -o ranks >out 2>&1 &&
	ln -s "$top_builddir/libtsim_mpi.so" libtsim_mpi.so.0
report 'tsim_mpi.h' $? out
./ranks in.bed without
report 'without MPI it is refused' $?
on_ranks 1 ./ranks in.bed </dev/null >out.1 2>err
report 'one rank' $? err
grep '^end ' out.1 >end.1
for n in 2 3; do
	on_ranks $n ./ranks in.bed </dev/null >"out.$n" 2>err
	report "$n ranks" $? err
	grep '^end ' "out.$n" >"end.$n"
	same "$n ranks: the same numbers" end.1 "end.$n"
	[ "$(grep -c '^rank ' "out.$n")" = 0 ] && [ "$(grep -c '^Loop time' "out.$n")" = 2 ] && [ "$(grep -c '^Loop time' log.ranks)" = 2 ]
	report "$n ranks print once, and have the same forces and errors" $? "out.$n"
done
# fault WHAT TEXT: functions that act in steps with this fault end all ranks with this text
fault() {
	on_ranks 3 ./ranks in.bed "$1" </dev/null >out 2>&1
	[ $? != 0 ] && [ "$(grep -c "$2" out)" = 1 ] && ! grep -q '^end ' out
	report "functions in steps: $1" $? out
}
fault all "'ke' is needed in each step, when each rank has its own particles only"
fault energy 'fix external: energy and vector are of all particles, but ranks have given different numbers'
fault stop 'a function of tsim_on_step ended the run at step 151 with code 7'
# A particle that is lost on one rank ends all of them.
sed 's/^thermo_modify.*//' "$top_srcdir/tests/rank/scenes/in.outlet" >in.lost
sed -i '/^dump/d; /^run/d' in.lost
printf 'thermo_modify lost error\nrun 1200\n' >>in.lost
on_ranks 3 ./ranks in.lost </dev/null >out 2>&1
[ $? != 0 ] && [ "$(grep -c 'left the box through its fixed face' out)" = 1 ]
report 'an error of one rank ends all' $? out

cat >ranks.py <<'END'
import sys
from mpi4py import MPI
import tsim
comm = MPI.COMM_WORLD
if comm.size == 4: # two simulations side by side
    comm = comm.Split(comm.rank % 2)
sim = tsim.Simulation(comm=comm, log="log.python" if comm.rank == 0 else "log.none")
sim.file(sys.argv[1])
sim.step(40)
f = sim.gather("f")
assert comm.bcast(f.tobytes(), 0) == f.tobytes()
assert sim.setting("ranks") == comm.size and sim.setting("rank") == comm.rank
try:
    sim.commands("nonsense 1")
    print("no error")
except tsim.TsimError as error:
    assert error.code == tsim.Status.UNKNOWN
lmp = tsim.lammps(comm=comm, cmdargs=["-log", "none", "-screen", "none"])
lmp.command("units si")
assert lmp.extract_setting("world_size") == comm.size and lmp.get_mpi_comm() == comm
lmp.close()
sim.commands("fix push all external pf/callback 1 1")
def push(caller, step, n, tag, x, f):
    assert n == len(tag) == len(x) == len(f)
    for k in range(n):
        f[k][0] = 1e-6 * x[k][2] * (tag[k] % 5)
sim.set_fix_external_callback("push", push)
sim.commands("run 20")
f = sim.gather("v")
if MPI.COMM_WORLD.rank == 0:
    print("end", len(sim), repr(sim.value("ke")), *(repr(float(x)) for x in f[::17, 2]))
END
if python_with 'mpi4py, numpy' 'python3-mpi4py python3-numpy'; then
	export PYTHONPATH=$top_srcdir/python PYTHONDONTWRITEBYTECODE=1 TSIM_LIBRARY=$top_builddir/libtsim_mpi.so
	for n in 1 3 4; do
		on_ranks $n "$python" ranks.py in.bed </dev/null >"out.$n" 2>&1
		report "Python on $n ranks" $? "out.$n"
		grep '^end ' "out.$n" >"end.$n"
		same "Python on $n ranks: the same numbers" end.1 "end.$n"
	done
	TSIM_LIBRARY=$top_builddir/libtsim.so "$python" ranks.py in.bed >out 2>&1
	grep -q 'mpi4py.MPI was not imported before tsim' out
	report 'the library without ranks' $? out
fi
finish
