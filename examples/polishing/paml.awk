# Rows of pads, as in.paml writes them, to means over the pads with standard errors, for each number in the first column:
#	at, then mean and error of: N_all N_act force removal | PML: N_all N_elig N_act removal | PI: the same | area gap/um
# With -v fit=1: exponents of the removal by the first column, a line for each model, error by leaving out pad after pad.
/^#/ { next }
{
	if (!($1 in seen)) { seen[$1] = 1; order[++n] = $1 }
	if (!($2 in pads)) { pads[$2] = 1; name[++most] = $2 }
	count[$1]++
	for (k = 3; k <= 19; k++) {
		s[$1, k] += $k
		t[$1, k] += $k * $k
		value[$1, $2, k] = $k
	}
	load[$1] += $4 * $6
}
function mean(a, k) { return s[a, k] / count[a] }
function error(a, k,    v) {
	v = t[a, k] / count[a] - mean(a, k) ^ 2
	return count[a] > 1 && v > 0 ? sqrt(v / (count[a] - 1)) : 0
}
# Slope of log(removal) by log(at), without one pad ("": all of them); "nan": nothing removed somewhere.
function slope(k, without,    i, x, y, sx, sy, sxx, sxy) {
	sx = sy = sxx = sxy = 0
	for (i = 1; i <= n; i++) {
		y = s[order[i], k] - (without == "" ? 0 : value[order[i], without, k])
		if (!(y > 0)) return "nan"
		x = log(order[i]); y = log(y)
		sx += x; sy += y; sxx += x * x; sxy += x * y
	}
	return (n * sxy - sx * sy) / (n * sxx - sx * sx)
}
function exponent(model, k,    i, b, v, sum, square, one) {
	b = slope(k, "")
	for (i = 1; i <= most; i++) {
		one = slope(k, name[i])
		if (one == "nan") { b = "nan"; break }
		sum += one; square += one * one
	}
	if (b == "nan") printf "%s nan nan\n", model
	else {
		v = square / most - (sum / most) ^ 2
		printf "%s %.3f %.3f\n", model, b, (v > 0 ? sqrt((most - 1) * v) : 0)
	}
}
END {
	if (fit) {
		exponent("pml", 13); exponent("pi", 17); exponent("paml", 8); exponent("paml_active", 4)
		exit
	}
	for (i = 1; i <= n; i++) {
		a = order[i]
		printf "%g %.5g %.2g %.4g %.2g %.4g 0 %.4g %.2g", a, mean(a, 3), error(a, 3), mean(a, 4), error(a, 4), (s[a, 4] > 0 ? load[a] / s[a, 4] : 0), mean(a, 8), error(a, 8)
		for (k = 10; k <= 18; k++)
			printf " %.5g %.2g", mean(a, k), error(a, k)
		printf " %.4g %.2g\n", 1e6 * mean(a, 19), 1e6 * error(a, 19)
	}
}
