#!/bin/bash
# make book-html: all pages, without a warning; nothing is fetched from the network; formulas are MathML; a dead link is an
# error.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs sphinx-build python3-sphinx
needs pandoc
sed -n '1s/^#! *//p' "$(command -v sphinx-build)" >interpreter
if ! "$(cat interpreter)" -c 'import myst_parser' 2>/dev/null; then
	echo 'skipped: needs MyST (apt-get install python3-myst-parser)'
	exit 77
fi
book() { # SOURCE OUTPUT WORDS...
	local source=$1 out=$2
	shift 2
	sphinx-build -q -W --keep-going -c "$source/book" -d trees-"$out" -b html "$@" "$source" "$out" >log 2>&1
}
# a small copy, with a dead link
mkdir -p small/styles && cp -r "$top_srcdir/doc/book" small && cp "$top_srcdir"/doc/styles/{fix_gravity,fix_nve}.md small/styles &&
	printf '# Commands and styles\n\n## fix\n\n- [gravity](fix_gravity.md) — a\n- [nve](fix_nve.md) — b\n' >small/styles/index.md &&
	printf '# Book\n\n## Part\n\n- [Styles](styles/index.md) — all\n- [Page](page.md) — a page\n' >small/index.md
printf '# Page\n\nAs fix gravity does: $`a^2`$\n\n```math\nF = \\frac{m}{a}\n```\n' >small/page.md
book small good
report 'a small book' $? log
grep -q '<math' good/page.html && grep -q '<mfrac>' good/page.html
report 'formulas are MathML' $? good/page.html
grep -q 'href="styles/fix_gravity.html"' good/page.html
report 'a style that is named is a link' $? good/page.html
grep -q '^"styles/fix_gravity": "fix gravity ' good/searchtexts.js && grep -q '^"page": "Page As fix gravity does' good/searchtexts.js
report 'the search has the texts of all pages' $? good/searchtexts.js
sed -n '/class="sphinxsidebar"/,$p' good/styles/fix_nve.html >beside
grep -q 'toctree-l1 current"><a class="reference internal" href="index.html">Styles<' beside &&
	grep -q 'toctree-l1"><a class="reference internal" href="../page.html">Page<' beside
report 'the list of pages beside each page marks the one that leads to it' $? beside
printf '\nSee [nothing](nothing.md).\n' >>small/page.md
! book small bad
report 'a dead link is an error' $? log

book "$top_srcdir/doc" html
report 'the book' $? log
[ "$(find html -name '*.html' | wc -l)" -ge 380 ]
report 'a page for each style' $?
grep -rlE '<(script|link|img)[^>]*(src|href)="(https?:)?//' html --include=*.html >fetched
[ ! -s fetched ]
report 'nothing is fetched' $? fetched
grep -q 'repos' html/searchindex.js && grep -q 'wall/gran' html/genindex.html && [ -s html/_static/book.css ]
report 'search and index' $?
finish
