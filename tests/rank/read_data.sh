#!/bin/bash
# read_data on several ranks: each reads a part of the lines and keeps the particles of its block. Particles, output and messages are
# those of one rank, and a rank never has the memory of all.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_ranks.sh
. "$top_srcdir/tests/lib_ranks.sh" || exit 99
has_ranks || exit 77
export OMP_NUM_THREADS=1

# grains N: a file of N^3 grains, some beyond the periodic faces; ids in another order than places, with gaps; velocities in
# another order than ids
grains() {
	awk -v n="$1" 'BEGIN {
		count = n^3
		print "grains\n"
		print count, "atoms\n3 atom types\n"
		print 0, n, "xlo xhi\n" 0, n, "ylo yhi\n" 0, 2 * n, "zlo zhi\n"
		print "Atoms # sphere\n"
		for (k = 0; k < count; k++) {
			if (k % 5 == 0)
				print "# a comment"
			print 3 * ((k * 7919) % count) + 1, 1 + k % 2, 0.9 + 0.01 * (k % 7), 1.5, k % n + 0.5 + (k % 11 == 0) * n, int(k / n) % n + 0.5, int(k / n^2) + 0.5, 0, 0, 0
		}
		print "\nVelocities\n"
		for (k = count - 1; k >= 0; k--)
			print 3 * k + 1, 0.01 * (k % 13), 0, -0.02 * (k % 3), 0, 0.1 * (k % 2), 0
	}'
}
# reading WORDS...: a script that reads the file
reading() {
	printf 'units lj\natom_style sphere\nboundary p f f\nread_data %s\n' "$*"
	cat <<'E'
set type 2 density 1.2
group left id < 300
velocity left set 0.1 0 0 sum yes
thermo_style	custom step atoms ke erotate fmax fnorm density
thermo_modify	lost ignore
E
	laws
	cat <<'E'
run 30
dump end all custom 1 ${out}.dump id type mass radius x y z vx vy vz omegax omegay omegaz fx fy fz ix
dump_modify end format float %.17g
run 3
E
}

grains 8 >grains.data
gzip -c grains.data >packed.data.gz
reading grains.data >in.plain
same_on plain 2 3 4 7
gathered 0 4
reading packed.data.gz >in.gz
same_on gz 3
mkfifo pipe
sed 's/grains.data/pipe/' in.plain >in.pipe
for file in grains.data packed.data.gz; do # read before the writer ends, from the copy that the first rank gives the others
	cat "$file" >pipe &
	on_ranks 3 timeout 60 "$TSIM" -in in.pipe -log none -screen none -var out piped >out 2>&1 </dev/null
	report "$file through a pipe on 3 ranks" $? out
	"$TSIM" -in in.plain -log none -screen none -var out plain >out 2>&1
	same "the same particles" plain.dump piped.dump
	wait
done
reading grains.data extra/atom/types 2 offset 1 0 shift 0 0 0.25 group rock >in.words
same_on words 2
grains 2 >few.data
sed 's/grains.data/few.data/' in.plain >in.few
same_on few 7
sed '/^Velocities/,$d' grains.data >still.data
sed 's/grains.data/still.data/' in.plain >in.still
same_on still 3
{ sed '/^group/,$d' in.plain; echo 'read_data few.data add append shift 0 0 8.5'; sed -n '/^group/,$p' in.plain; } >in.append
same_on append 3

# Errors are those of one rank, told once.
n=0
while read -r change; do
	n=$((n + 1))
	sed "$change" grains.data >wrong.data
	sed 's/grains.data/wrong.data/' in.plain >in.wrong
	"$TSIM" -in in.wrong -log none -var out one >one 2>&1
	[ $? -ne 0 ] && grep '^wrong.data.*error' one >one.error
	report "an error: $change" $? one
	on_ranks $((n % 3 + 2)) "$TSIM" -in in.wrong -log none -var out many >many 2>&1 </dev/null
	[ $? -ne 0 ] && grep '^wrong.data.*error' many >many.error
	same "the same on $((n % 3 + 2)) ranks" one.error many.error
done <<'E'
620s/[0-9.]* *$/x/
302s/ 1.5 / -1.5 /
500s/^[0-9]*/1/
20s/^[0-9]*/1000000/
40s/^\([0-9]*\) [0-9]/\1 4/
62s/1.5 \([0-9.]*\) [0-9.]*/1.5 \1 -3/
700s/$/ 3 4/
800s/^[0-9]*/2/
1000,$d
400,450d
90s/^/junk /
91s/^/junk /
3s/atoms/atom/
E

# The memory of a rank that reads its particles and does a step.
measures_memory || { finish; exit; }
for k in 20 60; do
	grains $k >grains$k.data
	{ reading "grains$k.data"; } | sed '/^run 30/,$d' >in.step$k
	echo 'run 1' >>in.step$k
done
most_bytes 2 360 in.step20 in.step60
most_bytes 4 220 in.step20 in.step60
finish
