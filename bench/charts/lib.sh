# For the charts: runs tsim and takes its time, records points, calls what draws and tabulates them.

# levels A B ... [-- C D ...]: the settings of a chart; those after -- only with LONG=1
levels() {
	local word
	for word; do
		if [ "$word" = -- ]; then
			[ -n "${LONG-}" ] || return 0
		else
			echo "$word"
		fi
	done
}

# located METHOD: whether the contacts of a method are to be located within the step: its last word
located() {
	case $1 in *' located') echo yes ;; *) echo no ;; esac
}

# problem NAME: the points that follow belong to it; each problem has a panel and a front of its own
problem() {
	problem=$1
	idle=0
}

# simulate WORDS: runs the deck of the chart. Its output is in $work/output, its processor time (user and system) in
# $seconds: the least of some runs, unless they take long.
simulate() {
	local k user system least= took total=0 TIMEFORMAT='%3U %3S'
	for ((k = 0; k < ${REPEATS:-5} && total < 500; k++)); do
		{ time (cd "${place:-$work}" && "$tsim" -in "$deck" -log none -threads 1 "$@" \
			>"$work/output" 2>&1 </dev/null); } \
			2>"$work/time" || { sed -n '/error:/{p;q;}' "$work/output" >&2; return 1; }
		read -r user system <"$work/time"
		took=$((10#${user/./} + 10#${system/./}))
		total=$((total + took))
		spent=$((spent + took))
		[ -n "$least" ] && [ "$least" -le "$took" ] || least=$took
	done
	least=$((least > idle ? least - idle : 1))
	seconds=$(printf '%d.%03d' $((least / 1000)) $((least % 1000)))
}

# idle WORDS: the time of this run, one of no steps, is taken off the points that follow up to the next `problem`
idle() {
	idle=0
	simulate "$@" || exit 1
	idle=$((10#${seconds/./}))
}

# ensemble SEEDS WORDS: runs the deck once for each seed (-var seed SEED). All outputs are in $work/output, $seconds is the
# mean time of a run.
ensemble() {
	local seed sum=0 count=0 REPEATS=1
	: >"$work/outputs"
	for seed in $1; do
		simulate "${@:2}" -var seed "$seed" || return 1
		cat "$work/output" >>"$work/outputs"
		sum=$((sum + 10#${seconds/./}))
		count=$((count + 1))
	done
	mv "$work/outputs" "$work/output"
	sum=$(((sum + count / 2) / count))
	seconds=$(printf '%d.%03d' $((sum / 1000)) $((sum % 1000)))
}

# deviation NAME: how far the mean of the lines `VALUE NAME number` of an ensemble is from that of the finest one with the
# same seeds, and the standard error of this difference, run by run; both by the mean of the finest
deviation() {
	awk -v name="$1" '$1 != "VALUE" || $2 != name { next }
		NR == FNR { reference[++n] = $3; r += $3; next }
		{ x = $3 - reference[++k]; d += x; q += x * x }
		END { d /= n; r /= n; v = (q / n - d * d) / (n > 1 ? n - 1 : 1)
		      print (d < 0 ? -d : d) / (r < 0 ? -r : r), sqrt(v > 0 ? v : 0) / (r < 0 ? -r : r) }' \
		"$work/finest/output" "$work/output"
}

# record METHOD SETTING ERROR [SPREAD]: a point of the chart; its cost is $seconds
record() {
	case ${3-} in nan | [-+.0-9]*) ;; *) echo "charts: '${3-}' is no error, in $chart, $1, $2" >&2; exit 1 ;; esac
	case $problem$1$2 in *,*) echo "charts: a comma in '$problem', '$1' or '$2' of $chart" >&2; exit 1 ;; esac
	echo "$chart,$problem,$1,$2,$(printf %.6g "$3"),$seconds,$(printf %.3g "${4:-0}")" >>"$work/points"
	echo "  $chart${problem:+, $problem}: $1, $2: error $(printf %.3g "$3"), $seconds s"
}

# finest WORDS: a run that is the reference of the points that follow, and no point itself. What it prints and writes is
# kept in $work/finest, the output as `output`.
finest() {
	simulate "$@" || exit 1
	keep_finest
}

keep_finest() {
	mkdir -p "$work/finest"
	find "$work" -maxdepth 1 -type f ! -name points -exec cp {} "$work/finest" ';'
}

# difference: the root mean square of the differences between the numbers in lines `VALUE name number` of the output and
# the reference, by that of the reference. A chart may define `difference` anew; it prints ERROR [SPREAD].
difference() {
	awk '$1 != "VALUE" { next }
	     NR == FNR { reference[$2] = $3; next }
	     { d += ($3 - reference[$2])^2; r += reference[$2]^2; n++ }
	     END { if (n && r > 0) printf "%.6g\n", sqrt(d / r); else print "nan" }' "$work/finest/output" "$work/output"
}

# point METHOD SETTING WORDS: a run and its error: what its line `ERROR number [spread]` says, else its difference from
# the finest run. A run that fails is an error of nan, which is in the data and not in the chart.
point() {
	local method=$1 setting=$2 error
	shift 2
	if simulate "$@"; then
		error=$(sed -n 's/^ERROR //p' "$work/output")
		[ -n "$error" ] || error=$(difference)
	else
		error=nan seconds=nan
	fi
	record "$method" "$setting" ${error:-nan}
}

# What a chart says of itself, for the head of the data.
heading() {
	echo "# $title"
	echo "# error: $error"
	echo "# reference: ${reference//$'\n'/ }"
	echo "# setting: ${setting//$'\n'/ }"
	echo "# seconds: processor time of one thread, user and system, least of ${REPEATS:-5} runs if they are short"
	[ -z "$spread" ] || echo "# spread: $spread"
	echo "# took $1 s of processor time (budget $budget s${LONG:+; long setting})"
	echo "chart,problem,method,setting,error,seconds,spread,front"
}

# load NAME: reads the definition of a chart
load() {
	chart=$1
	problem= idle=0 place= spread= also= price= deck=$folder/$chart.in
	unset -f points figure
	. "$folder/$chart.sh"
}

make_chart() { # NAME
	spent=0
	load "$1"
	work=$(mktemp -d)
	trap 'rm -rf "$work"' EXIT
	: >"$work/points"
	echo "$chart: $title"
	if declare -F points >/dev/null; then
		points
		{ heading $((spent / 1000)); awk -f "$here/front.awk" "$work/points"; } >"$out/$chart.csv"
	fi
	draw
	[ $((spent / 1000)) -le "$budget" ] || [ -n "${LONG-}" ] ||
		echo "charts: $chart took $((spent / 1000)) s, more than its budget of $budget s" >&2
}

# The pictures of a chart: as SVG and PNG, and NAME-setting with the setting on the axis if it has `also`; or what its own
# function `figure FORMAT FILE` draws.
draw() {
	local format
	command -v gnuplot >/dev/null || return 0
	for format in svg png; do
		if declare -F figure >/dev/null; then
			figure "$format" "$out/$chart.$format"
			continue
		fi
		if [ -n "$price" ]; then
			plot "$out/$chart.$format" seconds-setting "$price" 'processor time (s)'
		else
			plot "$out/$chart.$format" error-seconds 'processor time (s)' "$error"
		fi
		[ -z "$also" ] || plot "$out/$chart-setting.$format" error-setting "$also" "$error"
	done
}

plot() { # FILE AXES XLABEL YLABEL
	awk -v file="$1" -v format="${1##*.}" -v axes="$2" -v xlabel="$3" -v ylabel="$4" -v title="$title" \
		-f "$here/plot.awk" "$out/$chart.csv" | gnuplot
}

# The page of all charts whose data there is.
write_page() {
	local part csv
	cat "$here/page.head"
	for part in Grains Fluid; do
		for csv in "$out"/*.csv; do
			[ -f "$folder/$(basename "$csv" .csv).sh" ] || continue
			(load "$(basename "$csv" .csv)" && [ "$part" = "${kind:-Grains}" ] && section "$csv") || true
		done
	done
}

section() { # CSV
	local links="charts"
	[ "$(dirname "$page")/charts" = "$out" ] || links=.
	printf '\n## %s\n\n![%s](%s/%s.png)\n\n' "$title" "$title" "$links" "$chart"
	[ -z "$also" ] || printf '![%s, by setting](%s/%s-setting.png)\n\n' "$title" "$links" "$chart"
	printf '**Recommended:** %s\n\n' "$pick"
	printf 'Error: %s. Reference: %s. Setting: %s.%s Data: [%s.csv](%s/%s.csv).\n\n' \
		"$error" "$reference" "$setting" "${spread:+ Spread: $spread.}" "$chart" "$links" "$chart"
	awk -f "$here/winners.awk" "$1"
}
