#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Kills `run`, `run --force` and `convert --openfoam --force` at random moments by INT, TERM, HUP, PIPE and KILL, and looks
# at what is left: a whole result or none, and after the next start nothing hidden.
#   bench/kill_runs.sh PATH/TO/angiomesh-cli [KILLS [RANDOM_SEED]]
# One line for each fault, then how many kills left none. Some 2 kills a second.
set -u
[ $# -ge 1 ] && [ -x "$1" ] ||
  { echo "usage: bench/kill_runs.sh PATH/TO/angiomesh-cli [KILLS [RANDOM_SEED]]" >&2; exit 2; }
program=$(realpath "$1")
kills=${2:-2000}
RANDOM=${3:-1}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 2
"$program" phantom bifurcation --size 40 --radius 3 --noise 20 -o case >/dev/null || exit 2
run=(run case/image.mha --set segmentation.keep=largest)
one=(--set smooth.method=none) two=(--set smooth.method=taubin)
# Without what tells the time.
sums() { (cd "$1" && find . -type f ! -name report.json ! -name '*.png' -exec md5sum {} + | sort); }
"$program" "${run[@]}" "${one[@]}" -o one >/dev/null || exit 2
"$program" "${run[@]}" "${two[@]}" -o two >/dev/null || exit 2
"$program" mesh case/truth.mha --cut-ends 3 -o cut.ply >/dev/null 2>&1 || exit 2
"$program" convert cut.ply --openfoam -o foam-one >/dev/null 2>&1 || exit 2
sums one >one.sums; sums two >two.sums; sums foam-one >foam.sums
start=$(date +%s%N)
"$program" "${run[@]}" "${one[@]}" -o time >/dev/null
whole=$((($(date +%s%N) - start) / 1000000))
signals=(INT TERM HUP PIPE KILL)
faults=0
fault() { faults=$((faults + 1)); echo "kill $n, $signal, $what: $1"; }
hidden() { find . -mindepth 1 -maxdepth 2 -name '.angiomesh*' | head -1; }
for ((n = 1; n <= kills; n++)); do
  signal=${signals[RANDOM % 5]}
  case $((RANDOM % 3)) in
    0) what=run; place=new; call=("${run[@]}" "${one[@]}" -o new) ;;
    1) what="run --force"; place=forced; call=("${run[@]}" "${two[@]}" -o forced --force)
       [ -d forced ] || cp -r one forced ;;
    2) what="convert --openfoam --force"; place=foam; call=(convert cut.ply --openfoam -o foam --force)
       [ -d foam ] || cp -r foam-one foam ;;
  esac
  "$program" "${call[@]}" >/dev/null 2>stderr &
  process=$!
  most=$whole
  [ $place = foam ] && most=$((whole / 4 + 50))
  sleep "$(printf '0.%03d' $((RANDOM % (most * 11 / 10) % 1000)))"
  kill -$signal $process 2>/dev/null
  wait $process 2>/dev/null
  code=$?
  # 128 and the signal: it came before the program had begun.
  case $code in 0 | 4 | 129 | 130 | 137 | 141 | 143) ;; *) fault "exit code $code, $(tail -1 stderr)" ;; esac
  # The next start finishes or clears; without --force it replaces nothing.
  case $place in
    foam) timeout 60 "$program" convert cut.ply --openfoam -o foam --force >/dev/null 2>&1 ;;
    *) timeout -s INT 60 "$program" "${run[@]}" --until preprocess -o $place >/dev/null 2>&1 ;;
  esac
  left=$(hidden)
  [ -z "$left" ] || fault "$left is left"
  case $place in
    new) [ -f new/vessels.ply ] && { sums new >now.sums; cmp -s now.sums one.sums || fault "a part of a result"; }
         rm -rf new ;;
    forced) sums forced >now.sums
         cmp -s now.sums one.sums || cmp -s now.sums two.sums || fault "two results mixed"
         [ $((RANDOM % 2)) -eq 0 ] && rm -rf forced ;;
    foam) sums foam >now.sums; cmp -s now.sums foam.sums || fault "the case is not whole" ;;
  esac
  rm -rf .angiomesh-*
done
echo "$((kills - faults)) of $kills kills left nothing behind"
[ $faults -eq 0 ]
