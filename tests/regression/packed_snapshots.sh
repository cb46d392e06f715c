#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# packed_snapshots.sh LIGGGHTS_MUCKPILE MUCKPILE_POST: a small bench with snapshots of text and packed is measured alike, and the packed
# ones take less than half of the bytes.
# Scope: one rank, whose runs repeat to the last bit; floats leave seven digits of velocities.
set -euo pipefail
program=$1 post=$2
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"
readonly small=(-var accuracy quick -var bench_height 3 -var burden 1.5 -var hole_diameter 0.06 -var time_end 0.3)

bytes() { find "$out/$1/dump" -name "blocks_0*.$2" -printf '%s\n' | awk '{ sum += $1 } END { print sum }'; }

for form in csv packed; do
  run_input $form 1 inputs/bench/in.bench "${small[@]}" -var snapshot_form $form
  "$post" profile "$out/$form" >"$out/$form/post"
done
"$post" compare "$out/csv" "$out/packed" --relative 1e-6 --absolute 1e-6
text=$(bytes csv csv) packed=$(bytes packed bin)
echo "bytes of snapshots: $text of text, $packed packed"
((2 * packed < text)) || fail "packed snapshots take $packed of $text bytes"
[[ -z $(find "$out/packed/dump" -name 'blocks_0*.csv') ]] || fail "snapshots of text beside packed ones"
