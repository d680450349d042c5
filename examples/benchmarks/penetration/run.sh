#!/bin/sh
# The penetration case: sh run.sh [DIAMETER [-var NAME VALUE ...]]. With the grains of 2 mm the bed takes ten
# minutes and the impact twenty; with 0.008 both take seconds. TSIM is the program. ball.txt is drawn by plot.gp.
tsim=${TSIM:-tsim}
here=$(cd "$(dirname "$0")" && pwd)
d=${1:-0.002}
[ $# = 0 ] || shift
"$tsim" -in "$here/in.bed" -log none -var here "$here" -var d "$d" &&
	"$tsim" -in "$here/in.penetration" -log none -var here "$here" -var d "$d" "$@"
