#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# foreign_files.sh MUCKPILE_POST: what is told of a file of another kind is a short line that a screen can show, whatever is in the file.
# Scope: the command line; what is refused is tested with each reader.
set -euo pipefail
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir -p run/dump

refused() {  # refused WORD...
  local status=0
  "$program" "$@" >out 2>told || status=$?
  [[ $status -eq 1 && ! -s out ]] || { echo "$*: exit status $status, must be 1"; exit 1; }
  [[ $(wc -c <told) -lt 900 && $(wc -l <told) -eq 1 ]] || { echo "$*: tells too much: $(wc -c <told) bytes"; exit 1; }
  ! LC_ALL=C grep -q '[[:cntrl:]]' told || { echo "$*: tells what moves the cursor: $(cat -v told)"; exit 1; }
  grep -q '^muckpile-post: ' told || { echo "$*: does not say who tells"; exit 1; }
}

for ((k = 0; k < 2000; ++k)); do printf 'x\033[2J\r\001 %d\r' "$k"; done >lines_by_cr.csv
refused plan lines_by_cr.csv
printf '\377\376h\0o\0l\0e\0\n\0' >utf16.csv
refused plan utf16.csv
printf '\211PNG\r\n\032\n\0\0\0\rIHDR' >picture.csv
refused plan picture.csv
printf '{"case": "bench\033[2J' >run/dump/scene.json
refused profile run
