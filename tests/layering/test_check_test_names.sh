#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# check_test_names.sh passes clean tests and names what two files of an area could both define.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
readonly check=$here/check_test_names.sh tree=$out
mkdir -p "$tree"/tests/unit/{state,bond/network}

write() {  # write FILE OUTSIDE: a test with that outside its unnamed namespace
  printf '#include <vector>\n\nnamespace muckpile {\n\n%s\n\nnamespace {\n\nint helper() { return 1; }\n\nTEST(A, B) {}\n\n}  // namespace\n}  // namespace muckpile\n' \
    "$2" >"$tree/tests/unit/$1"
}
write state/test_a.cpp $'struct Stone {\n  int mass;\n};\ntemplate <>\nstruct Stored<Stone> {\n};'
write state/test_b.cpp 'enum class Colour : int { grey };'
write bond/test_c.cpp 'struct Stone {};'
write bond/network/test_d.cpp '/// Nothing.'
"$check" "$tree" || fail "clean tests were refused"

expect_fault() {  # expect_fault OUTSIDE MESSAGE
  write bond/network/test_d.cpp "$1"
  if output=$("$check" "$tree"); then fail "'$1' passed"; fi
  grep -qF "$2" <<<"$output" || fail "wrong message: $output"
}
expect_fault 'struct Stone {};' "tests/unit/bond/test_c.cpp:5: Stone is the name of a type in tests/unit/bond/network/test_d.cpp:5, too"
expect_fault 'double half(double x) { return 0.5 * x; }' "test_d.cpp:5 is outside the unnamed namespace: double half"
expect_fault 'constexpr double kStep = 1.0;' "test_d.cpp:5 is outside the unnamed namespace"
expect_fault $'template <class T>\nT twice(T x) {\n}' "test_d.cpp:5 is outside the unnamed namespace: template"
