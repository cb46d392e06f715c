# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash
# Variables of an input, and whether -var NAME VALUE fits one of them.
# Scope: sourced by muckpile, whose die() it uses; names of files are as the engine sees them, from the project's root.

# An input and the files that it includes, from the project's root; of a name with a variable in it, all that fit.
files_of() {
  local pattern included
  printf '%s\n' "$1"
  while read -r pattern; do
    # What is a variable and nothing else is a file of the user's, of any name.
    [[ ! $pattern =~ ^\$\{[^}]*\}$ ]] || continue
    while read -r included; do
      if [[ -f $included ]]; then files_of "$included"; fi
    done < <(compgen -G "$(sed -E 's/\$\{[^}]*\}/*/g' <<<"$pattern")")
  done < <(included_by "$1")
}

included_by() { sed -nE 's/^[[:space:]]*include[[:space:]]+([^[:space:]]+).*/\1/p' "$@"; }  # included_by FILE...: names as written

# What a value, or a word of the input's files, names.
files_named_by() {  # files_named_by INPUT [-var NAME VALUE]...
  local word
  {
    files_of "$1" | xargs -d '\n' sed 's/#.*//' | tr -s "[:space:]\"'" '\n'
    printf '%s\n' "${@:2}"
  } | sort -u | while read -r word; do
    if [[ -f $word ]]; then printf '%s\n' "$word"; fi
  done
}

# "NAME STYLE" of every variable that an input and the files that it includes define.
variables_of() {
  files_of "$1" | xargs -d '\n' sed -nE 's/^[[:space:]]*variable[[:space:]]+([A-Za-z0-9_]+)[[:space:]]+([a-z]+).*/\1 \2/p'
}

# Lists the files and variables of an input once, whatever the number of -var: sets input_files and input_variables ("NAME STYLE", sorted).
listed_input=''
list_input() {
  [[ $listed_input != "$1" ]] || return 0
  mapfile -t input_files < <(files_of "$1")
  input_variables=$(variables_of "$1" | sort -u)
  listed_input=$1
}

# A variable in the name of an included file has the values for which there is such a file.
check_word() {  # check_word INPUT NAME VALUE
  local pattern before after words
  list_input "$1"
  while read -r pattern; do
    before=${pattern%%"\${$2}"*} after=${pattern#*"\${$2}"}
    # A variable that begins the name stands for a folder, of which there may be any.
    [[ $pattern == "$before\${$2}$after" && $before == */* && $before$after != *'$'* ]] || continue
    words=$(compgen -G "$before*$after" | sort) || continue
    words=${words//"$before"/}
    words=${words//"$after"/}
    grep -qxF -- "$3" <<<"$words" || die "-var $2 must be one of $(paste -sd' ' <<<"$words"), got '$3'"
  done < <(included_by "${input_files[@]}")
}

# The name on standard input nearest to $1 in edits (at most a third of its length), or nothing.
closest_name() {
  awk -v word="$1" '
    function least(a, b) { return a < b ? a : b }
    function edits(a, b,   i, j, d) {
      for (i = 0; i <= length(a); i++) d[i, 0] = i
      for (j = 0; j <= length(b); j++) d[0, j] = j
      for (i = 1; i <= length(a); i++)
        for (j = 1; j <= length(b); j++)
          d[i, j] = least(least(d[i-1, j], d[i, j-1]) + 1,
                          d[i-1, j-1] + (substr(a, i, 1) != substr(b, j, 1)))
      return d[length(a), length(b)]
    }
    { n = edits(word, $1); if (n <= length($1) / 3 && (best == "" || n < fewest)) { best = $1; fewest = n } }
    END { print best }'
}

check_variable() {  # check_variable INPUT NAME VALUE
  local input=$1 name=$2 value=$3 known style near
  # The knobs *_words hold words of a style, any number of them.
  [[ -n $value && ($value != *[[:space:]]* || $name == *_words) ]] ||
    die "-var $name needs one value without blanks, got '$value'"
  [[ $name != out ]] || die "use -out DIR for the results folder, not -var out"
  list_input "$input"
  known=$input_variables
  # What one file sets as a default, another may compute.
  style=$(awk -v name="$name" '$1 == name && $2 != "delete" && style ~ /^(|index)$/ { style = $2 } END { print style }' <<<"$known")
  if [[ $style == index ]]; then
    check_word "$input" "$name" "$value"
    return
  fi
  [[ -z $style ]] ||
    die "$input computes '$name' itself (variable $name $style); -var sets 'index' variables only"
  known=$(awk '$1 == "out" || $2 == "delete" { next } $2 == "index" { set[$1] } $2 != "index" { computed[$1] }
    END { for (name in set) if (!(name in computed)) print name }' <<<"$known" | sort)
  near=$(closest_name "$name" <<<"$known")
  [[ -z $near ]] || near="; did you mean '$near'?"
  die "$input has no variable '$name'$near (it has: $(paste -sd' ' <<<"$known"))"
}

value_of() {  # value_of NAME [-var NAME VALUE]...
  local name=$1 value=''
  shift
  while [[ $# -gt 0 ]]; do
    [[ $2 != "$name" ]] || value=$3
    shift 3
  done
  printf '%s' "$value"
}
