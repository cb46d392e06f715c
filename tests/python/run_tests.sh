#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run_tests.sh MODULE LIGGGHTS_MUCKPILE MUCKPILE_POST: the tests of one module, with the first Python that has NumPy:
# $PYTHON, python3, /usr/bin/python3. Ends with 77 where there is none.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
root=$(readlink -f "$here/../..")
export MUCKPILE_PROGRAM=$2 MUCKPILE_POST=$3 MUCKPILE_ROOT=$root
export PYTHONPATH=$root/postproc/python:$here PYTHONDONTWRITEBYTECODE=1
for python in ${PYTHON:+"$PYTHON"} python3 /usr/bin/python3; do
  if "$python" -c 'import sys, numpy; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then
    cd "$root"
    exec "$python" -W error -m unittest -v "$1"
  fi
done
echo "skipped: no Python 3.11 or later with NumPy is installed; apt-get install python3-numpy" >&2
exit 77
