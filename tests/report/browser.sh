#!/bin/bash
# A browser shows a report as it is meant: at the width of a screen and of a telephone nothing is cut off, pictures and
# plots have a size, and the dark style has a dark ground.
# shellcheck source=tests/lib_cases.sh
. "${top_srcdir:-$(dirname "$0")/../..}/tests/lib_cases.sh" || exit 99

browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || {
	echo "skipped: no chromium to show a page"
	exit 77
}

cat >in.gas <<'END'
atom_style	granular
region		box block 0 8 0 8 0 8 units box
create_box	1 box
fix		m1 all property/global youngsModulus peratomtype 5e4
fix		m2 all property/global poissonsRatio peratomtype 0.3
fix		m3 all property/global coefficientRestitution peratomtypepair 1 0.9
pair_style	gran model hertz tangential off
pair_coeff	* *
timestep	1e-4
lattice		sc 2
create_atoms	1 box
set		group all diameter 1 density 1
velocity	all create 1 5
fix		nve all nve/sphere
thermo_style	custom step atoms ke
thermo		50
run		1000
print		"RESULT a_name_that_is_long_as_names_of_results_may_be_in_a_script 1.23456789 1.23456789 0.001 ok"
END
"$TSIM" -in in.gas -report run.html -log none >out 2>&1
report "run with a report" $? out

# The page measures itself: its script replaces the text by what it finds.
measured() { # WHAT WIDTH WORDS...
	local what=$1 width=$2
	shift 2
	sed "s|</body>|<script>addEventListener('load',function(){\
var wide=document.documentElement.scrollWidth>innerWidth,small=0,dark=getComputedStyle(document.body).backgroundColor;\
document.querySelectorAll('img,svg').forEach(function(e){var r=e.getBoundingClientRect();\
small+=r.width<200\|\|r.height<100\|\|r.right>innerWidth});\
document.body.innerHTML='WIDE '+wide+' SMALL '+small+' GROUND '+dark+' WIDTH '+innerWidth+' END'})</script></body>|" \
		run.html >measure.html
	timeout 60 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$work/profile" "$@" \
		--window-size="$width,900" --dump-dom "file://$work/measure.html" >dom 2>browser.log
	grep -o 'WIDE .* END' dom >measure
	grep -q 'WIDE false SMALL 0 ' measure
	report "$what" $? measure
}
measured "screen" 1280
measured "telephone" 500
timeout 60 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$work/profile" --hide-scrollbars \
	--screenshot=shot.png --window-size=800,600 "file://$work/run.html" >browser.log 2>&1
[ "$(head -c 8 shot.png | tail -c 7 | head -c 3)" = PNG ]
report "screenshot" $? browser.log

finish
