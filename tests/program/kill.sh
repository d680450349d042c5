#!/bin/bash
# A run killed at any moment (kill -9) leaves a restart file that can be read, whatever it was doing; and
# what is read is a state of the run. KILLS (50) times. SEED is that of the moments.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
seed=${SEED:-20231}
echo "SEED=$seed"
RANDOM=$((seed % 32768))

# states of the whole run by their steps, as sums of positions
cat >in.state <<END
read_restart \${file}
print "\$(step) \$(xcm(all,x):%.17g) \$(xcm(all,z):%.17g)"
END
cat >in.run <<END
include $top_srcdir/tests/data/in.older
restart 1 turn1 turn2
dump single all restart 1 single
dump series all restart 7 series.*
dump d all custom 3 dump id x y z
run 4000 upto
END
cat >in.whole <<END
variable last index 0
variable line equal step
include $top_srcdir/tests/data/in.older
fix note all print 1 "\$(step) \$(xcm(all,x):%.17g) \$(xcm(all,z):%.17g)" file whole screen no title none
run 4000 upto
END
"$TSIM" -in in.whole -log none -screen none 2>err
report 'the whole run' $? err

kills=0
files=0
bad=0
while [ $kills -lt "${KILLS:-50}" ]; do
	"$TSIM" -in in.run -log log -var last 0 >out 2>&1 &
	run=$!
	# at the earliest when there is a file, then anywhere within some steps
	while [ ! -e single ] && kill -0 $run; do :; done 2>/dev/null
	for ((k = RANDOM % 20000; k > 0; k--)); do :; done
	kill -9 $run 2>/dev/null
	wait $run 2>/dev/null
	kills=$((kills + 1))
	for file in turn1 turn2 single 'series.*'; do
		ls | grep -q "^${file/'*'/[0-9]*}\$" || continue
		files=$((files + 1))
		"$TSIM" -in in.state -var file "$file" -log none 2>err | tail -n 1 >state
		grep -qxF "$(cat state)" whole || { bad=$((bad + 1)); cat state err; }
	done
	rm -f turn? single series.* ./*.tmp.*
done
[ $bad = 0 ] && [ $files -ge $kills ]
report "$kills kills, $files files read, $bad bad" $?
echo "$kills kills survived, $files restart files read"
finish
