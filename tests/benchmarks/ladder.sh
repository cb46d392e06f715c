#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# ladder.sh LIGGGHTS_MUCKPILE MUCKPILE_POST OUT [quick]: run time against error of a bench of half the height, one knob at a time; writes
# OUT/ladder.csv, OUT/ladder.md and OUT/cases/ladder.json.
# Scope: CPU seconds of one rank, so that other work on the machine and runs side by side disturb little. Error: distance from the run that
# is finest in everything. `quick` makes every second run only, and ends them earlier: a trial of the command, not a result.
set -euo pipefail
program=$(readlink -f "$1") post=$(readlink -f "$2") out=$(realpath -m "$3") quick=${4-}
root=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
# Of tests/regression/bench_small.json; long enough for the burden to land.
bench="-var bench_height 5 -var burden 2 -var hole_diameter 0.064 -var time_end 3.0"
[[ $quick != quick ]] || bench=${bench/time_end 3.0/time_end 0.2}
readonly bench
readonly quantities=(face_velocity_m_s throw_cg_m beyond_toe_fraction joints_broken_fraction)
export OMPI_MCA_btl_vader_single_copy_mechanism=none

# The sizes of the standard blocks (median, smallest, largest) times a factor. At the wall of the crushed zone, 0.192 m wide here,
# blocks must not be larger than it.
sizes() {
  awk -v f="$1" 'BEGIN {
    least = 0.18 * f < 0.19 ? 0.18 * f : 0.19
    printf "-var fragment_x50 %.4g -var block_min %.4g -var block_max %.4g", 0.35 * f, least, 0.50 * f }'
}

# name|knob|setting|variables; the knob groups the points of a plot. The finest run is the longest, so it starts first.
ladder=(
  "finest|finest|blocks x 0.7, 8 spheres, half the step, 4 x stiffer|$(sizes 0.7) -var spheres_per_block 8 -var wave_share 0.45 -var gas_substeps 8 -var steps_per_contact 30 -var contact_modulus 1e8 -var softening 1.5e-3 -var push_softening 1 -var open_sleep 0 -var sleep 0"
  "size_0.7|block size|x 0.7|$(sizes 0.7)"
  "size_0.85|block size|x 0.85|$(sizes 0.85)"
  "standard|standard|seed 1|$(sizes 1)"
  "size_1.2|block size|x 1.2|$(sizes 1.2)"
  "size_1.4|block size|x 1.4|$(sizes 1.4)"
  "seed_2|standard|seed 2|$(sizes 1) -var seed 2"
  "seed_3|standard|seed 3|$(sizes 1) -var seed 3"
  "spheres_3|spheres per block|3|$(sizes 1) -var spheres_per_block 3"
  "spheres_8|spheres per block|8|$(sizes 1) -var spheres_per_block 8"
  "share_0.35|first phase: step over the stable one|0.35|$(sizes 1) -var wave_share 0.35"
  "gas_substeps_8|substeps of the gas|8|$(sizes 1) -var gas_substeps 8"
  "steps_15|steps per contact|15|$(sizes 1) -var steps_per_contact 15"
  "steps_30|steps per contact|30|$(sizes 1) -var steps_per_contact 30"
  "softening_low|softening|9.4e-5|$(sizes 1) -var softening 9.4e-5"
  "softening_high|softening|1.5e-3|$(sizes 1) -var softening 1.5e-3"
  "modulus_low|contact modulus|6.25e6 Pa|$(sizes 1) -var contact_modulus 6.25e6"
  "modulus_high|contact modulus|1e8 Pa|$(sizes 1) -var contact_modulus 1e8"
  "sleep_off|shortcut off|sleep 0|$(sizes 1) -var sleep 0"
  "open_sleep_off|shortcut off|open_sleep 0|$(sizes 1) -var open_sleep 0"
  "push_off|shortcut off|push_softening 1|$(sizes 1) -var push_softening 1"
  "quiet_off|shortcut off|quiet 0|$(sizes 1) -var quiet 0"
  "gas_wait|shortcut off|gas_rest 1e-9|$(sizes 1) -var gas_rest 1e-9"
  "accuracy_quick|accuracy|quick|-var accuracy quick -var fragment_x50 0.455 -var block_min 0.19"
  "accuracy_fine|accuracy|fine|-var accuracy fine -var fragment_x50 0.28"
)

value_of() {  # value_of QUANTITY RUN
  sed -nE "s/^ *\"$1\": ([-0-9.eE+]+),?$/\1/p" "$out/runs/$2/summary.json"
}

one_run() {  # one_run NAME VARIABLES...: leaves NAME/summary.json and NAME/seconds
  local folder=$out/runs/$1 TIMEFORMAT='%U %S'
  shift
  rm -rf "$folder"
  mkdir -p "$folder/dump"
  # shellcheck disable=SC2086 # $bench is many words
  { time "$program" -in inputs/bench/in.bench -log none -var out "$folder" $bench "$@" \
    >"$folder/screen" 2>&1 </dev/null; } 2>"$folder/seconds" || {
    tail -n 15 "$folder/screen"
    return 1
  }
  "$post" profile "$folder" >"$folder/post" 2>&1 || { tail -n 5 "$folder/post"; return 1; }
  rm -rf "$folder"/dump/blocks_*.csv "$folder"/*.png
}

# On as many cores as there are, two at least: a run is on one core.
all_runs() {
  local rung name knob setting vars running=0 most failed=0
  most=$(nproc)
  for rung in "${ladder[@]}"; do
    IFS='|' read -r name knob setting vars <<<"$rung"
    if ((running >= most)); then
      wait -n || failed=1
      running=$((running - 1))
    fi
    echo "ladder: $name ($knob: $setting)"
    # shellcheck disable=SC2086
    one_run "$name" $vars &
    running=$((running + 1))
  done
  for ((; running > 0; running--)); do wait -n || failed=1; done
  return "$failed"
}

write_csv() {
  local rung name knob setting vars quantity row
  echo "name,knob,setting,blocks,steps,cpu_s,$(IFS=, && echo "${quantities[*]}")"
  for rung in "${ladder[@]}"; do
    IFS='|' read -r name knob setting vars <<<"$rung"
    row="$name,$knob,${setting//,/;},$(value_of blocks "$name"),$(value_of steps "$name"),$(awk '{ print $1 + $2 }' "$out/runs/$name/seconds")"
    for quantity in "${quantities[@]}"; do row+=,$(value_of "$quantity" "$name"); done
    echo "$row"
  done
}

# Table for the page: values with their distance from the finest run in per cent.
write_table() {
  awk -F, '
    NR == 1 { next }
    $1 == "finest" { for (i = 7; i <= 10; i++) finest[i] = $i }
    { row[++n] = $0 }
    function far(value, i) { return sprintf("%.4g (%+.1f %%)", value, 100 * (value / finest[i] - 1)) }
    END {
      print "| knob | setting | blocks | steps | CPU s | face velocity, m/s | throw of the mass centre, m | share beyond the old toe | joints broken |"
      print "|---|---|---|---|---|---|---|---|---|"
      for (k = 1; k <= n; k++) {
        split(row[k], c, ",")
        printf "| %s | %s | %d | %d | %.1f | %s | %s | %s | %s |\n", c[2], c[3], c[4], c[5], c[6], far(c[7], 7), far(c[8], 8), far(c[9], 9), far(c[10], 10)
      }
    }' "$out/ladder.csv"
}

# Mean and standard deviation over the three seeds of the standard setting: differences below that say nothing.
write_scatter() {
  awk -F, '
    NR == 1 { for (i = 7; i <= 10; i++) name[i] = $i; next }
    $2 == "standard" { n++; for (i = 7; i <= 10; i++) { sum[i] += $i; square[i] += $i * $i } }
    END {
      print "| quantity | mean of " n " seeds | standard deviation |\n|---|---|---|"
      for (i = 7; i <= 10; i++) {
        mean = sum[i] / n
        variance = (square[i] - n * mean * mean) / (n - 1)
        deviation = variance > 0 ? sqrt(variance) : 0
        printf "| %s | %.4g | %.2g (%.1f %%) |\n", name[i], mean, deviation, 100 * deviation / mean
      }
    }' "$out/ladder.csv"
}

# The report that make_page reads: a row per run and quantity, a curve per knob and quantity.
write_report() {
  awk -F, -v total="$SECONDS" '
    function json(word) { return "\"" word "\"" }
    NR == 1 { for (i = 7; i <= 10; i++) name[i] = $i; next }
    $1 == "finest" { for (i = 7; i <= 10; i++) finest[i] = $i }
    { run[++n] = $0 }
    END {
      unit["face_velocity_m_s"] = "m/s"; unit["throw_cg_m"] = "m"
      printf "{\"report\": \"ladder\", \"seconds\": %d,\n \"rows\": [", total
      for (k = 1; k <= n; k++) {
        split(run[k], c, ",")
        printf "%s\n  {\"case\": %s, \"quantity\": \"CPU time\", \"unit\": \"s\", \"value\": %g, \"reference\": 0, \"source\": \"none\", \"error\": null, \"tolerance\": null, \"pass\": true}", (k > 1 ? "," : ""), json(c[1]), c[6]
        for (i = 7; i <= 10; i++)
          printf ",\n  {\"case\": %s, \"quantity\": %s, \"unit\": %s, \"value\": %g, \"reference\": %g, \"source\": \"finest run\", \"error\": %g, \"tolerance\": null, \"pass\": true}", json(c[1]), json(name[i]), json(unit[name[i]]), c[i], finest[i], c[i] / finest[i] - 1
      }
      printf "\n ],\n \"curves\": ["
      for (i = 7; i <= 10; i++) {
        colour = 0
        delete points
        delete label
        knobs = 0
        for (k = 1; k <= n; k++) {
          split(run[k], c, ",")
          error = c[i] / finest[i] - 1
          if (c[1] == "finest") continue
          if (!(c[2] in points)) label[++knobs] = c[2]
          # A logarithmic axis has no 0: what is nearer than 0.01 % is drawn there.
          error = error < 0 ? -error : error
          points[c[2]] = points[c[2]] (points[c[2]] == "" ? "" : ", ") sprintf("[%g, %g]", c[6], 100 * (error > 1e-4 ? error : 1e-4))
        }
        for (k = 1; k <= knobs; k++)
          printf "%s\n  {\"plot\": \"ladder_%s\", \"title\": \"%s: run time against distance from the finest run\", \"x_label\": \"CPU time, s\", \"y_label\": \"distance, %%\", \"x_scale\": \"logarithmic\", \"y_scale\": \"logarithmic\", \"label\": %s, \"style\": \"points\", \"colour\": %d, \"points\": [%s]}", (i + k > 8 ? "," : ""), name[i], name[i], json(label[k]), k - 1, points[label[k]]
      }
      print "\n ]}"
    }' "$out/ladder.csv"
}

mkdir -p "$out/cases"
cd "$root"
all_runs || { echo "ladder: error: a run failed; see above and $out/runs" >&2; exit 1; }
write_csv >"$out/ladder.csv"
write_table >"$out/ladder.md"
write_scatter >"$out/scatter.md"
write_report >"$out/cases/ladder.json"
cat "$out/ladder.md"
