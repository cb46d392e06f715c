#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# post_options.sh PROGRAM FOLDER: each command of muckpile-post has a page in FOLDER, linked from its index, and the page names
# the options that the command has and no others.
# Scope: names; what a page says of an option is not compared.
set -euo pipefail
program=$1
folder=$2
faults=0

fault() {
  echo "$*" >&2
  faults=$((faults + 1))
}

commands_in() { sed -n '/^Subcommands:/,$ s/^  \([a-z]\+\) .*/\1/p' <<<"$1"; }

options_of() {  # options_of COMMAND...: its own and those of its sub-commands
  local help inner
  help=$("$program" "$@" --help)
  sed -n 's/^  \(-h,\)\?\(--[a-z0-9-]\+\).*/\2/p' <<<"$help" | sed '/^--help$/d'
  for inner in $(commands_in "$help"); do options_of "$@" "$inner"; done
}

commands=$(commands_in "$("$program" --help)")
[ -n "$commands" ] || fault "$program names no commands"
for command in $commands; do
  page=$folder/$command.md
  if [ ! -f "$page" ]; then
    fault "no page $page"
    continue
  fi
  grep -qF "]($command.md)" "$folder/README.md" || fault "$folder/README.md does not link to $command.md"
  has=$(options_of "$command" | sort -u)
  shown=$(grep -E '^\| *`--' "$page" | cut -d'|' -f2 | grep -oE -- '--[a-z0-9-]+' | sort -u || true)
  for option in $(comm -23 <(echo "$has") <(echo "$shown")); do fault "$page: the table of options lacks $option"; done
  for option in $(comm -13 <(echo "$has") <(echo "$shown")); do fault "$page: $command has no option $option"; done
done
for page in "$folder"/*.md; do
  command=$(basename "$page" .md)
  [ "$command" = README ] || grep -qx "$command" <<<"$commands" || fault "$page: muckpile-post has no command $command"
done
[ "$faults" -eq 0 ]
