#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# run.sh [SECONDS] [TARGET...]
# Builds the readers under libFuzzer with the sanitizers and runs each target (fuzz_dicom, fuzz_image,
# fuzz_mesh) for SECONDS, by default 60, from the corpus that is kept beside this script. What breaks
# a reader is left in build/fuzz/found/. New inputs go to build/fuzz/corpus/TARGET.
set -u
. "$(dirname "${BASH_SOURCE[0]}")/../packaging/setup.sh"
build="$root/build/fuzz"
package_lists+=("$root/fuzz/packages.txt")
cmake_options+=(-DCMAKE_CXX_COMPILER=clang++ -DANGIOMESH_BUILD_FUZZ=ON -DANGIOMESH_BUILD_GUI=OFF
  -DANGIOMESH_BUILD_TESTS=OFF)

seconds=60
case "${1:-}" in
  -h | --help)
    sed -n '3,6s/^# //p' "$0"
    exit 0
    ;;
  [0-9]*)
    seconds=$1
    shift
    ;;
esac
targets=("$@")
[ $# -gt 0 ] || targets=(fuzz_dicom fuzz_image fuzz_mesh)

compile "${targets[@]}"
mkdir -p "$build/found"
status=0
for target in "${targets[@]}"; do
  mkdir -p "$build/corpus/$target"
  # A reader may take memory as the input justifies, and no more: the inputs are small.
  ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=0 "$build/bin/$target" \
    -max_total_time="$seconds" -timeout=10 -rss_limit_mb=1024 -malloc_limit_mb=512 -max_len=65536 \
    -artifact_prefix="$build/found/$target-" -print_final_stats=1 -verbosity=0 \
    "$build/corpus/$target" "$root/fuzz/corpus/$target" >"$build/$target.log" 2>&1
  code=$?
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$build/$target.log")
  if [ "$code" -ne 0 ]; then
    grep -v '^$' "$build/$target.log" | tail -n 40 >&2
    say "$target broke a reader: the input is in $build/found/"
    status=1
  else
    say "$target: ${runs:-no} inputs in $seconds s, none broke a reader"
  fi
done
exit "$status"
