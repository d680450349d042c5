# Writes the gnuplot script of a chart: a panel for each problem, a line for each method, a band along the front.
# Set: file, format (svg or png), axes (error-seconds, error-setting or seconds-setting), xlabel, ylabel, title.
BEGIN {
	FS = ","
	# colours that also those see apart who do not see all (Okabe and Ito)
	split("#0072B2 #D55E00 #009E73 #CC79A7 #E69F00 #56B4E9 #000000 #8c8c8c", colour, " ")
	split("6 5 9 13 11 7 1 2", mark, " ")
}
BEGIN { column = axes ~ /setting$/ ? "setting" : "seconds" }
/^#/ || $1 == "chart" || $5 !~ /^[-+.0-9]/ { next }
{
	if (!($2 in panel)) { panel[$2] = ++panels; heading[panels] = $2 }
	if (!($3 in line)) { line[$3] = ++lines; name[lines] = $3 }
	n++
	at[n] = panel[$2]; method[n] = line[$3]; error[n] = (axes ~ /^seconds/ ? $6 : $5) + 0; spread[n] = axes ~ /^error/ ? $7 + 0 : 0; front[n] = $8; setting[n] = $4
	x[n] = column == "setting" ? $4 + 0 : $6 + 0
	drawn[at[n], method[n]] = 1
	if (error[n] == 0) zero[at[n]] = 1
	if (spread[n] > 0) bars = 1
	range(at[n], x[n], error[n])
}
function range(p, a, b) {
	if (!(p in xlo) || a < xlo[p]) xlo[p] = a
	if (!(p in xhi) || a > xhi[p]) xhi[p] = a
	if (b > 0 && (!(p in ylo) || b < ylo[p])) ylo[p] = b
	if (!(p in yhi) || b > yhi[p]) yhi[p] = b
}
function floor10(v) { v = log(v) / log(10); return 10^(v < int(v) - 1e-9 ? int(v) - 1 : int(v)) }
# the next of 1, 2, 5, 10 ... below or above
function below(v,	p) { p = floor10(v); v /= p; return p * (v >= 5 ? 5 : v >= 2 ? 2 : 1) }
function above(v,	p) { p = floor10(v); v /= p; return p * (v <= 1.0001 ? 1 : v <= 2 ? 2 : v <= 5 ? 5 : 10) }
function axis_of(p) {
	if (!(p in ylo)) ylo[p] = 1e-15
	if (yhi[p] <= 0) yhi[p] = 1
	floor_of[p] = below(ylo[p] * 0.9)
	if (p in zero) { floor_of[p] = floor10(ylo[p]) / 100; }
	low = (p in zero) ? floor_of[p] / 3 : floor_of[p]
	high = yhi[p] * (yhi[p] / low)^0.15
	printf "set xrange [%g:%g]\n", below(xlo[p] * 0.95), above(xhi[p] * 1.1)
	printf "set yrange [%g:%g]\n", low, high
	decades = log(high / low) / log(10)
	print "unset ytics; set ytics nomirror format '" (decades > 2.5 ? "10^{%T}" : "%g") "'"
	if (decades <= 1.3) print "set ytics add (" ticks(low, high) ")"
	if (p in zero) printf "set ytics add ('0' %g)\n", floor_of[p]
	printf "unset xtics; set xtics nomirror format '%s'\n", column == "setting" && xhi[p] < 1e5 ? "%g" : "%g"
	wide = log(xhi[p] / xlo[p]) / log(10)
	if (wide <= 1.3) print "set xtics add (" ticks(below(xlo[p] * 0.95), above(xhi[p] * 1.1)) ")"
}
# labels of 1, 2, 5 in each decade, and of those between where there is less than one
function ticks(a, b,	text, v, k, some, m) {
	m = split(b / a < 6 ? "1 1.5 2 3 4 5 7" : "1 2 5", some, " ")
	for (v = floor10(a); v <= b; v *= 10)
		for (k = 1; k <= m; k++)
			text = text sprintf("%s'%g' %g", text ? ", " : "", v * some[k], v * some[k])
	return text
}
function shown(i) { return error[i] > 0 ? error[i] : floor_of[at[i]] }
END {
	if (!n) exit
	columns = panels <= 3 ? panels : panels == 4 ? 2 : 3
	rows = int((panels + columns - 1) / columns)
	width = columns == 1 ? 680 : columns == 2 ? 1080 : 1300
	height = rows * (columns == 1 ? 480 : 430) + 30
	if (format == "svg") printf "set terminal svg size %d,%d font 'Helvetica,13' background rgb 'white'\n", width, height
	else printf "set terminal pngcairo size %d,%d font 'Helvetica,10'\n", width, height
	printf "set output '%s'\n", file
	print "set border 3 lc rgb '#444444'; set grid lc rgb '#e5e5e5' lt 1; set tics nomirror"
	print "set logscale xy"
	printf "set xlabel \"%s\"\nset multiplot layout %d,%d title \"%s\" noenhanced\n", xlabel, rows, columns, title
	for (p = 1; p <= panels; p++) panel_of(p)
	print "unset multiplot\nunset output"
}
# the corner of the panel in which the legend covers no points; the upper right one, above all points, if there is none
function corner(p,	name, k, i, u, v, a, b, covered, tall) {
	split("top right,top left,bottom right,bottom left", name, ",")
	a = below(xlo[p] * 0.95); b = above(xhi[p] * 1.1)
	tall = 0.06 * (lines + 1)
	for (k = 1; k <= 4; k++) {
		covered = 0
		for (i = 1; i <= n; i++) {
			if (at[i] != p) continue
			u = log(x[i] / a) / log(b / a); v = log(shown(i) / low) / log(high / low)
			if (name[k] ~ /right/) u = 1 - u
			if (name[k] ~ /top/) v = 1 - v
			covered += u < 0.5 && v < tall
		}
		if (!covered) return name[k]
	}
	printf "set yrange [%g:%g]\n", low, high * (high / low)^(tall / (1 - tall))
	return name[1]
}
function panel_of(p,	i, m, text, any, look, bottom) {
	axis_of(p)
	printf "set title \"%s\" noenhanced\n", heading[p]
	if ((p - 1) % columns == 0) printf "set ylabel \"%s\"\n", ylabel
	else print "unset ylabel"
	print "set key " (p == 1 ? corner(p) " samplen 2 spacing 1.1 noenhanced opaque" : "off")
	text = ""
	if (column == "seconds") {
		printf "$front%d << END\n", p
		sorted(p)
		print "END"
		text = "$front" p " using 1:2 with lines lw 9 lc rgb '#f0e2a8' title 'Pareto front'"
	}
	for (m = 1; m <= lines; m++) {
		if (p != 1 && !((p, m) in drawn)) continue
		printf "$p%dm%d << END\n", p, m
		any = 0
		for (i = 1; i <= n; i++)
			if (at[i] == p && method[i] == m) {
				bottom = error[i] - spread[i]
				print x[i], shown(i), (bottom > low ? bottom : low), error[i] + spread[i]
				any = 1
			}
		if (!any) print "nan nan nan nan"
		print "END"
		look = sprintf("lc rgb '%s'", colour[(m - 1) % 8 + 1])
		if (bars) # first, so that they do not cross the marks out
			text = text (text ? ", \\\n" : "") sprintf("$p%dm%d using 1:2:3:4 with yerrorbars lw 1 pt -1 %s notitle",
				p, m, look)
		text = text (text ? ", \\\n" : "") sprintf("$p%dm%d using 1:2 with linespoints lw 1.8 ps %g pt %s %s title \"%s\"",
			p, m, m == 1 ? 1.6 : 0.9, mark[(m - 1) % 8 + 1], look, name[m])
	}
	if (column == "seconds") text = text ", \\\n$front" p " using 1:2:3 with labels noenhanced font ',8' tc rgb '#555555' left offset 0.4,0.7 notitle"
	print "plot " text
}
# the points of the front in the order of their cost, with their settings
function sorted(p,	i, k, done, best) {
	for (k = 1; k <= n; k++) {
		best = 0
		for (i = 1; i <= n; i++)
			if (at[i] == p && front[i] == 1 && !(i in done) && (!best || x[i] < x[best])) best = i
		if (!best) { if (k == 1) print "nan nan nan"; return }
		done[best] = 1
		printf "%g %g \"%s\"\n", x[best], shown(best), setting[best]
	}
}
