# SPDX-License-Identifier: BSD-3-Clause
# Sourced by run.sh, test.sh and bench/run.sh: installs the packages, configures and builds, each only
# when needed.
# Everything that these steps print goes to a log; the end of it is shown when a step fails.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
build="$root/build/release"
package_lists=("$root/packaging/packages.txt")
cmake_options=()

fail() {
  printf '%s: %s\n' "$(basename "$0")" "$1" >&2
  exit "${2:-1}"
}

say() { printf '%s\n' "$*" >&2; }

# quietly WORK LOG COMMAND...: runs the command with its output in $build/LOG; shows the end of it and
# stops the script when the command fails, naming the work.
quietly() {
  local work=$1 log="$build/$2"
  shift 2
  if ! "$@" >"$log" 2>&1 </dev/null; then
    tail -n 40 "$log" >&2
    fail "$work failed: see the lines above; all of its output is in $log"
  fi
}

missing_packages() {
  local wanted
  wanted=$(grep -hv '^ *\(#\|$\)' "${package_lists[@]}")
  # shellcheck disable=SC2086
  { dpkg-query -W -f '${Package} ${db:Status-Status}\n' $wanted 2>/dev/null; printf '%s\n' "$wanted"; } |
    awk '$2 == "installed" { have[$1] = 1 } NF == 1 && !have[$1] { printf "%s ", $1 }'
}

install_packages() {
  command -v dpkg-query >/dev/null || {
    say "This is not a Debian system: the packages of packaging/packages.txt are taken as installed."
    return
  }
  local missing
  missing=$(missing_packages)
  [ -n "$missing" ] || return 0
  local as_root=(env DEBIAN_FRONTEND=noninteractive)
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null ||
      fail "these packages are missing and there is no sudo: as root, run apt-get install $missing" 2
    sudo -v || fail "these packages are missing: as root, run apt-get install $missing" 2
    as_root=(sudo "${as_root[@]}")
  fi
  say "Installing Debian packages (2.4 GB on a minimal system, a few minutes): $missing"
  local options=(-y -q -o Acquire::Retries=3 -o DPkg::Lock::Timeout=600)
  # shellcheck disable=SC2086
  quietly "installing Debian packages" packages.log "${as_root[@]}" bash -c \
    'dpkg --configure -a; apt-get "${@:2}" update && apt-get "${@:2}" --no-install-recommends install $1' \
    apt "$missing" "${options[@]}"
}

configure() {
  # A build folder that was made for another place of the sources cannot be used again.
  if [ -f "$build/CMakeCache.txt" ] &&
    ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"; then
    rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles"
  fi
  if [ ! -f "$build/CMakeCache.txt" ] || [ ! -f "$build/build.ninja" ]; then
    say "Configuring"
    quietly configuring configure.log cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
      ${cmake_options[@]+"${cmake_options[@]}"}
  fi
}

# One compiler for each core, as long as each can have 1 GB of memory.
jobs() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/^MemAvailable:/ { print int($2 / 1048576) }' /proc/meminfo 2>/dev/null)
  if [ "${memory:-$cores}" -lt "$cores" ]; then cores=$((memory > 0 ? memory : 1)); fi
  printf '%s\n' "$cores"
}

# compile TARGET...: installs, configures and builds what is not up to date.
compile() {
  mkdir -p "$build" || fail "cannot make the build folder $build: check the permissions" 2
  exec 9>"$root/build/.lock"
  flock 9
  install_packages
  configure
  if ! ninja -C "$build" -n "$@" 2>&1 | grep -q 'no work to do'; then
    say "Building (a few minutes the first time; log: $build/build.log)"
    quietly building build.log ninja -C "$build" -j "$(jobs)" "$@"
  fi
  flock -u 9
  exec 9>&-
}
