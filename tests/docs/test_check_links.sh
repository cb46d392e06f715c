#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_check_links.sh CHECK_LINKS: it passes sound pages and names each kind of fault.
set -euo pipefail
check=$1
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
mkdir -p "$root/docs/styles" "$root/inputs"

fail() {
  echo "$1" >&2
  exit 1
}

refused() {  # refused MESSAGE
  local told
  if told=$("$check" "$root"); then fail "passed: $1"; fi
  [[ $told == *"$1"* ]] || fail "told '$told' instead of '$1'"
}

printf '# Glossary\n\n## Leaning face\n\nA face that leans.\n' >"$root/docs/glossary.md"
printf '# Page\n\nA [leaning face](../glossary.md#leaning-face), `[not](a.link)`.\n' >"$root/docs/styles/page.md"
"$check" "$root" || fail "sound pages were refused"

printf '[gone](gone.md)\n' >"$root/README.md"
refused "'gone.md' leads to no file"
printf '[gone](docs/styles/page.md#gone)\n' >"$root/README.md"
refused "'docs/styles/page.md#gone' leads to no heading"
rm "$root/README.md"
printf '\n## Burden\n\nA distance.\n' >>"$root/docs/glossary.md"
refused "no page links to 'burden'"
