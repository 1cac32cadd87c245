#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Kills a program that edits and saves a case as the desktop does, at random moments, by INT, TERM, HUP, PIPE and KILL. The
# next start has to find the last edit that was noted, or the one in work, whole and nothing else; after the next save and a
# clean end nothing but the case may be there.
#   bench/kill_cases.sh PATH/TO/angiomesh-bench-cases [KILLS [RANDOM_SEED]]
# One line for each fault, then how many kills left none. Some 2 kills a second.
set -u
[ $# -ge 1 ] && [ -x "$1" ] ||
  { echo "usage: bench/kill_cases.sh PATH/TO/angiomesh-bench-cases [KILLS [RANDOM_SEED]]" >&2; exit 2; }
program=$(realpath "$1")
kills=${2:-400}
RANDOM=${3:-1}
scratch=$(mktemp -d)
n=0
trap 'rm -rf "$scratch"; [ $n -gt $kills ] || echo "ended at kill $n"' EXIT
cd "$scratch" || exit 2
mkdir data
places=(data/study.angiomesh data/recovery)
signals=(INT TERM HUP PIPE KILL)
faults=0
fault() { faults=$((faults + 1)); echo "kill $n, $signal: $1"; }
last_of() { awk -v what="$1" '$1 == what { n = $2 } END { print n + 0 }' said; }
# What is not part of a case that was closed.
left() {
  find data -mindepth 1 ! -path data/recovery ! -path data/study.angiomesh ! -path data/study.angiomesh/cache \
    ! -path 'data/study.angiomesh/case.json' ! -path 'data/study.angiomesh/case.previous.json' \
    ! -path 'data/study.angiomesh/cache/evolve.*' | head -1
}
edits=0
# A script's processes in the background are deaf to INT, and under nohup to HUP.
for ((n = 1; n <= kills; n++)); do
  signal=${signals[RANDOM % 5]}
  [ $((RANDOM % 4)) -eq 0 ] && rm -rf data/*
  env --default-signal=INT,TERM,HUP,PIPE "$program" edit "${places[@]}" --seed $RANDOM >said 2>stderr &
  process=$!
  sleep "0.$(printf '%03d' $((50 + RANDOM % 500)))"
  kill -$signal $process 2>/dev/null || fault "it ended by itself: $(tail -1 stderr)"
  wait $process 2>/dev/null
  noted=$(last_of noted) begun=$(last_of begin) opened=$(last_of opened)
  [ "$noted" -lt "$opened" ] && noted=$opened
  [ "$begun" -lt "$noted" ] && begun=$noted
  edits=$((edits + noted - opened))
  now=$("$program" state "${places[@]}" 2>stderr)
  now=${now#holds }
  if [ -z "$now" ]; then
    fault "$(tail -1 stderr)"
    rm -rf data/*
    continue
  fi
  # Killed before it had opened the case, it tells nothing.
  if grep -q . said && { [ "$now" -lt "$noted" ] || [ "$now" -gt "$begun" ]; }; then
    fault "the case holds edit $now; $noted was noted, $begun begun"
  fi
  hidden=$(find data/study.angiomesh -name '.angiomesh*' 2>/dev/null | head -1)
  [ -z "$hidden" ] || fault "after the next start $hidden is there"
  [ $((RANDOM % 2)) -eq 0 ] && continue
  "$program" end "${places[@]}" >/dev/null 2>stderr || fault "it does not open: $(tail -1 stderr)"
  rest=$(left)
  [ -z "$rest" ] || { fault "after the next end $rest is there"; rm -rf data/*; }
done
echo "$((kills - faults)) of $kills kills lost and left nothing; $edits edits were noted"
[ $faults -eq 0 ]
