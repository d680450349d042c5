#!/bin/sh
# The eight contact tests of Chung and Ooi (2011): results.txt has all RESULT lines, impact.txt what
# plot.gp draws (gnuplot plot.gp). They are written here or in the folder that is named. TSIM is the program.
tsim=${TSIM:-tsim}
here=$(cd "$(dirname "$0")" && pwd)
cd "${1:-.}" || exit 1
rm -f results.txt impact.txt
status=0

# impact TEST NAME=VALUE ...
impact() {
	set -- "test=$@"
	for pair; do
		set -- "$@" -var "${pair%%=*}" "${pair#*=}"
		shift
	done
	"$tsim" -in "$here/in.impact" -log none -var here "$here" "$@" >out 2>&1 || { tail -n 3 out; status=1; }
	grep '^RESULT' out >>results.txt
}

glass='material=glass young=48e9 poisson=0.2 density=2800'
limestone='material=limestone young=20e9 poisson=0.25 density=2500'
aluminium='material=aluminium young=70e9 poisson=0.3 density=2699'
magnesium='material=magnesium young=40e9 poisson=0.35 density=1800'
oxide='material=oxide young=380e9 poisson=0.23 density=4000'
iron='material=iron young=100e9 poisson=0.25 density=7000'
alloy='material=alloy young=70e9 poisson=0.33 density=2700'
steel='material=steel young=208e9 poisson=0.3 density=7850'
plastic='material=polyethylene young=1e9 poisson=0.4 density=1400'
copper='material=copper young=120e9 poisson=0.35 density=8900'
plane='radius2=0 v2=0 stiffer=1000'

sine() { echo "$1" | awk '{ print sin($1 * atan2(0, -1) / 180) }'; }
cosine() { echo "$1" | awk '{ print cos($1 * atan2(0, -1) / 180) }'; }
tangent() { echo "$1 $2" | awk '{ print $1 * sin($2 * atan2(0, -1) / 180) / cos($2 * atan2(0, -1) / 180) }'; }

# 1 and 2: elastic and straight, of two spheres and on a plane
for material in "$glass" "$limestone"; do
	impact 1 $material
done
for material in "$aluminium" "$magnesium"; do
	impact 2 $material $plane radius=0.1 v1=0.2
done
# 3: straight with damping
for e in 0.2 0.4 0.6 0.8 1; do
	impact 3 $oxide $plane radius=0.0025 v1=3.9 e=$e
	impact 3 $iron $plane radius=0.0025 v1=3.9 e=$e
done
# 4: oblique, always with 3.9 m/s
for angle in 2 5 8 11 15 20 25 30 35 40 45 50 55 60 65 70 80; do
	v="v1=$(echo "$(cosine $angle)" | awk '{ print 3.9 * $1 }') vt=$(echo "$(sine $angle)" | awk '{ print 3.9 * $1 }')"
	impact 4 $oxide $plane radius=0.0025 $v mu=0.092 e=0.98
	impact 4 $alloy $plane radius=0.0025 $v mu=0.092 e=0.98
done
# 5: oblique and elastic, always with the same normal velocity
for angle in 5 15 25 35 45 55 65 75; do
	impact 5 $steel $plane radius=1e-5 v1=5 vt="$(tangent 5 $angle)" mu=0.3
	impact 5 $plastic $plane radius=1e-5 v1=5 vt="$(tangent 5 $angle)" mu=0.3
done
# 6: straight with spin; 7: two equal spheres with equal spins; 8: on a larger sphere at rest
for angle in 10 25 40 55 65 75 80; do
	spin=$(tangent 2 $angle)
	impact 6 $aluminium $plane radius=0.1 v1=0.2 mu=0.4 e=0.5 rigid=1 spin1=-$spin
	impact 6 $copper $plane radius=0.1 v1=0.2 mu=0.4 e=0.5 rigid=1 spin1=-$spin
	impact 7 $aluminium radius=0.1 radius2=0.1 v1=0.2 v2=0.2 mu=0.4 e=0.5 rigid=1 spin1=-$spin spin2=-$spin
	impact 8 $aluminium radius=0.1 radius2=0.5 v1=0.2 v2=0 mu=0.4 e=0.5 rigid=1 spin1=-$spin
done
rm -f out
awk -f "$here/measured.awk" impact.txt "$here/kharaz2001.txt" >>results.txt
awk '{ n++; off += $6 != "ok" } END { print n " results, " 0 + off " off"; exit !n || off }' results.txt &&
	exit $status
exit 1
