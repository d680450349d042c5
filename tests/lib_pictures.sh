# For tests of pictures: which colour at which pixel. To be read after lib_cases.sh.

# pixel FILE COLUMN ROW: "r g b" of a .ppm file
pixel() {
	local width head
	width=$(head -n 2 "$1" | tail -n 1 | cut -d' ' -f1)
	head=$(head -n 3 "$1" | wc -c)
	tail -c +$((head + 3 * ($3 * width + $2) + 1)) "$1" | head -c 3 | od -An -tu1 | xargs
}
# is WHAT FILE COLUMN ROW COLOUR
is() {
	[ "$(pixel "$2" "$3" "$4")" = "$5" ]
	report "$1: $(pixel "$2" "$3" "$4"), expected $5" $?
}
# near WHAT FILE COLUMN ROW COLOUR: each part within 2
near() {
	paste -d' ' <(pixel "$2" "$3" "$4") <(echo "$5") | awk '{ exit !(($1 - $4) ^ 2 <= 4 && ($2 - $5) ^ 2 <= 4 && ($3 - $6) ^ 2 <= 4) }'
	report "$1: $(pixel "$2" "$3" "$4"), expected $5" $?
}
