#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# on_off.sh LIGGGHTS_MUCKPILE "-var NAME VALUE" BOUND INPUT [-var NAME VALUE]...: runs INPUT with a shortcut and, by the words in quotes,
# without it, and compares how the two end: the work of the gas and the mean speed of throw may differ by BOUND (a share).
# Scope: the shortcut must save a tenth of the steps at least, or it did not act.
set -euo pipefail
program=$1 bound=$3 input=$4
read -ra off <<<"$2"
shift 4
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_mpi_yield_when_idle=1 \
  OMPI_MCA_btl_vader_single_copy_mechanism=none

run() {  # run NAME [-var NAME VALUE]...
  local to=$out/$1
  shift
  mkdir -p "$to/dump"
  mpirun -np 2 --oversubscribe --bind-to none "$program" -in "$input" -log none -var out "$to" "$@" >"$to/screen" 2>&1 ||
    { tail -n 20 "$to/screen"; exit 1; }
}

of_run() { sed -nE "s/^ *\"$2\": ([-0-9.eE+]+),?$/\1/p" "$out/$1/dump/run.json"; }
mean_throw_speed() {  # of all blocks in the last snapshot, along x
  local snapshots=("$out/$1"/dump/blocks_*.csv)
  awk -F, 'NR == 2 { for (i = 1; i <= NF; i++) if ($i == "vx_m_s") c = i } NR > 2 { sum += $c } END { print sum / (NR - 2) }' "${snapshots[-1]}"
}

run with "$@"
run without "$@" "${off[@]}"
compare() {  # compare NAME WITH WITHOUT
  awk -v name="$1" -v with="$2" -v without="$3" -v bound="$bound" 'BEGIN {
    share = with / without - 1
    printf "%s: with %s, without %s, difference %.4f, allowed %s\n", name, with, without, share, bound
    exit !(share <= bound && -share <= bound) }'
}
compare "work of the gas [J]" "$(of_run with gas_work_J)" "$(of_run without gas_work_J)"
compare "mean speed of throw [m/s]" "$(mean_throw_speed with)" "$(mean_throw_speed without)"
steps_with=$(of_run with steps) steps_without=$(of_run without steps)
echo "steps: with $steps_with, without $steps_without"
((10 * steps_with <= 9 * steps_without)) || { echo "less than a tenth of the steps was saved"; exit 1; }
