#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# knobs.sh ROOT: each '-var NAME' that a page shows is a variable of an input, each file of the project that stands between
# backticks with its path from the root is there.
# Scope: names; whether the input beside it has that knob is for docs.recipes_run to find.
set -euo pipefail
cd "$1"
mapfile -t pages < <(find . -maxdepth 1 -name '*.md' && find docs inputs postproc -name '*.md')
faults=0
known=$(grep -rhoE '^ *variable +[a-z_0-9]+' inputs | awk '{print $2}' | sort -u)
shown=$(grep -ohE -- '-var [a-z][a-z_0-9]*' "${pages[@]}" | awk '{print $2}' | sort -u)
for name in $(comm -13 <(echo "$known") <(echo "$shown")); do
  echo "no input has the variable '$name' of:" >&2
  grep -nE -- "-var $name\b" "${pages[@]}" | cut -c1-120 >&2
  faults=$((faults + 1))
done
while read -r file; do
  [ -e "${file%%[<*\{]*}" ] || compgen -G "${file%%[<*\{]*}*" >/dev/null || { echo "pages name $file, which is not there" >&2 && faults=$((faults + 1)); }
done < <(grep -ohE '`(src|fixes|tests|docs|postproc|cmake)/[A-Za-z_0-9/.<>*{},-]+`' "${pages[@]}" | tr -d '`' | grep -vE 'saeb|COMMAND' | sort -u)
[ "$faults" -eq 0 ]
