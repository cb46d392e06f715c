#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# leaning_face.sh LIGGGHTS_MUCKPILE MUCKPILE_POST: the bench with a free face of 76 degrees, as a user would write it with regions: `profile`
# measures it. The same with a face that is turned about z, too, which is no plane through the toe: it is measured as it was cut. With holes that
# stand elsewhere than the burden says `profile` ends with exit status 3, leaves no figures, and takes back those that lie there; the other
# reports work.
# Scope: the shortest run of the smallest bench; inputs/bench/in.bench is taken with other regions.
set -euo pipefail
program=$1 post=$2
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"

input=$out/in.leaning
upright='^region +rock block '
[[ $(grep -cE "$upright" inputs/bench/in.bench) -eq 1 ]] || fail "inputs/bench/in.bench has not one line '$upright'"
run_with_face() {  # run_with_face FOLDER NORMAL: of a plane through the toe in the middle of the row, into the rock
  sed -E "s/$upright(.*)/region whole block \\1\nregion behind_face plane 0 0 0 $2 units box\nregion rock intersect 2 whole behind_face/" \
    inputs/bench/in.bench >"$input"
  run_input "$1" 1 "$input" -var bench_height 3 -var burden 1.5 -var hole_diameter 0.05 -var fragment_x50 0.4 -var block_min 0.25 \
    -var block_max 0.7 -var time_end 0.02
}

run_with_face leaning "-0.970296 0 -0.241922"  # 76 degrees
"$post" profile "$out/leaning"
for key in throw_cg_m face_velocity_m_s; do
  grep -qE "\"$key\": [0-9]" "$out/leaning/summary.json" || fail "$key of the leaning face was not measured"
done

run_with_face run "-0.940 -0.242 -0.241"
"$post" profile "$out/run"
grep -q '"face_note": "no plane: rock begins between' "$out/run/summary.json" || fail "the turned face was taken for a plane"
grep -qE '"throw_cg_m": [0-9]' "$out/run/summary.json" || fail "throw of the turned face was not measured"

sed -i 's/"burden_m": *1.5/"burden_m": 2.5/' "$out/run/dump/scene.json"
echo "old" | tee "$out/run/profile.csv" >"$out/run/profile.png"
status=0
"$post" profile "$out/run" 2>"$out/message" || status=$?
cat "$out/message"
[[ $status -eq 3 ]] || fail "profile: exit status $status, should be 3"
grep -q 'the front row of holes must stand at x = -2.5 m' "$out/message" || fail "another message"
[[ ! -e $out/run/profile.csv && ! -e $out/run/profile.png ]] || fail "old profile.* are still there"
! grep -qE '"(throw_cg_m|face_velocity_m_s|swell_factor|pile_toe_m)"' "$out/run/summary.json" || fail "figures in summary.json"
grep -q '"profile_refused"' "$out/run/summary.json" || fail "no reason in summary.json"
for report in fragments energy render series; do "$post" "$report" "$out/run"; done
