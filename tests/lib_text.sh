# For shell tests: a text in the output of a program.

# bounded TEXT: sets `bounded` to the Perl pattern of TEXT where it is no part of a longer word or number: 'count 1' is not in
# 'count 17', nor '1.2' in '-1.2', '31.2', '1.25' or '1.2e-3'
bounded() {
	local before='' after=''
	case $1 in
	[0-9]*) before='(?<![\w.+-])' ;;
	[[:alpha:]_]*) before='(?<!\w)' ;;
	.[0-9]*) before='(?<!\d)' ;;
	[-+][0-9]*) before='(?<!\d[eE])' ;;
	esac
	case $1 in
	*[0-9]) after='(?!\w|\.\d)' ;;
	*[[:alpha:]_]) after='(?!\w)' ;;
	*[0-9].) after='(?!\d)' ;;
	esac
	bounded=$before\\Q${1//\\E/\\E\\\\E\\Q}\\E$after
}

# shows TEXT FILE...: whether a line of a file has TEXT, not as a part of a longer word or number
shows() {
	local bounded
	bounded "$1"
	shift
	grep -qP -- "$bounded" "$@"
}

# says_line LINE FILE: whether LINE is a whole line of the file; '*TEXT' need only be a part of one
says_line() {
	case $1 in
	\**) shows "${1#\*}" "$2" ;;
	*) grep -qxF -- "$1" "$2" ;;
	esac
}
