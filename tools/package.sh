# shellcheck shell=bash
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
# Debian packages for the front door, beside build.sh, whose functions it calls.
# shellcheck disable=SC2154

debian_release() { (. /etc/os-release 2>/dev/null && echo "${ID:-} ${VERSION_ID:-}"); }

copy_sources_to() { # FOLDER: what the packages are made of, and no build
  local packages
  mapfile -d '' packages < <(package_folders | grep -zv '^\./test')
  mkdir -p "$1"
  (cd "$repo" && tar -c --exclude=__pycache__ --exclude='*.pyc' \
    debian tools slam docs ./*.md LICENSE test/toys "${packages[@]}") | tar -C "$1" -x
  touch "$1/test/CATKIN_IGNORE" # what new_component copies is installed, not built
}

build_packages() { # FOLDER: the packages come to lie beside it
  # What is sourced here is not what the packages may depend on. Debugging symbols would take another
  # third of the time; debhelper gives the build a home of its own, without the cache.
  (cd "$1" && env -u CMAKE_PREFIX_PATH -u LD_LIBRARY_PATH -u PKG_CONFIG_PATH -u PYTHONPATH \
    -u ROS_PACKAGE_PATH CCACHE_DIR="$(ccache -k cache_dir)" DEB_CXXFLAGS_APPEND=-g0 \
    DEB_BUILD_OPTIONS="nocheck noautodbgsym parallel=2" nice dpkg-buildpackage -b -us -uc)
}

make_packages() { # [--out DIR]
  local out tree=$home/package_build/ros-slam release
  [[ $# == 0 || ($# == 2 && $1 == --out && $2) ]] || fail 2 "package takes --out DIR only (./slam help)"
  release=$(debian_release)
  [[ $release == "debian 12" ]] ||
    fail 1 "packages are built on Debian 12, and this is ${release:-an unknown system}"
  out=$(realpath -m -- "${2:-$home/packages}")
  { mkdir -p "$out" 2>/dev/null && [[ -w $out ]]; } || fail 1 "cannot write to $out"
  install_missing package_tools.txt
  lock
  rm -rf "$home/package_build"
  copy_sources_to "$tree"
  logged "building packages" "$home/package.log" build_packages "$tree"
  logged "checking packages" "$home/lintian.log" \
    lintian --allow-root --fail-on error,warning "$home"/package_build/*.changes
  rm -f "$out"/ros-slam*.deb
  mv "$home"/package_build/*.deb "$out"
  rm -rf "$home/package_build"
  echo "packages: $out ($(find "$out" -name 'ros-slam*.deb' | wc -l) files)"
  echo "install them with: sudo apt install $out/*.deb"
}
