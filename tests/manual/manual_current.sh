#!/bin/sh
# The committed manual pages and grammar files of editors are those the program writes.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$TSIM" -doc "$work" || exit 1
if ! diff -r "$top_srcdir/doc/styles" "$work"; then
	echo "doc/styles is stale: run make manual and commit the result"
	exit 1
fi
while read -r editor file; do
	"$TSIM" -grammar "$editor" >"$work/grammar" || exit 1
	if ! cmp "$top_srcdir/$file" "$work/grammar"; then
		echo "$file is stale: run make manual and commit the result"
		exit 1
	fi
done <<END
vim editors/vim/syntax/tsim.vim
vscode editors/vscode/syntaxes/tsim.tmLanguage.json
bash editors/bash/tsim
END
