#!/bin/bash
# Scripts as users of LIGGGHTS write them, run by both programs with `tsim -crosscheck liggghts`. The first
# line of each says what is demanded, `# crosscheck: tolerance 1e-10`; together they use all that is
# used much. Words after the name of this test choose some of them.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
if ! command -v liggghts >/dev/null; then
	echo 'skipped: needs liggghts (apt-get install liggghts)'
	exit 77
fi
cp -R "$top_srcdir/tests/crosscheck/scripts/." .
for script in in.*; do
	[ $# = 0 ] || case " $* " in *" ${script#in.} "*) ;; *) continue ;; esac
	demand=$(sed -n '1s/^# crosscheck: *//p' "$script")
	# shellcheck disable=SC2086
	"$TSIM" -crosscheck liggghts $demand -in "$script" >said 2>&1
	status=$?
	report "$script" $status said
	echo "$script: $(tail -n 1 said)"
done
finish
