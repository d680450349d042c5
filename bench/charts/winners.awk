# The table of a chart: for each problem and decade of the error, the cheapest point that is at least so exact. Errors above
# one half are not worth a row.
BEGIN { FS = "," }
/^#/ || $1 == "chart" { next }
$8 == 1 && $5 <= 0.5 {
	n++
	problem[n] = $2; method[n] = $3; setting[n] = $4; error[n] = $5 + 0; seconds[n] = $6 + 0
	if (!($2 in seen)) { seen[$2] = 1; names[++m] = $2 }
	if ($2 != "") many = 1
}
END {
	printf "|%s error at most | method | setting | error | seconds |\n", many ? " problem |" : ""
	printf "|%s---|---|---|---|---|\n", many ? "---|" : ""
	for (p = 1; p <= m; p++) {
		last = 0
		for (e = 2; e >= -17; e--) {
			limit = 10^e * (1 + 1e-9)
			best = 0
			for (i = 1; i <= n; i++)
				if (problem[i] == names[p] && error[i] <= limit && (!best || seconds[i] < seconds[best]))
					best = i
			# the coarsest limit that a point meets says it all
			if (!best || best == last) continue
			last = best
			printf "|%s %s | %s | %s | %.2g | %.3g |\n", many ? " " names[p] " |" : "",
				error[best] == 0 ? "0" : sprintf("1e%d", ceiling(log(error[best]) / log(10))),
				method[best], setting[best], error[best], seconds[best]
		}
	}
}
function ceiling(x,	y) { y = int(x); return x > y + 1e-9 ? y + 1 : y }
