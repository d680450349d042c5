#!/bin/bash
# A browser shows a report as it is meant: at the width of a screen and of a telephone nothing is cut off, pictures and
# plots have a size; a reader who asks for dark pages has a dark ground with light letters, and bars have the colours of
# the curves in both.
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

# The page measures itself: its script replaces the text by what it finds. The colour of a bar is that of the first curve.
measured() { # WHAT WIDTH COLOURS WORDS...
	local what=$1 width=$2 colours=$3
	shift 3
	sed "s|</body>|<script>addEventListener('load',function(){\
var wide=document.documentElement.scrollWidth>innerWidth,small=0,style=getComputedStyle(document.body);\
var colour=function(e,of){return getComputedStyle(document.querySelector(e))[of].replace(/ /g,'')};\
var bar=colour('.q0','backgroundColor'),curve=colour('.ts-plot .c1','color');\
document.querySelectorAll('img,svg').forEach(function(e){var r=e.getBoundingClientRect();\
small+=r.width<200\|\|r.height<100\|\|r.right>innerWidth});\
document.body.innerHTML='WIDE '+wide+' SMALL '+small+' COLOURS '+[style.backgroundColor,style.color].join(' ').replace(/, /g,',')+\
' '+(bar==curve\&\&bar)+' WIDTH '+innerWidth+' END'})</script></body>|" \
		run.html >measure.html
	timeout 60 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$work/profile" "$@" \
		--window-size="$width,900" --dump-dom "file://$work/measure.html" >dom 2>browser.log
	grep -o 'WIDE .* END' dom >measure
	grep -qF "WIDE false SMALL 0 COLOURS $colours WIDTH" measure
	report "$what" $? measure
}
# ground, letters and first curve: page_style.c and ts_plot_colour
light='rgb(246,246,243) rgb(29,33,38) rgb(0,81,145)'
dark='rgb(21,24,28) rgb(228,230,232) rgb(53,134,225)'
measured "screen" 1280 "$light" --blink-settings=preferredColorScheme=1
measured "telephone" 500 "$light" --blink-settings=preferredColorScheme=1
measured "dark" 1280 "$dark" --blink-settings=preferredColorScheme=0
timeout 60 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$work/profile" --hide-scrollbars \
	--screenshot=shot.png --window-size=800,600 "file://$work/run.html" >browser.log 2>&1
[ "$(head -c 8 shot.png | tail -c 7 | head -c 3)" = PNG ]
report "screenshot" $? browser.log

finish
