#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# benchmark.sh BUILD RESULTS [--quick | --peers-only]: all speed measurements, and without a third word the page docs/benchmarks.md from them.
# Scope: one program at a time, as the first ones need a quiet machine; the programs of BUILD must be there (./muckpile benchmark).
set -euo pipefail
build=$1 results=$2 mode=${3-}
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
readonly program=$build/src/app/liggghts-muckpile post=$build/postproc/tools/muckpile-post perf=$build/tests/perf tables=$build/tests/benchmarks
readonly measured=(contacts facets blocks gas polyhedra)

fail() {
  printf '%s\n' "benchmark: error: $*" >&2
  exit 1
}

widest_vectors() {
  local set
  for set in avx512f avx2; do
    if grep -qw "$set" /proc/cpuinfo; then echo "$set" && return; fi
  done
  echo "neither AVX2 nor AVX-512"
}

compare_codes() { "$here/peers/peers.sh" "$program" "$tables/peers_table" "$results" || fail "the comparison failed; the reason is above"; }

mkdir -p "$results"
if [[ $mode == --peers-only ]]; then
  compare_codes
  exit
fi
for what in "${measured[@]}"; do
  echo "muckpile: perf_$what"
  "$perf/perf_$what" 2>/dev/null >"$results/$what.json" || fail "perf_$what failed"
done
"$perf/perf_table" "$results" "${measured[@]}" | tee "$results/perf.csv"
ladder_mode=quick page=()
if [[ $mode != --quick ]]; then
  compare_codes
  ladder_mode=full page=("$here/page.md.in" "$here/../../docs/benchmarks.md")
fi
rm -rf "$results/cases"
"$here/ladder.sh" "$program" "$post" "$tables/ladder_report" "$results" "$ladder_mode" || fail "the ladder failed; the reason is above"
echo "Machine: $(sed -nE 's/^model name[[:space:]]*: //p;T;q' /proc/cpuinfo) ($(widest_vectors)), $(nproc) cores, $(date +%Y-%m-%d)." \
  >"$results/machine.md"
"$build/tests/verification/verify_make_page" "$results" "${page[@]}" || fail "the page could not be made; the reason is above"
if ((${#page[@]} > 0)); then
  cp "$results/perf.csv" "$here/../../docs/benchmarks/hot_loops.csv"
  cp "$results/ladder.csv" "$here/../../docs/benchmarks/ladder.csv"
fi
