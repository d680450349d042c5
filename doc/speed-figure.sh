#!/bin/sh
# Draws doc/figures/speed.png from the table of doc/speed.md: processor time of the other program by that of tsim.
#	sh doc/speed-figure.sh
cd "$(dirname "$0")/.." || exit 1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
awk -F' *[|] *' '/^<!-- end of race/ { exit } $4 == "LIGGGHTS" || $4 == "LAMMPS" { if (!(($2, $4) in t)) { t[$2, $4] = $(NF - 2)
	if (!($2 in seen)) { seen[$2] = 1; name[n++] = $2 } } }
	END { for (k = 0; k < n; k++) { a = t[name[k], "LIGGGHTS"]; b = t[name[k], "LAMMPS"]
		print name[k], a == "" ? 0 : a, b == "" ? 0 : b } }' doc/speed.md >"$work/table"
gnuplot <<END
set terminal pngcairo size 1000,360 font ",11"
set output 'doc/figures/speed.png'
set style data histograms
set style histogram clustered gap 1
set style fill solid 0.9 border -1
set boxwidth 0.9
set yrange [0:*]
set xtics rotate by -30
set ylabel 'time of the other / time of tsim'
set grid ytics
set key outside right top
set title 'Computing time of LIGGGHTS and LAMMPS, one process, relative to that of tsim, one thread (doc/speed.md)'
set arrow from graph 0, first 1 to graph 1, first 1 nohead lw 2
plot '$work/table' using 2:xtic(1) title 'LIGGGHTS 3.8' lc rgb '#d08030', '' using 3 title 'LAMMPS 2021' lc rgb '#3070b0'
END
