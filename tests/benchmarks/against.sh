#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# against.sh OLD NEW RESULTS [TURNS [BENCH_TURNS]]: the programs of tests/perf and the default bench of two checkouts, both of them built, in turns (old, new,
# new, old ...). Writes RESULTS/against.md: a table of times and ratios, and how many snapshots of the two benches are the same to the last bit.
# Scope: one program at a time, one rank, on a quiet machine. Each bench is the input of its own checkout.
set -euo pipefail
old=$(readlink -f "$1") new=$(readlink -f "$2") results=$(realpath -m "$3") turns=${4:-9} bench_turns=${5:-2}
readonly programs=(contacts facets blocks gas)
export OMPI_MCA_btl_vader_single_copy_mechanism=none

fail() {
  printf '%s\n' "benchmark: error: $*" >&2
  exit 1
}

root_of() { if [[ $1 == old ]]; then echo "$old"; else echo "$new"; fi; }

# The two sides of a turn, the first of them by turns.
order() { if (($1 % 2)); then echo old new; else echo new old; fi; }

measure() {  # measure SIDE NAME TURN
  "$(root_of "$1")/build/release/tests/perf/perf_$2" 2>/dev/null >"$results/$1/$2_$3.json" || fail "perf_$2 of the $1 build failed"
}

blast() {  # blast SIDE TURN
  local out=$results/$1/bench TIMEFORMAT='{"one_rank": {"cpu_s": %U}}'
  rm -rf "$out" && mkdir -p "$out"
  cd "$(root_of "$1")"
  { time mpirun -np 1 --bind-to none build/release/src/app/liggghts-muckpile -in inputs/bench/in.bench -log "$out/log.liggghts" -var out "$out" \
    >"$out/screen" 2>&1; } 2>"$results/$1/bench_$2.json" || fail "the bench of the $1 build failed; see $out/screen"
}

# A snapshot's first line names its run.
same_snapshots() {
  local file count=0 same=0
  for file in "$results"/new/bench/dump/blocks_*.csv; do
    count=$((count + 1))
    ! cmp -s <(tail -n +2 "$file") <(tail -n +2 "$results/old/bench/dump/${file##*/}" 2>/dev/null) || same=$((same + 1))
  done
  echo "$same of $count snapshots of the default bench on one rank are the same to the last bit."
}

for side in old new; do
  for name in "${programs[@]}"; do
    [[ -x $(root_of "$side")/build/release/tests/perf/perf_$name ]] || fail "perf_$name of '$(root_of "$side")' is not built: run ./muckpile build there"
  done
  rm -rf "${results:?}/$side" && mkdir -p "$results/$side"
done
for ((turn = 1; turn <= turns; ++turn)); do
  for name in "${programs[@]}"; do
    for side in $(order "$turn"); do measure "$side" "$name" "$turn"; done
  done
done
for ((turn = 1; turn <= bench_turns; ++turn)); do
  for side in $(order "$turn"); do blast "$side" "$turn"; done
done
table=$new/build/release/tests/benchmarks/turns_table
{
  "$table" "$results" "$turns" "${programs[@]}"
  ((bench_turns == 0)) || "$table" "$results" "$bench_turns" bench | tail -n +3
  echo
  ((bench_turns == 0)) || same_snapshots
} | tee "$results/against.md"
