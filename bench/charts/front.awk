# Marks the Pareto front of each problem: points for which no other one is both at least as exact and at least as cheap,
# and better in one of the two. Errors within a hundredth of each other count as equal. Reads and writes rows of a chart; the last column written is 1 on the front, else 0.
BEGIN { FS = OFS = "," }
{
	row[NR] = $0
	problem[NR] = $2
	error[NR] = $5 + 0
	seconds[NR] = $6 + 0
	number[NR] = $5 ~ /^[-+.0-9]/
}
END {
	for (i = 1; i <= NR; i++) {
		front = number[i]
		for (j = 1; j <= NR && front; j++)
			if (number[j] && problem[j] == problem[i] && error[j] <= 1.01 * error[i] && seconds[j] <= seconds[i] &&
			    (1.01 * error[j] < error[i] || seconds[j] < seconds[i]))
				front = 0
		print row[i], front
	}
}
