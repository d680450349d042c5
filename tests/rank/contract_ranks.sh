#!/bin/bash
# tests/rank/contract.sh with all its scenes.
export TS_RANKS='2 3 4 7'
# shellcheck source=tests/rank/contract.sh
. "$top_srcdir/tests/rank/contract.sh"
