#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# packed_snapshots.sh LIGGGHTS_MUCKPILE MUCKPILE_POST: a small bench with snapshots of text and packed is measured alike, and the packed
# ones take less than half of the bytes. A run may go on in the other form.
# Scope: one rank, whose runs repeat to the last bit, and two; floats leave seven digits of velocities.
set -euo pipefail
program=$1 post=$2
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"
readonly small=(-var accuracy quick -var bench_height 3 -var burden 1.5 -var hole_diameter 0.06 -var time_end 0.3)

bytes() { find "$out/$1/dump" -name "blocks_0*.$2" -printf '%s\n' | awk '{ sum += $1 } END { print sum }'; }

measured() { check_figures print "$out/$1/summary.json:$2"; }  # measured FOLDER QUANTITY

for form in csv packed; do run_input $form 1 inputs/bench/in.bench "${small[@]}" -var snapshot_form $form; done
run_input two 2 inputs/bench/in.bench "${small[@]}" -var snapshot_form packed
for folder in csv packed two; do "$post" profile "$out/$folder" >"$out/$folder/post"; done
"$post" compare "$out/csv" "$out/packed" --relative 1e-6 --absolute 1e-6
for folder in csv packed; do "$post" fragments "$out/$folder" >"$out/$folder/post"; done
wrong=0
compare "median sieve size [m]" "$(measured packed sieve_p50_m)" "$(measured csv sieve_p50_m)" 0.01 || wrong=1
compare "throw [m], on 2 ranks" "$(measured two throw_cg_m)" "$(measured packed throw_cg_m)" 0.1 || wrong=1
text=$(bytes csv csv) packed=$(bytes packed bin)
echo "bytes of snapshots: $text of text, $packed packed"
((2 * packed < text)) || fail "packed snapshots take $packed of $text bytes"
[[ -z $(find "$out/packed/dump" -name 'blocks_0*.csv') ]] || fail "snapshots of text beside packed ones"

# Going on in the other form leaves one snapshot of each step.
run_input on 1 inputs/bench/in.bench "${small[@]}" -var restart_every 100
run_input on 1 inputs/bench/in.bench "${small[@]}" -var restart_every 100 -var go_on 1 -var from "$out/on/dump/a.restart" -var snapshot_form packed
twice=$(find "$out/on/dump" -name 'blocks_0*' -printf '%f\n' | sed 's/\..*//' | sort | uniq -d)
[[ -z $twice ]] || fail "snapshots in both forms: $twice"
"$post" profile "$out/on" >"$out/on/post"
exit $wrong
