# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash disable=SC2034,SC2154
# ./muckpile sweep: an input with every combination of some values, several runs at once, and the table and plots of them all.
# Scope: sourced by muckpile together with the files beside it; sweep_record.sh knows which runs have ended well before. Each run is that of
# run_input.sh, in a process and a folder of its own. The parts of sweep() share its local variables.

readonly most_runs=10000
readonly longest_folder_name=255  # of a file system

sweep() {
  local command=sweep known_options=$sweep_options default_folder=results/sweep_
  local input='' ranks='' out='' jobs='' seeds='' samples='' go_on cores engine_args=() reports=() folder
  local ranges=()  # "NAME=FROM..TO" of what is sampled
  # Of run k: "NAME<tab>VALUE<line end>"... of what is swept, and waiting, measure, done, failed or interrupted.
  local swept=() fixed=() runs=() states=() common_conditions measured_by
  local -A values_of=()
  cores=$(available_cores)
  read_sweep_words "$@"
  cd "$root"
  check_sweep_words
  build liggghts-muckpile muckpile-post
  mkdir -p "$out" || die "cannot make the folder '$out'"
  lock "$out"
  note_what_has_ended
  run_all
  end_sweep
}

# Reading

read_sweep_words() {
  local words=()
  while [[ $# -gt 0 ]]; do
    case $1 in
      -seeds)
        [[ -z $seeds ]] || die "-seeds is given twice"
        [[ ${2-} =~ ^[1-9][0-9]{0,3}$ ]] || die "-seeds must be a whole number from 1 to 9999, got '${2-}'"
        seeds=$2
        shift 2
        ;;
      -samples)
        [[ -z $samples ]] || die "-samples is given twice"
        [[ ${2-} =~ ^[1-9][0-9]{0,3}$ && $2 -gt 1 ]] || die "-samples must be a whole number from 2 to 9999, got '${2-}'"
        samples=$2
        shift 2
        ;;
      -jobs)
        [[ -z $jobs ]] || die "-jobs is given twice"
        [[ ${2-} =~ ^[1-9][0-9]{0,3}$ ]] || die "-jobs must be a whole number from 1 to 9999, got '${2-}'"
        jobs=$2
        shift 2
        ;;
      -var)  # a value is no option
        words+=("${@:1:3}")
        shift $(($# < 3 ? $# : 3))
        ;;
      *)
        words+=("$1")
        shift
        ;;
    esac
  done
  read_run_words "${words[@]}"
  sort_out_variables
}

# Which variables are swept or sampled, and which have one value.
sort_out_variables() {
  local i name value number='[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?'
  for ((i = 0; i < ${#engine_args[@]}; i += 3)); do
    name=${engine_args[i + 1]} value=${engine_args[i + 2]}
    [[ $name =~ ^[A-Za-z0-9_]+$ ]] || die "-var needs a name and a value, got the name '$name'"
    if [[ $value =~ ^(log:)?$number\.\.$number$ ]]; then
      ranges+=("$name=$value")
      value=${value#log:}
      sweep_over "$name" "${value%%..*}"$'\n'"${value#*..}"
    elif [[ $value == *,* ]]; then
      [[ ,$value, != *,,* ]] || die "-var $name has an empty value in '$value'"
      [[ ! ,$value, =~ ,((log:)?$number\.\.$number), ]] || die "-var $name has the range '${BASH_REMATCH[1]}' among values; a range goes alone"
      sweep_over "$name" "$(each_from_root "${value//,/$'\n'}")"
    else
      fixed+=(-var "$name" "$value")
    fi
  done
  [[ -z $seeds ]] || sweep_over seed "$(seq "$seeds")"
  check_samples
}

each_from_root() {  # each_from_root VALUES
  local value
  while IFS= read -r value; do value_from_root "$value"; done <<<"$1"
}

sweep_over() {  # sweep_over NAME VALUES: one on each line
  local twice
  [[ -z ${values_of[$1]-} ]] || die "-var $1 is given twice"
  [[ $2 != *[,\"\#]* ]] || die "-var $1 must not have , # or a double quote in a value"
  twice=$(while IFS= read -r value; do
    if [[ $value =~ ^[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?$ ]]; then LC_ALL=C printf '%.12g\n' "$value"; else printf '%s\n' "$value"; fi
  done <<<"$2" | sort | uniq -d | head -n 1)
  [[ -z $twice ]] || die "-var $1 has the value $twice twice"
  swept+=("$1")
  values_of[$1]=$2
}

# Sets what was not given, too.
check_sweep_words() {
  local name value most=$((most_ranks_per_core * cores))
  if [[ -n $samples ]]; then list_ends; else list_runs; fi
  ((${#runs[@]} > 1)) ||
    die "sweep needs two runs at least: -var NAME V1,V2,... with a comma between the values, or -seeds N; ./muckpile run does one"
  : "${ranks:=1}"
  choose "${runs[0]}"
  check_run_words
  [[ -z $go_on ]] || die "a sweep begins each run anew; -var go_on and -var from are for ./muckpile run"
  for name in "${swept[@]}"; do
    while IFS= read -r value; do check_variable "$input" "$name" "$value"; done <<<"${values_of[$name]}"
  done
  [[ -z $samples ]] || sample_runs
  refuse_one_folder_for_two
  : "${jobs:=$((cores > ranks ? cores / ranks : 1))}"
  ((jobs * ranks <= most)) || die "-jobs times -np must be at most $most on $cores cores, got '$jobs' times '$ranks'"
}

# Every combination, the last variable fastest.
list_runs() {
  local name value run longer count=1
  for name in "${swept[@]}"; do count=$((count * $(wc -l <<<"${values_of[$name]}"))); done
  ((count <= most_runs)) || die "a sweep does at most $most_runs runs, got $count"
  runs=('')
  for name in "${swept[@]}"; do
    longer=()
    for run in "${runs[@]}"; do
      while IFS= read -r value; do longer+=("$run$name"$'\t'"$value"$'\n'); done <<<"${values_of[$name]}"
    done
    runs=("${longer[@]}")
  done
}

# Sets engine_args and, within the sweep's, the folder of a run.
choose() {  # choose RUN
  local name value
  engine_args=("${fixed[@]}") folder=''
  while IFS=$'\t' read -r name value; do
    [[ -n $name ]] || continue
    engine_args+=(-var "$name" "$value")
    folder+=,$name-$value
  done <<<"$1"
  folder=${folder#,}
  folder=${folder//[^A-Za-z0-9._+,-]/_}
}

refuse_one_folder_for_two() {
  local run twice
  twice=$(for run in "${runs[@]}"; do
    choose "$run"
    printf '%s\n' "$folder"
  done | sort | uniq -d | head -n 1)
  for run in "${runs[@]}"; do
    choose "$run"
    ((${#folder} <= longest_folder_name)) || die "the folder of a run would be '$folder', longer than $longest_folder_name letters; use shorter values"
  done
  [[ -z $twice ]] || die "two runs would have the same folder '$twice', as names of folders have letters, digits and . _ + , - only"
}

# Running

run_all() {
  local k stopping=''
  local -A running=()  # number of the run by its process
  trap stop_all INT TERM HUP
  for k in "${!runs[@]}"; do
    [[ ${states[k]} != 'done' ]] || continue
    while ((${#running[@]} >= jobs)); do wait_for_one; done
    [[ -z $stopping ]] || break
    begin_run "$k"
  done
  while ((${#running[@]} > 0)); do wait_for_one; done
  trap - INT TERM HUP
}

# As Ctrl-C does to one run: the first asks the engine to stop, the second ends it.
stop_all() {
  local processes=("${!running[@]}")
  stopping=1
  ((${#processes[@]} == 0)) || kill -s TERM -- "${processes[@]}" 2>/dev/null || true
}

begin_run() {  # begin_run K
  choose "${runs[$1]}"
  if ! mkdir -p "$out/$folder"; then
    states[$1]=failed
    tell "$1" failed ": cannot make the folder '$out/$folder'"
    write_runs
    return
  fi
  tell "$1" "$([[ ${states[$1]} == measure ]] && echo measured again || echo begun)"
  # Job control makes it a process group of its own: Ctrl-C reaches it through stop_all only, once.
  set -m
  (run_one "${states[$1]}") </dev/null >"$out/$folder/run.log" 2>&1 &
  set +m
  running[$!]=$1
  [[ -z $stopping ]] || kill -s TERM -- "$!" 2>/dev/null || true  # asked to stop before it was there
}

# A signal reaches this process alone, which lets what it has begun come to an end: the engine by its state, files whole.
run_one() {  # run_one STATE: in a process of its own
  local signals=0 on_signal='signals=$((signals + 1))'
  let_signals_be
  SECONDS=0
  out+=/$folder
  if [[ $1 == measure ]]; then
    lock "$out"
    [[ -s $out/summary.json ]] || rm -f -- "$out/summary.json"  # muckpile-post adds to one that is there
    write_record nothing
  else
    rm -f -- "$out/$sweep_record"
    prepare_folder
    ((signals == 0)) || exit 130
    run_in_folder
    refuse_empty_files "$out"
    [[ ! -f $out/dump/scene.json ]] || write_record nothing
  fi
  post_process "$out" "${reports[@]}"
  [[ -s $out/summary.json ]] || die "the run has left no $out/summary.json"
  write_record "$measured_by"
  say "took $SECONDS s"
}

wait_for_one() {
  local process='' status=0 k
  wait -n -p process "${!running[@]}" || status=$?
  if [[ -z ${process-} ]]; then  # a signal has ended the waiting, or the shell has taken notice of the end before
    for k in "${!running[@]}"; do
      kill -0 "$k" 2>/dev/null || { process=$k && break; }
    done
    [[ -n ${process-} ]] || return 0
    status=0
    wait "$process" || status=$?
  fi
  k=${running[$process]}
  unset "running[$process]"
  choose "${runs[k]}"
  if ((status == 0)) && has_run_well && is_measured; then
    states[k]='done'
    tell "$k" 'done' " ($(sed -nE 's/^muckpile: took (.*)$/\1/p' "$out/$folder/run.log" | tail -n 1))"
  elif ((status == 130)) || [[ -n $stopping ]]; then
    states[k]=interrupted
    if has_run_well; then states[k]=measure; fi
    tell "$k" interrupted "$([[ ${states[k]} != measure ]] || echo ': the run is whole, and not measured')"
  else
    states[k]=failed
    tell "$k" failed ": $(reason_in "$out/$folder/run.log")"
  fi
  write_runs
}

# The engine's message, or that of muckpile-post, whose last line it is where it has failed, stands before those of who called it.
reason_in() {  # reason_in LOG
  local reason
  reason=$(grep -m 1 '^ERROR' "$1" || grep '^muckpile-post: ' "$1" | tail -n 1 | grep . || grep -m 1 '^muckpile: error: ' "$1" || tail -n 1 "$1")
  printf '%s' "${reason:-no message}"
}

tell() {  # tell K WORD [MORE]: of the run that was chosen last
  say "[$(($1 + 1))/${#runs[@]}] $2 $folder${3-}"
}

# Ending

end_sweep() {
  local k failed=() done_count=0 interrupted=''
  for k in "${!runs[@]}"; do
    case ${states[k]} in
      done) done_count=$((done_count + 1)) ;;
      failed) failed+=("$k") ;;
      *) interrupted=1 ;;
    esac
  done
  ((done_count == 0)) || "$build_dir/postproc/tools/muckpile-post" sweep "$out" || die "muckpile-post failed; the reason is above"
  say "$done_count of ${#runs[@]} runs done, ${#failed[@]} failed"
  for k in "${failed[@]}"; do
    choose "${runs[k]}"
    say "failed: $folder, log $out/$folder/run.log"
  done
  [[ -z $interrupted ]] || { say "interrupted; the same command does what is missing" && exit 130; }
  [[ ${#failed[@]} -eq 0 ]] || exit 1
}
