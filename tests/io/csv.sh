#!/bin/bash
# Files whose name ends in .csv: tables that a reader of comma-separated values understands, with the numbers of the
# usual files; continued after a restart.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >model <<'END'
units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
region box block 0 1 0 1 0 1 units box
create_box 1 box
neighbor 0.01 bin
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-4
END
cat >start <<'END'
create_atoms 1 random 40 12345 NULL
set group all diameter 0.1 density 2500
velocity all create 1e22 4928459
END
# E: ending of the files, F: format of numbers in usual ones
cat >outputs <<'END'
fix move all nve/sphere
variable a equal ke+step
variable b equal vcm(all,x)
variable w atom v_b
variable who string "a b"
compute p all property/atom radius vx
compute local all pair/gran/local id force
compute r all reduce sum x vy
compute ch all chunk/atom bin/1d x lower 0.25 units box
fix time all ave/time 1 5 10 v_a v_b c_r[*] file time.${E} format ${F}
fix cor all ave/correlate 1 4 10 v_b v_a type full file cor.${E}
fix rows all ave/time 10 1 10 f_cor[3] mode vector file rows.${E} format ${F}
fix bins all ave/chunk 1 5 10 ch vx vy file chunk.${E} format ${F}
fix histo all ave/histo 1 5 10 -2 2 4 vx file histo.${E} format ${F}
fix words all print 10 "$(step) ${b}, $(ke + 1) ${who}" file print.${E} screen no
fix ledger all energy/ledger file ledger.${E} every 10
thermo 10
thermo_style custom step time ke v_b c_r[1]
thermo_modify format float ${F}
thermo_log thermo.${E}
dump d all custom 10 dump.${E} id type x y z vx c_p[2] v_w element
dump_modify d format float ${F} element "quartz, fine"
dump e all custom 20 every.*.${E} id x
dump l all local 10 local.${E} index c_local[1] c_local[2] c_local[4]
dump_modify l format float ${F}
dump a all atom 20 atom.${E}
dump_modify a format float ${F} time yes
END
for e in csv txt; do
	{
		printf 'variable E index %s\nvariable F index %%.17g\n' $e
		cat model start outputs
		[ $e = txt ] || echo 'fix late all ave/time 1 1 10 v_a file late.csv format %9.3f'
		echo 'run 40'
	} >in_$e
	"$TSIM" -in in_$e -log none >out 2>&1
	report "runs, $e" $? out
done
head -1 time.csv >names
says_line 'step,v_a,v_b,c_r[1],c_r[2]' names
report 'names of columns' $? names
sed -n 2p late.csv | grep -qE '^0,[0-9]+\.[0-9]{3}$'
report 'a given format' $? late.csv
grep -q '^step,id,type,x,y,z,vx,c_p\[2\],v_w,element$' dump.csv && grep -q ',"quartz, fine"$' dump.csv
report 'quotes' $? dump.csv
grep -q '^step,b,ke + 1,who$' print.csv && grep -q ',a b$' print.csv
report 'fix print: names and texts' $? print.csv

# The numbers of the usual files, as one sequence, those of the table without what its rows repeat.
has python3 || finish
cat >compare.py <<'END'
import csv, sys

def table(name):
    rows = list(csv.reader(open(name, newline="")))
    assert len({len(r) for r in rows}) == 1 and len(rows) > 2, name
    return rows[0], rows[1:]

def usual(name):
    return [line.split() for line in open(name) if not line.startswith(("#", "Step", "    Step"))]

def same(what, a, b):
    a, b = [[float(x) for x in r] for r in a], [[float(x) for x in r] for r in b]
    print(what, "same" if a == b and a else "different: %s %s" % (a[:2], b[:2]))

def blocks(name, size):
    """Rows of blocks with the words of the first line of each before them."""
    rows, out, head, left = usual(name), [], None, 0
    for r in rows:
        if not left:
            head, left = r, int(r[size])
        else:
            out.append((head, r))
            left -= 1
    return out

names, rows = table("time.csv")
same("ave/time", rows, usual("time.txt"))
names, rows = table("rows.csv")
assert names == ["step", "row", "f_cor[3]"]
same("ave/time vector", rows, [h[:1] + r for h, r in blocks("rows.txt", 1)])
names, rows = table("chunk.csv")
assert names == ["step", "chunk", "coord1", "count", "vx", "vy"]
near = [h[:1] + r for h, r in blocks("chunk.txt", 1)]
same("ave/chunk", [r[:2] + r[4:] for r in rows], [r[:2] + r[4:] for r in near])
names, rows = table("histo.csv")
assert names == ["step", "bin", "coord", "count", "fraction", "total", "missing", "min", "max"]
same("ave/histo", rows, [h[:1] + r + h[2:] for h, r in blocks("histo.txt", 1)])
names, rows = table("cor.csv")
assert names == ["step", "index", "lag", "count", "v_b*v_b", "v_b*v_a", "v_a*v_b", "v_a*v_a"]
same("ave/correlate", [["%g" % float(x) for x in r] for r in rows], [h[:1] + r for h, r in blocks("cor.txt", 1)])
names, rows = table("print.csv")
same("print", [r[:3] for r in rows], [r[:1] + [r[1].rstrip(",")] + r[2:3] for r in usual("print.txt")])
names, rows = table("thermo.csv")
assert names == ["step", "time", "ke", "v_b", "c_r[1]"]
same("thermo", rows, usual("thermo.txt"))
names, rows = table("ledger.csv")
digits = [["%.9g" % float(x) for x in r[:2]] + ["%.12g" % float(x) for x in r[2:]] for r in rows]
same("energy/ledger", digits, usual("ledger.txt"))

def frames(name):
    out, lines = [], open(name).read().split("ITEM: ")
    step = time = None
    for item in lines:
        head, *rest = item.splitlines() or [""]
        if head == "TIMESTEP":
            step = rest[0]
        elif head == "TIME":
            time = rest[0]
        elif head.startswith(("ATOMS", "ENTRIES")):
            out += [[step] + ([time] if time else []) + r.split() for r in rest]
    return out

names, rows = table("dump.csv")
same("custom", [r[:-1] for r in rows], [r[:9] for r in frames("dump.txt")])
assert {r[-1] for r in rows} == {"quartz, fine"}
names, rows = table("local.csv")
same("local", rows, frames("local.txt"))
names, rows = table("atom.csv")
assert names[:4] == ["step", "time", "id", "type"]
same("atom", [r[:1] + r[2:] for r in rows], [r[:1] + r[2:] for r in frames("atom.txt")])
same("one file per frame", table("every.20.csv")[1], [["20"] + [r[1], r[3]] for r in table("dump.csv")[1] if r[0] == "20"])
END
python3 compare.py >same 2>&1
[ "$(grep -c ' same$' same)" = 12 ] && ! grep -q 'different\|Error' same
report 'the numbers of the usual files' $? same

# a restart in between: the same tables
mkdir whole
mv ./*.csv whole
sed -i '/fix late/d' in_csv
sed '$d' in_csv >in.first
printf 'run 20\nwrite_restart half\n' >>in.first
{
	printf 'variable E index csv\nvariable F index %%.17g\n'
	sed '/^region\|^create_box/d; s/^units si/&/' model
	sed 's/\( file \)\(time\|rows\|chunk\|histo\|print\)/ append \2/; s/^thermo_log.*/& append/; s/^dump_modify \([dlea]\)/& append yes/' outputs
	echo 'run 20'
} >in.second
sed -i 's/^neighbor/read_restart half\n&/' in.second
"$TSIM" -in in.first -log none >out 2>&1 && "$TSIM" -in in.second -log none >>out 2>&1
report 'in two runs' $? out
for f in time rows chunk histo print dump local atom; do
	same "$f.csv continued" whole/$f.csv $f.csv
done
# the step between the runs is a row of both tables
cut -d, -f1 thermo.csv | tr '\n' ' ' | grep -q '^step 0 10 20 20 30 40 $'
report 'thermo.csv continued' $? thermo.csv

# refused
wrong() { # WHAT LINE TEXT
	{ cat model start; printf '%s\n' 'variable a equal ke' "$2" 'run 10'; } >in.wrong
	refused "$1" "$3" -in in.wrong
}
wrong 'titles' 'fix t all ave/time 1 1 10 v_a file t.csv title1 "# a"' 'a table of comma-separated values has no title lines'
wrong 'correlations appended and replaced' 'fix t all ave/correlate 1 4 10 v_a file t.csv append u.csv' 'append cannot be used with file'
wrong 'XYZ as a table' 'dump t all xyz 10 t.csv' 'take `dump ID GROUP custom N t.csv type x y z`'
wrong 'titles of correlations' 'fix t all ave/correlate 1 4 10 v_a file t.csv title3 "# a"' 'has no title lines'
wrong 'a title too short' 'fix t all print 10 "$(step) ${a}" file t.csv title step' 'the title names 1 columns, but the text has 2 parts'
echo 'step,other' >old.csv
wrong 'another table' 'fix t all ave/time 1 1 10 v_a append old.csv' "which begins with 'step,other': the columns would be 'step,v_a'"
wrong 'columns that change' 'thermo_log t.csv
run 0
thermo_style custom step' 'the columns have changed since the table'

# correlations appended to those of a run before
for e in txt csv; do
	{ cat model start; printf '%s\n' 'fix move all nve/sphere' 'variable a equal vcm(all,x)' \
		"fix t all ave/correlate 1 4 10 v_a append more.$e" 'run 20'; } >in.more
	"$TSIM" -in in.more -log none >out 2>&1 && cp more.$e once.$e && "$TSIM" -in in.more -log none >out 2>&1
	report "correlations appended, $e" $? out
	cat once.$e once.$e >twice.$e
	[ $e = csv ] && { cat once.csv; tail -n +2 once.csv; } >twice.csv
	same "rows of both runs, $e" twice.$e more.$e
done
finish
