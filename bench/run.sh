#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# run.sh [--quick] [-o DIR]
# Builds the benchmarks and writes their tables (Markdown) and plots (SVG) to DIR, by default
# bench-results/ in the current folder. --quick takes small volumes: a few minutes, not an hour.
set -u
. "$(dirname "${BASH_SOURCE[0]}")/../packaging/setup.sh"
build="$root/build/bench"
package_lists+=("$root/bench/packages.txt")
cmake_options+=(-DANGIOMESH_BUILD_BENCH=ON -DANGIOMESH_BUILD_GUI=OFF -DANGIOMESH_BUILD_TESTS=OFF)

quick=no
output=bench-results
while [ $# -gt 0 ]; do
  case "$1" in
    --quick) quick=yes ;;
    -o)
      [ $# -gt 1 ] || fail "-o needs a folder: use run.sh [--quick] [-o DIR]" 2
      shift
      output=$1
      ;;
    -h | --help)
      sed -n '3,5s/^# //p' "$0"
      exit 0
      ;;
    *) fail "unknown option, $1: use run.sh [--quick] [-o DIR]" 2 ;;
  esac
  shift
done

compile angiomesh-bench-segmentation angiomesh-bench-printed-method angiomesh-bench-surface \
  angiomesh-bench-io
mkdir -p "$output" || fail "cannot make the folder $output: check the permissions" 2
sizes=64,96,128,192,256 tree=256 trees=(1 2 3)
if [ "$quick" = yes ]; then sizes=48,64,96 tree=96 trees=(1); fi
threads=1
if [ "$(nproc)" -gt 1 ]; then threads=1,2; fi

"$build/bin/angiomesh-bench-segmentation" --size "$sizes" --threads "$threads" \
  --thread-size "$((tree / 2))" -o "$output" >/dev/null ||
  fail "the benchmark of the segmentation failed: see the lines above"
"$build/bin/angiomesh-bench-io" -o "$output" >/dev/null ||
  fail "the benchmark of reading failed: see the lines above"
for rule in false true; do
  printf 'The printed method, levelset.acrossCrests=%s\n\n' "$rule"
  "$build/bin/angiomesh-bench-printed-method" --clip --set levelset.acrossCrests="$rule" \
    --size "$tree" \
    --random-seed "${trees[@]}" || fail "the comparison with the printed method failed: see above"
  printf '\n'
done >"$output/printed-method.md"
say "Tables and plots: $output"
cat "$output/segmentation.md" "$output/io.md" "$output/printed-method.md"
