#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# numbers_that_are_none.sh MUCKPILE_POST: nan, inf and an empty word, as of a variable that is not set, are refused by name, before the folder is
# read, by every option with a number.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../support/script.sh"
post=$(readlink -f "$1")

refused() {  # refused OPTION COMMAND...
  local option=$1 status=0
  shift
  "$post" "$@" >"$out/screen" 2>&1 || status=$?
  ((status == 105)) && grep -q -e "^$option: must be .*, got '\(nan\|inf\|\)'" "$out/screen" ||
    fail "'$*' ends with $status: $(head -1 "$out/screen")"
}
for number in nan inf ''; do
  for option in azimuth elevation zoom section; do refused "--$option" render "$out" "--$option" "$number"; done
  refused --from section "$out" --from 0 "$number" --to 1 1
  refused --to over "$out" --from 0 0 --to "$number" 1
  refused --to render "$out" --from 0 0 --to 1 "$number"
  refused --colour-range render "$out" --colour-range "$number" 1
  refused --focus render "$out" --focus 0 "$number" 0
  for option in k factor launch-angle; do refused "--$option" flyrock "$out" "--$option" "$number"; done
  refused --fines fragments "$out" --fines "$number"
  for option in fines-top fines-exponent; do refused "--$option" fragments "$out" --fines 5 "--$option" "$number"; done
  refused --turn movement "$out" --turn "$number"
  refused --cutoff movement "$out" --cutoff "$number"
  refused --shift movement "$out" --shift 0 0 "$number"
  refused --turn survey "$out" ground.csv --turn "$number"
  refused --shift survey "$out" ground.csv --shift "$number" 0 0
  for option in y cell moved; do refused "--$option" profile "$out" "--$option" "$number"; done
done
