#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# scaling.sh PROGRAM RESULTS "SIZE..." "NP...": what docs/scaling.md and docs/perf.md are made of. The bench with block sizes
# times SIZE (1: 10,600 blocks; 0.37: 200,000) on NP ranks, a few steps of the wave; a line of CSV for each to
# RESULTS/scaling.csv: wall and CPU time of the steps, peak memory of the largest rank and of all.
# With RUN_UNDER set (say "chrt -r 3"), the ranks run under that command.
set -euo pipefail
[[ $# -eq 4 ]] || { sed -n '3,7s/^# //p' "$0" >&2; exit 2; }
program=$(realpath "$1") results=$(realpath -m "$2") sizes=$3 ranks=$4 few=${FEW_STEPS:-100}
cd "$(dirname "$0")/../.."
mkdir -p "$results"
read -ra under <<<"${RUN_UNDER:-}"
input=$results/in.few
sed '/^run_blast/,$c include tests/benchmarks/few_steps.in' inputs/bench/in.bench >"$input"
figures=$(dirname "$program")/../../tests/benchmarks/log_figures

csv=$results/scaling.csv
[[ -s $csv ]] || echo "size,np,blocks,joints,create_s,steps,loop_wall_s,us_per_block_step,peak_rank_MB,peak_all_MB" >"$csv"
for size in $sizes; do
  for np in $ranks; do
    out=$results/size${size}_np$np
    mkdir -p "$out/dump"
    rm -f "$out"/rank.*
    # Each rank writes its own peak memory [kB].
    # shellcheck disable=SC2046 # sizes are many words
    mpirun --oversubscribe -np "$np" bash -c '
      out=$1; shift
      exec /usr/bin/time -o "$out/rank.${OMPI_COMM_WORLD_RANK:-0}" -f "%M %U" "$@"' rank "$out" "${under[@]}" \
      "$program" -in "$input" -log "$out/log" -var out "$out" -var few "$few" $("$figures" sizes 0.26 0.18 0.5 "$size") \
      </dev/null >"$out/output" 2>&1 || { tail -n 3 "$out/output" "$out/log" >&2; exit 1; }
    "$figures" scaling "$size" "$np" "$out" | tee -a "$csv"
  done
done
