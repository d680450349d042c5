# Reads C files, prints one line "kind name type symbol file" per TS_STYLE mark.
# The name is the first .name of the table `symbol` that follows the mark. A style of kind fix stands in a file
# fix_*.c; only the commands of the script language itself are in files of other names (src/script).

function fail(message)
{
	print FILENAME ":" FNR ": " message > "/dev/stderr"
	failed = 1
}

function finish_file()
{
	for (s in type_of) {
		print file ": table " s " has no name" > "/dev/stderr"
		failed = 1
		delete type_of[s]
	}
}

FNR == 1 {
	finish_file()
	file = FILENAME
	symbol = ""
}

/^TS_STYLE\(/ {
	line = $0
	sub(/^TS_STYLE\(/, "", line)
	sub(/\).*/, "", line)
	if (split(line, part, /[ \t]*,[ \t]*/) != 3) {
		fail("expected TS_STYLE(kind, type, symbol)")
		next
	}
	if (file !~ "/" part[1] "_[^/]*$" && file !~ /^src\/script\//)
		fail("a " part[1] " style in a file that is not named " part[1] "_*.c")
	kind_of[part[3]] = part[1]
	type_of[part[3]] = part[2]
}

# "const struct ts_style ts_fix_gravity = {"
/^const struct [a-z_]+ [a-z0-9_]+ = / {
	symbol = $4
	if (!(symbol in type_of))
		symbol = ""
	else if ($3 != type_of[symbol])
		fail("table " symbol " is of type " $3 ", its mark says " type_of[symbol])
}

symbol != "" && /\.name = "[^"]*"/ {
	match($0, /\.name = "[^"]*"/)
	name = substr($0, RSTART + 9, RLENGTH - 10)
	print kind_of[symbol], name, type_of[symbol], symbol, file
	delete type_of[symbol]
	symbol = ""
}

END {
	finish_file()
	if (failed)
		exit 1
}
