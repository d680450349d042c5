# Models of the contact of a rough surface, and the number of columns
title='Contact of a rough surface with a plane'
kind=Grains
error='relative error, root mean square of three surfaces'
reference='half-space with 1024 columns along each edge, area corrected'
setting='columns along each edge of the surface'
also='columns along each edge'
budget=35
pick='`halfspace` with four columns for the shortest wave (64 here for the self-affine surface): mean gap to 2e-3 and area to 3 % in
milliseconds; 32 columns give 0.2 % of the area. Take the corrected area (c_ID[3]): there are 13 to 20 % too many columns in contact with four columns for
the shortest wave, 2 % with 32. Springs, `winkler`, as stiff as the half-space under the rms wave number have its mean gap to 3 to 6 %, but 60 to 70 % too
much area, on any grid: they are for solids that are made of columns, or where the stiffness is fitted.'

# contact QUANTITY NAME REFERENCE METHOD: a point of the ensemble in $work/output: the root mean square of the errors of NAME
contact() {
	problem="$surface: $1"
	record "$4" $cells "$(awk -v name="$2" -v reference="$3" '
		$1 != "VALUE" { next }
		NR == FNR { if ($2 == reference) r[++n] = $3; next }
		$2 == name { d = $3 / r[++k] - 1; sum += d * d }
		END { print sqrt(sum / k) }' "$work/finest/output" "$work/output")"
}

points() {
	local surface cells model seeds='1 2 3'
	for surface in self-affine Gaussian; do
		idle=0
		ensemble "$seeds" -var surface $surface -var cells 1024 || exit 1
		keep_finest
		for cells in $(levels 48 64 96 128 192 256 512 -- 768); do
			for model in halfspace winkler; do
				idle -var surface $surface -var cells $cells -var model $model -var solve 0
				ensemble "$seeds" -var surface $surface -var cells $cells -var model $model || exit 1
				if [ $model = winkler ]; then
					contact area area corrected winkler
				else
					contact area corrected corrected halfspace
					contact area area corrected 'columns in contact'
				fi
				contact 'mean gap' gap gap "$model"
			done
		done
	done
}
