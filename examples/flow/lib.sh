# For the studies: finds the program, goes to the folder of the results. TSIM names it (default: ../../../build/tsim,
# else tsim).
set -e -o pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here"
tsim=${TSIM:-../../../build/tsim}
[ -x "$tsim" ] || tsim=$(command -v tsim) || { echo "study: no tsim found, set TSIM" >&2; exit 1; }
mkdir -p results

# run DECK -var NAME VALUE ...: its lines that begin with a capital word
run() {
	local deck=$1
	shift
	"$tsim" -in "$deck" -log none "$@" >results/screen 2>&1 || { tail -n 4 results/screen >&2; exit 1; }
	grep -E '^[A-Z]+ ' results/screen
}

# slopes FILE: lines `key h error`; the order between neighbours of a key: `key h error order`
slopes() {
	awk '{ line = $0
	       if ($1 == key && $3 > 0 && error > 0) line = line sprintf(" %.2f", log(error / $3) / log(h / $2))
	       print line
	       key = $1; h = $2; error = $3 }' "$1"
}

# plot FILE [NAME=VALUE ...]: a chart, its variables set before
plot() {
	local file=$1
	shift
	if command -v gnuplot >/dev/null; then
		gnuplot -e "$*" "$file"
	else
		echo "gnuplot is not installed: no plot, the numbers are in results"
	fi
}
