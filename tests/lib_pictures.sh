# For tests of pictures: which colour at which pixel. To be read after lib_cases.sh.

# pixel FILE COLUMN ROW: sets `pixel` to "r g b" of a .ppm file
pixel() {
	local magic size most width red green blue
	{ IFS= read -r magic && IFS= read -r size && IFS= read -r most; } <"$1"
	width=${size%% *}
	read -r red green blue < <(od -An -tu1 -N 3 -j $((${#magic} + ${#size} + ${#most} + 3 + 3 * ($3 * width + $2))) "$1")
	pixel="$red $green $blue"
}
# is WHAT FILE COLUMN ROW COLOUR
is() {
	local pixel
	pixel "$2" "$3" "$4"
	[ "$pixel" = "$5" ]
	report "$1: $pixel, expected $5" $?
}
# near WHAT FILE COLUMN ROW COLOUR: each part within 2
near() {
	local pixel expected found k off=0
	pixel "$2" "$3" "$4"
	read -ra found <<<"$pixel"
	read -ra expected <<<"$5"
	for k in 0 1 2; do
		[ -n "${found[k]}" ] && ((found[k] - expected[k] <= 2 && expected[k] - found[k] <= 2)) || off=1
	done
	report "$1: $pixel, expected $5" $off
}
