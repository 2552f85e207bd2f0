# shellcheck shell=bash
# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
# Installing and building for the front door, which sets repo, home, workspace, command and yes.
# shellcheck disable=SC2154

called=./slam # as people call the command, in what it and the programs say

fail() { # CODE MESSAGE
  printf 'slam: %s\n' "$2" >&2
  [[ $command != test || $1 == 2 ]] || echo "0 passed, 1 failed"
  exit "$1"
}

lock() { # held until the script ends or calls a program
  if ! mkdir -p "$home" 2>/dev/null || [[ ! -w $home ]]; then
    fail 1 "cannot write to $home: call $called as the owner of this clone, or make your own clone"
  fi
  touch "$home/CATKIN_IGNORE" # keeps an outer workspace out of the folder
  exec 9>>"$home/lock"
  flock -n 9 || { echo "waiting for another $called" >&2 && flock 9; }
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

missing() { # [LIST...]: the Debian packages that are not installed; other systems use rosdep
  grep -qs '^ID=debian' /etc/os-release || return 0
  local names
  mapfile -t names < <(cd "$repo/tools" && sed 's/[[:space:]]*#.*//; /^$/d' packages.txt "$@")
  LC_ALL=C comm -13 <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${names[@]}" 2>/dev/null |
    sed -n 's/^installed //p' | LC_ALL=C sort -u) <(printf '%s\n' "${names[@]}" | LC_ALL=C sort -u)
}

install_missing() { # [LIST...]: packages.txt, and what further lists in tools name
  local names root=() answer
  mapfile -t names < <(missing "$@")
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

source_workspace() { # unless it is sourced: then the workspaces on top of it count as well
  local entry before=() outside=()
  IFS=: read -ra before <<<"${CMAKE_PREFIX_PATH:-}"
  ! holds_space "${before[@]}" || return 0
  set +u # catkin's script reads unset variables
  # shellcheck disable=SC1091
  source "$workspace/devel/setup.bash" --
  set -u
  for entry in "${before[@]}"; do
    [[ ! -e $entry/.catkin || :$CMAKE_PREFIX_PATH: == *:$entry:* ]] || outside+=("$entry")
  done
  ((${#outside[@]} == 0)) ||
    echo "slam: the workspace ${outside[0]} is sourced, but not built on top of this one, and left out;" \
      "source $workspace/devel/setup.bash, build yours from scratch and source it again" >&2
}

holds_space() { # FOLDERS...: whether one is this workspace's
  local entry
  for entry; do [[ ! $entry -ef $workspace/devel ]] || return 0; done
  return 1
}

underlay() { # what is sourced beneath this workspace: it must not be built on what lies on top of it
  local entry entries below=()
  IFS=: read -ra entries <<<"${CMAKE_PREFIX_PATH:-}"
  for entry in "${entries[@]}"; do
    if [[ $entry -ef $workspace/devel ]]; then below=(); else below+=("$entry"); fi
  done
  (IFS=: && echo "${below[*]}")
}

# What this workspace and those on top of it have put into a list of paths is left out: catkin writes
# down what its setup script adds to the environment for the tests, and must find none of it there.
outside() { # LIST
  local entry prefix entries prefixes kept=() below
  below=:$(underlay):
  IFS=: read -ra entries <<<"$1"
  IFS=: read -ra prefixes <<<"${CMAKE_PREFIX_PATH:-}"
  for entry in "${entries[@]}"; do
    for prefix in "${prefixes[@]}"; do
      [[ $below == *:$prefix:* || $entry/ != "$prefix"/* ]] || continue 2
    done
    kept+=("$entry")
  done
  (IFS=: && echo "${kept[*]}")
}

# An enclosing workspace keeps its own flags.
build_flags() {
  [[ $workspace == "$home" ]] || return 0
  printf '%s\n' --source "$repo" -DCMAKE_BUILD_TYPE=Release \
    "-DSLAM_WERROR=$([[ ${CI:-} ]] && echo ON || echo OFF)" \
    "-DCMAKE_C_COMPILER_LAUNCHER=$(type -p ccache)" "-DCMAKE_CXX_COMPILER_LAUNCHER=$(type -p ccache)"
}

sources() { # FOLDERS...: find's answer to `tests` there, without builds
  find "$@" \( -path './.*' -o -path './build*' -o -path './devel*' -o -path './install*' \
    -o -name __pycache__ \) -prune -o "${tests[@]}"
}

package_folders() { # zero-terminated; beside them lie bags, runs and pictures, which commands leave there
  local tests=(-type f -name package.xml -printf '%h\0')
  cd "$repo" && sources .
}

fingerprint() { # of every file of the packages, and of where and how they are built
  local packages tests=(-type f ! -name '*.md' -printf '%p %s %T@\n')
  cd "$repo" || return
  mapfile -d '' packages < <(package_folders)
  { printf '%s\n' "$workspace" && build_flags && sources "${packages[@]}" | sort -u; } | sha256sum
}

fresh() { # STAMP FINGERPRINT
  [[ -e $workspace/devel/setup.bash && $(cat "$1" 2>/dev/null) == "$2" ]]
}

batch_size() { # how many files are compiled as one: 16 take less time than 8, but 2 GB for each job
  local memory
  memory=$(awk '/^MemTotal/ {print int($2 / 1000)}' /proc/meminfo) # [MB]
  echo $((memory / $(nproc) > 4000 ? 16 : 8))
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
  [[ $workspace != "$home" || -e $home/build/CMakeCache.txt ]] ||
    flags+=(-DCMAKE_UNITY_BUILD=ON "-DCMAKE_UNITY_BUILD_BATCH_SIZE=$(batch_size)")
  # catkin writes down the tests' environment before the first build, and leaves out what is not there
  mkdir -p "$workspace/devel/lib/python3/dist-packages"
  PATH=$(outside "$PATH") PYTHONPATH=$(outside "${PYTHONPATH:-}") \
    LD_LIBRARY_PATH=$(outside "${LD_LIBRARY_PATH:-}") \
    PKG_CONFIG_PATH=$(outside "${PKG_CONFIG_PATH:-}") ROS_PACKAGE_PATH='' CMAKE_PREFIX_PATH=$(underlay) \
    logged "building" "$home/build.log" catkin_make -C "$workspace" "${flags[@]}" -j"$(nproc)" "$1"
  echo "$now" >"$stamp"
}
