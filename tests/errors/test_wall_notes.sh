#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_wall_notes.sh LIGGGHTS_MUCKPILE: blocks at the wall of a crushed zone are as wide as widest_wall_block lets them be, and inputs note it where they are cut
# down or where a pulse rises faster than a wave crosses a block; and strengths that no rock has.
set -euo pipefail
program=$1
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
cd "$root"

wrong=0
try() { "$program" -log none "$@" >"$out/screen" 2>&1 </dev/null || true; }
says() {  # says COUNT TEXT: on so many lines
  [[ $(grep -cF -- "$2" "$out/screen") -eq $1 ]] || { echo "not $1 times: $2"; tail -n 5 "$out/screen"; wrong=1; }
}

cat >"$out/in.wall" <<'END'
variable crushed_radius index 0.1
variable full_radius index 0.1
variable block_min index 0.5
variable fragment_x50 index 0.5
include inputs/common/wall_blocks.in
print 'block_min is ${block_min} m'
END
try -in "$out/in.wall"
says 1 'NOTE: block_min 0.5 m is wider than 2 radii of the crushed zone; 0.1999 m is taken'
says 1 'block_min is 0.1999 m'
try -in "$out/in.wall" -var widest_wall_block 6
says 0 'NOTE'
says 1 'block_min is 0.5 m'

try -in "$out/in.wall" -var widest_wall_block 5 -var crushed_radius 0.05
says 1 'NOTE: block_min 0.5 m is wider than 6 radii of the crushed zone of a charge that does not fill its hole; 0.29985 m is taken'
try -in "$out/in.wall" -var crushed_radius 0.05
says 1 'NOTE: block_min 0.5 m is wider than 2 radii of the crushed zone; 0.1999 m is taken'

# The run stops at time_end, after the check of the pulse.
try -in inputs/pattern/in.pattern -var out "$out" -var time_end 0.1 -var rise_time 1e-4
says 1 'NOTE: the pulse rises (rise_time 1e-4 s) faster than a wave crosses a block of block_min 0.95 m'
says 1 'ERROR: input: time_end'
try -in inputs/pattern/in.pattern -var out "$out" -var time_end 0.1 -var rise_time 3e-4
says 0 'NOTE'
says 1 'ERROR: input: time_end'

# So it is in the quarry: in blocks of 0.35 m the pulse would be too fast.
try -in inputs/quarry/in.quarry -var out "$out" -var time_end 0.1 -var hole_diameter 0.03 -var rise_time 6e-5 -var crushed_ratio 3
says 1 'NOTE: block_min 0.35 m is wider than 6 radii of the crushed zone; 0.269865 m is taken'
says 0 'faster than a wave crosses'

# The thinnest hole of the table counts, whatever the knob hole_diameter says.
sed '/^r1h3,/s/,0\.165,/,0.089,/' inputs/pattern/holes.csv >"$out/thin.csv"
try -in inputs/pattern/in.pattern -var out "$out" -var time_end 0.1 -var hole_table "$out/thin.csv" -var crushed_ratio 3
says 1 'NOTE: block_min 0.95 m is wider than 6 radii of the crushed zone; 0.8005995 m is taken'
says 1 'faster than a wave crosses a block of block_min 0.8005995 m'  # of the width that is used
sed '1,/^hole,/s/diameter_m,/diameter_m,crushed_radius_m,/; s/,0\.165,/,0.165,0.1,/' inputs/pattern/holes.csv >"$out/own_radius.csv"
try -in inputs/pattern/in.pattern -var out "$out" -var time_end 0.1 -var hole_table "$out/own_radius.csv"
says 1 'NOTE: block_min 0.95 m is wider than 6 radii of the crushed zone; 0.5997 m is taken'

# A median size that no block can have.
try -in inputs/pattern/in.pattern -var out "$out" -var time_end 0.1 -var rise_time 3e-4 -var fragment_x50 9
says 1 'WARNING: fragment_x50 9 m is above block_max 2.5 m: no block gets wider than that'
try -in inputs/pattern/in.pattern -var out "$out" -var time_end 0.1 -var rise_time 3e-4 -var fragment_x50 0.1
says 1 'WARNING: fragment_x50 0.1 m is below block_min 0.95 m: no block gets narrower than that'
try -in inputs/pattern/in.pattern -var out "$out" -var time_end 0.1 -var rise_time 3e-4
says 0 'WARNING: fragment_x50'

# Strengths a thousand times too small or too large.
for strength in tension cohesion; do
  for value in 1e4 1e10; do
    try -in inputs/pattern/in.pattern -var out "$out" -var time_end 0.1 -var rise_time 3e-4 -var $strength $value
    says 1 "NOTE: $strength $value Pa is "
    says 1 NOTE
  done
done
try -in inputs/pattern/in.pattern -var out "$out" -var time_end 0.1 -var rise_time 3e-4 -var tension 0 -var cohesion 0
says 0 NOTE
exit $wrong
