#!/bin/bash
# Options, exit statuses, and the form of errors of the program.
set -u
# shellcheck source=tests/lib_text.sh
. "$top_srcdir/tests/lib_text.sh" || exit 99
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 99
[ -x "$TSIM" ] || { echo "no program: $TSIM"; exit 99; }
failed=0

# expect NAME STATUS EXPECTED-STANDARD-OUTPUT EXPECTED-STANDARD-ERROR ARGUMENTS...
expect() {
	local name=$1 status=$2 out=$3 err=$4
	shift 4
	"$TSIM" "$@" >out 2>err </dev/null
	local got=$?
	if [ $got != "$status" ] || [ "$(cat out)" != "$out" ] || [ "$(cat err)" != "$err" ]; then
		echo "FAILED: $name: status $got, expected $status"
		diff <(echo "$out") out
		diff <(echo "$err") err
		failed=1
	fi
}

version=$("$TSIM" -version | head -n 1)
"$TSIM" -version >features
for feature in threads gsl zlib png hdf5 movies ranks; do
	[ "$(grep -cE "^  $feature +[^ ]" features)" = 1 ] || { echo "FAILED: -version has no $feature"; failed=1; }
done
more="'tsim -help' lists the options"
printf 'variable n index 2.5\nprint "n $n"  # so\nif "$n > 3" then "prnit $n"\n' >in.script

expect 'script' 0 "$version
n 2.5" '' -in in.script
printf '%s\n' "$version" 'variable n index 2.5' 'print "n $n"  # so' 'n 2.5' \
	'if "$n > 3" then "prnit $n"' >expected.log
cmp expected.log log.tsim || failed=1

error="in.script:3:19: error: unknown command 'prnit'; did you mean 'print'?
  if \"\$n > 3\" then \"prnit \$n\"
                    ^~~~~"
expect 'error with place' 1 "$version
n 7" "$error" --in in.script -var n 7 -log mine.log
tail -n 3 mine.log >got.log
[ "$(cat got.log)" = "$error" ] || { echo 'FAILED: the error is not in the log'; failed=1; }
expect 'negative value' 0 "$version
n -7" '' -in in.script -v n -7 8 -log none
expect 'no screen' 1 '' "$error" -in in.script -screen none -log none -var n 7
expect 'unused variable' 0 "$version
n 2.5
warning: variable 'm' was set from outside, but the script does not use it" '' \
	-var m 7 -in in.script -log none
expect 'variable given twice: the last value' 0 "$version
n 2" '' -var n 1 -in in.script -v n 2 -log none
expect 'unknown option' 2 '' "tsim: unknown option '-lgo'; did you mean '-log'?
$more" -lgo none
expect 'option without value' 2 '' "tsim: option -in needs FILE
$more" -in
expect 'stray word' 2 '' "tsim: expected an option, found 'in.script'; a script is given by -in FILE
$more" in.script
expect 'threads' 2 '' "tsim: expected a number from 1 to 1024 after -threads, found '0'
$more" -threads 0
# as LAMMPS is called
echo 'print "$m"' >in.empty
expect 'options of LAMMPS' 0 '' '' -sf hybrid omp gpu -pk omp 2 neigh no -nocite -nc -v m 1 2 -e none -l none -sc none -i in.empty
expect 'threads of a package' 2 '' "tsim: expected a number from 1 to 1024 after -package omp, found '-3'
$more" -pk omp -3
expect 'another package' 2 '' "tsim: expected omp after -package, found 'gpu'; tsim has threads
$more" -package gpu 1
expect 'missing script' 1 "$version" \
	"error: cannot open script 'none': No such file or directory" -in none -log none
expect 'unknown page' 2 '' "tsim: there is no command 'prin'; did you mean 'print'?
$more" -help command prin

echo 'quit 7' | "$TSIM" -log none -screen none
[ $? = 7 ] || { echo 'FAILED: quit'; failed=1; }
printf 'label a\njump SELF a\n' >in.loop
timeout -s TERM 1 "$TSIM" -in in.loop -log none >out 2>err
[ $? = 124 ] && grep -q '^in.loop:.*stopped on request$' err || { echo 'FAILED: SIGTERM'; failed=1; }
"$TSIM" -help command print | grep -q '^Syntax$' || { echo 'FAILED: page'; failed=1; }
# pages are found by words as scripts have them, and by their text
page() { # FIRST LINE THAT IS THERE, then the words
	local line=$1
	shift
	"$TSIM" -help "$@" >out 2>err && shows "$line" out || { echo "FAILED: -help $*"; failed=1; }
}
page 'pair gran: ' pair_style gran
page 'pair gran: ' 'pair_style gran'
page 'fix drag: ' 'fix drag'
page 'command pair_style: ' pair_style
page 'particles are grains' pair_style lj/cut
page 'tsim -help pair spring/dashpot' restitution
page 'tsim -help fix mesh/surface' hopper
page 'tsim -help pair gran' Rolling
page 'tsim -help compute temp/granular' granular temperature
page 'tsim -help command flow_boundary' outlet
page '      v = sum m v_i / sum m' fix ave/euler
expect 'a style that does not exist' 2 '' "tsim: there is no kind or style 'gravty'; did you mean 'gravity'?
$more" -help gravty
expect 'words that stand nowhere' 2 '' "tsim: no page of the manual has the word 'repoze'; did you mean 'repose'?
$more" -help 'angle of repoze'
mkdir pages && "$TSIM" -doc pages && shows 'command_print.md' pages/index.md &&
	grep -q '^# command print$' pages/command_print.md || { echo 'FAILED: -doc'; failed=1; }
expect 'two ways to run' 2 '' "tsim: -advise and -crosscheck cannot be given together
$more" -advise 1 -crosscheck liggghts -in in.script
expect 'a run and none' 2 '' "tsim: -crosscheck and -check cannot be given together
$more" -crosscheck liggghts -check -in in.script
for options in '-help fix' '-grammar vim' -version; do
	# shellcheck disable=SC2086
	"$TSIM" $options >/dev/full 2>err
	[ $? = 1 ] && [ "$(cat err)" = 'tsim: cannot write to standard output' ] || { echo "FAILED: $options on a full disk"; cat err; failed=1; }
done
"$TSIM" -report /proc/none.html -in in.script >out 2>err </dev/null
[ $? = 1 ] && [ "$(grep -c 'cannot write' err)" = 1 ] || { echo 'FAILED: an impossible report is told once'; cat err; failed=1; }
exit $failed
