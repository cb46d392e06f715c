#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run.sh [RESULTS [LIGGGHTS_MUCKPILE MUCKPILE_POST]]: runs in.burden_velocity for burdens of 2.5 to 4 m and three seeds, fits v = c W^-n to the face velocities,
# and writes RESULTS/velocities.csv and RESULTS/summary.json. RESULTS is results/burden_velocity unless given.
# Scope: takes the programs of build/release unless others are named; fails if the exponent is outside what expected.json allows.
set -euo pipefail
root=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../../..")
case_dir=inputs/validation/burden_velocity
cd "$root"
results=${1:-results/burden_velocity}
program=${2:-build/release/src/app/liggghts-muckpile} post=${3:-build/release/postproc/tools/muckpile-post}
mkdir -p "$results"
table=$results/velocities.csv
echo "burden_m,seed,face_velocity_m_s,wave_work_J,gas_work_J,explosive_energy_J" >"$table"

value() { sed -nE "s/^ *\"$2\": ([-0-9.eE+]+),?$/\1/p" "$1"; }

for burden in 2.5 3 3.5 4; do
  for seed in 1 2 3; do
    out=$results/w${burden}_s$seed
    rm -rf "$out" && mkdir -p "$out/dump"
    OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_btl_vader_single_copy_mechanism=none \
      mpirun -np 1 --bind-to none "$program" -in $case_dir/in.burden_velocity -log none \
      -var out "$out" -var burden "$burden" -var seed "$seed" >"$out/screen"
    "$post" profile "$out"
    summary=$out/summary.json
    echo "$burden,$seed,$(value "$summary" face_velocity_mean_m_s),$(value "$summary" wave_work_J),$(value "$summary" gas_work_J),$(value "$summary" explosive_energy_J)" |
      tee -a "$table"
  done
done

# Least squares of ln v over ln W.
awk -F, -v json="$results/summary.json" 'NR > 1 {
    x = log($1); y = log($3); n++; sx += x; sy += y; sxx += x * x; sxy += x * y
    if ($1 == 3) { v3 += $3; n3++; wave += $4 / $6; gas += $5 / $6 } }
  END { slope = (n * sxy - sx * sy) / (n * sxx - sx * sx)
    printf "{\n  \"burden_velocity_exponent\": %.4f,\n  \"velocity_at_3_m_m_s\": %.3f,\n", slope, v3 / n3 > json
    printf "  \"wave_efficiency_at_3_m\": %.4f,\n  \"gas_efficiency_at_3_m\": %.4f\n}\n", wave / n3, gas / n3 > json }' "$table"
cat "$results/summary.json"

wrong=0
while read -r quantity value tolerance; do
  found=$(value "$results/summary.json" "$quantity")
  verdict=$(awk -v f="$found" -v v="$value" -v t="$tolerance" 'BEGIN { print (f != "" && f - v <= t && v - f <= t) ? "ok" : "WRONG" }')
  printf '%-28s %14s  expected %s +- %s  %s\n' "$quantity" "${found:-missing}" "$value" "$tolerance" "$verdict"
  [[ $verdict == ok ]] || wrong=1
done < <(sed -nE 's/^ *\{"quantity": "([a-zA-Z0-9_]+)", "value": ([-0-9.eE+]+), "tolerance": ([-0-9.eE+]+),.*/\1 \2 \3/p' $case_dir/expected.json)
exit "$wrong"
