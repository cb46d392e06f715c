#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# contact_stress.sh LIGGGHTS_MUCKPILE [NP]: runs in.contacts. Up to twice the step that contacts with dashpots bear the heap must rest with
# its energy balanced to 0.1 %; far above, both must be lost (the drift is 1 to 3 % there, by chance of the rattling).
set -euo pipefail
program=$1 ranks=${2:-1}
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
source "$root/tests/support/check_figures.sh"
cd "$root"
on_ranks "$ranks" -in "$here/in.contacts" -log none -var out "$out" "${@:3}" \
  >"$out/screen" 2>&1 || { tail -n 5 "$out/screen"; exit 1; }
grep '^contact_stress:' "$out/screen"
wrong=0
for share in 1 2; do
  figures=$out/share_$share.json
  check_figures bounds "kinetic energy at share $share [J]" "$figures:kinetic_J" --below 0.2 || wrong=1
  check_figures bounds "drift of the balance at share $share" "$figures:balance_drift" --below 1e-3 || wrong=1
done
check_figures bounds "kinetic energy at share 6 [J]" "$out/share_6.json:kinetic_J" --above 50 || wrong=1
check_figures bounds "drift of the balance at share 6" "$out/share_6.json:balance_drift" --above 5e-3 || wrong=1
exit $wrong
