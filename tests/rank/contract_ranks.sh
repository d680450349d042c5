#!/bin/bash
# tests/rank/contract.sh with all its scenes, each on two numbers of ranks: 2x2 has ranks with a neighbour on both sides that is
# the same and threads, 3 a rank between two others, 4 blocks that meet at an edge, 7 blocks thinner than the reach of contacts,
# some empty. TS_RANKS="2 3 4 7 2x2" runs all scenes on all of them.
export TS_RANKS=${TS_RANKS-turns}
# shellcheck source=tests/rank/contract.sh
. "$top_srcdir/tests/rank/contract.sh"
