#!/bin/bash
# A report has all its sections, is well-formed, repeats the RESULT lines of the log, and is there after an error, a
# signal, `clear` and without a place on the disk; the run is the same with and without it.
# shellcheck source=tests/lib_cases.sh
. "${top_srcdir:-$(dirname "$0")/../..}/tests/lib_cases.sh" || exit 99

cat >in.more <<'END'
variable	heavy equal 2500	# <b>density</b> & "more"
END
cat >in.fall <<'END'
units		si
atom_style	granular
boundary	p p f
variable	steps index 2000
region		box block 0 0.02 0 0.02 0 0.03 units box
create_box	1 box
neighbor	0.0005 bin
fix		m1 all property/global youngsModulus peratomtype 5e6
fix		m2 all property/global poissonsRatio peratomtype 0.3
fix		m3 all property/global coefficientRestitution peratomtypepair 1 0.6
fix		m4 all property/global coefficientFriction peratomtypepair 1 0.4
pair_style	gran model hertz tangential history
pair_coeff	* *
timestep	1e-5
include		in.more
lattice		sc 0.005 origin 0.5 0.5 0.5
create_atoms	1 box
set		group all diameter 0.002 density ${heavy}
velocity	all create 0.1 5
fix		g all gravity 9.81 vector 0 0 -1
fix		floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix		top all wall/gran model hertz tangential history primitive type 1 zplane 0.03
fix		nve all nve/sphere
fix		books all energy/ledger summary no
thermo_style	custom step atoms ke f_books
thermo		100
variable	unused equal 1
run		${steps}
print		"RESULT atoms $(atoms) 96 0 ok"
print		"RESULT number $(step) 1 0 off"
print		"RESULT unjudged 3"
END

# Checks that tags are closed in the right order, and that no address is outside of the file.
cat >wellformed.py <<'END'
import sys
from html.parser import HTMLParser

VOID = {"meta", "img", "br", "hr", "link", "input"}

class Checker(HTMLParser):
    def __init__(self):
        super().__init__()
        self.open, self.ids, self.links = [], set(), []
    def handle_startendtag(self, tag, attributes):
        self.attributes(attributes)
    def handle_starttag(self, tag, attributes):
        self.attributes(attributes)
        if tag not in VOID:
            self.open.append(tag)
    def attributes(self, attributes):
        for name, value in attributes:
            if name == "id":
                assert value not in self.ids, "twice: id " + value
                self.ids.add(value)
            if name in ("href", "src"):
                assert value[0] == "#" or value.startswith("data:image/png;base64,"), name + " " + value
                self.links += [value[1:]] if value[0] == "#" else []
    def handle_endtag(self, tag):
        assert self.open and self.open[-1] == tag, "</%s> in %s" % (tag, self.open)
        self.open.pop()

text = open(sys.argv[1], encoding="utf-8").read()
checker = Checker()
checker.feed(text)
checker.close()
assert not checker.open, checker.open
assert text.startswith("<!DOCTYPE html>") and text.endswith("</html>\n")
assert all(link in checker.ids for link in checker.links), checker.links
assert "url(" not in text and "@import" not in text and "<script" not in text
END

wellformed() { # WHAT FILE
	python3 wellformed.py "$2" >out 2>&1
	report "$1 is well-formed and complete in itself" $? out
}

has() { # WHAT FILE TEXT...
	local what=$1 file=$2 text missing=0
	shift 2
	for text in "$@"; do
		grep -qF -- "$text" "$file" || { missing=1 && echo "no $text" >out; }
	done
	report "$what" $missing out
}

# ---- a whole run
"$TSIM" -in in.fall -report a/run.html -log log >screen 2>&1
report "run with a report" $? screen
wellformed "page" a/run.html
has "sections" a/run.html 'id="results"' 'id="warnings"' 'id="pictures"' 'id="log"' 'id="energy"' 'id="limits"' \
	'id="times"' 'id="script"' '>finished<' '1 of 2 results ok' 'in.more' "variable 'unused' is never used" \
	'<i># &lt;b&gt;density&lt;/b&gt; &amp; &quot;more&quot;</i>' 'fix nve/sphere' "$TSIM -in in.fall -report a/run.html"
sed -n 's/^RESULT //p' log >wanted
sed -n '/id="results"/,/<\/section>/s/^<tr><td>//p' a/run.html |
	sed 's/<\/td><\/tr>//; s/<\/td><td[^>]*>/ /g; s/ *$//' >found
same "RESULT lines are those of the log" wanted found
# KinEng and the ledger vary, Atoms does not; the third is the time step by its limit
{ grep -o '<svg\|<img' a/run.html | sort | uniq -c | tr -s ' \n' ' '; } >out
[ "$(cat out)" = " 2 <img 2 <svg " ]
report "plots of the columns that vary, two pictures" $? out
[ "$(wc -c <a/run.html)" -lt 300000 ]
report "small page" $?
grep -o 'base64,[^"]*' a/run.html | tail -n 1 | cut -c8- | base64 -d >last.png
python3 -c 'import struct, sys, zlib
d = open("last.png", "rb").read()
assert d[:8] == b"\x89PNG\r\n\x1a\n" and struct.unpack(">II", d[16:24]) == (640, 480)
n, = struct.unpack(">I", d[33:37])
assert len(zlib.decompress(d[41:41 + n])) == 480 * (3 * 640 + 1)' >out 2>&1
report "pictures are PNG" $? out

# ---- the run is the same, and so are its restart files
plain() { sed -n '/^ *Step/,/^Loop/p' "$1" | grep -v Loop; }
(cat in.fall && echo 'write_restart with.restart') >in.with
(cat in.fall && echo 'write_restart without.restart') >in.without
"$TSIM" -in in.with -report b.html picture 100 vz diameter -log with >out 2>&1 &&
	"$TSIM" -in in.without -log without >out 2>&1
report "with and without" $? out
plain with >rows.with
plain without >rows.without
same "rows with and without a report" rows.with rows.without
same "restart files with and without a report" with.restart without.restart
[ "$(grep -c '<img' b.html)" -le 15 ] && grep -q 'One picture in 200 steps is shown, not one in 100' b.html
report "the number of pictures is limited" $?

# ---- commands in the script
(echo 'report file c.html title "A <title>" renew 0.1' && echo 'report picture ends vx diameter size 64 48 modify backcolor white' &&
	cat in.fall && echo clear && echo 'report file c.html' && cat in.fall) >in.command
"$TSIM" -in in.command -log none >out 2>&1
report "report in a script, clear, a second run" $? out
wellformed "its page" c.html
has "both runs are in it" c.html 'A &lt;title&gt;' '2 of 4 results ok' '>2 runs<' 'vx diameter size 64 48'
"$TSIM" -in in.command -report d.html -log none >out 2>&1 && grep -q 'written to d.html, as the command line says' out
report "the option replaces the file" $? out
has "its pictures stay" d.html 'vx diameter size 64 48'
sed '/^run/,$d; s/diameter 0.002/diameter 0.00501/' in.fall >in.steps
for k in $(seq 9); do printf 'timestep %de-6\nrun 1 post no\n' "$k"; done >>in.steps
"$TSIM" -in in.steps -report s.html -log none >out 2>&1 && grep -q 'All 9 runs' s.html &&
	grep -q '<tr><td>9</td><td class="n">9e-06</td>' s.html
report "many limits of the time step are folded behind the nearest" $? out
wellformed "its page" s.html
sed '/^create_atoms/d; /^set/d; /^velocity/d; /^fix.*wall/d; /^run/,$d' in.fall >in.empty
printf 'run 10\nrun 10\n' >>in.empty
"$TSIM" -in in.empty -report t.html -log none >out 2>&1 && ! grep -q '<img' t.html && ! grep -q 'for pictures' t.html
report "nothing to be seen: no picture" $? out
sed '/^run/,$d' in.fall >in.still
echo 'run 0' >>in.still
"$TSIM" -in in.still -report u.html -log none >out 2>&1 && [ "$(grep -c '<img' u.html)" = 1 ] &&
	grep -q 'first and last state, step 0' u.html
report "nothing has changed: one picture" $? out
sed '/^run/,$d' in.fall >in.zero
cat >>in.zero <<'END'
variable k loop 3
variable square equal v_k*v_k
thermo_style custom step cpu v_square
label again
run 0
next k
jump SELF again
variable square equal 9
run 0
run 5
END
"$TSIM" -in in.zero -report z.html -log none >out 2>&1 && grep -q '4 rows, 5 runs' z.html &&
	grep -q '<tr><td>square</td><td class="n">1</td><td class="n">9</td><td class="n">1</td><td class="n">9</td></tr>' z.html
report "rows of one step are left out only where they repeat the last one" $? z.html
wellformed "its page" z.html
(echo 'report picture none' && cat in.fall) >in.none
"$TSIM" -in in.none -report e.html -log none >out 2>&1 && ! grep -q '<img' e.html
report "picture none" $? out

# ---- ends
refused() { # WHAT TEXT SCRIPT WORDS...
	local what=$1 text=$2 script=$3
	shift 3
	"$TSIM" -in "$script" -log none "$@" >out 2>&1
	[ $? -gt 0 ] && grep -qF -- "$text" out
	report "$what" $? out
}
sed 's/^timestep.*/timestep 1e-3/' in.fall >in.large
refused "unstable" 'moves more than its radius' in.large -report f.html
wellformed "page of a failure" f.html
has "failure" f.html '>failed<' 'moves more than its radius' 'class="bad"'
refused "no file" 'is no folder' in.fall -report in.more/x.html
refused "no page" 'must end in .html' in.fall -report x.txt
refused "unknown quantity" "unknown quantity 'nonsense'" in.fall -report g.html picture 100 nonsense diameter
has "the page says so" g.html '>failed<' nonsense
(echo 'report picture 10 nonsense diameter' && cat in.fall) >in.nonsense
refused "unknown quantity without a report" "unknown quantity 'nonsense'" in.nonsense
refused "the same by -check" "unknown quantity 'nonsense'" in.nonsense -check
refused "two reports" 'is written already' <(echo 'report file x.html' && echo 'report file y.html' && cat in.fall)
refused "no number" 'expected none, ends, or a number' in.fall -report h.html picture often vx diameter
refused "a sweep" 'cannot be given together' in.fall -report i.html -sweep n=1,2
"$TSIM" -in in.fall -report new/j.html -check >out 2>&1 && [ ! -e new ]
report "-check writes nothing" $? out
"$TSIM" -in in.fall -report new/j.html -explain -log none >out 2>&1 && [ ! -e new ]
report "-explain writes nothing" $? out
(ulimit -f 20 && "$TSIM" -in in.fall -report full.html -log none >out 2>&1)
[ $? -gt 0 ] && grep -q "writing 'full.html' failed" out && grep -q '^RESULT number 2000 1 0 off' out && ! ls full.html.tmp* 2>/dev/null
report "no space: the run is whole, the exit status tells" $? out

# ---- renewed while it runs, interrupted
"$TSIM" -in in.fall -var steps 100000000 -report k.html renew 0.1 -log none -restart-on-signal none >out 2>&1 &
pid=$!
for _ in $(seq 100); do
	grep -q '<svg' k.html 2>/dev/null && break
	sleep 0.1
done
cp k.html running.html
kill -INT $pid
wait $pid
[ $? = 130 ]
report "interrupted" $? out
wellformed "page of a run" running.html
has "running" running.html '>running<' 'http-equiv="refresh"'
has "page of an interruption" k.html '>interrupted<' 'stopped on request after step' 'last state'
! grep -q 'http-equiv="refresh"' k.html
report "which does not reload itself" $?

# keywords of a picture that share a list are shown once
printf '%s\n' 'boundary f f f' 'region box block 0 1 0 1 0 1 units box' 'create_box 1 box' 'create_atoms 1 single 0.5 0.5 0.5 units box' \
	'region q sphere 0.5 0.5 0.5 0.2 units box' 'fix w all wall/gran hooke 1 NULL 1 NULL 0.5 0 type 1 zplane 0.0' 'pair_style none' \
	'dump d all image 1 q.ppm type diameter wall all color red region q blue filled size 20 20' 'run 0' >in.parts
"$TSIM" -report parts.html -in in.parts -log none >out 2>&1
grep -o 'dump image: [^<;]*' parts.html >shown
grep -q 'diameter diameter wall all color red region q blue filled size' shown && ! grep -q 'mesh\|voxel' shown
report 'keywords of a picture' $? shown

finish
