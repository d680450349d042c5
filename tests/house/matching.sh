#!/bin/bash
# The tests' own search for a text (tests/lib_text.sh): a wrong number or another word is not found.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# found TEXT LINE, absent TEXT LINE
found() {
	shows "$1" <(printf '%s\n' "$2")
	report "'$1' is in '$2'" $?
}
absent() {
	! shows "$1" <(printf '%s\n' "$2")
	report "'$1' is not in '$2'" $?
}
for line in 'count 17' 'count 1.5' 'count 1e3' 'recount 1' 'count 1_'; do absent 'count 1' "$line"; done
for line in 'count 1' 'a count 1 b' '(count 1)' 'count 1.' 'count 1, 2' '`count 1`' 'f_count[count 1]'; do found 'count 1' "$line"; done
for line in -1.2 31.2 0.1.2 1.25 1.2.5 1.2e-3 +1.2; do absent 1.2 "$line"; done
found -1.2 'x -1.2'
absent -5 1e-5
absent .5 1.5
absent 0. 0.3
absent 'unknown quantity' 'unknown quantitys'
found "'x' (> 0)*[1]\\E.^\$" "error: 'x' (> 0)*[1]\\E.^\$ here"
found '--x' 'a --x'

printf '%s\n' 'n 5 6' 'n 50' ' n 5' >lines
for line in 'n 5' 'n 5 6 ' 50; do
	! says_line "$line" lines
	report "'$line' is no line" $?
done
for line in 'n 5 6' ' n 5' '*n 5' '*50'; do
	says_line "$line" lines
	report "'$line' is a line, or a part of one" $?
done

# what the helpers with these searches make of a wrong number
for wrong in 'prints "print 17" 1' 'prints "print \"n 5 6\"" "n 5"' 'prints "print 1.25" "*1.2"' 'rejects "bogus" "unknown command '\''bogu"' \
	'agree small "print \"is x 1e-20 2e-20\""' 'agree scale "print \"is x 0.11 0.1 0.1\""'; do
	(eval "$wrong"; [ "$failed" = 0 ]) >/dev/null
	[ $? = 1 ]
	report "fails: $wrong" $?
done
finish
