#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# spelling.sh [--installed] [FILE...]
# Looks for misspelt and American words in FILEs, by default all *.md, *.h and *.cpp that git knows, by
# codespell (Debian package codespell). american.txt beside this script has the words that are spelt
# otherwise here, accepted.txt those that are none but are meant. With --installed, does nothing where
# codespell is missing.
set -u
. "$(dirname "${BASH_SOURCE[0]}")/../../packaging/setup.sh"

installed=
case "${1:-}" in
  -h | --help)
    sed -n '3,7s/^# //p' "$0"
    exit 0
    ;;
  --installed)
    installed=1
    shift
    ;;
esac
if ! command -v codespell >/dev/null; then
  [ -n "$installed" ] || fail "codespell is missing: apt-get install codespell" 2
  say "Spelling is not checked: there is no codespell."
  exit 0
fi
cd "$root" || exit 2
files=("$@")
[ $# -gt 0 ] || mapfile -t files < <(git ls-files '*.md' '*.h' '*.cpp')
# Names such as aName, what follows a dot, an arrow or two colons, and functions are not words.
codespell --ignore-regex '\w*[a-z][A-Z]\w*|(\.|->|::)\w+|\w+\(|[{;]color:' -I tests/house/accepted.txt \
  -D - -D tests/house/american.txt "${files[@]}" ||
  fail "misspelt: mend it, or add the word to tests/house/accepted.txt where it is meant"
