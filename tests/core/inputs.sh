#!/bin/bash
# Inputs written as lists: c_ID[*], c_ID[2*4], quantities, shapes that do not fit.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.scene <<'END'
units si
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 2 box
create_atoms 1 single 0.5 0.5 0.5
create_atoms 2 single 0.25 0.25 0.75
set group all diameter 0.1 density 2385
velocity all set 0.1 0.2 0.3
compute p all property/atom x y z
compute centre all com
fix move all nve
timestep 0.01
END
cat >in.lists <<'END'
include in.scene
compute most all reduce max c_p[*] vx
compute tail all reduce max c_p[2*] update_on_run_end yes
fix path all vector 2 time c_centre[*] c_most[2*3]
fix one all vector 2 c_centre[1]
fix mean all ave/time 2 2 4 c_centre[*2] file mean.txt
fix table all ave/time 1 1 8 f_path[2] f_path[6] mode vector file table.txt start 8
thermo_style custom step c_most[*] f_mean[*] f_path[1][6]
dump d all custom 10 dump.lists id c_p[*]
run 8
print "row $(f_path[2][1]:%.10g) $(f_path[3][4]:%.10g) $(f_path[1][6]:%.10g) $(f_one[3]:%.10g)"
print "slope $(slope(f_path[3]):%.10g) least $(min(f_path[6]):%.10g) tail $(c_tail[2]:%.10g)"
END
"$TSIM" -in in.lists -log none >out 2>err
report 'lists of inputs' $? err
has() {
	says_line "$1" out
	report "$1" $? out
}
has 'row 0.02 0.637 0.75 0.379'
has 'slope 0.004 least 0.75 tail 0.774'
has '*       most[1]        most[2]        most[3]        most[4]        mean[1]        mean[2]'
grep -qxF '# TimeStep c_centre[1] c_centre[2]' mean.txt
report 'names of the averages' $? mean.txt
grep -qxF 'ITEM: ATOMS id c_p[1] c_p[2] c_p[3] ' dump.lists
report 'columns of a dump' $? dump.lists
grep -qxF '5 0.383 0.774' table.txt
report 'columns of an array as vectors' $? table.txt

wrong() { # TEXT LINE...
	printf '%s\n' 'include in.scene' 'compute most all reduce max x' "${@:2}" >in.wrong
	refused "$2" "$1" -in in.wrong
}
wrong "'c_centre' is a vector, expected a single number; choose an element with [k]" \
	'fix a all ave/time 1 1 1 c_centre'
wrong "'c_most' is a vector or a single number" 'compute a all reduce sum c_most'
wrong "unknown quantity 'radios'" 'compute a all reduce sum radios'
wrong "did you mean 'radius'" 'compute a all reduce sum radios'
wrong "'c_p[2*5]': 'c_p' has 3" 'compute a all reduce sum c_p[2*5]'
wrong "'c_p[4*]': 'c_p' has 3" 'compute a all reduce sum c_p[4*]'
wrong 'there are no elements or columns for *' 'fix a all vector 1 c_p[*]'
wrong "dump custom: unknown quantity 'step'" 'dump a all custom 1 a.dump step'
wrong "dump local: 'c_p[1]' is numbers of particles, expected rows of contacts, bonds or triangles" \
	'dump a all local 1 a.dump c_p[1]'
wrong "'f_a' is an array" 'fix a all vector 1 step time' 'fix b all ave/time 1 1 1 f_a'
wrong 'the array has 1 rows and 2 columns' 'fix a all vector 1 step time' 'run 0' \
	'print $(f_a[2][1])'

# the samples of a restart file are those of the same values
cat >in.cut <<'END'
include in.scene
fix path all vector 3 time c_centre[*]
run 10
write_restart cut.restart
run 7
print "path $(f_path[6][2]:%.17g) $(slope(f_path[4]):%.17g)"
END
cat >in.rest <<'END'
read_restart cut.restart
compute centre all com
fix path all vector 3 time c_centre[*]
fix move all nve
timestep 0.01
run 7
print "path $(f_path[6][2]:%.17g) $(slope(f_path[4]):%.17g)"
END
"$TSIM" -in in.cut -log none >whole 2>err
report 'in one' $? err
"$TSIM" -in in.rest -log none >parts 2>err
report 'in two' $? err
grep '^path' whole >whole.path
grep '^path' parts >parts.path
same 'an array of samples through a restart file' whole.path parts.path
sed 's/time c_centre/c_centre/' in.rest >in.fewer
refused 'another number of values' 'values' -in in.fewer
finish
