# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash
# The Debian packages that Muckpile is built and tested with, and the installation of those that are missing.
# Scope: sourced by muckpile, whose say() and die() it uses; Debian 12 and its kin.
readonly packages=(g++ cmake ninja-build libliggghts-dev libopenmpi-dev openmpi-bin libeigen3-dev
  voro++-dev libvtk9-dev libgtest-dev libcli11-dev nlohmann-json3-dev python3-numpy)

missing_packages() {  # missing_packages PACKAGE...
  # dpkg-query fails when it does not know one of the packages; its output is still right.
  local installed
  installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "$@" 2>/dev/null || true)
  local package
  for package in "$@"; do
    grep -qxF "$package installed" <<<"$installed" || printf '%s\n' "$package"
  done
}

as_root() {
  if [[ $(id -u) -eq 0 ]]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    die "installing packages needs root, and there is no sudo; as root: $*"
  fi
}

install_deps() {  # install_deps [PACKAGE]...: Muckpile's own and these
  local wanted=("${packages[@]}" "$@")
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    die "no apt-get here; install what these Debian packages hold, then './muckpile build': ${wanted[*]}"
  fi
  local missing
  mapfile -t missing < <(missing_packages "${wanted[@]}")
  [[ ${#missing[@]} -eq 0 ]] && return
  say "installing ${missing[*]}"
  local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0)
  as_root "${apt[@]}" update || die "apt-get update failed; is there a network?"
  as_root "${apt[@]}" install -y --no-install-recommends "${missing[@]}" ||
    die "could not install ${missing[*]}; apt-get's own message is above"
}

# Without apt the tools may still be there: then CMake says what is missing.
install_deps_if_possible() {
  if command -v apt-get >/dev/null && command -v dpkg-query >/dev/null; then install_deps; fi
}
