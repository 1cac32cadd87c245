#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# tidy.sh [--installed] [--since REF] [--minutes M] [FILE...]
# Runs clang-tidy (Debian package clang-tidy) with the checks of .clang-tidy on FILEs, by default all
# .cpp files of the release build, or on those of them that differ from REF. Builds first what is not up
# to date: tests include what is generated. Clang cannot compile Debian's ITK headers: files with these
# are left out. After M minutes it starts no file, ends those at work and names all that are left. With
# --installed, does nothing where clang-tidy is missing.
set -u
. "$(dirname "${BASH_SOURCE[0]}")/../../packaging/setup.sh"

installed=
since=
minutes=
while [ $# -gt 0 ]; do
  case "$1" in
    -h | --help)
      sed -n '3,8s/^# //p' "$0"
      exit 0
      ;;
    --installed) installed=1 ;;
    --since | --minutes)
      [ $# -gt 1 ] || fail "$1 needs a value: see --help" 2
      printf -v "${1#--}" %s "$2"
      shift
      ;;
    -*) fail "unknown option, $1: see --help" 2 ;;
    *) break ;;
  esac
  shift
done
[ -z "$minutes" ] || [[ $minutes =~ ^[0-9]+$ ]] || fail "--minutes needs a number, not $minutes" 2
[ -z "$since" ] || [ $# -eq 0 ] || fail "--since and files do not go together: give one" 2
if ! command -v clang-tidy >/dev/null; then
  [ -n "$installed" ] || fail "clang-tidy is missing: apt-get install clang-tidy" 2
  say "clang-tidy does not look at the sources: it is not installed."
  exit 0
fi

cd "$root" || exit 2
if [ $# -gt 0 ]; then
  files=("$@")
elif [ -n "$since" ]; then
  changed=$(git diff --name-only --diff-filter=d "$since" -- '*.cpp') || fail "no such ref, $since" 2
  mapfile -t files <<<"$changed"
else
  mapfile -t files < <(git ls-files '*.cpp')
fi
compile all
mapfile -t files < <(for file in "${files[@]}"; do
  if [ -f "$file" ] && grep -qF "\"$root/$file\"" "$build/compile_commands.json" &&
    ! grep -q '#include <itk' "$file"; then
    printf '%s\n' "$file"
  fi
done)
[ ${#files[@]} -gt 0 ] || {
  say "clang-tidy: no file to look at${since:+ differs from $since}."
  exit 0
}

tidy() {
  local left=0 code
  if [ -n "$end" ]; then
    left=$((end - $(date +%s)))
    [ "$left" -gt 0 ] || left=skip
  fi
  [ "$left" = skip ] || timeout "$left" clang-tidy --quiet -p "$build" "$1" 2>/dev/null
  code=$?
  if [ "$left" = skip ] || [ "$code" = 124 ]; then
    printf 'clang-tidy had no time for %s\n' "$1"
    return 0
  fi
  return "$code"
}
export -f tidy
export build end="${minutes:+$(($(date +%s) + 60 * minutes))}"
say "clang-tidy: ${#files[@]} files"
# shellcheck disable=SC2016
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$(jobs)" bash -c 'tidy "$1"' _ ||
  fail "clang-tidy found what .clang-tidy does not allow: see the lines above"
