# The skin of the neighbour search
title='Skin of the neighbour search: 2940 grains fall together in a box'
kind=Grains
error='relative difference of positions'
reference='the run with a skin of 0.2 diameters'
setting='skin given by the diameter of the grains'
price='skin given by the diameter'
budget=25
deck=$here/collapse.in
pick='Anything: what is given hardly matters where all faces are fixed, as the program takes at each search a skin that suits the
speeds. Through other faces, and where particles that leave are ignored, it is at most what is given: 0.2 diameters or more then. It is a
matter of cost alone: in this box results are the same bit for bit (all
differences are 0), for pairs are found before they can touch, and forces are added in one order. (Through periodic faces grains go at
rebuilds of the lists, which changes the rounding of positions.)'

difference() {
	awk 'FNR < 10 { next }
	     NR == FNR { for (k = 2; k <= 4; k++) reference[$1, k] = $k; next }
	     { for (k = 2; k <= 4; k++) { d += ($k - reference[$1, k])^2; r += reference[$1, k]^2 } }
	     END { print sqrt(d / r) }' "$work/finest/end" "$work/end"
}

points() {
	local skin
	finest -var skin 0.2 -var rayleigh 0.2
	for skin in $(levels 0.01 0.02 0.05 0.1 0.2 0.3 0.5 0.8); do
		point nve/sphere $skin -var skin $skin -var rayleigh 0.2
	done
}
