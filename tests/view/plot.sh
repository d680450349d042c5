#!/bin/bash
# tsim -plot: every kind of table, the columns that it finds, what it draws of them, and what it refuses.
set -u
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
export LC_ALL=C
unset LANG COLUMNS

# draws WHAT TEXT WORDS...: -plot succeeds without a message and its output has the text
draws() {
	local what=$1 text=$2
	shift 2
	"$TSIM" -plot "$@" >out 2>err </dev/null && [ ! -s err ] && shows "$text" out
	report "$what" $? out
}

# fails WHAT STATUS TEXT WORDS...
fails() {
	local what=$1 status=$2 text=$3
	shift 3
	"$TSIM" "$@" >out 2>err </dev/null
	[ $? = "$status" ] && shows "$text" err
	report "$what" $? err
}

# line NAME: the numbers of a column in the overview
row() {
	awk -v name="$1" '$1 == name { print $2, $3, $4, $5, $6 }' out
}

# is WHAT NAME NUMBERS: of the overview in `out`
is() {
	[ "$(row "$2")" = "$3" ]
	report "$1" $? out
}

# ---- logs

cat >in.fall <<'END'
atom_style granular
boundary f f f
newton off
region box block 0 1 0 1 0 1
create_box 1 box
create_atoms 1 single 0.5 0.5 0.5
set group all diameter 0.1 density 2500
fix 1 all nve/sphere
fix g all gravity 8 vector 0 0 -1
compute ke all ke
fix a all ave/time 1 5 10 c_ke file ave
fix h all ave/histo 10 5 50 0 1 5 z mode vector file histo
compute bins all chunk/atom bin/1d z lower 0.25
fix c all ave/chunk 10 5 50 bins density/number vz file chunk
fix o all ave/correlate 1 5 50 c_ke file correlate
fix p all print 20 "$(step) $(ke) $(time) 1" file print title "# step ke t one"
thermo 20
timestep 1e-4
thermo_style custom step atoms ke time
run 100
run 100
END
"$TSIM" -in in.fall >run 2>&1
report 'run' $? run
draws 'log' 'log.tsim: log, 2 runs, 12 rows, 4 columns' log.tsim
is 'lines of fix print are no rows' Step '0 200 0 200 100'
awk '$1 == "Time" { ok = ($3 == 0.02); exit } END { exit !ok }' out
report 'last row' $?
sed 's/^ *//' log.tsim >log.flush
draws 'log whose rows begin without a blank' '2 runs' log.flush
draws 'a run' '0.008+ ' log.tsim Time -part 1
draws 'averages' 'ave: table, 20 rows, 2 columns' ave
is 'their names' TimeStep '10 200 10 200 105'
draws 'histogram' 'blocks, 4 blocks, of the last one (step 200) 5 rows' histo
is 'last block' Count '0 0 0 5 1'
draws 'chunks' 'against Coord1' chunk
draws 'correlation' 'against TimeDelta' correlate
draws 'fix print' 'print: table, 10 rows, 4 columns' print
is 'names in a title' one '1 1 1 1 1'
gzip -c log.tsim >log.gz && draws 'compressed' '2 runs' log.gz

printf 'LAMMPS (2 Aug 2023)\nthermo_style custom temp\nPer MPI rank memory allocation (min/avg/max) = 3 | 3 | 3 Mbytes\n%s\n%s\n%s\n%s\n' \
	'   Step          Temp          E_pair    ' '         0   1.0           -2.5          ' \
	'WARNING: something' '       100   nan           -3            ' >log.lammps
draws 'LAMMPS, a run without its end' '1 run, 2 rows, 3 columns' log.lammps
is 'a value that is no number' Temp '1 1 1 1 1'
printf 'LIGGGHTS (Version 3)\n%s\n%s\n%s\n%s\n%s\n%s\nLoop time of 1 on 1\n' \
	'---------------- Step        0 ----- CPU =      0.0000 (sec) ----------------' \
	'Temp     =         0.5000 TotEng   =        -5.2536 ' 'Press    =        -1.5 ' \
	'---------------- Step       20 ----- CPU =      0.5000 (sec) ----------------' \
	'Temp     =         0.2500 TotEng   =        -5.2540 ' 'Press    =        -1.75 ' >log.multi
draws 'thermo in blocks' '1 run, 2 rows, 5 columns' log.multi
is 'a name in blocks' Press '-1.5 -1.75 -1.75 -1.5 -1.625'
printf "LAMMPS (2 Aug 2023)\n---\nkeywords: ['Step', 'Temp', ]\ndata:\n  - [0, 1.5, ]\n  - [10, 2, ]\n...\nLoop time of 1\n" >log.yaml
draws 'thermo as lists' '1 run, 2 rows, 2 columns' log.yaml
is 'a name in lists' Temp '1.5 2 1.5 2 1.75'
printf 'tsim 0\nke pe\n1 2\n    KinEng  PotEng\n  3  4\n5 6\n  7 8\nLoop time of 1\n' >log.print
draws 'messages above and within a table' '1 run, 2 rows' log.print
is 'are no part of it' KinEng '3 7 3 7 5'
printf 'tsim 0\n%s\n 0 1\n 1 2\nLoop time of 1\n%s\n 2 3 4\nLoop time of 1\n' '  Step a' '  Step a b' >log.two
"$TSIM" -plot log.two >out 2>&1
shows 'log.two: 1 of 2 runs left out' out && shows '1 rows, 3 columns' out
report 'runs with other columns are told' $? out
draws 'and are shown' '|' log.two a -part 1

# ---- other tables

printf '# t (s), speed (m/s)\n0 1\n1 -\n2 4\n' >units
draws 'units in parentheses' 'speed (m/s)' units
draws 'as axis' 't (s)' units 2
draws 'points without a number are told' '1 of 3 points not shown: not finite' units 2
printf 'x y\n1 2\n3 4\n' >heading
draws 'names in a line' 'heading: table, 2 rows, 2 columns' heading
is 'below the names' y '2 4 2 4 3'
printf '1 2\n3 4\n' >bare
draws 'without names' 'against 1' bare
printf '1 2\n3 4\n5' >torn
"$TSIM" -plot torn >out 2>&1
shows 'torn:3: warning: the last row is not complete; it is left out' out && shows '2 rows' out
report 'a torn last row is told' $? out
printf 'name,x,"y, m"\na,1,2\n"b ""c""",2,\nd,3,5\n' >words.csv
draws 'words in a column' "words, such as 'a'" words.csv
draws 'cells in quotes, empty cells' 'y, m' words.csv 'y, m' -x x

printf '\357\273\277x,y\r\n1,2\r\n3,4\r\n' >mark.csv
draws 'byte order mark, line ends of DOS' 'draws columns against x' mark.csv
is 'its first column' x '1 3 1 3 2'

# ---- studies

cat >summary.csv <<'END'
mu,Ec,speed,E,E_error,E_runs
0.5,5,1,3,0.5,2
0.1,1,1,1,0.25,2
0.1,1,2,4,,1
0.5,5,2,6,1,2
END
draws 'a study' 'draws columns against mu' summary.csv
draws 'a curve for each value of the other variable' '* speed 1   + speed 2' summary.csv E
"$TSIM" -plot summary.csv -o summary.svg >out 2>&1 && [ "$(grep -c 'class="c[12] bar"' summary.svg)" = 2 ] &&
	grep -q '>mu<' summary.svg && ! grep -q E_error summary.svg
report 'error bars' $? out
"$TSIM" -plot summary.csv E -by mu -x speed -o by.svg && grep -q '>mu 0.1<' by.svg && grep -q '>mu 0.5<' by.svg
report '-by' $? out
cat >runs.csv <<'END'
run,script,version,mu,seed,status,seconds,off,error,E,nu
1,in.a,x,0.1,1,0,1.5,0,,1,0.2
2,in.a,x,0.1,2,0,1.5,0,,2,0.2
3,in.a,x,0.2,1,1,1.5,0,"in.a: error, so",,
4,in.a,x,0.2,2,0,1.5,0,,5,0.2
END
draws 'runs of a study' '* seed 1   + seed 2' runs.csv E

# ---- pictures

# png FILE: prints its size
png() {
	od -An -tu1 -j16 -N8 "$1" | awk '{ print $3 * 256 + $4, $7 * 256 + $8 }'
}
"$TSIM" -plot log.tsim KinEng Time -log y -xrange 0:100 -title 'T & t' -o both.svg >out 2>err
[ $? = 0 ] && [ ! -s out ] && grep -q '>T &amp; t<' both.svg && grep -q '>KinEng<' both.svg
report 'SVG' $? err
if has xmllint libxml2-utils; then
	xmllint --noout both.svg summary.svg
	report 'XML' $?
fi
"$TSIM" -plot log.tsim KinEng -o one.png && [ "$(png one.png)" = '1440 960' ]
report 'PNG' $?
"$TSIM" -plot log.tsim -o all.png && [ "$(png all.png)" = '1440 2880' ]
report 'PNG of all columns' $?
"$TSIM" -plot log.tsim Time KinEng=energy -panels -o panels.svg && [ "$(grep -c '^<svg' panels.svg)" = 3 ] &&
	grep -q '>Time<' panels.svg && grep -q '>energy<' panels.svg && ! grep -q '>Atoms<' panels.svg
report 'panels of named columns' $?
"$TSIM" -plot log.tsim KinEng -size 720x240 -o wide.png && [ "$(png wide.png)" = '2160 720' ]
report 'size' $?
OMP_NUM_THREADS=3 "$TSIM" -plot log.tsim KinEng -o again.png; same 'the same bytes' one.png again.png
"$TSIM" -plot ave c_ke -plot log.tsim KinEng -o two.svg && grep -q 'c_ke, ave<' two.svg &&
	grep -q 'KinEng, log.tsim<' two.svg
report 'two files' $?
"$TSIM" -plot ave 2 -x 1 -plot print -o first.svg && grep -q '>ke, print<' first.svg
report 'columns by number, of both files' $?

"$TSIM" -plot ave '2=mean, in 10 steps' -x 1 -style points -plot print ke+-one=now -style lines -o words.svg \
	-mark y=0.01:limit x=50 -xlabel 'step (10 us)' -ylabel energy -title '' &&
	grep -q '>mean, in 10 steps<' words.svg && grep -q '>now<' words.svg && grep -q '>limit<' words.svg &&
	[ "$(grep -c 'class="mark"' words.svg)" = 2 ] && grep -q '>step (10 us)<' words.svg &&
	[ "$(grep -c 'class="c[12] bar"' words.svg)" = 1 ] && [ "$(grep -c 'path class="c1"' words.svg)" = 0 ] &&
	[ "$(grep -c 'path class="c2"' words.svg)" = 2 ]
report 'labels, errors, styles by file, marks' $?
printf '# t load cracks e\n1 2 3000 0.25\n2 4 8000 0.25\n3 8 9000 0.5\n' >right
cp right other
draws 'an axis on the right, on a terminal' 'cracks (right)' right load -right cracks
[ "$(grep -c '[+|][0-9]*$' out)" -ge 10 ] && grep -q '+8000$' out && grep -q '^load .*cracks$' out
report 'its numbers and names' $? out
"$TSIM" -plot right load -right cracks -rightlabel 'broken bonds' -rightrange 0:10000 -log r -title '' -o right.svg >out 2>&1 &&
	grep -q '>load<' right.svg && grep -q 'class="e" x="47[0-9.]*" y="[0-9.]*">broken bonds<' right.svg &&
	grep -q '>cracks (right)<' right.svg && grep -q '>5000<' right.svg && ! grep -q '(10' right.svg
report 'in SVG, with its own words' $? out
"$TSIM" -plot right load -right cracks -o right.png && [ "$(png right.png)" = '1440 960' ]
report 'in PNG' $?
draws 'the same columns of the second file' 'cracks, other (right)' right load -right cracks -plot other
draws 'two on the right' '+ cracks (right)   o e (right)' right load -right cracks e -log r
! grep -q '^load .*cracks' out
report 'which have no name in common' $?
draws 'only on the right' '+ cracks (right)' right load -plot other -right cracks=cracks
"$TSIM" -plot right load -x 't+-e' -o across.svg && [ "$(grep -o 'class="c1 bar" d="[^"]*' across.svg | tr -cd h | wc -c)" = 3 ] &&
	[ "$(grep -o 'class="c1 bar" d="[^"]*' across.svg | tr -cd v | wc -c)" = 6 ]
report 'errors of x' $?
printf '# a=b c\n1 2\n' >equal
draws 'a name with =' 'a=b' equal a=b -x c

# ---- refused

fails 'no column' 1 "log.tsim has no column 'kineng'; did you mean 'KinEng'?" -plot log.tsim kineng
fails 'no x' 1 "log.tsim has no column 'Tmie'; did you mean 'Time'?" -plot log.tsim KinEng -x Tmie
gzip -c mark.csv >mark.csv.gz
fails 'compressed CSV' 1 "not read compressed: gunzip 'mark.csv.gz'" -plot mark.csv.gz
fails 'words' 1 "words.csv:2: error: column 'name' has 'a', expected a number" -plot words.csv name
fails 'folder' 1 "'.' is not a regular file" -plot .
mkfifo pipe
fails 'pipe' 1 "'pipe' is not a regular file" -plot pipe
fails 'no file' 1 "cannot open 'none'" -plot none
fails 'no table' 1 "'in.fall' has no table" -plot in.fall
: >empty
fails 'empty' 1 "'empty' has no table" -plot empty
printf 'name a b\nsteel 1 2\nglass 3 4\n' >words
fails 'a word in column 1' 1 "'words' has no table: the second line has the word 'steel' in column 1" -plot words a
printf '# a b\n1 2\n3\n4 5\n' >short
fails 'short row' 1 'short:3: error: the row has 1 words, expected 2 as the table' -plot short
printf 'a,b\n1,2\n3\n' >short.csv
fails 'short row of CSV' 1 'short.csv:3: error: the row has 1 cells, expected 2 as the first line' -plot short.csv
printf '# TimeStep Number-of-rows\n# Row x\n0 3\n1 5\n2 6 7\n3 8\n' >block
fails 'block' 1 'block:5: error: the row has 3 words, expected 2 as the table' -plot block
head -n 4 block >cut
fails 'a block that is cut off' 1 "'cut' has no table" -plot cut
printf 'ITEM: TIMESTEP\n0\n' >dump
fails 'dump' 1 'this is a dump, not a table' -plot dump
printf 'a\0b\n' >binary
fails 'binary' 1 'not a text file' -plot binary
fails 'ending' 1 "expected a name that ends in .svg or .png" -plot ave c_ke -o x.pdf
fails 'folder' 1 "cannot write" -plot ave c_ke -o ave/x.svg
fails 'axes' 1 "-log is 'z', expected x, y or xy" -plot ave c_ke -log z
fails 'range' 1 "-xrange is '2:1', expected LO:HI" -plot ave c_ke -xrange 2:1
fails 'style' 1 "-style is 'line', expected lines, points, both or steps" -plot ave c_ke -style line
fails 'size' 1 "-size is '480', expected WIDTHxHEIGHT" -plot ave c_ke -size 480
fails 'mark' 1 "-mark is 'z=1', expected x=VALUE or y=VALUE" -plot ave c_ke -mark z=1
fails 'mark without number' 1 "-mark is 'y=:a', expected x=VALUE or y=VALUE" -plot ave c_ke -mark y=:a
fails 'no error' 1 "ave has no column 'e'" -plot ave c_ke+-e=x
fails 'no error of x' 1 "right has no column 'f'" -plot right load -x t+-f
fails 'nothing on the left' 1 'all columns are on the right axis: name one for the left' -plot right -right load
fails 'no right axis' 1 'belong to -right, which is not given' -plot right load -log r
fails 'axes twice' 1 "-log is 'rr', expected" -plot right load -right cracks -log rr
fails 'panels' 1 '-panels and -right cannot be given together' -plot right load -right cracks -panels
fails 'twice' 2 '-right is given twice for right' -plot right load -right cracks -right e
fails 'without a file' 2 '-right follows -plot FILE' -right cracks -plot right load
fails 'part' 1 "-part is '5', expected all, last, or a number from 1 to 2" -plot log.tsim -part 5
fails 'together' 2 '-plot and -in cannot be given together' -plot ave -in in.fall
fails 'alone' 2 'belong to -plot, which is not given' -x a -in in.fall
fails 'no words' 2 'option -plot needs FILE' -plot
# formulas of columns
printf '# t ke pe c_x[2]\n1 2 3 4\n2 4 0 8\n3 8 5 1\n' >formulas
printf 't,share,scaled\n1,40,10\n2,100,20\n3,61.53846153846154,30\n' >direct.csv
"$TSIM" -plot formulas '100*ke/(ke+pe)=share' '$1*10=scaled' -x 't*2' -xlabel t -title '' -o formulas.svg >out 2>&1 &&
	"$TSIM" -plot direct.csv share scaled -x t*2 -xlabel t -title '' -o direct.svg >>out 2>&1
same 'formulas are columns' formulas.svg direct.svg
"$TSIM" -plot formulas 'ke/(t!=2)/(pe>=3)=where pe is large' -o some.svg >out 2>&1 &&
	grep -q '>where pe is large<' some.svg && grep -q '>1 of 3 points not shown' some.svg
report 'a formula that selects rows' $? out
"$TSIM" -plot formulas 'sqrt(c_x[2])/pe' >out 2>&1 && grep -q '^1 of 3 points not shown: not finite' out
report 'a row without a value' $? out
fails 'a formula without one' 1 'division of 2 by zero' -plot formulas 'ke/(pe-pe)'
fails 'an unknown name' 1 "unknown name 'kee'; did you mean 'ke'" -plot formulas 'kee/pe'
fails 'an unknown number' 1 "the columns of formulas are " -plot formulas '$5+1'
fails 'no column' 1 "as a formula it names none" -plot formulas '3*4'
fails 'not closed' 1 "expected" -plot formulas '(ke'
printf 'a,b\n1,x\n2,y\n' >words
fails 'a word' 1 "column 'b' of words has 'x', expected a number" -plot words 'a+b'
# Comma-separated values without names: the first row is a row.
printf '1,2\n3,4\n5,7\n' >numbers.csv
"$TSIM" -plot numbers.csv >out 2>&1
grep -q 'numbers.csv: comma-separated values, 3 rows, 2 columns' out && grep -Eq '^2 +2 +7 +2 +7 +4.33333' out
report 'comma-separated numbers without names' $? out
finish
