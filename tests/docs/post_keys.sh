#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# post_keys.sh ROOT: each key of summary.json that the reports of muckpile-post write by name stands on a page of docs/post.
# Scope: keys["name"] of the sources; those that are put together from parts are not found, nor is a wrong meaning.
set -euo pipefail
cd "$1"
keys=$(grep -rohE 'keys\["[A-Za-z0-9_]+"\]' postproc/lib/report | cut -d'"' -f2 | sort -u)
[ "$(wc -l <<<"$keys")" -ge 50 ] || { echo 'too few keys found in postproc/lib/report' >&2 && exit 1; }
missing=$(comm -23 <(echo "$keys") <(grep -rohE '`[A-Za-z0-9_]+`' docs/post | tr -d '`' | sort -u))
if [ -n "$missing" ]; then
  echo "no page of docs/post has the keys: ${missing//$'\n'/ }" >&2
  exit 1
fi
