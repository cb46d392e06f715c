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
scaled() { awk -v a="$1" -v s="$2" 'BEGIN { printf "%.6g", a * s }'; }

csv=$results/scaling.csv
[[ -s $csv ]] || echo "size,np,blocks,joints,create_s,steps,loop_wall_s,us_per_block_step,peak_rank_MB,peak_all_MB" >"$csv"
for size in $sizes; do
  for np in $ranks; do
    out=$results/size${size}_np$np
    mkdir -p "$out/dump"
    rm -f "$out"/rank.*
    # Each rank writes its own peak memory [kB].
    mpirun --oversubscribe -np "$np" bash -c '
      out=$1; shift
      exec /usr/bin/time -o "$out/rank.${OMPI_COMM_WORLD_RANK:-0}" -f "%M %U" "$@"' rank "$out" "${under[@]}" \
      "$program" -in "$input" -log "$out/log" -var out "$out" -var few "$few" \
      -var fragment_x50 "$(scaled 0.26 "$size")" -var block_min "$(scaled 0.18 "$size")" \
      -var block_max "$(scaled 0.5 "$size")" </dev/null >"$out/output" 2>&1 || { tail -n 3 "$out/output" "$out/log" >&2; exit 1; }
    cat "$out"/rank.* | awk -v size="$size" -v np="$np" -v log_file="$out/log" '
      { all += $1; if ($1 > most) most = $1 }
      END {
        while ((getline line < log_file) > 0) {
          n = split(line, w, " ")
          if (line ~ /^create_blocks: [0-9]+ blocks/) { blocks = w[2]; joints = w[6] }
          if (line ~ /largest initial sphere overlap/) create = w[n - 1]
          if (line ~ /^Loop time of/) { wall = w[4]; for (k = 1; k <= n; ++k) if (w[k] == "steps") steps = w[k - 1] }
        }
        printf "%s,%s,%s,%s,%s,%s,%s,%.4g,%.0f,%.0f\n", size, np, blocks, joints, create, steps, wall,
               1e6 * wall / blocks / steps, most / 1024, all / 1024
      }' | tee -a "$csv"
  done
done
