# For tests of src/ as compiled: makes the folder $work, with the lists `sources` (C files and headers of src/ but the generated
# table of styles) and `objects`, and goes to the folder of the sources. $builddir is where objects are.
command -v nm >/dev/null || { echo 'skipped: needs nm (apt-get install binutils)'; exit 77; }
builddir=$(cd "${top_builddir:-.}" && pwd)
cd "${top_srcdir:-$(dirname "$0")/../..}" || exit 99
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# the generated table of styles alone names them all
find src -mindepth 2 -name '*.[ch]' ! -path src/library/style_table.c | sort >"$work/sources"
sed -n "s|^\\(.*\\)\\.c$|$builddir/\\1.o|p" "$work/sources" >"$work/objects"
xargs ls <"$work/objects" >/dev/null || exit 99
