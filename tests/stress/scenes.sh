#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# scenes.sh LIGGGHTS_MUCKPILE MUCKPILE_POST LIST: runs every scene of LIST to its end. Each must end without an error (a lost block is
# one), with finite figures, an energy balance within the scene's bound, and no block faster than five times the face.
# Scope: LIST has a line per scene: name, ranks, bound of the balance in % of the blast's work, input, -var NAME VALUE...; `#` starts a remark.
set -euo pipefail
program=$1 post=$2 list=$(readlink -f "$3")
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
source "$root/tests/support/check_figures.sh"
cd "$root"

value() { sed -nE "s/^ *\"$1\": ([^,]+),?$/\1/p" "$out/summary.json" | head -n 1; }

keeps() {  # keeps CHECK...: prints what is wrong
  local said
  said=$(check_figures "$@" 2>&1) || printf '%s\n' "${said:-check_figures $* failed}"
}

faults_of() {  # faults_of REPORT BOUND
  local summary=$out/summary.json
  keeps finite "$out/dump/run.json" "$out/dump/history.csv"
  keeps bounds "energy balance error" "$summary:energy_balance_error_worst" --below 0.01 --times "$2"
  if [[ $1 == profile ]]; then
    keeps bounds "fastest block [m/s]" "$summary:fastest_block_m_s" --below "$summary:face_velocity_m_s" --times 5
    if grep -q '"still": true' "$summary"; then keeps bounds "swell" "$summary:swell_factor" --at-least 1; fi
  fi
}

wrong=0 scenes=0
while read -r name ranks bound input rest; do
  [[ -n $name && $name != '#'* ]] || continue
  scenes=$((scenes + 1))
  rm -rf "${out:?}"/* && mkdir "$out/dump"
  read -ra vars <<<"$rest"
  status=0 report=profile
  [[ $input != *crater* ]] || report=crater
  timeout -k 5 900 mpirun -np "$ranks" --oversubscribe --bind-to none "$program" -in "$input" -log none -var out "$out" "${vars[@]}" \
    >"$out/screen" 2>&1 </dev/null || status=$?
  [[ $status -ne 0 ]] || "$post" "$report" "$out" >>"$out/screen" 2>&1 || status=$?
  if [[ $status -ne 0 ]]; then
    echo "$name: exit status $status: $(grep '^ERROR' "$out/screen" || tail -n 1 "$out/screen")"
    wrong=1
    continue
  fi
  verdict=$(faults_of "$report" "$bound")
  printf '%-22s ranks %d: %6s blocks, face %6s m/s, fastest %6s m/s, swell %6s, balance %9s, still %5s at %s s  %s\n' "$name" "$ranks" \
    "$(value blocks)" "$(value face_velocity_m_s)" "$(value fastest_block_m_s)" "$(value swell_factor)" "$(value energy_balance_error_worst)" \
    "$(value still)" "$(value physical_time_s)" "${verdict:-ok}"
  [[ -z $verdict ]] || wrong=1
done <"$list"
[[ $scenes -gt 0 ]] || { echo "no scene in $list"; wrong=1; }
exit $wrong
