# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash disable=SC2034
# What the run.sh of validations share: source validation_case.sh NAME "$@" of a run.sh sets $case_dir, $results, $program, $post,
# goes to the project's root and defines check_figures and run_input.
# Scope: to be sourced. RESULTS is results/NAME unless given; the programs are those of build/release unless others are named.
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit
case_dir=inputs/validation/$1
results=${2:-results/$1}
program=${3:-build/release/src/app/liggghts-muckpile} post=${4:-build/release/postproc/tools/muckpile-post}
source tests/support/check_figures.sh
mkdir -p "$results"

# run_input INPUT OUT [VAR VALUE]...: one run on one rank into a folder of its own, made anew.
run_input() {
  local input=$1 out=$2 words=()
  shift 2
  while (($#)); do
    words+=(-var "$1" "$2")
    shift 2
  done
  rm -rf "$out" && mkdir -p "$out/dump"
  OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_btl_vader_single_copy_mechanism=none \
    mpirun -np 1 --bind-to none "$program" -in "$input" -log none -var out "$out" "${words[@]}" >"$out/screen"
}
