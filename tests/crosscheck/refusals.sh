#!/bin/bash
# What LIGGGHTS 3.8 refuses of the table tests/data/refusals.txt, and what not. That tsim refuses as much, but for
# those lines that say why not: tests/script/refusals.sh.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs liggghts
data=$top_srcdir/tests/data

n=0
while IFS='|' read -r who what edit _; do
	case $who in '' | \#*) continue ;; esac
	n=$((n + 1))
	mkdir $n
	cp "$data/triangle.stl" $n
	sed "$edit" "$data/in.refusals" >$n/in.case
	echo "$who|$what" >$n/case
done <"$data/refusals.txt"
# it mostly waits for its message passing to start: many at a time
seq $n | xargs -P 24 -I {} sh -c 'cd {} && OMPI_MCA_orte_tmpdir_base=$PWD liggghts -in in.case -log none >out 2>&1 </dev/null; echo $? >status'
for k in $(seq $n); do
	IFS='|' read -r who what <$k/case
	case $who in
	both | LIGGGHTS) [ "$(cat $k/status)" != 0 ] ;;
	*) [ "$(cat $k/status)" = 0 ] ;;
	esac
	report "$what: refused by $who" $? $k/out
done
finish
