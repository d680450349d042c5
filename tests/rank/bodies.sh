#!/bin/bash
# Bodies in a fluid that ranks divide: what all find is told once, regions that a body closes off are refused, and a rank has a part of
# the grid. That results are those of one rank: tests/rank/contract.sh.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_ranks.sh
. "$top_srcdir/tests/lib_ranks.sh" || exit 99
has_ranks || exit 77
export OMP_NUM_THREADS=1

cp "$top_srcdir/tests/rank/scenes/in.sluice" .
"$TSIM" -in in.sluice -log none -var out one >out 2>&1
report 'a gate and balls, one rank' $? out
said one.said
[ "$(grep -c 'overlap with different velocities, at [0-9]* points' one.said)" = 1 ] && [ "$(grep -c 'covers a part of the wall' one.said)" = 2 ]
report 'it warns of what bodies cover' $? one.said
for n in 2 5; do
	on_ranks $n "$TSIM" -in in.sluice -log none -var out many >out 2>&1 </dev/null
	report "a gate and balls, $n ranks" $? out
	said many.said
	same "warnings of $n ranks" one.said many.said
done

# A plate that goes down closes off the fluid below it, at once or when it has slid across.
plate() { # WORDS AFTER BLOCK
	cat <<-END
		units si
		boundary f f f
		region box block 0 0.04 0 0.04 0 0.06 units box
		create_box 1 box
		timestep 5e-4
		flow_style projection cells 20 20 30 viscosity 1e-2 density 1000
		flow_boundary zhi outlet
		flow_boundary xlo slip
		flow_boundary xhi slip
		flow_boundary ylo slip
		flow_boundary yhi slip
		variable slide equal -0.008+2*time
		region plate block INF INF $1 units box
		fix plate all immersed/boundary region plate velocity 0 0 -0.02
		run 40
	END
}
plate '-0.01 0.05 0.026 0.034' >in.shut
plate '-0.01 0.036 0.026 0.034 move NULL v_slide NULL' >in.slides
for scene in shut slides; do
	for n in 1 3; do
		on_ranks $n "$TSIM" -in in.$scene -log none >out 2>&1 </dev/null
		[ $? != 0 ] && [ "$(grep -c "in.$scene:14:[0-9]*: error: .* the body pushes fluid at .* that it closes off about" out)" = 1 ]
		report "$scene: refused by $n ranks" $? out
		grep -o 'error: .*' out >"error.$n"
		[ $scene = shut ] || grep -q '^ *0  *' out
		report "$scene: when, $n ranks" $? out
	done
	same "$scene: the message of three ranks" error.1 error.3
done

# Of a rank, in a grid of 32 x 32 x 96 cells with a ball: planes of its own and four on each side.
{
	plate '-0.01 0.05 0.026 0.034' | sed '/^variable/,$d; s/cells 20 20 30/cells 32 32 96/'
	printf '%s\n' 'region ball sphere 0.02 0.02 0.031 0.01 units box' 'fix ball all immersed/boundary region ball' 'run 1'
} >in.ball
"$TSIM" -in in.ball -explain -ranks 4 -log none >out 2>&1
grep -q "^  fluid's planes  *each rank has up to 32 of 100 in memory" out
report 'planes of a rank' $? out
finish
