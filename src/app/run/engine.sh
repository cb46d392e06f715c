# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash disable=SC2154
# liggghts-muckpile as a child of this script, on so many ranks.
# Scope: sourced by muckpile, whose $build_dir it uses. $signals counts those that ask to stop; outside of the engine's time, and that of
# muckpile-post, they do what $on_signal says.

available_cores() {
  local physical usable
  usable=$(nproc)
  physical=$(lscpu -p=Core,Socket 2>/dev/null | grep -v '^#' | sort -u | wc -l || true)
  if ((physical > 0 && physical < usable)); then echo "$physical"; else echo "$usable"; fi
}

# shellcheck disable=SC2064  # what $on_signal says now
let_signals_be() { trap "$on_signal" INT TERM HUP; }

# Status of a child that has ended: a signal, which a trap counts, interrupts the waiting only, and who waits again gets it.
wait_for() {  # wait_for PROCESS
  local status before
  while true; do
    status=0 before=$signals
    wait "$1" || status=$?
    ((signals > before)) || return "$status"
  done
}

# Ctrl-C asks the engine to write its state and stop, and waits for that; mpirun, which would kill it after two seconds, is
# told of the second Ctrl-C only.
run_engine() {  # run_engine RANKS OUT INPUT [-var NAME VALUE]...
  local ranks=$1 out=$2 input=$3
  shift 3
  # Two jobs at once would otherwise share the first core.
  local mpi=(mpirun -np "$ranks" --bind-to none)
  if [[ $(id -u) -eq 0 ]]; then mpi+=(--allow-run-as-root); fi
  if ((ranks > $(available_cores))); then mpi+=(--oversubscribe); fi
  local engine='' signal=USR2 status=0
  # shellcheck disable=SC2086  # no word while there is no engine
  trap 'signals=$((signals + 1)); kill -s "$signal" $engine 2>/dev/null || true; signal=TERM' INT TERM HUP
  # A job of Open MPI that ends may remove the folder that all jobs share, in which another is about to begin.
  local sessions
  sessions=$(mktemp -d -p "${OMPI_MCA_orte_tmpdir_base:-${TMPDIR:-/tmp}}") || die "cannot make a folder for mpirun's own files"
  # Containers forbid the single-copy mechanism; Open MPI would warn and fall back at every message.
  OMPI_MCA_btl_vader_single_copy_mechanism=none OMPI_MCA_orte_tmpdir_base=$sessions setsid "${mpi[@]}" "$build_dir/src/app/liggghts-muckpile" \
    -in "$input" -log "$out/log.liggghts" -var out "$out" "$@" &
  engine=$!
  ((signals == 0)) || kill -s USR2 "$engine" 2>/dev/null || true  # asked to stop before it was there
  wait_for "$engine" || status=$?
  let_signals_be
  rm -rf -- "$sessions"
  return "$status"
}
