#!/bin/sh
# Grammar files for editors: vim takes its one and marks an example as it should; the one of VS Code is
# JSON whose patterns can be compiled and find what they are for.
. "$top_srcdir/tests/lib_cases.sh"
top_srcdir=$(cd "$OLDPWD" && cd "$top_srcdir" && pwd)

"$TSIM" -grammar vim >tsim.vim
"$TSIM" -grammar vscode >tsim.json
"$TSIM" -grammar emacs >out 2>err
[ $? = 2 ] && shows "expected vim, vscode or bash after -grammar, found 'emacs'" err
report 'another editor' $? err

cat >in.scene <<'END'
# a comment
units		si
fix	down all gravity ${g} vector 0 0 -1
variable x equal "sqrt(2.5)*v_y" # remark
compute c all reduce sum c_k[1] &
	inputs peratom
print "depth ${depth} and $(v_x)"
  region box block 0 1.5e-3 INF EDGE 0 1 units box
dump d all custom 100 a.dump id radius
END

if ! vim --version 2>/dev/null | grep -q '+syntax'; then
	echo 'skipped: needs vim with syntax colours (apt-get install vim)'
else
	cat >ask.vim <<'END'
let out = []
for [line, column] in [[1,3], [2,1], [3,1], [3,10], [3,18], [3,23], [3,28], [3,38], [4,21], [4,36], [5,15], [5,26], [5,33], [7,8], [7,16], [8,3], [8,14], [8,22], [8,29], [9,12], [9,30]]
	call add(out, line . ',' . column . ' ' . synIDattr(synID(line, column, 1), 'name'))
endfor
call writefile(out, 'groups')
qa!
END
	mkdir -p vim/syntax
	cp -r "$top_srcdir/editors/vim/ftdetect" vim
	cp tsim.vim vim/syntax
	vim -Nu NONE -es -c "set rtp^=$work/vim" -c 'filetype on' -c 'syntax on' \
		-c 'e in.scene' -c 'so ask.vim' >out 2>&1 </dev/null
	cat >expected <<'END'
1,3 tsimComment
2,1 tsimCommand
3,1 tsimCommand
3,10 tsimHead
3,18 tsim_fix
3,23 tsimVariable
3,28 tsimKeyword
3,38 tsimNumber
4,21 tsimString
4,36 tsimComment
5,15 tsim_compute
5,26 tsimReference
5,33 tsimContinuation
7,8 tsimString
7,16 tsimVariable
8,3 tsimCommand
8,14 tsim_region
8,22 tsimNumber
8,29 tsimKeyword
9,12 tsim_dump
9,30 tsimName
END
	same 'vim marks an example' expected groups
fi

"$TSIM" -grammar bash >complete
# completes WORDS EXPECTED: what bash offers for the last of the words
completes() {
	bash -c '. ./complete
		read -ra COMP_WORDS <<<"$1"
		[ "${1: -1}" = " " ] && COMP_WORDS+=("")
		COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
		_tsim
		printf "%s\n" "${COMPREPLY[@]}"' bash "$1" >out 2>&1
	grep -qxF -- "$2" out
	report "bash completes '$1'" $? out
}
touch in.scene
completes 'tsim -cross' '-crosscheck'
completes 'tsim -echo ' 'screen'
completes 'tsim -help grav' 'gravity'
completes 'tsim -help fix wall/' 'wall/gran'
completes 'tsim -help pair ' 'gran'
completes 'tsim -in in.sc' 'in.scene'
completes 'tsim -log x -in ./in.sc' './in.scene'

if has python3; then
	python3 - "$top_srcdir/editors/vscode" tsim.json >out 2>&1 <<'END'
import json, re, sys
folder = sys.argv[1]
package = json.load(open(folder + "/package.json"))
json.load(open(folder + "/" + package["contributes"]["languages"][0]["configuration"]))
grammar = json.load(open(sys.argv[2]))
assert package["contributes"]["grammars"][0]["scopeName"] == grammar["scopeName"]
rules = grammar["patterns"] + grammar["repository"]["variable"]["patterns"]
def first(text, scope):
    for rule in rules:
        for key in ("match", "begin", "end"):
            if key in rule:
                re.compile(rule[key])
        found = re.search(rule["match"], text) if "match" in rule else None
        names = [rule.get("name", "")] + [c["name"] for c in rule.get("captures", {}).values()]
        if found and any(n.startswith(scope) for n in names):
            return found
    raise SystemExit("%s not found in %s" % (scope, text))
line = "  fix down all drag/stokes axes z # remark"
assert first(line, "support.type.fix").group(2) == "drag/stokes"
assert first("write_restart a", "keyword.control").group().strip() == "write_restart"
assert first("v_a*sqrt(2)", "support.function").group() == "sqrt"
assert first("0 0 -1.5e-3", "constant.numeric").group() == "0"
assert first("x c_k[1]", "variable.other").group() == "c_k[1]"
assert first("x ${k}", "variable.parameter").group() == "${k}"
assert first("a &", "punctuation").group() == "&"
assert first(line, "comment").group() == "# remark"
END
	report 'the grammar of VS Code' $? out
fi
finish
