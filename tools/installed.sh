# shellcheck shell=bash
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
# In the place of build.sh where the packages of `./slam package` are installed: nothing to build.
# shellcheck disable=SC2034,SC2154

installed=$(dirname -- "$(dirname -- "$repo")") # of PREFIX/share/ros-slam
called=slam
home=${XDG_DATA_HOME:-${HOME:-/tmp}/.local/share}/slam
hidden='/^  \(setup\|test\|docs\|package\) /d; /^setup, demo/d; s/ \[--yes\]//; s|\./slam|'$called'|g'

fail() { # CODE MESSAGE
  printf 'slam: %s\n' "$2" >&2
  exit "$1"
}

missing() { :; } # dpkg has seen to it
install_missing() { :; }
build() { :; }
source_workspace() { :; } # what is sourced lies on top of the packages
enclosing_workspace() { :; }
