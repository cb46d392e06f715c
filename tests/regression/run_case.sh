#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run_case.sh LIGGGHTS_MUCKPILE MUCKPILE_POST INPUT REPORTS EXPECTED.json [RANKS]: runs INPUT with the "vars" of EXPECTED.json
# on 2 ranks or RANKS, lets muckpile-post make the REPORTS, and compares summary.json, or the last row of history.csv, with its "expected" rows.
# Scope: EXPECTED.json is as in support/check_figures/expected.h.
set -euo pipefail
program=$1 post=$2 input=$3 expected=$(readlink -f "$5") ranks=${6:-2}
read -ra reports <<<"$4"
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"

words=$(check_figures vars "$expected")
read -ra vars <<<"$words"
run_input run "$ranks" "$input" "${vars[@]}"
for report in "${reports[@]}"; do "$post" "$report" "$out/run"; done

check_figures case "$expected" "$out/run/summary.json" "$out/run/dump/history.csv"
