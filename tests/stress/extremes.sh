#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# extremes.sh LIGGGHTS_MUCKPILE INPUT SECONDS [-var NAME VALUE]...: runs INPUT with every knob in turn at the least and at the greatest value that
# its `require` lines allow, up to the begin of the throw. Each run must end with finite figures, or be refused or stopped with an
# ERROR line of ours that says why: no crash, no fault found by LIGGGHTS far from its cause, no number that is none, no more than SECONDS.
# Scope: one knob at a time, one rank. The variables make the case small. Values that only make more blocks are left out (kLarge).
set -euo pipefail
program=$1 input=$2 seconds=$3
shift 3
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
source "$root/tests/support/check_figures.sh"
cd "$root"
source src/app/run/input_variables.sh
readonly kLarge=' bench_height=100 burden=50 holes=10000 spacing=50 half_width=500 rock_below=500 subdrill=50 fragment_x50=1e-3 block_min=1e-3 go_on=1 time_end=1000 charge_mass=1e5 hole_diameter=0.005 '

# A knob and its two ends; where an end itself is excluded, a number just inside.
ends() {
  files_of "$input" | sort -u | xargs grep -hE '^require +([A-Za-z0-9_]+) +\$\{\1\} ' | awk '{
    lo = hi = ""
    for (i = 4; i < NF; i++) {
      number = $(i + 1) ~ /^[-0-9.e+]+$/
      if (number && $i == "at_least") lo = $(i + 1)
      if (number && $i == "at_most") hi = $(i + 1)
      if (number && $i == "above") lo = $(i + 1) == 0 ? "1e-6" : $(i + 1) * 1.001
      if (number && $i == "below") hi = $(i + 1) * 0.999
    }
    if (lo != "") print $2, lo
    if (hi != "") print $2, hi }' | sort -u
}

tried=0 wrong=0 ran=0
try() {  # try KNOB VALUE [-var NAME VALUE]...: the first -var of a name counts
  local knob=$1 value=$2 status=0 fault=''
  shift 2
  tried=$((tried + 1))
  rm -rf "$out/dump" && mkdir "$out/dump"
  timeout -k 5 "$seconds" "$program" -in "$input" -log none -var out "$out" -var "$knob" "$value" "$@" >"$out/screen" 2>&1 || status=$?
  if [[ $status -eq 0 ]]; then
    ran=$((ran + 1))
    fault=$(check_figures finite "$out/dump/run.json" "$out/dump/history.csv" 2>&1) || fault=${fault:-no figures}
  elif [[ $status -ne 1 ]] || ! grep -qE '^ERROR: (input|create_blocks|charge_design|run_blast|fix muckpile/[a-z]+)[: ]' "$out/screen"; then
    fault="exit status $status, $(tail -n 1 "$out/screen")"
  fi
  printf '%-24s %-12s %s\n' "$knob" "$value" "${fault:-$([[ $status -eq 0 ]] && echo ran || grep '^ERROR' "$out/screen" | head -n 1 | cut -c1-150)}"
  [[ -z $fault ]] || { echo "  WRONG"; wrong=1; }
}

while read -r knob value; do
  [[ $kLarge != *" $knob=$value "* ]] || continue
  ! grep -qsE "^variable[[:space:]]+$knob[[:space:]]+(equal|string)" "$input" "$(dirname "$input")/geometry.in" || continue  # computed, no knob
  try "$knob" "$value" "$@"
done < <(ends)
echo "$tried values tried, $ran ran"
[[ $tried -ge 30 && $ran -ge 20 ]] || { echo "too few in $input"; wrong=1; }
exit $wrong
