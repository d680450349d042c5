# RESULT lines: how far measured points lie from the simulated curve of test 4. Input: impact.txt and
# kharaz2001.txt. Below 9 degrees parts of the contact stick while others slip, which a spring does not know:
# those points are left out.
BEGIN {
	degree = atan2(0, -1) / 180
	split("restitution spin rebound", name)
	split("0.06 60 2", within)
}
FNR == NR {
	if ($1 == 4 && $2 == "oxide") {
		angle[++n] = atan2($5, $4) / degree
		value[1, n] = $8 / $5
		value[2, n] = $9
		value[3, n] = atan2($8, $7 * $4) / degree
	}
	next
}
NF == 0 { new = 1 }
NF == 2 {
	set += new
	new = 0
	for (k = 1; k < n && !(angle[k] <= $1 && $1 <= angle[k + 1]); k++);
	if (k == n || $1 < 9)
		next
	part = ($1 - angle[k]) / (angle[k + 1] - angle[k])
	simulated = (1 - part) * value[set, k] + part * value[set, k + 1]
	off = simulated - $2
	print "RESULT 4.measured." name[set] "." $1, sprintf("%.6g", simulated), $2, within[set],
		off <= within[set] && -off <= within[set] ? "ok" : "off"
}
