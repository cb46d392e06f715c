# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash disable=SC2034,SC2154
# ./muckpile run: reads its words, runs an input in its folder of results, and lets muckpile-post measure what came of it.
# Scope: sourced by muckpile together with the files beside it. The parts of run() share its local variables; sweep.sh uses them, too.

# More ranks than this gain little on 10,000 blocks.
readonly most_default_ranks=4
# Ranks that share a core wait for each other at every step.
readonly most_ranks_per_core=16
readonly run_options='-np, -var, -out, -vtk'
readonly sweep_options="$run_options, -seeds, -samples, -jobs"

# $1, seen from the caller's folder, as seen from the root of the project, if it lies there.
from_root() {
  local path
  path=$(cd "$caller_dir" && realpath -m -- "$1")
  path=${path#"$root"/}
  if [[ $path == -* ]]; then path=./$path; fi
  printf '%s\n' "$path"
}

# A value that names a file is one of the caller's folder, if it has it; numbers and words are what they are.
value_from_root() {
  if [[ $1 == *[./]* && ! $1 =~ ^[-+.0-9eE]+$ ]] && (cd "$caller_dir" && compgen -G "$1" >/dev/null); then
    from_root "$1"
  else
    printf '%s\n' "$1"
  fi
}

run() {
  local command=run known_options=$run_options default_folder=results/
  local input='' ranks='' out='' go_on cores engine_args=() reports=()
  local signals=0 on_signal=-
  cores=$(available_cores)
  read_run_words "$@"
  cd "$root"
  check_run_words
  [[ $go_on != 1 || -n $(value_of from "${engine_args[@]}") ]] || die "-var go_on 1 needs -var from FILE with it, a restart file of the run"
  build liggghts-muckpile muckpile-post
  prepare_folder
  run_in_folder
  refuse_empty_files "$out"
  post_process "$out" "${reports[@]}"
}

read_run_words() {
  while [[ $# -gt 0 ]]; do
    case $1 in
      -np)
        [[ -z $ranks ]] || die "-np is given twice"
        [[ ${2-} =~ ^[1-9][0-9]*$ ]] || die "-np must be a whole number >= 1, got '${2-}'"
        ranks=$2
        shift 2
        ;;
      -var)
        [[ ${2-} != *=* ]] || die "-var takes name and value as two words, got '$2': -var ${2/=/ }"
        [[ $# -ge 3 ]] || die "-var needs a name and a value"
        [[ ", $sweep_options," != *", $3,"* ]] || die "-var needs a name and a value, got the option $3 behind '$2'"
        engine_args+=(-var "$2" "$(value_from_root "$3")")
        shift 3
        ;;
      -out)
        [[ -n ${2-} ]] || die "-out needs a folder"
        [[ -z $out ]] || die "-out is given twice"
        out=$(from_root "$2")
        shift 2
        ;;
      -vtk)
        reports=(--vtk)
        shift
        ;;
      -*) die "unknown option '$1' of $command (known: $known_options)" ;;
      *)
        [[ -n $1 ]] || die "$command needs an input, e.g. inputs/bench/in.bench; got an empty word"
        [[ -z $input ]] || die "$command takes one input, got '$input' and '$1'; values go behind -var NAME"
        input=$(from_root "$1")
        shift
        ;;
    esac
  done
  [[ -n $input ]] || die "$command needs an input, e.g. inputs/bench/in.bench"
}

# Sets what was not given, too.
check_run_words() {
  [[ -f $input && -r $input ]] || die "cannot read the input '$input'"
  check_variables
  go_on=$(value_of go_on "${engine_args[@]}")
  [[ $go_on == 1 || -z $(value_of from "${engine_args[@]}") ]] || die "-var from FILE needs -var go_on 1 with it"
  : "${out:=$default_folder$(basename "$(dirname "$(realpath "$input")")")}"
  [[ $out != *[[:space:]]* ]] || die "LIGGGHTS splits names at blanks; choose another folder than '$out'"
  refuse_odd_letters -out "$out"
  refuse_odd_letters "-var explosive_table" "$(value_of explosive_table "${engine_args[@]}")"
  refuse_own_results
  ((${#ranks} < 6 && ranks <= most_ranks_per_core * cores)) ||
    die "-np must be at most $((most_ranks_per_core * cores)) on $cores cores, got '$ranks'"
  if [[ -z $ranks ]]; then ranks=$((cores < most_default_ranks ? cores : most_default_ranks)); fi
}

# Results would lie elsewhere than is told, or lack the file that an input copies into them.
refuse_odd_letters() {  # refuse_odd_letters OPTION PATH
  [[ $2 != *[%*\$\;\&\|\(\)\<\>\'\"\`\\]* ]] ||
    die "LIGGGHTS or the shell in which it copies files takes % * \$ ; & | ( ) < > \\ and quotes for something else; choose another $1 than '$2'"
}

# What is in the folder of results makes room for the new ones.
refuse_own_results() {
  local muck
  muck=$(value_of muck "${engine_args[@]}")
  [[ -z $muck || $muck == none || $(realpath -m -- "$muck")/ != "$(realpath -m -- "$out")"/* ]] ||
    die "-var muck must be outside of '$out', where the results of this run go and replace what is there, got '$muck'"
}

# The run goes on from a restart file, and so do its files.
continues() {
  local pour_from
  pour_from=$(value_of pour_from "${engine_args[@]}")
  [[ $go_on != 1 ]] || return 0
  [[ -n $pour_from && $pour_from != none ]] || return 1
  [[ ! -f $out/dump/scene.json ]] || die "-var pour_from goes on with a pour, but the blast in '$out' has begun: go on with that one (-var go_on 1), or pour into another folder"
}

check_variables() {
  local i name
  local -A given=()
  for ((i = 0; i < ${#engine_args[@]}; i += 3)); do
    name=${engine_args[i + 1]}
    [[ -n $name ]] || die "-var needs a name and a value"
    [[ -z ${given[$name]-} ]] || die "-var $name is given twice"
    given[$name]=1
    check_variable "$input" "$name" "${engine_args[i + 2]}"
  done
}

# Old results wait aside, unless the run goes on from a restart file: that one continues what is there.
prepare_folder() {
  mkdir -p "$out/dump" || die "cannot make the folder '$out/dump'"
  [[ -w $out && -w $out/dump ]] || die "cannot write to '$out'"
  lock "$out"
  recover_previous "$out"
  # shellcheck disable=SC2064  # Ctrl-C while they are moved
  trap "put_back $(printf '%q' "$out")" EXIT
  if ! continues; then set_aside "$out" "$input" "${engine_args[@]}"; fi
  [[ ! -f $out/log.liggghts ]] || mv -f -- "$out/log.liggghts" "$out/.previous.log"  # which one that goes on would write over
}

# Returns only where there are results to be measured.
run_in_folder() {
  local status=0 steps_before written_before
  say "running $input on $ranks of $cores cores (-np to change), results go to $out"
  steps_before=$(steps_in "$out") written_before=$(written_in "$out")
  trap - EXIT  # the engine outlives a killed script, and writes on; the next run puts back what is old, or drops it
  run_engine "$ranks" "$out" "$input" "${engine_args[@]}" || status=$?
  # The engine ends well when it is interrupted.
  if keep_interrupted_state "$out" "$input" "${engine_args[@]}"; then
    drop_previous "$out"
    exit 130
  fi
  if was_cut_short || { ((signals > 0)) && ! is_whole; }; then status=130; fi
  if ! has_left_something; then end_without_a_step; fi
  drop_previous "$out"
  ((status != 130)) || { say "interrupted; there is no state to go on from" && exit 130; }
  ((status == 0)) || die "the run stopped with an error; see the message above or $out/log.liggghts"
}

# A signal has reached the engine, from this script or from elsewhere, before it had done all of its input.
was_cut_short() { ((status == 0)) && grep -qs '^interrupted: ' "$out/log.liggghts"; }

# The engine was asked to stop when it had nothing left to do. An error, a killed rank or a full disk leave no such line.
is_whole() { ((status == 0)) && ! was_cut_short && grep -qs '^whole: ' "$out/log.liggghts" && has_taken_steps; }

has_left_something() {
  if ((status == 0)); then
    [[ $(written_in "$out") != "$written_before" ]]
  else
    has_taken_steps
  fi
}

has_taken_steps() {
  if continues; then
    [[ $(steps_in "$out") != "$steps_before" ]]
  else
    started "$out"
  fi
}

# The run was refused, interrupted in its set-up, or has written nothing.
end_without_a_step() {
  local back=''
  [[ ! -d $out/.previous ]] || back="; what '$out' held is back in its place"
  put_back "$out"
  if ((status == 130)); then
    say "interrupted before the first step; nothing was changed"
    exit 130
  fi
  ((status == 0)) || die "the run stopped before its first step; see the message above$back"
  # shellcheck disable=SC2016  # as it stands in inputs
  ! files_of "$input" | xargs -d '\n' grep -qF '${out}/dump' || die "the run left nothing in '$out/dump'; is the disk full?$back"
  say "$input has written nothing to its \${out}: nothing to extract"
  exit 0
}

# A signal, now or behind the engine's last step, leaves what the engine has done, to be measured another time.
post_process() {  # post_process OUT [OPTION OF muckpile-post all]...
  local measuring='' status=130
  if [[ ! -f $1/dump/scene.json ]]; then
    say "no $1/dump/scene.json: nothing to extract"
    return
  fi
  trap 'signals=$((signals + 1)); kill -s TERM $measuring 2>/dev/null || true' INT TERM HUP
  if ((signals == 0)); then
    "$build_dir/postproc/tools/muckpile-post" all "$@" &
    measuring=$! status=0
    wait_for "$measuring" || status=$?
  fi
  let_signals_be
  if ((signals > 0 && status != 0)); then
    say "interrupted; the run in $1 is whole, and not measured: ${build_dir#"$root"/}/postproc/tools/muckpile-post all $* does that"
    exit 130
  fi
  ((status == 0)) || die "muckpile-post failed; the reason is above"
}
