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

commands_of() { "$program" "$@" --help | sed -n '/^Subcommands:/,$ s/^  \([a-z]\+\) .*/\1/p'; }

options_of() {  # options_of COMMAND...: its own, or those of its sub-commands
  local inner
  for inner in $(commands_of "$@"); do options_of "$@" "$inner"; done
  "$program" "$@" --help | sed -n 's/^  \(-h,\)\?\(--[a-z0-9-]\+\).*/\2/p' | grep -v '^--help$' || true
}

for command in $(commands_of); do
  page=$folder/$command.md
  [ -f "$page" ] || { fault "no page $page" && continue; }
  grep -qF "]($command.md)" "$folder/README.md" || fault "$folder/README.md does not link to $command.md"
  has=$(options_of "$command" | sort -u)
  shown=$(grep -E '^\| *`--' "$page" | cut -d'|' -f2 | grep -oE -- '--[a-z0-9-]+' | sort -u || true)
  for option in $(comm -23 <(echo "$has") <(echo "$shown")); do fault "$page: the table of options lacks $option"; done
  for option in $(comm -13 <(echo "$has") <(echo "$shown")); do fault "$page: $command has no option $option"; done
done
for page in "$folder"/*.md; do
  command=$(basename "$page" .md)
  [ "$command" = README ] || commands_of | grep -qx "$command" || fault "$page: muckpile-post has no command $command"
done
[ "$faults" -eq 0 ]
