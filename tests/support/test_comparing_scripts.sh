#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_comparing_scripts.sh CHECK_FIGURES: the scripts that run a case and compare its figures pass with the right ones, and fail with a
# number that is none, without figures, and with a mistyped row of expected values.
# Scope: fakes in place of mpirun and muckpile-post write what stands in $WRITES; tests/regression and inputs/validation.
# shellcheck disable=SC2016  # the bodies of the fakes expand when they run
set -euo pipefail
check=$(readlink -f "$1")
source "$(dirname "${BASH_SOURCE[0]}")/script.sh"
readonly tree=$out
mkdir -p "$tree"/{bin,src/app,tests/support/check_figures}
ln -s "$check" "$tree/tests/support/check_figures/check_figures"
program=$tree/src/app/program post=$tree/bin/post
touch "$program"
export PATH=$tree/bin:$PATH WRITES=$tree/writes TMPDIR=$tree

fake() { printf '#!/bin/bash\nset -e\n%s\n' "$2" >"$tree/bin/$1" && chmod +x "$tree/bin/$1"; }  # fake NAME BODY
# The engine's folder is the word behind -var out; muckpile-post's is its second.
fake mpirun 'while [[ $1 != out ]]; do shift; done
cp "$WRITES"/run.json "$WRITES"/history.csv "$WRITES"/blocks_1.csv "$2/dump"; echo x | tee "$2/dump/a.restart" >"$2/dump/b.restart"; echo "Reading restart file, 1 by 2 MPI processor grid"'
fake post 'cp "$WRITES/summary.json" "$2"'

good() {
  rm -rf "$WRITES" && mkdir "$WRITES"
  echo '{"steps": 100, "blocks": 5, "gas_work_J": 10, "wave_work_J": 2, "joints_broken_fraction": 0.9, "physical_time_s": 1, "energy_balance_error": 0.001}' \
    >"$WRITES/run.json"
  printf 'time_s,blast_work_J,energy_balance_error_worst\n1,12,0.001\n' >"$WRITES/history.csv"
  printf '# step=1\nblock,vx_m_s\n1,2\n2,4\n' >"$WRITES/blocks_1.csv"
  echo '{"throw_m": 8.5}' >"$WRITES/summary.json"
  printf '{"case": "x", "vars": "-var a 1",\n"expected": [\n{"quantity": "throw_m", "value": 8.4, "tolerance": 0.2, "why": "so"},
{"quantity": "blast_work_J", "value": 12, "tolerance": 1, "why": "so"}\n]}\n' >"$WRITES/expected.json"
}
call() {
  status=0
  output=$("$@" 2>&1) || status=$?
}
problem() {
  printf '%s\n' "test_comparing_scripts: $*" "--- status $status, output:" "$output"
  exit 1
}
passes() { call "$@" && { [[ $status -eq 0 ]] || problem "must pass: $*"; }; }
fails() {  # fails TEXT COMMAND...
  call "${@:2}"
  [[ $status -ne 0 ]] || problem "must fail: $*"
  grep -qF -- "$1" <<<"$output" || problem "does not tell '$1'"
}

run_case=("$root/tests/regression/run_case.sh" "$program" "$post" in.x profile "$WRITES/expected.json")
good
passes "${run_case[@]}"
sed -i 's/,12,/,nan,/' "$WRITES/history.csv"
fails "blast_work_J must be a finite number, got 'nan'" "${run_case[@]}"
good
echo '{"throw_m": null}' >"$WRITES/summary.json"
fails 'throw_m must be a finite number, got null' "${run_case[@]}"
good
echo '{}' >"$WRITES/summary.json"
fails 'no file has it' "${run_case[@]}"
good
sed -i '3s/tolerance/tolerence/' "$WRITES/expected.json"
fails "row 1 of expected: unknown key 'tolerence'" "${run_case[@]}"

go_on=("$root/tests/regression/go_on.sh" "$program" in.x 10)
ranks=("$root/tests/regression/ranks.sh" "$program" 2 0.01 in.x)
good
passes "${go_on[@]}"
passes "${ranks[@]}"
sed -i 's/"energy_balance_error": 0.001/"energy_balance_error": nan/' "$WRITES/run.json"
fails 'run.json' "${go_on[@]}"
fails 'run.json' "${ranks[@]}"
good
sed -i 's/"gas_work_J": 10, //' "$WRITES/run.json"
fails "has no 'gas_work_J'" "${ranks[@]}"

# The shortcut saves steps where the word off is not among the variables.
on_off=("$root/tests/regression/on_off.sh" "$program" "-var off 1" 0.01 0.01 0.9 in.x)
fake mpirun 'all=$*; while [[ $1 != out ]]; do shift; done
cp "$WRITES"/run.json "$WRITES"/blocks_1.csv "$2/dump"; [[ $all != *"-var off 1"* ]] || sed -i "s/100/200/; s/10,/10.01,/" "$2/dump/run.json"'
good
passes "${on_off[@]}"
sed -i 's/"steps": 100, //' "$WRITES/run.json"
fails "has no 'steps'" "${on_off[@]}"
sed -i 's/"gas_work_J": 10,/"gas_work_J": 5,/' "$WRITES/run.json"
fails 'it did not act' "${on_off[@]}"
good
sed -i 's/^2,4/2,nan/' "$WRITES/blocks_1.csv"
fails "vx_m_s must be a finite number, got 'nan'" "${on_off[@]}"

# Figures of expected.json at 3 m, and a power law with its exponent.
expected() { sed -nE "s/.*\"quantity\": \"$1\", \"value\": ([^,]+),.*/\1/p" "$root/inputs/validation/burden_velocity/expected.json"; }
SPEED=$(expected velocity_at_3_m_m_s) EXPONENT=$(expected burden_velocity_exponent)
WAVE=$(expected wave_efficiency_at_3_m) GAS=$(expected gas_efficiency_at_3_m)
[[ -n $SPEED && -n $EXPONENT && -n $WAVE && -n $GAS ]] || problem "figures of burden_velocity are not found"
export SPEED EXPONENT WAVE GAS
burdens=("$root/inputs/validation/burden_velocity/run.sh" "$tree/results" "$program" "$post")
fake mpirun 'true'
fake post 'w=${2##*/w} w=${w%_s*}
LC_ALL=C awk -v w="$w" '"'"'BEGIN { printf "{\"face_velocity_mean_m_s\": %.6f, \"wave_work_J\": %s, \"gas_work_J\": %s, \"explosive_energy_J\": 1}", ENVIRON["SPEED"] * (w / 3)^ENVIRON["EXPONENT"], ENVIRON["WAVE"], ENVIRON["GAS"] }'"'"' >"$2/summary.json"'
passes "${burdens[@]}"
fake post 'echo "{\"face_velocity_mean_m_s\": $SPEED, \"wave_work_J\": $WAVE, \"gas_work_J\": $GAS, \"explosive_energy_J\": 1}" >"$2/summary.json"'
fails 'WRONG' "${burdens[@]}"
fake post 'echo "{\"face_velocity_mean_m_s\": null, \"wave_work_J\": $WAVE, \"gas_work_J\": $GAS, \"explosive_energy_J\": 1}" >"$2/summary.json"'
fails 'face_velocity_mean_m_s must be a finite number, got null' "${burdens[@]}"
fake post 'echo "{}" >"$2/summary.json"'
fails "has no 'face_velocity_mean_m_s'" "${burdens[@]}"
