# The skin of the neighbour search
title='Skin of the neighbour list: collapse of 2940 grains in a box'
kind=Grains
error='relative difference of positions'
reference='a skin of 0.2 diameters'
setting='skin / grain diameter'
price='skin / grain diameter'
budget=15
deck=$here/collapse.in
pick='any value if all faces are fixed, because each search chooses a skin suitable for the present speeds. With other faces,
and if lost particles are ignored, the skin is at most the given one: use 0.2 diameters or more. The skin affects only the computing
time. In this box results are the same bitwise (all differences are 0), because pairs are found before they touch and forces are
summed in a fixed order. (With periodic faces particles are wrapped at rebuilds of the lists, which changes the rounding of
positions.)'

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
