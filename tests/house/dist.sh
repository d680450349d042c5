#!/bin/bash
# The archive of `make dist` is configured and built without autotools, from what is in it alone.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
unset MAKEFLAGS MAKELEVEL MFLAGS
${MAKE:-make} -C "$top_builddir" distdir distdir="$work/tsim" top_distdir="$work/tsim" >out 2>&1
report 'make distdir' $? out

mkdir bin
for tool in autoconf autoheader automake aclocal autom4te autoreconf automake-1.16 aclocal-1.16; do
	printf '#!/bin/sh\necho "%s $*" >>"%s/called"\nexit 127\n' "$tool" "$work" >bin/$tool
	chmod +x bin/$tool
done
mkdir build
cd build || exit 99
# Lists of dependencies are of the compiler, not of the archive: to make them takes most of the time of configure.
PATH=$work/bin:$PATH ../tsim/configure --disable-dependency-tracking CC="$CC" >out 2>&1
report 'configure' $? out
PATH=$work/bin:$PATH ${MAKE:-make} -n all >out 2>&1
report 'make' $? out
grep -q 'src/main' out
report 'make would compile' $? out
[ ! -e "$work/called" ]
report 'no autotools are called' $? "$work/called"
for file in pyproject.toml setup.py Dockerfile python/tsim/_lammps.py python/tsim/py.typed editors/bash/tsim debian/rules \
	examples/library/tutorial.ipynb examples/everyday/calibrate doc/python.md potentials/glass.material; do
	[ -e "$work/tsim/$file" ]
	report "$file is in the archive" $?
done
[ -z "$(find "$work/tsim" -name __pycache__ -o -name '*.o' -o -name post)" ]
report 'nothing that was built is in it' $?
finish
