# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash disable=SC2154
# What each run of a sweep came of, written beside its results, so that a sweep does again only what is missing or was made otherwise.
# Scope: sourced by muckpile together with sweep.sh, whose local variables it uses.

# In the folder of a run whose engine has ended well. Two equal records but for the lines of kept_apart give the same results.
readonly sweep_record=sweep_record.txt
readonly kept_apart='^(run_id|measured_by) '

print_of() { sha256sum -- "$@" | sha256sum | cut -c 1-16; }  # print_of FILE...

# Of what a program is built from, and how: the program itself has the commit in it, which changes with pages and tests, too.
print_of_sources() {  # print_of_sources FOLDER...
  find CMakeLists.txt CMakePresets.json cmake "$@" -type f \( -name '*.cpp' -o -name '*.h' -o -name '*.in' -o -name '*.csv' -o -name CMakeLists.txt \
    -o -name CMakePresets.json -o -name '*.cmake' \) -print0 | sort -z | xargs -0 sha256sum | sha256sum | cut -c 1-16
}

# Programs and inputs are the same for all runs of a sweep.
read_common_conditions() {
  local files
  mapfile -t files < <({ files_of "$input"; files_named_by "$input"; } | sort -u)
  common_conditions=$(
    printf 'engine %s\n' "$(print_of_sources src/core src/app fixes)"
    printf 'input %s %s\n' "$input" "$(print_of "${files[@]}")"
    printf 'ranks %s\n' "$ranks"
  )
  measured_by=$(print_of_sources src/core src/figures postproc/lib postproc/tools)
}

conditions() {  # of the run that was chosen last
  local i value
  printf '%s\n' "$common_conditions"
  for ((i = 0; i < ${#engine_args[@]}; i += 3)); do
    value=${engine_args[i + 2]}
    if [[ -f $value ]]; then value+=" $(print_of "$value")"; fi
    printf 'variable %s %s\n' "${engine_args[i + 1]}" "$value"
  done | sort
}

run_id_of() { "$build_dir/postproc/tools/muckpile-post" run-id "$@"; }  # run_id_of FILE...: of one run; an empty line if it has none

write_record() {  # write_record MEASURED_BY
  {
    conditions
    printf 'run_id %s\nmeasured_by %s\n' "$(run_id_of "$out/dump/scene.json")" "$1"
  } >"$out/$sweep_record.part"
  mv -f -- "$out/$sweep_record.part" "$out/$sweep_record"
}

# What the engine has left is there, of this run and of no other that has used the folder since.
has_run_well() {
  local run=$out/$folder id
  [[ -f $run/$sweep_record && -f $run/dump/scene.json ]] || return 1
  id=$(run_id_of "$run/dump/scene.json" 2>/dev/null) && grep -qxF "run_id $id" "$run/$sweep_record" || return 1
  [[ $(grep -vE "$kept_apart" "$run/$sweep_record") == "$(conditions)" ]]
}

# By this program, where the run has ended well.
is_measured() {
  local run=$out/$folder
  [[ -s $run/summary.json ]] && run_id_of "$run/dump/scene.json" "$run/summary.json" >/dev/null 2>&1 &&
    grep -qxF "measured_by $measured_by" "$run/$sweep_record"
}

# Sets the state of each run, and tells why those that have results begin anew.
note_what_has_ended() {
  local k count=0 changed
  read_common_conditions
  for k in "${!runs[@]}"; do
    choose "${runs[k]}"
    states[k]=waiting
    if has_run_well; then
      states[k]=measure
      if is_measured; then
        states[k]='done'
        count=$((count + 1))
      fi
    elif [[ -f $out/$folder/$sweep_record ]]; then
      changed=$(diff <(grep -vE "$kept_apart" "$out/$folder/$sweep_record") <(conditions) | sed -nE 's/^[<>] ([a-z]+( [A-Za-z0-9_]+)?).*/\1/p' || true)
      changed=$(sed -E '/^variable/!s/ .*//' <<<"$changed" | sort -u | paste -sd, | sed 's/,/, /g')
      tell "$k" "begins anew" ": ${changed:-results} changed since"
    fi
  done
  write_runs
  say "sweep of $input: ${#runs[@]} runs, $count done before; $jobs at once with -np $ranks on $cores cores; results go to $out"
}

# The list that muckpile-post sweep reads.
write_runs() {
  local k name value values
  {
    printf '# %s%s\n' "$input" "$(printf ' %s' "${fixed[@]}")"
    [[ -z $samples ]] || printf '# sampled%s\n' "$(printf ' %s' "${ranges[@]}")"
    printf 'folder,state%s\n' "$(printf ',%s' "${swept[@]}")"
    for k in "${!runs[@]}"; do
      choose "${runs[k]}"
      values=''
      while IFS=$'\t' read -r name value; do [[ -z $name ]] || values+=,$value; done <<<"${runs[k]}"
      # The folder of several variables has commas in its name, and this table knows no quotes.
      printf '%s,%s%s\n' "${folder//,/;}" "${states[k]}" "$values"
    done
  } >"$out/sweep_runs.csv.part"
  mv -f -- "$out/sweep_runs.csv.part" "$out/sweep_runs.csv"
}
