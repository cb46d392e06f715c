# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash disable=SC2154
# check_figures of the build that $program (liggghts-muckpile) is of; see check_figures/main.cpp.
# Scope: to be sourced, once $program is set. No other way of comparing numbers: awk takes NaN for equal, and nothing for zero.
check_program=$(dirname "$(readlink -f "$program")")/../../tests/support/check_figures/check_figures
[[ -x $check_program ]] || { echo "$check_program is not there; ./muckpile build makes it" >&2; exit 1; }
check_figures() { "$check_program" "$@"; }
