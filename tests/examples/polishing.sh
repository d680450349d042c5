#!/bin/bash
# The converging gap of examples/polishing by the film and by the full equations: the RESULT lines are ok; the load by the full
# equations exceeds that of the film by the neglected terms, about 4.5 (h/L)^2.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp -r "$top_srcdir/examples/polishing" "$top_srcdir/examples/flow" . || exit 99
cd polishing || exit 99

results 'film' in.gap 3 -var within 2e-5
results 'film, another slope' in.gap 3 -var K 3 -var aspect 100 -var M 400 -var within 2e-5
results 'full equations' in.gap 3 -var model cfd -var N 10 -var aspect 8 -var within 0.15
awk '$2 == "gap.cfd.load" { off = ($3/$4 - 1)*8^2; print off; exit !(off > 3 && off < 6) }' out >ratio
report 'terms of second order' $? ratio

# slurry WHAT OK WORDS...: the RESULT lines that are ok, and no others, are OK
slurry() {
	local what=$1 good=$2
	shift 2
	"$TSIM" -in in.slurry -log none "$@" >out 2>&1 </dev/null &&
		[ "$(awk '$1 == "RESULT" && $6 == "ok" { printf "%s ", $2 }' out)" = "$good " ]
	report "$what" $? out
}
slurry 'slurry, a gap that opens' 'slider ratio.of.64.and.16 falls.with.speed part.below.ambient' -var M 2 -var pads 2
awk '$1 !~ /^#/ { n++; p[n] = $2; if ($6 < -101325 || $4 < 0.5 || $2 >= 0) bad = 1 }
	END { exit bad || n != 4 || !(p[4]/p[1] < 4) }' post/slurry.txt
report 'its table' $? post/slurry.txt
slurry 'without cavitation' 'slider ratio.of.64.and.16 falls.with.speed part.below.ambient' -var M 2 -var pads 2 -var cavitation none
awk '$1 !~ /^#/ { n++; p[n] = $2/n } END { for (k = 2; k <= n; k++) if ((p[k]/p[1] - 1)^2 > 1e-8) bad = 1; exit bad || n != 4 }' post/slurry.txt
report 'in proportion to the speed' $? post/slurry.txt
slurry 'a gap that closes' 'slider ratio.of.64.and.16' -var M 2 -var pads 2 -var tilt -2.2
awk '$1 !~ /^#/ && !($2 > 0) { bad = 1 } END { exit bad }' post/slurry.txt
report 'above ambient' $? post/slurry.txt
slurry 'slurry, full equations' 'cfd.16.by.film cfd.32.by.film cfd.48.by.film cfd.64.by.film falls.with.speed' \
	-var model cfd -var N 12
finish
