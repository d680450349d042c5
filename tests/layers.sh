#!/bin/sh
# A folder of src/ includes from itself and from the folders it stands on, nothing else; a style
# never includes another style.
cd "$top_srcdir/src" || exit 1

allowed() {
	case $1 in
	base) echo base ;;
	math) echo base math ;;
	law) echo base math law ;;
	core) echo base math core ;;
	particles) echo base math geom core particles ;;
	script) echo base math core script ;;
	geom) echo base math geom ;;
	neigh) echo base math geom core particles law neigh ;;
	flow) echo base math geom core particles law flow ;;
	io) echo base math geom core particles io ;;
	crosscheck) echo base math core io crosscheck ;;
	advise) echo base math core io neigh particles script crosscheck advise ;;
	program) echo base core crosscheck advise script program tsim.h ;;
	library) echo base math geom core particles script library tsim.h ;;
	review) echo base math law geom core particles neigh review ;;
	styles) echo base math law geom core particles neigh flow io ;;
	esac
}

find . -mindepth 2 -name '*.[ch]' ! -name style_table.c | sort | sed 's|^\./||' |
while read -r file; do
	folder=${file%%/*}
	sed -n 's/^[ \t]*#[ \t]*include[ \t]*"\([^"]*\)".*/\1/p' "$file" | while read -r header; do
		case $header in
		*/* | tsim.h) ;;
		*)
			echo "src/$file: includes \"$header\"; paths are relative to src/"
			continue
			;;
		esac
		case " $(allowed "$folder") " in
		*" ${header%%/*} "*) ;;
		*) echo "src/$file: $folder must not include from ${header%%/*} (\"$header\")" ;;
		esac
	done
done >"${TMPDIR:-/tmp}/layers.$$"
cat "${TMPDIR:-/tmp}/layers.$$"
[ ! -s "${TMPDIR:-/tmp}/layers.$$" ]
status=$?
rm -f "${TMPDIR:-/tmp}/layers.$$"
exit $status
