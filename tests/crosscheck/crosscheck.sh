#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# crosscheck.sh bar|collapse LIGGGHTS_MUCKPILE COMPARER RESULTS: the same scene in Muckpile and in LAMMPS, and their comparison.
# Scope: a report in RESULTS/cases, the runs in RESULTS/crosscheck; exit status 77 where LAMMPS is not installed.
set -euo pipefail
case_name=$1 program=$2 comparer=$3 results=$4
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
readonly runs=$results/crosscheck/$case_name reports=$results/cases
mkdir -p "$reports"
export OMP_NUM_THREADS=1 LC_ALL=C

if ! command -v lmp >/dev/null; then
  why="LAMMPS (lmp) is not installed; on Debian: apt-get install lammps"
  printf '%s\n' "crosscheck.$case_name: skipped: $why"
  printf '{"report": "crosscheck.%s", "seconds": 0, "rows": [], "curves": [], "skipped": "%s"}\n' \
    "$case_name" "$why" >"$reports/crosscheck.$case_name.json"
  exit 77
fi
rm -rf "$runs"

# run FOLDER COMMAND...: the words go on as they are; output into FOLDER/log, CPU seconds (user, system) into FOLDER/cpu_s
run() {
  local folder=$1 TIMEFORMAT='%U %S'
  shift
  mkdir -p "$folder"
  { time "$@" -log none -var out "$folder" >"$folder/log" 2>&1 </dev/null; } 2>"$folder/cpu_s" || {
    tail -n 15 "$folder/log"
    cat "$folder/cpu_s"
    printf '%s\n' "crosscheck: error: this failed: $*"
    exit 1
  }
}

# Bar

bar() {  # bar CELLS ACROSS STEPS: long enough for two periods of its bending
  local size=(-var cells "$1" -var steps "$3") folder=$runs/$2 began=$SECONDS
  run "$folder/muckpile" "$program" -in "$here/bar_muckpile.in" "${size[@]}" -var across "$2"
  "$comparer" start "$1" "$2" "$folder/start.data"
  run "$folder/lammps" lmp -in "$here/bar_lammps.in" "${size[@]}" -var start "$folder/start.data"
  "$comparer" compare "$1" "$2" "$folder"/{muckpile,lammps}/frames.txt "$reports" $((SECONDS - began))
}

# Collapse

readonly restitution=0.3

tsuji_input() { "$(dirname "$comparer")/crosscheck_tsuji_damping" "$1" "$restitution"; }  # tsuji_input pair|wall

lammps_clumps() {  # the dump start.txt on standard input as a data file
  awk 'NR == 6 || NR == 7 || NR == 8 { side[NR] = $1 " " $2 }
    NR > 9 { row[++n] = $1 " 1 " $3 " " $4 " " $5 " 0.1 2500 " $2 }
    END {
      print "clumps\n\n" n " atoms\n1 atom types"
      print side[6] " xlo xhi\n" side[7] " ylo yhi\n" side[8] " zlo zhi\n\nAtoms\n"
      for (i = 1; i <= n; i++) print row[i]
    }'
}

collapse() {  # collapse SEED
  local folder=$runs/$1
  run "$folder/muckpile" "$program" -in "$here/collapse_muckpile.in" -var seed "$1" -var restitution "$restitution"
  lammps_clumps <"$folder/muckpile/start.txt" >"$folder/muckpile/start.data"
  run "$folder/lammps" lmp -in "$here/collapse_lammps.in" -var start "$folder/muckpile/start.data" \
    -var pair_cor "$(tsuji_input pair)" -var wall_cor "$(tsuji_input wall)"
}

# Two seeds at a time, for two cores.
collapses() {
  local seed status=0
  for seed in "$@"; do
    while (($(jobs -rp | wc -l) >= 2)); do wait -n || status=1; done
    collapse "$seed" &
  done
  while (($(jobs -rp | wc -l) > 0)); do wait -n || status=1; done
  return "$status"
}

case $case_name in
  bar)
    status=0
    bar 30 1 10500 || status=1
    bar 30 6 2500 || status=1
    exit "$status"
    ;;
  collapse)
    collapses 49979687 86028121 15485863 67867967 32452867
    "$comparer" "$runs" "$reports" "$SECONDS"
    ;;
  *) printf '%s\n' "crosscheck: no case '$case_name'" && exit 2 ;;
esac
