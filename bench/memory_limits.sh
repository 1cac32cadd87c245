#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs the commands under limits of memory: each has to end with exit code 0 or 2, in time, and to leave all of its
# files or none.
#   bench/memory_limits.sh PATH/TO/angiomesh-cli [FIRST_MB [LAST_MB [STEP_MB [VOXELS]]]]
# One line for each call that does not, then how many did. The volume is a vessel tree of VOXELS^3, 64 unless given. A limit
# takes some 12 s of processor time, of 40^3 voxels 3 s: from 120 to 1024 MB in steps of 1 that is 3 hours, or less than one.
set -u
[ $# -ge 1 ] && [ -x "$1" ] || { echo "usage: bench/memory_limits.sh PATH/TO/angiomesh-cli [FIRST [LAST [STEP [VOXELS]]]]" >&2; exit 2; }
program=$(realpath "$1")
first=${2:-120} last=${3:-1024} step=${4:-1} voxels=${5:-64}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 2
"$program" phantom vessel-tree --size "$voxels" --radius "$(awk "BEGIN { print $voxels / 16 }")" --noise 20 -o case >/dev/null || exit 2
calls=("info case/image.mha" "run case/image.mha -o out" "mesh case/truth.mha -o out.ply")
for method in level-set geodesic-active-contour confidence-connected threshold; do
  calls+=("segment case/image.mha -o out.nrrd --method $method")
done
all=0 bad=0
for ((limit = first; limit <= last; limit += step)); do
  for call in "${calls[@]}"; do
    all=$((all + 1))
    # shellcheck disable=SC2086
    (ulimit -v $((limit * 1024)) -c 0; exec timeout -s KILL 300 "$program" --threads 2 $call) >stdout 2>stderr
    code=$?
    left=$(ls -A | grep -vx 'case\|stdout\|stderr')
    if { [ $code -ne 0 ] && [ $code -ne 2 ]; } || { [ $code -eq 2 ] && [ -n "$left" ]; }; then
      bad=$((bad + 1))
      echo "$limit MB, $call: exit code $code, $(tail -1 stderr | cut -c1-120) ${left:+(left: $left)}"
    fi
    rm -rf out out.ply out.nrrd .angiomesh-*
  done
done
echo "$((all - bad)) of $all calls ended as they have to"
[ $bad -eq 0 ]
