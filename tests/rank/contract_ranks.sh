#!/bin/bash
# tests/rank/contract.sh with all its scenes, each on two numbers of ranks (tests/lib_ranks.sh). TS_RANKS='2 3 4 7 2x2' runs all
# scenes on all of them, before a release.
export TS_RANKS=${TS_RANKS:-turns}
# shellcheck source=tests/rank/contract.sh
. "$top_srcdir/tests/rank/contract.sh"
