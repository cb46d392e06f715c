#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_help.sh PROGRAM FIXES_CMAKELISTS: -help, -h and --help end well and list every style that FIXES_CMAKELISTS builds, and LIGGGHTS' own
# after them.
set -euo pipefail
program=$1 list=$2
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"

mapfile -t styles < <(sed -nE 's/^muckpile_add_style\(([a-z]+) ([^ )]+) [a-z]+\)$/\1 \2/p' "$list")
[[ ${#styles[@]} -ge 7 ]] || fail "found ${#styles[@]} styles in $list"

for option in -help -h --help; do
  # LIGGGHTS warns on standard error of styles that it registers twice.
  status=0
  output=$("$program" "$option" 2>/dev/null </dev/null) || status=$?
  [[ $status -eq 0 ]] || fail "$option: exit status $status"
  ours=$(sed -n '1,/^LIGGGHTS (Version/p' <<<"$output")
  for style in "${styles[@]}"; do
    grep -qE "^ +${style/ / +}$" <<<"$ours" || fail "$option does not list: $style"
  done
  for style in multisphere wall/gran gravity property/global; do
    grep -qwF -- "$style" <<<"${output#"$ours"}" || fail "$option does not list LIGGGHTS' own $style"
  done
done
