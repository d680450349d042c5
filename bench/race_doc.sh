# shellcheck shell=bash disable=SC2034,SC2154
# For bench/race: puts head and table in place of what is between the marks `race` in the file $doc.
{
	sed 's/^/- /' head
	cat <<'END'

Times are in nanoseconds per particle and step: "processor" is processor time, "wall" the loop time, "spread" the
spread over the rounds. The last columns are the times of the other program divided by those of tsim on one thread.

| scene | particles | commands of | tsim, processor (spread) | tsim, wall | tsim, 2 threads, wall | other, processor (spread) | other, wall | bound | bytes per particle, tsim : other | list builds | other / tsim, processor | wall |
|---|---|---|---|---|---|---|---|---|---|---|---|---|
END
	awk -F , '
		$4 == "tsim" && $5 == 1 { order[++n] = $1 FS $6; one[$1, $6] = $0; next }
		$4 == "tsim" { two[$1, $6] = $9; next }
		{ peer[$1, $6, ++peers[$1, $6]] = $0 }
		function over(a, b) { return b > 0 ? sprintf("%.2f", a / b) : "-" }
		function name(program) {
			return program == "lammps" ? "LAMMPS" : program == "liggghts" ? "LIGGGHTS" : program == "esys" ? "ESyS-Particle" : "Yade"
		}
		END {
			for (k = 1; k <= n; k++) {
				split(order[k], key, FS)
				split(one[key[1], key[2]], a, FS)
				for (j = 1; j == 1 || j <= peers[key[1], key[2]]; j++) {
					m = split(peer[key[1], key[2], j], p, FS)
					printf "| %s | %d | %s | %.1f (%.1f) | %.1f | %s | ", a[1], a[2], name(m ? p[4] : a[6]), a[7], a[8], a[9],
						(key[1], key[2]) in two ? sprintf("%.1f", two[key[1], key[2]]) : "-"
					if (m) printf "%.1f (%.1f) | %.1f | %.1f | %d : %d | %d | %s | %s |\n", p[7], p[8], p[9], a[14], a[12], p[12], a[13],
						over(p[7], a[7]), over(p[9], a[9])
					else printf "- | - | %.1f | %d : - | %d | - | - |\n", a[14], a[12], a[13]
				}
			}
		}' <(tail -n +2 all.csv)
} >table.md
awk '
	FNR == NR { table = table $0 "\n"; next }
	/^<!-- end of race -->/ { hidden = 0 }
	!hidden
	/^<!-- race -->/ { printf "%s", table; hidden = 1; found = 1 }
	END { exit !found }' table.md "$doc" >renewed || { echo "$doc has no line <!-- race -->" && exit 1; }
cat renewed >"$doc"
