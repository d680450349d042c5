# Limits of stability where contacts are many: from the table that tests/stability/check_network writes
title='Largest stable time step with many contacts, measured by bisection'
budget=5

figure() {
	# single-contact limit 'inf': there is none, 0
	awk '/^Many contacts/ { on = 1; next } on && NF < 6 && seen { exit }
		on && NF >= 6 { seen = 1; n = split($0, w); name = ""; for (k = 1; k <= n - 5; k++) name = name (k > 1 ? " " : "") w[k]
			if (name ~ /^the same/ && base) sub(/^the same/, base, name); else { base = name; sub(/ held ones$/, "", base) }
			printf "\"%s\" %s %s %s %s\n", name, w[n-4], w[n-3], w[n-2], w[n] == "inf" ? 0 : w[n] }' \
		"$top/doc/stability.txt" >"$work/networks.dat"
	gnuplot -e "format='$1'; data='$work/networks.dat'; file='$2'" "$here/networks.gp"
}
