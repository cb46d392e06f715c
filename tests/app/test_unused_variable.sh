#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_unused_variable.sh PROGRAM: a name behind -var that is no variable of the script and its includes is told, twice, with the one that
# was meant; so is one in a file that a value behind -var names; others are not, and nothing is said of a script whose includes cannot be found.
set -euo pipefail
program=$1
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
cd "$out"

warnings() {  # warnings INPUT OPTION...: how many lines warn of -var
  output=$("$program" -log none -in "$@" 2>&1 </dev/null) || true
  grep -c '^WARNING: -var' <<<"$output" || true
}

mkdir common
cat >in.x <<'EOF'
variable burden index 3   # not burdn
variable case index a
include common/${case}.in
print "${burden} $h"
label again
print "density 2900 v_twice"
EOF
echo 'variable twice equal 2*v_spacing' >common/a.in
cat >in.lost <<'EOF'
include common/not_there_${case}.in
EOF

[[ $(warnings in.x -var burdn 4 -var h 1) -eq 2 ]] || fail "burdn must be told twice"
output=$("$program" -log none -in in.x -var burdn 4 -var h 1 2>&1 </dev/null) || true
grep -qF "did you mean 'burden'?" <<<"$output" || fail "burden must be named"
[[ $(warnings in.x -var density 4 -var again 1 -var h 1) -eq 4 ]] || fail "a keyword and a label are no variables"
[[ $(warnings in.x -var burden 4 -var h 1 -var burden 5) -eq 2 ]] || fail "a name that is given twice must be told"
output=$("$program" -log none -in in.x -var burden 4 -var h 1 -var burden 5 2>&1 </dev/null) || true
grep -q "^4 1$" <<<"$output" || fail "the first value must count"
grep -q "^WARNING: -var burden is given more than once: the first value counts" <<<"$output" || fail "which value counts must be told"
[[ $(warnings in.x -var burden 4 -var h 1 -var spacing 2 -var case a) -eq 0 ]] || fail "variables must not be told"
# Its own file is a variable: no file of the folder is meant, neither the one that would use the name.
printf 'variable site index none.in\ninclude ${site}\n' >in.any
echo 'print "${burdn}"' >in.other && touch none.in
[[ $(warnings in.any -var site none.in -var burdn 4) -eq 2 ]] || fail "a file that is a variable alone stands for none"
# A rock of one's own.
printf 'variable site index none.in\ninclude ${site}\ninclude common/${rock}.in\nvariable burden index 3\nprint "${burden} v_width"\n' >in.own
printf 'variable burdn index 4\nvariable width index 5\nvariable width index 6 # again\n' >common/mine.in
cp common/mine.in mine.in && touch common/good.in
for words in "-var rock mine -var site none.in" "-var site mine.in -var rock good"; do
  read -ra words <<<"$words"
  output=$("$program" -log none -in in.own "${words[@]}" 2>&1 </dev/null) || true
  [[ $(grep -c '^WARNING: -var' <<<"$output") -eq 4 ]] || fail "what a file of ${words[*]} sets in vain must be told"
  grep -qE "^WARNING: -var (rock|site) mine.*mine.in sets burdn, which nothing reads; did you mean 'burden'" <<<"$output" || fail "burdn must be named"
  grep -q "sets width more than once: the first value counts" <<<"$output" || fail "width must be named"
done
cd "$root"
for rock in inputs/common/rocks/*.in; do
  [[ $(warnings inputs/bench/in.bench -var out "$out" -var seed 0 -var rock "$(basename "$rock" .in)") -eq 0 ]] || fail "$rock sets nothing in vain"
done
cd "$out"
[[ $(warnings in.lost -var burdn 4 -var case b) -eq 0 ]] || fail "a file that is not there may use any name"
[[ $("$program" --version) == Muckpile\ * ]] || fail "--version must print the version"
