#!/bin/bash
# pip makes a wheel without a network; what it installs runs by itself: the library and the files of materials are in it.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
[ -n "$SHARED" ] || { echo 'skipped: built without the shared library'; exit 77; }
if nm -D "$top_builddir/$SHARED" 2>/dev/null | grep -q __asan_init; then
	echo 'skipped: a sanitizer must be loaded before Python'
	exit 77
fi
python_with 'setuptools, wheel, pip' 'python3-pip python3-setuptools python3-wheel' || exit 77

mkdir tree
(cd "$top_srcdir" && cp -r pyproject.toml setup.py configure.ac README.md python potentials "$work/tree")
library=$(cd "$top_builddir" && pwd)/$SHARED
TSIM_LIBRARY=$library "$python" -m pip --disable-pip-version-check wheel --no-index --no-build-isolation --no-deps \
	--wheel-dir wheels ./tree >out 2>&1
report 'pip wheel' $? out
ls wheels >out
grep -qxE 'tsim-[0-9.]+-py3-none-[a-z]+_.*\.whl' out
report 'the wheel is one for any Python 3 of this system' $? out
"$python" -m pip --disable-pip-version-check install --no-index --no-deps --target site wheels/*.whl >out 2>&1
report 'pip install' $? out

mkdir elsewhere
cd elsewhere || exit 99
cat >run.py <<'END'
import os
import tsim
from tsim import _library
assert os.path.dirname(tsim.__file__) == os.path.dirname(_library._lib._name), _library._lib._name
with tsim.Simulation() as sim:
    sim.commands("""
units si
boundary f f f
region b block 0 1 0 1 0 1 units box
create_box 1 b
material 1 file glass
create_atoms 1 single 0.5 0.5 0.5 units box
set group all diameter 0.01
fix move all nve
fix g all gravity 9.81 vector 0 0 -1
timestep 1e-4
run 100
""")
    print("fallen", sim.value("vz[1]"))
    sim.picture(size=(64, 64)).save("now.png")
END
env -u TSIM_LIBRARY -u TSIM_POTENTIALS -u LD_LIBRARY_PATH PYTHONPATH="$work/site" "$python" run.py >out 2>&1 && [ -s now.png ]
report 'what was installed runs' $? out
[ -f "$work/site/tsim/py.typed" ] && [ -f "$work/site/tsim/potentials/steel.material" ]
report 'type hints and materials are in it' $?
finish
