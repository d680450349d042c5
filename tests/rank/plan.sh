#!/bin/bash
# -explain -ranks N tells what ranks have and send without starting them: compared with what the logs of runs on N ranks
# tell.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_ranks.sh
. "$top_srcdir/tests/lib_ranks.sh" || exit 99
export OMP_NUM_THREADS=1

# short SCENE STEPS: a script of so many steps, without outputs, so short that the list of contacts stays
short() {
	sed -E '/^(run|dump|fix mean|thermo_modify)/d; s/^timestep.*/timestep 1e-8/' "$top_srcdir/tests/rank/scenes/in.$1"
	printf 'thermo 1000\nrun %d\n' "$2"
}
# number NAME COLUMN: of the table of ranks in `out`
number() {
	awk -v name="$1" -v column="$2" '/blocks, now:$/ { table = 1 } table && index($0, "  " name) == 1 { print $(NF - 3 + column) }' out
}

short bed 12 >in.plan
for n in 1000 64; do
	"$TSIM" -in in.plan -explain -ranks $n -log none >out 2>&1
	report "plan of $n ranks" $? out
	all=$(sed -n 's/^  particles  *\([0-9]*\) of 2 types.*/\1/p' out)
	awk -v all="$all" -v n=$n -v mean="$(number 'particles ' 2)" 'BEGIN { d = mean * n - all; exit !(all > 0 && d * d <= (0.05 * n)^2) }'
	report "$n ranks have all particles" $? out
done
refused 'what does not work with ranks' 'shell with a program does not work with several ranks yet (there are 3)' -shell yes -explain -ranks 3 \
	-in <(sed 's/^run.*/shell true\nrun 1/' in.plan)
"$TSIM" -in in.plan -log none -ranks 4 >out 2>&1
[ $? = 2 ] && grep -q 'ranks are started by mpirun -np N' out
report '-ranks without -explain' $? out
for n in 0 -1 x 1e9; do
	"$TSIM" -in in.plan -explain -log none -ranks $n >out 2>&1
	[ $? = 2 ]
	report "-ranks $n" $? out
done
printf 'units lj\nregion b block 0 1 0 1 0 1\ncreate_box 1 b\nrun 1\n' >in.empty
"$TSIM" -in in.empty -explain -ranks 5 -log none >out 2>&1 && ! grep -qi nan out
report 'an empty box' $? out
printf 'units lj\nprocessors 5 1 1\nregion b block 0 1 0 1 0 1\ncreate_box 1 b\nrun 1\n' >in.empty
refused 'blocks that do not fit' 'processors: ' -in in.empty -explain -ranks 4

# What each rank has wholly, so that more ranks do not make it faster.
for deck in rank/scenes/in.oil decks/in.automaton; do
	"$TSIM" -in "$top_srcdir/tests/$deck" -explain -ranks 4 -log none -var out x >out 2>&1
	grep -q '^  every rank has the whole grid of the fluid or automaton' out
	report "plan of $deck" $? out
done

# The contacts that all ranks get, as loads and wear are summed.
"$TSIM" -in "$top_srcdir/tests/rank/scenes/in.mill" -explain -ranks 4 -log none -var out x >out 2>&1
report 'plan of a scene with loads' $? out
[ "$(grep -c '^  shared contacts  all ranks get those with wall [a-z]* where .* in each step .*: now [0-9]*, [0-9]* bytes each$' out)" = 6 ]
report 'contacts that all ranks get' $? out

has_ranks || finish
ranks() {
	local n=$1
	shift
	on_ranks "$n" "$TSIM" "$@" >out 2>&1 </dev/null
}
# planned NAME RANKS [ITERATIONS]: of runs of in.two (2 steps) and in.twelve with one list of contacts the difference is ten steps, in
# which a solver makes so many iterations. compare_plans runs them: the start of ranks takes more time than they do. A run before both is
# not compared: the first one after another scene sends more before its first step.
planned() {
	local k=${#plans[@]}
	plans+=("$1")
	iterations_in+=("${3:-0}")
	of_ranks[$2]+=" $k"
	cp in.two "in.first.$k"
	cp in.two "in.two.$k"
	cp in.twelve "in.twelve.$k"
}
plans=()
iterations_in=()
of_ranks=()

# compare_plans N: those of N ranks, which are started once for the runs, and once for the plans
compare_plans() {
	local n=$1 k runs=()
	# shellcheck disable=SC2086
	set -- ${of_ranks[n]}
	for k in "$@"; do runs+=("first.$k" "two.$k" "twelve.$k"); done
	in_turn "$n" "runs.$n" "${runs[@]}"
	report "two and twelve steps on $n ranks" $? out
	for k in "$@"; do printf 'print "plan of %s"\ninclude in.twelve.%s\nclear\n' "$k" "$k"; done >in.plans
	ranks "$n" -in in.plans -log none -explain
	report "plans of $n ranks" $? out
	mv out plans.out
	for k in "$@"; do
		awk -v from="plan of $k" '/^plan of / { inside = $0 == from } inside' plans.out >out
		compare_plan "${plans[k]}" "$n" "${iterations_in[k]}" "runs.$n/two.$k/log" "runs.$n/twelve.$k/log"
	done
}
# compare_plan NAME RANKS ITERATIONS TWO TWELVE: the plan in `out` with the logs of both runs
compare_plan() {
	awk -v most="$(number 'particles ' 3)" -v copies="$(number copies 1)" -v iterations="$3" \
		-v messages="$(number 'messages sent' 1)" -v bytes="$(number 'bytes sent' 1)" \
		-v messages_more="$(number 'messages an' 1)" -v bytes_more="$(number 'bytes an' 1)" '
		/^Ranks:/ { differ += most != $(NF - 4) ? 1 : 0; print "most", most, $(NF - 4) }
		/^Of the first rank:/ {
			if (!n++) { m = 2 * $5; b = 2 * $7; next }
			m = (12 * $5 - m) / 10; b = (12 * $7 - b) / 10
			messages += messages_more * iterations / 10
			bytes += bytes_more * iterations / 10
			print "copies", copies, $(14), "messages", messages, m, "bytes", bytes, b
			differ += copies != $14 || (messages - m)^2 > 0.2 || (bytes - b)^2 > 1 || !(bytes > 0)
		}
		END { exit differ || n != 2 || (iterations > 0 && !(bytes_more > 0)) }' "$4" "$5" >difference
	report "$1: $2 ranks have and send what was planned" $? difference
}
# iterations_of: of the solver in steps 3 to 12 of in.twelve on one rank; 0 without a fluid
iterations_of() {
	sed 's/^thermo .*/thermo 1/; s/^run .*/thermo_style custom step flow_iter\n&/' in.twelve >in.one
	"$TSIM" -in in.one -log none >out 2>&1 && awk 'NF == 2 && $1 ~ /^[0-9]+$/ && $1 > 2 { n += $2 } END { print n + 0 }' out
}
for scene in bed gas fluid current; do
	short $scene 2 >in.two
	short $scene 12 >in.twelve
	iterations=0
	! grep -q ^flow_style in.two || iterations=$(iterations_of)
	for n in 2 3 7; do
		planned $scene $n "$iterations"
	done
done

# More cells than particles: then all ranks have all cells. Drag by the velocity of the last step sends half. The spheres fill
# the small cells: with the acceleration of the fluid ranks would doubt that their added mass is stable, and gather particles once.
short fluid 2 | sed 's/cells 5 3 8/cells 12 7 16/; s/scheme implicit/& lagged yes/; s/added_mass$/& fluid_acceleration no/' >in.two
sed 's/^run .*/run 12/' in.two >in.twelve
planned 'few particles' 3 "$(iterations_of)"

# stream SOLVER FLUID BOUNDARY LINES: a fluid without particles in steps of one length
stream() {
	cat <<-END
		units si
		boundary $3
		region box block 0 1 0 1 0 1 units box
		create_box 1 box
		flow_style projection viscosity 0.01 density 1.0 body_force 0.3 0 0.1 $2
		pressure_style $1
		timestep 0.001
		thermo 1000
		$4
	END
}
# solved NAME SOLVER FLUID BOUNDARY LINES: plan and logs of such a fluid on two and three ranks
solved() {
	local n iterations
	for n in 2 12; do
		(stream "$2" "$3" "$4" "$5" && echo run $n) >in.$n
	done
	mv in.2 in.two
	mv in.12 in.twelve
	iterations=$(iterations_of)
	for n in 2 3; do
		planned "$1" $n "$iterations"
	done
}
cells='cells 12 10 16'
walls='f f f'
lid='flow_boundary zhi wall velocity 1 0 0'
solved direct direct "$cells" 'f p f' "$lid"
solved 'a periodic axis across the slabs' direct 'cells 12 40 16' 'f p p' 'flow_boundary xlo wall velocity 0 1 0'
solved cg 'cg preconditioner diagonal' "$cells" "$walls" "$lid"
solved multigrid multigrid 'cells 32 32 32' "$walls" "$lid"
solved sor 'sor tolerance 1e-5' "$cells" "$walls" "$lid"
solved 'implicit viscosity' direct "$cells time ab2 viscous implicit" "$walls" "$lid"
solved substeps direct "$cells time rk3 substeps 3" "$walls" "$lid"
solved 'one step of the fluid in two' direct "$cells every 2" "$walls" "$lid"
solved 'a scalar' direct "$cells" "$walls" "$lid
fix t all flow/scalar conductivity 0.02 capacity 1 initial 1 zlo value 2"
solved 'an immersed ball' direct "$cells" "$walls" "$lid
create_atoms 1 single 0.5 0.5 0.5 units box
set atom 1 diameter 0.45 density 1
fix b all immersed/boundary spheres"
"$TSIM" -in in.twelve -explain -ranks 17 -log none >out 2>&1 && grep -q "^  fluid's ranks  *each of the 17 computes the whole step: .* (16 here)" out
report 'more ranks than planes' $? out
for n in "${!of_ranks[@]}"; do
	compare_plans "$n"
done

# MPI's library is loaded when there are ranks: another one of that name does no harm to a process alone.
file=$(grep -ao 'libmpi[a-z_]*[.]so[.0-9]*' "$TSIM" | head -n 1)
if [ -n "$file" ]; then
	echo 'int tsim_nothing;' | ${CC:-cc} -shared -fPIC -x c - -Wl,-soname,"$file" -o "$file" >out 2>&1
	report 'a library without functions' $? out
	printf 'print "alone"\n' >in.alone
	LD_LIBRARY_PATH=$work "$TSIM" -in in.alone -log none >out 2>&1 && grep -q '^alone' out
	report 'alone, without MPI' $? out
	LD_LIBRARY_PATH=$work OMPI_COMM_WORLD_SIZE=2 "$TSIM" -in in.alone -log none >out 2>&1
	[ $? = 1 ] && grep -q 'error: the library of MPI cannot be loaded' out && ! grep -q '^alone' out
	report 'ranks, without MPI' $? out
fi
finish
