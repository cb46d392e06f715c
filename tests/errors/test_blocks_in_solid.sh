#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_blocks_in_solid.sh LIGGGHTS_MUCKPILE: rock that falls into a region where no rock can be is told of on the screen: one warning, by rank 0,
# however long the run goes on, and the count in each line from then on.
set -euo pipefail
program=$1
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
cd "$out"

# Eight cubes or so between -1 and 1; the lowest centres, at -0.5, pass -0.8 after 0.25 s.
cat >fall.in <<END
variable dir index $here
include $here/engine.in
create_blocks rock density 2700 size uniform 1 block_min 1 block_max 1 spheres_per_block 1 sweeps 2
fix pull all gravity 9.81 vector 0 0 -1
fix energy all muckpile/ledger
region ground block INF INF INF INF INF -0.8 units box
fix progress all muckpile/progress every 10 directory . solid ground
timestep 1e-2
run 10
run 30
END
on_ranks 2 -in fall.in -log none >screen 2>&1 || fail "the run failed"
warnings=$(grep -c "WARNING.*blocks in region 'ground', where no rock can be: [1-9]" screen || true)
[[ $warnings -eq 1 ]] || fail "$warnings warnings instead of one"
first=$(grep '^\[run\]' screen | head -n 1)
last=$(grep '^\[run\]' screen | tail -n 1)
[[ $first != *"in the solid"* ]] || fail "blocks are counted before they fall"
[[ $last == *"blocks in the solid"* ]] || fail "the last line has no count"
grep -qE '"blocks_in_solid": [1-9]' run.json || fail "run.json has no count"
