# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash disable=SC2016,SC2154
# A copy of the entry script in the folder $tree, with an input inputs/demo/in.demo, on programs that only record how they are called, in
# $tree/calls; and calls of it.
# Scope: sourced behind script.sh, by tests of ./muckpile; the folder $tree becomes the present one.
readonly script=$root/muckpile tree=$out
cp "$script" "$tree/muckpile"
mkdir -p "$tree/src/app" && cp -r "$(dirname "$script")/src/app/run" "$tree/src/app/run"
mkdir -p "$tree"/{bin,inputs/demo,inputs/common,build/release/postproc/tools}
touch "$tree/build/release/build.ninja"
cd "$tree"

printf 'include inputs/common/rock.in\nvariable bench_height index 12 # m\nvariable out index x\n' \
  >inputs/demo/in.demo
printf 'variable mode index slow\nvariable rock_density index 2700 # kg/m3\nvariable step equal 1\ninclude inputs/common/mode_${mode}.in\n' >inputs/common/rock.in
printf 'variable patience index 4\nvariable go_on index 0\nvariable from index none\n' >inputs/common/mode_slow.in

fake() {  # fake NAME BODY
  printf '#!/bin/bash\necho "%s $*" >>%s/calls\n%s\n' "$(basename "$1")" "$tree" "$2" >"$1"
  chmod +x "$1"
}
all_installed='shift 2; for p in "$@"; do echo "$p installed"; done'
fake_tools() {
  fake bin/dpkg-query "$all_installed"
  fake bin/apt-get ''
  fake bin/cmake ''
}

call() {  # call ARGUMENT...: runs the script on the fakes, keeps output and status
  rm -f calls
  status=0
  output=$(PATH="$tree/bin:$PATH" ./muckpile "$@" 2>&1) || status=$?
}
problem() {
  printf '%s\n' "$1" "--- status $status, output:" "$output" "--- calls:" "$(cat calls 2>/dev/null)"
  exit 1
}
must_refuse() {  # must_refuse TEXT ARGUMENT...
  local text=$1
  shift
  call "$@"
  [[ $status -ne 0 ]] || problem "accepted: $*"
  grep -qF -- "$text" <<<"$output" || problem "wrong message for: $*"
  ! grep -q '^mpirun' calls 2>/dev/null || problem "the engine ran for: $*"
}
must_work() {
  call "$@"
  [[ $status -eq 0 ]] || problem "failed: $*"
}
called() { grep -qE -- "$1" calls || problem "no call like: $1"; }
told() { grep -qF -- "$1" <<<"$output" || problem "not told: $1"; }
