#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# leaning_face.sh LIGGGHTS_MUCKPILE MUCKPILE_POST: the bench with a free face of 76 degrees, as a user would write it with regions.
# `profile` must refuse it with exit status 3 and its slope, leave no figures, and take back those that lie there; the other reports work.
# Scope: the shortest run of the smallest bench; inputs/bench/in.bench is taken with other regions.
set -euo pipefail
program=$1 post=$2
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"

input=$out/in.leaning
upright='^region +rock block '
[[ $(grep -cE "$upright" inputs/bench/in.bench) -eq 1 ]] || fail "inputs/bench/in.bench has not one line '$upright'"
# Normal (-sin, 0, -cos) of 76 degrees, which points into the rock.
sed -E "s/$upright(.*)/region whole block \1\nregion behind_face plane 0 0 0 -0.970296 0 -0.241922 units box\nregion rock intersect 2 whole behind_face/" \
  inputs/bench/in.bench >"$input"
run_input run 1 "$input" -var bench_height 3 -var burden 1.5 -var hole_diameter 0.05 -var fragment_x50 0.4 -var block_min 0.25 \
  -var block_max 0.7 -var time_end 0.02

echo "old" | tee "$out/run/profile.csv" >"$out/run/profile.png"
status=0
"$post" profile "$out/run" 2>"$out/message" || status=$?
cat "$out/message"
[[ $status -eq 3 ]] || fail "profile: exit status $status, should be 3"
grep -q 'the free face must be the plane x = 0 .* stands at 7[567].* to the horizontal' "$out/message" || fail "another message"
[[ ! -e $out/run/profile.csv && ! -e $out/run/profile.png ]] || fail "old profile.* are still there"
! grep -qE '"(throw_cg_m|face_velocity_m_s|swell_factor|pile_toe_m)"' "$out/run/summary.json" || fail "figures in summary.json"
grep -q '"profile_refused"' "$out/run/summary.json" || fail "no reason in summary.json"
for report in fragments energy render series; do "$post" "$report" "$out/run"; done
