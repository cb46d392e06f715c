# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash disable=SC2154
# The runs of a sweep whose values are taken from ranges.
# Scope: sourced by muckpile together with sweep.sh, whose local variables it uses.

check_samples() {
  if ((${#ranges[@]} == 0)); then
    [[ -z $samples ]] || die "-samples needs a range to take values from: -var NAME FROM..TO"
    return
  fi
  [[ -n $samples ]] || die "-var ${ranges[0]/=/ } is a range; -samples N says how many runs take their values from it"
  [[ -z $seeds ]] || die "-seeds is for lists of values; of samples each run has a seed of its own"
  ((${#ranges[@]} == ${#swept[@]})) || die "ranges go with single values, not with lists of values"
  [[ -z ${values_of[seed]-} ]] || die "-var seed cannot be a range; of samples each run has a seed of its own, unless -var seed gives one for all"
}

# Of samples, until the words are checked: the run at the lower ends of all ranges and that at the upper ends.
list_ends() {
  local name
  runs=('' '')
  for name in "${swept[@]}"; do
    runs[0]+="$name"$'\t'"$(head -n 1 <<<"${values_of[$name]}")"$'\n'
    runs[1]+="$name"$'\t'"$(tail -n 1 <<<"${values_of[$name]}")"$'\n'
  done
}

# A run for each sample; they differ in their seeds, too, where the input has a seed and none is given.
sample_runs() {
  local values run k shares
  build muckpile-post
  shares=$("$build_dir/postproc/tools/muckpile-post" sample --runs "$samples" "${ranges[@]}") || die "the ranges cannot be sampled; the reason is above"
  [[ -n $(value_of seed "${fixed[@]}") ]] || ! variables_of "$input" | grep -cx 'seed index' >/dev/null || swept+=(seed)
  runs=()
  while IFS=$'\t' read -r -a values; do
    [[ ${#values[@]} -eq ${#swept[@]} ]] || values+=("$((${#runs[@]} + 1))")
    run=''
    for k in "${!swept[@]}"; do run+="${swept[k]}"$'\t'"${values[k]}"$'\n'; done
    runs+=("$run")
  done <<<"$shares"
}
