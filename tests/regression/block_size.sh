#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# block_size.sh LIGGGHTS_MUCKPILE MUCKPILE_POST: a bench in blocks of 1 and 1.4 times a size, which stand at 1.9 and 2 radii of the crushed zone, with
# cracks of one spacing for the gas: charge, rock and cracks are the same, so are the work of the load and the momentum of the burden.
# Scope: half the height, until the gas has done its work. Bounds: two times what seeds scatter by (work 0.6 %, momentum 3 %), and the wave's
# part, which coarse blocks do not carry (docs/theory/wall.md). With a void as of images the wave does a half more work.
set -euo pipefail
program=$(readlink -f "$1") post=$(readlink -f "$2")
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"

wrong=0
cut_by() {  # cut_by FOLDER MEDIAN SMALLEST LARGEST
  run_input "$1" 1 inputs/bench/in.bench -var bench_height 5 -var burden 2 -var hole_diameter 0.064 -var crack_spacing 0.126 -var time_end 0.03 \
    -var fragment_x50 "$2" -var block_min "$3" -var block_max "$4"
  "$post" profile "$out/$1" >"$out/$1/post"
}
cut_by standard 0.35 0.18 0.50 &
cut_by coarse 0.49 0.19 0.70
wait $!
for run in standard coarse; do
  check_figures near "audit of $run" "$(of_run "$run" energy_audit_error)" 0 0.01 || wrong=1
  check_figures near "energy balance of $run" "$(of_run "$run" energy_balance_error)" 0 0.01 || wrong=1
done

total() { check_figures print "$out/$1/dump/history.csv:blast_work_J"; }
compare "work of the load [J], coarse against standard" "$(total coarse)" "$(total standard)" 0.05 || wrong=1
compare "work of the wave [J]" "$(of_run coarse wave_work_J)" "$(of_run standard wave_work_J)" 0.12 || wrong=1
velocity() { check_figures print "$out/$1/summary.json:burden_velocity_m_s"; }
compare "momentum of the burden over its mass [m/s]" "$(velocity coarse)" "$(velocity standard)" 0.1 || wrong=1
exit "$wrong"
