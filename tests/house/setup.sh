#!/bin/bash
# ./setup in a folder of its own, with a suite of five tests and packages that come and go: whether it configures
# again, and what it counts.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
mkdir -p tests build/tests bin
cp "$top_srcdir/setup" .
export PATH=$work/bin:$PATH

cat >configure <<'END'
echo "configured $*" >>../calls
touch Makefile
printf '#!/bin/sh\necho "status $*" >>../calls\n' >config.status
chmod +x config.status
END
cat >bin/dpkg-query <<'END'
#!/bin/sh
case $3 in
*Package*) cat "$(dirname "$0")/../installed" ;;
*) echo 'install ok installed' ;;
esac
END
printf '#!/bin/sh\n' >bin/make
chmod +x configure bin/dpkg-query bin/make
sed -i '1i #!/bin/sh' configure

# builds WHAT CALLS: what the build configures
builds() {
	: >calls
	./setup build >out 2>&1
	printf '%s' "$2" | cmp -s - calls
	report "$1" $? calls
}
echo 'gcc 12' >installed
builds 'the first build configures' $'configured \n'
builds 'the same packages: not again' ''
echo 'check 0.15' >>installed
builds 'a package has come' $'status --recheck\nstatus \n'
builds 'only once' ''
echo 'gcc 12' >installed
builds 'a package has gone' $'status --recheck\nstatus \n'
CONFIGURE_FLAGS=--enable-werror builds 'other flags' $'configured --enable-werror\n'
rm build/configured_with
builds 'configured by hand: its flags stay' $'status --recheck\nstatus \n'

printf 'shell_tests = \\\n\ttests/a.sh \\\n\ttests/b.sh \\\n\ttests/c.sh\nunit_tests = \\\n\ttests/check_d \\\n\ttests/check_e\nlibtests_a_SOURCES = \\\n\ttests/cloud.c \\\n\ttests/cloud.h\n' \
	>tests/sources.mk
ran() { # TEST RESULT LOG
	echo ":test-result: $2" >"build/tests/$1.trs"
	printf '%s\n' "$3" >"build/tests/$1.log"
}
counts() { # WHAT STATUS LAST-LINE [LINE]
	./setup results >out 2>&1
	[ $? = "$2" ] && [ "$(tail -n 1 out)" = "$3" ] && { [ -z "$4" ] || grep -qxF "$4" out; }
	report "$1" $? out
}
ran a PASS '7 passed, 0 failed'
ran b PASS 'no numbers of its own'
ran c PASS '1 passed, 0 failed'
ran check_d PASS '100%: Checks: 30, Failures: 0, Errors: 0'
ran check_e PASS '100%: Checks: 2, Failures: 0, Errors: 0'
counts 'all passed' 0 '41 passed, 0 failed, 0 skipped'
ran a FAIL '5 passed, 2 failed'
counts 'failures' 1 '39 passed, 2 failed, 0 skipped' 'failed: tests/a'
ran a PASS $'skipped: needs vim (apt-get install vim)\n6 passed, 0 failed'
counts 'a part is skipped' 1 '40 passed, 0 failed, 1 skipped' 'skipped: tests/a: needs vim (apt-get install vim)'
ran a SKIP 'skipped: needs liggghts (apt-get install liggghts)'
ran b SKIP ''
counts 'tests are skipped' 1 '33 passed, 0 failed, 2 skipped' 'skipped: tests/b'
ran a PASS '7 passed, 0 failed'
ran b PASS ''
ran check_e ERROR 'the program ended before its last line'
counts 'a test that broke off' 1 '39 passed, 1 failed, 0 skipped' 'failed: tests/check_e'
rm build/tests/check_e.trs
counts 'a test that did not run' 1 '39 passed, 1 failed, 0 skipped' 'failed: tests/check_e did not run'
rm build/tests/*.trs
counts 'nothing ran' 1 '0 passed, 5 failed, 0 skipped'
finish
