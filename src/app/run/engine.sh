# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash disable=SC2154
# liggghts-muckpile as a child of this script, on so many ranks.
# Scope: sourced by muckpile, whose $build_dir it uses.

available_cores() {
  local physical usable
  usable=$(nproc)
  physical=$(lscpu -p=Core,Socket 2>/dev/null | grep -v '^#' | sort -u | wc -l || true)
  if ((physical > 0 && physical < usable)); then echo "$physical"; else echo "$usable"; fi
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
  trap 'kill -s "$signal" $engine 2>/dev/null || true; signal=TERM' INT TERM HUP
  # Containers forbid the single-copy mechanism; Open MPI would warn and fall back at every message.
  OMPI_MCA_btl_vader_single_copy_mechanism=none setsid "${mpi[@]}" "$build_dir/src/app/liggghts-muckpile" \
    -in "$input" -log "$out/log.liggghts" -var out "$out" "$@" &
  engine=$!
  [[ $signal == USR2 ]] || kill -s USR2 "$engine" 2>/dev/null || true  # asked to stop before it was there
  wait "$engine" || status=$?
  while kill -0 "$engine" 2>/dev/null; do  # only the waiting was interrupted
    status=0
    wait "$engine" || status=$?
  done
  trap - INT TERM HUP
  [[ $signal == USR2 ]] || return 130
  return "$status"
}
