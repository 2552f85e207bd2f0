# shellcheck shell=bash
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
# Installing and building for the front door, which sets repo, home, workspace, packages,
# command and yes.
# shellcheck disable=SC2154

fail() { # CODE MESSAGE
  printf 'slam: %s\n' "$2" >&2
  [[ $command != test || $1 == 2 ]] || echo "0 passed, 1 failed"
  exit "$1"
}

lock() { # held until the script ends or calls a program
  if ! mkdir -p "$home" 2>/dev/null || [[ ! -w $home ]]; then
    fail 1 "cannot write to $home: call ./slam as the owner of this clone, or make your own clone"
  fi
  touch "$home/CATKIN_IGNORE" # keeps an outer workspace out of the folder
  exec 9>>"$home/lock"
  flock -n 9 || { echo "waiting for another ./slam" >&2 && flock 9; }
}

progress() { # LABEL: condenses the per cent lines of make and apt to a bar, or to a few lines in a log
  local line label percent bar shown=''
  while IFS= read -r line; do
    [[ $line =~ ^\[\ *([0-9]+)%\] || $line =~ ^[dp][lm]status:.*:([0-9]+)\.[0-9]+: ]] || continue
    percent=${BASH_REMATCH[1]} label=$1
    [[ $line != dlstatus* ]] || label="fetching packages"
    if [[ -t 1 ]]; then
      printf -v bar '%*s' $((percent / 4)) ''
      printf '\r%s [%-25s] %3d%%\e[K' "$label" "${bar// /#}" "$percent"
    elif [[ $((percent / 10)) != "$shown" ]]; then
      shown=$((percent / 10))
      echo "$label: $percent%"
    fi
  done
  if [[ -t 1 ]]; then printf '\r\e[K'; fi
}

logged() { # LABEL LOG COMMAND...
  local label=$1 log=$2
  shift 2
  "$@" 9>&- </dev/null 2>&1 | tee "$log" | progress "$label" >&2 && return
  tail -n 40 "$log" >&2
  fail 1 "$label failed; the whole log is $log"
}

missing() { # the Debian packages that are not installed; other systems resolve package.xml with rosdep
  grep -qs '^ID=debian' /etc/os-release || return 0
  local names
  mapfile -t names < <(sed 's/[[:space:]]*#.*//; /^$/d' "${packages[@]}")
  LC_ALL=C comm -13 <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${names[@]}" 2>/dev/null |
    sed -n 's/^installed //p' | LC_ALL=C sort -u) <(printf '%s\n' "${names[@]}" | LC_ALL=C sort -u)
}

install_missing() {
  local names root=() answer
  mapfile -t names < <(missing)
  ((${#names[@]})) || return 0
  printf 'Debian packages to install:\n  %s\n' "$(fold -s -w 96 <<<"${names[*]}" | sed '2,$s/^/  /')"
  if [[ $yes ]]; then
    :
  elif [[ -t 0 ]]; then
    read -rp "Install them with apt? [Y/n] " answer
    [[ ${answer:-y} == [yY]* ]] || fail 1 "nothing was installed"
  elif [[ ! ${CI:-} && $command != test ]]; then
    fail 2 "nobody is there to be asked: add --yes to install these packages"
  fi
  if ((EUID)); then
    root=(sudo)
    sudo -v || fail 1 "no right to install: have root install these packages"
  fi
  lock
  # A package source that cannot be reached need not matter: the installation decides.
  logged "installing packages" "$home/apt.log" "${root[@]}" env DEBIAN_FRONTEND=noninteractive \
    sh -c 'apt-get update; exec apt-get -y --no-install-recommends -o APT::Status-Fd=1 \
    -o DPkg::Lock::Timeout=600 install "$@"' apt "${names[@]}"
}

enclosing_workspace() { # the one that holds this clone and was built by catkin_make; else .slam
  local dir=$repo
  while [[ $dir != / ]]; do
    dir=$(dirname -- "$dir")
    [[ $repo/ == "$dir/src/"* && -e $dir/devel/share/slam_launch ]] || continue
    [[ $(cat "$dir/build/.built_by" 2>/dev/null) == catkin_make ]] && echo "$dir" && return
  done
  echo "$home"
}

# An enclosing workspace keeps its own flags. The tests of slam_core are built once, with sanitizers
# (test/run_tests), but for those of statistics.
build_flags() {
  [[ $workspace == "$home" ]] || return 0
  printf '%s\n' --source "$repo" -DCMAKE_BUILD_TYPE=Release \
    "-DSLAM_WERROR=$([[ ${CI:-} ]] && echo ON || echo OFF)" -DSLAM_TESTS=statistics \
    "-DCMAKE_C_COMPILER_LAUNCHER=$(type -p ccache)" "-DCMAKE_CXX_COMPILER_LAUNCHER=$(type -p ccache)"
}

sources() { # FOLDERS...: find's answer to `tests` there, without builds
  find "$@" \( -path './.*' -o -path './build*' -o -path './devel*' -o -path './install*' \
    -o -name __pycache__ \) -prune -o "${tests[@]}"
}

fingerprint() { # of every file of the packages, and of where and how they are built
  local packages tests=(-type f -name package.xml -printf '%h\0')
  cd "$repo" || return
  # Beside the packages lie bags, runs and pictures, which the commands leave there.
  mapfile -d '' packages < <(sources .)
  tests=(-type f ! -name '*.md' -printf '%p %s %T@\n')
  { printf '%s\n' "$workspace" && build_flags && sources "${packages[@]}" | sort -u; } | sha256sum
}

fresh() { # STAMP FINGERPRINT
  [[ -e $workspace/devel/setup.bash && $(cat "$1" 2>/dev/null) == "$2" ]]
}

build() { # TARGET
  local stamp=$home/built.$1 now flags
  now=$(fingerprint)
  fresh "$stamp" "$now" && return
  lock
  fresh "$stamp" "$now" && return # the ./slam we waited for has built it
  command -v catkin_make >/dev/null || fail 1 \
    "there is no catkin_make; where it is not Debian's, 'rosdep install --ignore-src --from-paths .' installs it"
  if [[ $workspace == "$home" && -e $home/build ]] &&
    ! grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$repo" "$home/build/CMakeCache.txt"; then
    echo "the build is another folder's, or broken: building from scratch" >&2
    rm -rf "$home"/{build,devel,install,core_sanitized}
  fi
  mapfile -t flags < <(build_flags)
  # A first build takes a third less where several files are compiled as one; it stays so.
  [[ $workspace != "$home" || -e $home/build/CMakeCache.txt ]] || flags+=(-DCMAKE_UNITY_BUILD=ON)
  # catkin writes down the tests' environment before the first build, and leaves out what is not there
  mkdir -p "$workspace/devel/lib/python3/dist-packages"
  logged "building" "$home/build.log" catkin_make -C "$workspace" "${flags[@]}" -j"$(nproc)" "$1"
  echo "$now" >"$stamp"
}
