#!/bin/sh
# Makes the charts of doc/accuracy.md: restitution.dat, stability.dat, and both as SVG and PNG.
# Run as `make charts`, or with TSIM set to the program. Takes seconds; needs gnuplot.
set -e
cd "$(dirname "$0")"
tsim=${TSIM:-tsim}

echo "# scheme e steps_per_contact relative_error (largest over 16 phases of entry)" >restitution.dat
for scheme in nve nve/symplectic nve/euler; do
	for e in 1 0.8 0.6 0.4 0.2; do
		for steps in 16 25 50 100 200 400 800 1600 3200 6400 12800; do
			"$tsim" -in restitution.in -log none -var scheme $scheme -var e $e \
				-var steps $steps | sed -n 's/^DATA //p'
		done
		printf '\n\n'
	done
done >>restitution.dat

# system scheme gamma/omega, largest stable omega h
echo "# system scheme gamma/omega0 largest_stable_omega0_h" >stability.dat
awk '$1 == "bond" || $1 == "contact" { print $1, $2, $3, $4 }' ../stability.txt >>stability.dat

gnuplot charts.gp
