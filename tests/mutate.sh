#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# mutate.sh [--count N] [--seed S] [--skip K] [--jobs J] [--minutes M] [--effort SECONDS]
#           [--most PERCENT] [--work FOLDER] [--since REF | FILE...]
# Plants N small faults (by default 100), one at a time and one line each, in core/*/*.cpp: in all of
# them, in the files named, or in those that differ from a git ref. A fault is killed when a test of
# core fails, crashes or takes three times its usual time of the processor; those that no test notices
# are printed, with their share. The faults follow from the seed (1) alone, but for the first K of
# them, which are left out; what the compiler refuses, or makes the same program of, is none. It starts
# no fault M minutes after the first, and fails where more than PERCENT of the faults survive. A fault
# meets the tests that can see its file, the nearest first, as far as these usually take SECONDS (by
# default all): then some survive that a far test would notice. It works in a copy of the tree in a
# temporary folder, or in FOLDER, which then is kept: the next run need not build all of it again.
# Ctrl-C ends it with what is known by then.
set -u
. "$(dirname "${BASH_SOURCE[0]}")/../packaging/setup.sh"

count=100
seed=1
jobs=$(jobs)
skip=0
minutes=
effort=
most=
work=
since=
files=()
while [ $# -gt 0 ]; do
  case "$1" in
    -h | --help)
      sed -n '3,14s/^# //p' "$0"
      exit 0
      ;;
    --count | --seed | --skip | --jobs | --minutes | --effort | --most | --work | --since)
      [ $# -gt 1 ] || fail "$1 needs a value: see --help" 2
      case "$1" in
        --work | --since) ;;
        *) [[ $2 =~ ^[0-9]+$ ]] || fail "$1 needs a number, not $2" 2 ;;
      esac
      printf -v "${1#--}" %s "$2"
      shift
      ;;
    -*) fail "unknown option, $1: see --help" 2 ;;
    *) files+=("$1") ;;
  esac
  shift
done
[ "$count" -gt 0 ] && [ "$jobs" -gt 0 ] || fail "--count and --jobs are at least 1" 2
[ -z "$since" ] || [ ${#files[@]} -eq 0 ] || fail "--since and files do not go together: give one" 2

cd "$root" || exit 2
if [ -n "$since" ]; then
  changed=$(git diff --name-only "$since" -- 'core/*/*.cpp') || fail "no such ref, $since" 2
  mapfile -t files < <(for file in $changed; do [ ! -f "$file" ] || printf '%s\n' "$file"; done)
  [ ${#files[@]} -gt 0 ] || {
    say "No source of core differs from $since."
    exit 0
  }
elif [ ${#files[@]} -eq 0 ]; then
  files=(core/*/*.cpp)
fi
for file in "${files[@]}"; do
  [[ $file == core/*/*.cpp && -f $file ]] ||
    fail "no source of core, $file: name files as core/ROOM/FILE.cpp" 2
done

keep=yes
if [ -z "$work" ]; then
  keep=no
  work=$(mktemp -d "${TMPDIR:-/tmp}/angiomesh-mutate.XXXXXX") || fail "cannot make a temporary folder" 2
fi
mkdir -p "$work/tree" || fail "cannot make $work/tree: check the permissions" 2
work=$(cd "$work" && pwd -P)
case "$work/" in "$root"/*) [ -n "${work##"$root"/build*}" ] && fail "$work lies in the sources" 2 ;; esac
# Where a build of the sources would be: a compiler cache that takes paths as relative knows it.
build="$work/tree/build/release"
install_packages
rm -rf "$work/mutants"
mkdir -p "$work/mutants" "$build"

finish() {
  trap - INT TERM EXIT
  # What runs in the background is a group of its own.
  [ -z "${group:-}" ] || kill -- "-$group" 2>/dev/null
  [ -z "${group:-}" ] || wait "$group" 2>/dev/null
  [ "$keep" = yes ] || rm -rf "$work"
}
trap finish EXIT
trap 'interrupted=yes; [ -z "${group:-}" ] || kill -- "-$group" 2>/dev/null' INT TERM

# In the background, so that the traps above act at once; in one group, so that all of it ends.
in_group() {
  set -m
  "$@" &
  group=$!
  set +m
  wait "$group"
  local code=$?
  group=
  [ -z "${interrupted:-}" ] || exit 130
  return "$code"
}

# The copy: what git knows and what it would add. Files that are as they were keep their time.
say "Copying and building (a few minutes the first time; log: $work/build.log)"
git ls-files -z -co --exclude-standard | while IFS= read -r -d '' file; do
  [ -f "$file" ] || continue
  cmp -s "$file" "$work/tree/$file" || printf '%s\0' "$file"
done | tar --null -T - -cf - | tar -xmf - -C "$work/tree"
(cd "$work/tree" && find . -path ./build -prune -o -type f -printf '%P\n') | while IFS= read -r file; do
  [ -e "$file" ] || rm -f "$work/tree/$file"
done

# core as a shared library: the one file of a fault is compiled into a small library of its own, which
# goes before core when a test starts. Nothing is linked anew.
lists="$work/tree/core/CMakeLists.txt"
shared='add_library(angiomesh_core SHARED)\
set_target_properties(angiomesh_core PROPERTIES DEFINE_SYMBOL "")'
sed "s/^add_library(angiomesh_core STATIC)/$shared/" core/CMakeLists.txt >"$lists"
grep -q 'angiomesh_core SHARED' "$lists" || fail "core/CMakeLists.txt has no static angiomesh_core" 2
# Its time as before, so that nothing is configured anew for it.
touch -r core/CMakeLists.txt "$lists"
{
  [ -f "$build/build.ninja" ] ||
    in_group cmake -S "$work/tree" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
      -DANGIOMESH_BUILD_GUI=OFF -DCMAKE_SKIP_RPATH=ON
} >"$work/build.log" 2>&1 && in_group ninja -C "$build" -j "$jobs" tests/core/all \
  >>"$work/build.log" 2>&1 || {
  tail -n 30 "$work/build.log" >&2
  fail "the build failed: see the lines above" 2
}

export QT_QPA_PLATFORM=offscreen LD_LIBRARY_PATH="$build/core${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
tests=$(sed -n 's|^angiomesh_test(\([a-z_/]*\) .*|\1|p' tests/core/CMakeLists.txt)

# What each test takes of the processor, which is the same on a busy machine; they must pass.
time_test() {
  local name=${1##*/} TIMEFORMAT='%3U %3S' took
  took=$({ time timeout --foreground 600 "$build/tests/$name" -nocrashhandler >"$work/$name.log" 2>&1; } 2>&1 &&
    rm "$work/$name.log") || {
    tail -n 20 "$work/$name.log" >&2
    printf '%s fails without a fault\n' "$1" >&2
    return 1
  }
  awk -v test="$1" '{ printf "%s\t%d\n", test, 1000 * ($1 + $2) }' <<<"$took" >>"$work/times.new"
}
export -f time_test
export build work
time_tests() {
  : >"$work/times.new"
  # shellcheck disable=SC2086
  printf '%s\n' $tests | xargs -P "$jobs" -n 1 bash -c 'time_test "$1"' _ &&
    mv "$work/times.new" "$work/times"
}
if [ ! -f "$work/times" ] ||
  [ -n "$(find "$build/tests" "$build/core" -type f -newer "$work/times" \
    \( -name 'tst_*' -o -name '*.so' \) -perm -100 -print -quit)" ]; then
  say "Running $(wc -w <<<"$tests") tests without a fault"
  in_group time_tests || fail "the tests do not pass as they are" 2
fi

# For each source the tests that can see it, the likeliest to notice first: of the same room, then by
# the number of includes between them, then by their time. A header stands for the sources that
# include it first, or of its room by way of the header that they include first.
# shellcheck disable=SC2016
(cd "$work/tree" && grep -o '^#include "[^"]*"' -r core tests/core --include='*.h' --include='*.cpp') |
  awk -F'[:"]' -v times="$work/times" '
    { if (!($1 in first)) { first[$1] = $3; if ($1 ~ /^core.*\.cpp$/) made[$3] = made[$3] " " $1 }
      uses[$1] = uses[$1] " " $3 }
    END {
      for (file in first) {
        if (file !~ /^core.*\.cpp$/) continue
        room = file; sub(/[^\/]*$/, "", room)
        n = split(uses[first[file]], at, " ")
        for (i = 1; i <= n; ++i)
          if (index(at[i], room) == 1) made[at[i]] = made[at[i]] " " file
      }
      while ((getline line < times) > 0) {
        split(line, field, "\t"); test = "tests/core/" field[1] ".cpp"
        room = field[1]; sub(/\/.*/, "", room)
        split("", far); front = test; far[test] = 0; step = 0
        while (front != "") {
          next_ = ""; ++step
          n = split(front, at, " ")
          for (i = 1; i <= n; ++i) {
            m = split(uses[at[i]] " " made[at[i]], to, " ")
            for (k = 1; k <= m; ++k)
              if (!(to[k] in far)) { far[to[k]] = step; next_ = next_ " " to[k] }
          }
          front = next_
        }
        for (file in far)
          if (file ~ /^core.*\.cpp$/)
            printf "%s\t%d\t%d\t%d\t%s\n", file, index(file, "core/" room "/") != 1, far[file],
              field[2], field[1]
      }
    }' | sort -t "$(printf '\t')" -k1,1 -k2,2n -k3,3n -k4,4n >"$work/seen"

seen=() unseen=()
for file in "${files[@]}"; do
  if grep -q "^$file	" "$work/seen"; then seen+=("$file"); else unseen+=("$file"); fi
done
[ ${#unseen[@]} -eq 0 ] || say "No test of core sees ${unseen[*]}: left out"
[ ${#seen[@]} -gt 0 ] || exit 0
awk -v seed="$seed" -f tests/mutants.awk "${seen[@]}" | sort -n -k1,1 >"$work/candidates"
[ -s "$work/candidates" ] || fail "nothing to change in ${seen[*]}" 2

compile_fault() {
  (cd "$build" && ulimit -t 300 && CCACHE_DISABLE=1 bash -c "$1") >"$2/log" 2>&1
}

# plant N: the fault of line N of the candidates. Its verdict: none, killed BY, or survived.
plant() {
  local dir="$work/mutants/$1" key file line new object command code test ms limit spent=0
  IFS=$'\t' read -r key file line new < <(sed -n "$1p" "$work/candidates")
  mkdir -p "$dir"
  new=$(sed -n "$1p" "$work/candidates" | cut -f 4-)
  NEW=$new awk -v line="$line" 'NR == line { $0 = ENVIRON["NEW"] } { print }' "$work/tree/$file" \
    >"$dir/${file##*/}"
  object="core/CMakeFiles/angiomesh_core.dir/${file#core/}.o"
  command=$(ninja -C "$build" -t commands "$object" | tail -n 1)
  command=${command/ -o $object/ -o $dir/fault.o}
  command=${command/ -c $work\/tree\/$file/ -w -c $dir/${file##*/}}
  command=${command// $object.d/ $dir/fault.d}
  verdict=none
  # With the library's checks, which notice an index that is too large.
  if compile_fault "${command/ -w / -w -D_GLIBCXX_ASSERTIONS }" "$dir" &&
    "${CXX:-c++}" -shared -o "$dir/fault.so" "$dir/fault.o" >>"$dir/log" 2>&1; then
    verdict=survived
    while IFS=$'\t' read -r _ _ _ ms test; do
      [ -z "$effort" ] || [ $((spent + ms)) -le $((1000 * effort)) ] || continue
      spent=$((spent + ms))
      # Of the processor; one that waits for ever is ended by the clock.
      limit=$((3 * ms / 1000 + 3))
      {
        (
          ulimit -t "$limit"
          exec timeout --foreground -k 1 $((20 * limit)) env LD_PRELOAD="$dir/fault.so" TMPDIR="$dir" \
            "$build/tests/${test##*/}" -nocrashhandler
        ) >"$dir/log" 2>&1 </dev/null
        code=$?
      } 2>/dev/null # the shell's own word about a crash
      [ "$code" -ne 0 ] || continue
      verdict="killed by $test"
      case "$code" in 124 | 137 | 152) verdict="$verdict, too slow" ;; esac
      break
    done < <(grep "^$file	" "$work/seen")
    # What no test notices may be the same program.
    if [ "$verdict" = survived ] && compile_fault "$command" "$dir" &&
      cmp -s "$dir/fault.o" "$build/$object"; then
      verdict=none
    fi
  fi
  rm -rf "$dir"
  printf '%s\t%s\t%s\t%s\t%s\n' "$1" "$verdict" "$file" "$line" "$new" >"$work/mutants/$1.done"
}

# Takes the candidates in their order, until enough of them are faults; one that was skipped by a
# worker that was slower is not among those that count.
worker() {
  local n
  while :; do
    exec 8>"$work/mutants/lock"
    flock 8
    n=$(($(cat "$work/mutants/next" 2>/dev/null || echo "$skip") + 1))
    echo "$n" >"$work/mutants/next"
    exec 8>&-
    [ "$n" -le "$(wc -l <"$work/candidates")" ] || return 0
    [ -z "$minutes" ] || [ $((SECONDS - started)) -lt $((60 * minutes)) ] || return 0
    [ "$(cat "$work"/mutants/*.done 2>/dev/null | cut -f 2 | grep -vc '^none$')" -lt "$count" ] ||
      return 0
    plant "$n"
  done
}
workers() {
  local j
  for ((j = 0; j < jobs; ++j)); do worker & done
  wait
}

# The first faults in the order of the candidates, as many as were asked for.
summary() {
  sort -n "$work"/mutants/*.done 2>/dev/null | awk -F '\t' -v count="$count" -v seed="$seed" \
    -v most="${most:-100}" -v tree="$root" '
    $2 == "none" { next }
    ++faults > count { next }
    $2 ~ /too slow$/ { ++slow }
    $2 == "survived" {
      ++survivors
      new = $5
      for (i = 6; i <= NF; ++i) new = new "\t" $i
      line = 0
      while ((getline old < (tree "/" $3)) > 0 && ++line < $4) continue
      close(tree "/" $3)
      printf "%s:%d\n  - %s\n  + %s\n", $3, $4, old, new
    }
    END {
      if (faults == 0) { print "No fault was planted."; exit 0 }
      if (faults > count) faults = count
      share = 100 * survivors / faults
      printf "%d of %d faults survived (%.1f %%), %d were killed by their time alone; seed %d\n",
        survivors, faults, share, slow, seed
      exit share > most
    }'
}

say "Planting $count faults in ${#seen[@]} files ($(wc -l <"$work/candidates") lines can have one)"
started=$SECONDS
set -m
workers &
group=$!
set +m
wait "$group" 2>/dev/null
[ -z "${interrupted:-}" ] || wait "$group" 2>/dev/null
group=
say "$((SECONDS - started)) s"
summary
status=$?
[ -z "${interrupted:-}" ] || status=130
exit "$status"
