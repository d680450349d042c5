#!/bin/bash
# The styles that doc/adding-a-style.md shows are made from its text alone, and do what it says.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
page=$top_srcdir/doc/adding-a-style.md

# block AFTER KIND: the first block of this kind behind the first line with these words
block() {
	awk -v after="$1" -v kind="\`\`\`$2" '
		index($0, after) { found = 1 }
		/^```/ && inside { exit }
		inside { print }
		found && $0 == kind { inside = 1 }' "$page"
}

# what `make styles` would do to a tree with these files
mkdir tree && (cd "$top_srcdir" && find src tests -name '*.[ch]' -print0 | tar -c --null -T - src/build) | tar -x -C tree || exit 99
for style in src/force/fix_trap.c src/load/fix_friction_work.c; do
	block "\`$style\`:" c >"tree/$style"
	[ -s "tree/$style" ]
	report "the page shows $style" $?
done
sh tree/src/build/gen-styles.sh "$PWD/lists" >out 2>&1 && grep -q ts_fix_trap lists/src/library/style_table.c
report 'they are entered in the list of styles' $? out
program=$(cd "$top_srcdir" && echo src/main.c src/program/*.c)
# shellcheck disable=SC2086
$CC $CFLAGS -std=gnu11 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -D_GNU_SOURCE -I"$top_srcdir/src" -o with \
	tree/src/force/fix_trap.c tree/src/load/fix_friction_work.c lists/src/library/style_table.c \
	$(printf "$top_builddir/%s.o " ${program//.c/}) "$top_builddir/libtsim.a" $TSIM_LIBS >out 2>&1
report 'they compile without a warning' $? out

./with -help fix trap | grep -q 'spring constant k'
report 'fix trap has help' $?
block 'whose result is known' '' >in.trap
./with -in in.trap -log none >out 2>&1 && grep -qx 'energy 1.28214625, expected 1.28214625' out
report 'fix trap: the energy stays' $? out
sed 's|v_period/1000|v_period/3|' in.trap >in.long
./with -in in.long -log none >out 2>&1
[ $? = 1 ] && grep -q 'exceeds the stability limit 0.537342 of fix trap' out
report 'fix trap: a step too large is refused' $? out

printf '%s\n' '-0.9 -0.9 0 1.9 -0.9 0 -0.9 0.9 0' '1.9 -0.9 0 1.9 0.9 0 -0.9 0.9 0' | solid >plate.stl
block 'a sphere slides without rotation' '' >in.friction
echo 'dump worn all mesh/vtk 1 worn*.vtk f_rubbed[1] plate
run 0' >>in.friction
./with -in in.friction -log none >out 2>&1 && awk '/^friction/ { n++; exit !(($2 - $4) ^ 2 < (2e-3 * $4) ^ 2) } END { exit !n }' out
report 'fix friction_work: friction has taken the energy of the motion' $? out
awk '/^f_rubbed/ { n++; getline; sum = $1 + $2; both = $1 > 0 && $2 > 0 } END { exit !(n == 1 && both && sum > 0) }' worn*.vtk
report 'fix friction_work: dump mesh/vtk writes what each triangle got' $?
finish
