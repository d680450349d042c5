#!/bin/bash
# The converging gap of examples/polishing by a closed form, the film and the full equations: the RESULT lines are ok; the load by
# the full equations exceeds that of the film by the neglected terms, about 4.5 (h/L)^2. Slurry by the film and the full equations.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp -r "$top_srcdir/examples/polishing" "$top_srcdir/examples/flow" . || exit 99
cd polishing || exit 99

results 'closed form' in.gap 3 -var model analytic -var within 1e-12
results 'closed form, another slope' in.gap 3 -var model analytic -var K 3 -var aspect 7 -var within 1e-12
results 'film' in.gap 3 -var within 2e-5
"$TSIM" -explain -in in.gap -var aspect 10 -var Re 2 >out 2>&1
# mean gap 1.5, length 10: Re 2 * 1.5^2/10, (1.5/10)^2, 1/10
shows 'inertia, rho U h^2/(eta L) = 0.45, and slopes, (h/L)^2 = 0.022, largest 0.1;' out && ! shows 'too steep' out
report 'what the theory of films neglects' $? out
results 'film, another slope' in.gap 3 -var K 3 -var aspect 100 -var M 400 -var within 2e-5
results 'full equations' in.gap 3 -var model cfd -var N 10 -var aspect 8 -var within 0.15
awk '$2 == "gap.cfd.load" { off = ($3/$4 - 1)*8^2; print off; ok = (off > 3 && off < 6); exit } END { exit !ok }' out >ratio
report 'terms of second order' $? ratio

# slurry WHAT OK WORDS...: the RESULT lines that are ok, and no others, are OK
slurry() {
	local what=$1 good=$2
	shift 2
	"$TSIM" -in in.slurry -log none "$@" >out 2>&1 </dev/null &&
		[ "$(awk '$1 == "RESULT" && $6 == "ok" { printf "%s ", $2 }' out)" = "$good " ]
	report "$what" $? out
}
slurry 'slurry, a gap that opens' 'slider ratio.of.64.and.16 falls.with.speed part.below.ambient' -var M 4 -var pads 2
awk '$1 !~ /^#/ { n++; p[n] = $2; if ($6 < -101325 || $4 < 0.5 || $2 >= 0) bad = 1 }
	END { exit bad || n != 4 || !(p[4]/p[1] < 4) }' post/slurry.txt
report 'its table' $? post/slurry.txt
slurry 'without cavitation' 'slider ratio.of.64.and.16 falls.with.speed part.below.ambient' -var M 2 -var pads 2 -var cavitation none
awk '$1 !~ /^#/ { n++; p[n] = $2/n } END { for (k = 2; k <= n; k++) if ((p[k]/p[1] - 1)^2 > 1e-8) bad = 1; exit bad || n != 4 }' post/slurry.txt
report 'in proportion to the speed' $? post/slurry.txt
slurry 'a gap that closes' 'slider ratio.of.64.and.16' -var M 2 -var pads 2 -var tilt -2.2
awk '$1 !~ /^#/ { n++; if (!($2 > 0)) bad = 1 } END { exit bad || !n }' post/slurry.txt
report 'above ambient' $? post/slurry.txt
"$TSIM" -explain -in in.slurry -var M 1 -var pads 2 >out 2>&1
shows 'the surfaces are too steep for a film: flow_style projection' out
report 'a film of steep columns' $? out
slurry 'smooth pad, full equations' 'smooth.16.by.film smooth.32.by.film smooth.48.by.film smooth.64.by.film falls.with.speed' \
	-var model smooth -var N 12
# a short time at each speed
slurry 'rough pad, full equations' \
	'cfd.falls.with.speed cfd.part.below.ambient cfd.ratio.of.64.and.16 cfd.correlation.with.film' -var model cfd -var settle 24
# -check does not know the lists that results of a run are, nor their lengths; it knows others
for model in film smooth cfd; do
	"$TSIM" -check -in in.slurry -var model $model -var M 2 -var pads 2 >out 2>&1
	report "-check of the slurry: $model" $? out
done
cat >in.lists <<'END'
units si
boundary f p f
region box block 0 1 0 1 0 1 units box
create_box 1 box
flow_style reynolds cells 5 5 lower 0 upper 0.1 lower_velocity 1 0 0 viscosity 1 density 1 update run
compute film all film
fix cells all ave/time 1 1 1 c_film[*] mode vector
run 0
variable gap vector f_cells[3]
variable gap vector ${gap}
variable three vector [1,2,3]
variable both vector v_three*v_${with}
print "$(sum(v_both))"
END
"$TSIM" -check -in in.lists -var with gap >out 2>&1
report '-check: a list that is not known' $? out
"$TSIM" -in in.lists -log none -var with gap >out 2>&1
[ $? = 1 ] && shows 'lists of 3 and 25 numbers cannot be combined' out
report 'in the run it is known' $? out
sed -i 's/^variable three.*/&\nvariable two vector [1,2]/' in.lists
"$TSIM" -check -in in.lists -var with two >out 2>&1
[ $? = 1 ] && shows 'lists of 3 and 2 numbers cannot be combined' out
report '-check: lists that are known' $? out
finish
