#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# no_history.sh ROOT: pages and reasons of expected figures say what is, never what was; what is quoted from memory is
# marked in docs/sources.md only. Nor does any file hold both sides of a merge.
# Scope: words that give such a passage away; a page may still be wrong without them.
set -euo pipefail
cd "$1"
words='earlier builds?|previous builds?|formerly|not measured again|before this (build|change|version)|from memory|used to be|no longer is|previously|old (build|version)'
if grep -rniE "$words" --include='*.md' --include='*.json' --include='*.cpp' --include='*.h' --include='*.csv' ./*.md docs inputs src fixes postproc tests |
  grep -v '^docs/sources\.md:'; then
  echo 'the lines above tell history, or quote from memory outside docs/sources.md' >&2
  exit 1
fi
if grep -rnE '^(<<<<<<<|>>>>>>>) ' ./*.md CMakeLists.txt muckpile docs inputs src fixes postproc tests; then
  echo 'the lines above are left of a merge' >&2
  exit 1
fi
