#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# recipes.sh PROGRAM PAGE: each './muckpile run INPUT ...' of a page cuts its rock, fires and does a few steps.
# Scope: coarser blocks than the recipe's, and a few steps in place of run_blast; what those runs come to is tested elsewhere.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
program=$(readlink -f "$1")
page=$(readlink -f "$2")
cd "$root"
readonly least_recipes=5

# Words that come first win.
coarser() {  # coarser INPUT
  case $1 in
    */in.bench) echo -var block_min 0.27 -var block_max 1.0 -var fragment_x50 0.6 ;;
    */in.quarry) echo -var block_min 0.35 -var block_max 2.0 -var fragment_x50 1.4 ;;
    */in.crater) echo -var block_min 0.3 -var block_max 1.2 -var fragment_x50 0.8 ;;
  esac
}

count=0
while IFS= read -r line; do
  eval "words=($line)"  # as a shell reads them, quotes and all
  input=${words[2]} options=()
  for ((k = 3; k < ${#words[@]}; k += 1)); do
    case ${words[k]} in
      -var) options+=(-var "${words[k + 1]}" "${words[k + 2]}") && k=$((k + 2)) ;;
      -out) k=$((k + 1)) ;;
      *) fail "unknown word '${words[k]}' in: $line" ;;
    esac
  done
  sed '/^run_blast/,$c include tests/benchmarks/few_steps.in' "$input" >"$out/in.recipe"
  rm -rf "$out/run" && mkdir -p "$out/run/dump"
  # shellcheck disable=SC2046
  on_ranks 1 -in "$out/in.recipe" -log "$out/run/log" -var few 3 -var out "$out/run" $(coarser "$input") "${options[@]}" \
    </dev/null >"$out/screen" 2>&1 || fail "does not run: $line"
  ! grep -q ' has no such variable' "$out/screen" || fail "has a knob that the input has not: $line"
  count=$((count + 1))
done < <(sed -nE 's/^ {4}(\.\/muckpile run inputs\/.*)$/\1/p' "$page")
((count >= least_recipes)) || fail "only $count recipes found in $page"
echo "$count recipes run"
