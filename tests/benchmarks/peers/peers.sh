#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# peers.sh LIGGGHTS_MUCKPILE PEERS_TABLE OUT [full]: equivalent scenes in Muckpile, stock LIGGGHTS, LAMMPS and YADE; writes OUT/peers.csv and peers.md.
# Scope: CPU seconds of one core for a stretch of steps, without set-up; three rounds, the codes in turn, the least counts. LAMMPS and YADE
# are left out, with a word, where they are not installed. `full` lets the 8,000 clumps come to rest too (about an hour).
set -euo pipefail
program=$(readlink -f "$1") table=$(readlink -f "$2") out=$3 full=${4-}
figures=$(dirname "$table")/log_figures
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
readonly rounds=3
readonly start=$out/peers/start.txt raw=$out/peers/raw.csv
mkdir -p "$out/peers"
echo "scene,code,law,particles,links,steps,seconds" >"$raw"
export OMP_NUM_THREADS=1

say() { printf '%s\n' "peers: $*"; }

have() {  # have COMMAND PACKAGE
  command -v "$1" >/dev/null && return
  say "skipped $2: not installed (apt-get install $2)"
  return 1
}

run() {  # run LOG COMMAND...
  local log=$1
  shift
  "$@" >"$log" 2>&1 </dev/null || {
    tail -n 15 "$log"
    say "error: this failed: $*"
    exit 1
  }
}

record() {  # record SCENE CODE LAW PARTICLES LINKS STEPS SECONDS
  local IFS=,
  printf '%s\n' "$*" >>"$raw"
}

# Scene: bonded rock

rock() {
  local log=$out/peers/rock.log steps
  steps=300
  run "$log" "$program" -in "$here/rock_muckpile.in" -log none -var count $steps
  record rock Muckpile "joint of 3 points: Mohr-Coulomb + cut-off + moments + dilatation; blocks of 5 spheres" \
    8000 "$("$figures" below 'joint[2]' 3 "$log")" $steps "$("$figures" seconds rock "$log")"
  steps=500
  run "$log" "$program" -in "$here/rock_liggghts.in" -log none -var count $steps
  record rock LIGGGHTS "no bonds in stock: Hertz contact with friction instead" \
    8788 $(($("$figures" below touches 3 "$log") / 2)) $steps "$("$figures" seconds rock "$log")"
  if have lmp lammps; then
    steps=1000
    run "$log" lmp -in "$here/rock_lammps.in" -log none -var count $steps
    record rock LAMMPS "bond_style harmonic: central force only; no strength" \
      8788 "$("$figures" below Bonds 3 "$log")" $steps "$("$figures" seconds rock "$log")"
  fi
  if have yade yade; then
    steps=300
    CELLS=13 COUNT=$steps run "$log" yade -n -x -j1 "$here/rock_yade.py"
    record rock YADE "JCFpm: normal and shear spring; Mohr-Coulomb + cut-off" \
      8788 "$("$figures" beside atoms 4 "$log")" $steps "$("$figures" seconds rock "$log")"
  fi
}

# Scene: loose clumps

record_clumps() {  # record_clumps CODE LAW LOG TOUCHES COUNT [pile]
  local code=$1 law=$2 log=$3 touches=$4 count=$5 pile=${6-}
  record "fall of $bodies" "$code" "$law" "$bodies" 0 "$count" "$("$figures" seconds fall "$log")"
  [[ -z $pile ]] || record "pile of $bodies" "$code" "$law" "$bodies" $((touches / 2)) "$count" "$("$figures" seconds pile "$log")"
}

clumps() {  # clumps BODIES SIDE SETTLE COUNT [pile]
  local bodies=$1 side=$2 settle=$3 count=$4 pile=${5-} log=$out/peers/clumps.log own
  local vars=(-log none -var side "$side" -var settle "$settle" -var count "$count" -var start)
  for own in 1 0; do
    run "$log" "$program" -in "$here/clumps_liggghts.in" "${vars[@]}" "$start" -var own $own -var bodies "$bodies"
    bodies=$(($(sed -n 4p "$start") / 8))
    if ((own)); then
      record_clumps Muckpile "fix multisphere/muckpile; pair muckpile/block (Hertz-Mindlin)" "$log" \
        "$("$figures" below touches 3 "$log")" "$count" "$pile"
    else
      record_clumps LIGGGHTS "fix multisphere; pair gran hertz tangential history" "$log" \
        "$("$figures" below touches 3 "$log")" "$count" "$pile"
    fi
  done
  if have lmp lammps; then
    "$figures" lammps_data "$side" "$start" >"$out/peers/start.data"
    run "$log" lmp -in "$here/clumps_lammps.in" "${vars[@]}" "$out/peers/start.data"
    record_clumps LAMMPS "fix rigid/small; gran/hertz/history" "$log" "$("$figures" below touches 3 "$log")" "$count" "$pile"
  fi
  if have yade yade; then
    START=$start SETTLE=$settle COUNT=$count SIDE=$side run "$log" yade -n -x -j1 "$here/clumps_yade.py"
    record_clumps YADE "clumps; Hertz-Mindlin" "$log" "$("$figures" beside touches 2 "$log")" "$count" "$pile"
  fi
}

for ((round = 1; round <= rounds; round++)); do
  say "round $round of $rounds"
  rock
  clumps 1000 2.5 6000 1000 pile
  if [[ $full == full ]]; then clumps 8000 7.1 6000 500 pile; else clumps 8000 7.1 201 200; fi
done
"$table" "$raw" "$out"
cat "$out/peers.md"
