#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# run.sh [--installed] [SECONDS] [TARGET...]
# Builds the readers under libFuzzer with the sanitizers and runs each target (fuzz_case, fuzz_dicom,
# fuzz_image, fuzz_labels, fuzz_mesh, fuzz_parameters) for SECONDS, by default 60, from the corpus that
# is kept beside this script. What breaks a reader is left in build/fuzz/found/. New inputs go to
# build/fuzz/corpus/TARGET. Installs clang where it is missing; with --installed, does nothing there.
set -u
. "$(dirname "${BASH_SOURCE[0]}")/../packaging/setup.sh"
build="$root/build/fuzz"
cmake_options+=(-DCMAKE_CXX_COMPILER=clang++ -DANGIOMESH_BUILD_FUZZ=ON -DANGIOMESH_BUILD_GUI=OFF
  -DANGIOMESH_BUILD_TESTS=OFF)

has_libfuzzer() {
  echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' |
    clang++ -fsanitize=fuzzer,address,undefined -x c++ - -o /dev/null 2>/dev/null
}

installed=
seconds=60
while [ $# -gt 0 ]; do
  case "$1" in
    -h | --help)
      sed -n '3,7s/^# //p' "$0"
      exit 0
      ;;
    --installed) installed=1 ;;
    [0-9]*) seconds=$1 ;;
    *) break ;;
  esac
  shift
done
targets=("$@")
[ $# -gt 0 ] || targets=(fuzz_case fuzz_dicom fuzz_image fuzz_labels fuzz_mesh fuzz_parameters)

if ! has_libfuzzer; then
  if [ -n "$installed" ]; then
    say "The fuzzers are skipped: there is no clang++ with libFuzzer."
    exit 0
  fi
  package_lists+=("$root/fuzz/packages.txt")
fi

compile "${targets[@]}"
mkdir -p "$build/found"
# Cases are written and forced to the medium, which memory does at once.
TMPDIR=$(mktemp -d -p /dev/shm 2>/dev/null || mktemp -d) || fail "cannot make a temporary folder" 2
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT
status=0
for target in "${targets[@]}"; do
  mkdir -p "$build/corpus/$target"
  # DCMTK is slow, and long inputs make it slower.
  longest=16384
  [ "$target" != fuzz_dicom ] || longest=8192
  # A reader may take memory as the input justifies, and no more: the inputs are small. The readers
  # turn the standard streams off for a while, so reports go to a copy of them (close_fd_mask). Leaks
  # are looked for at the end: after each input, those of the libraries would take most of the time; they
  # add up, and the limit of all memory leaves room for them. The limit of time is by the clock: on a
  # busy machine an input of a tenth of a second of work has taken ten.
  ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=0 UBSAN_OPTIONS=print_stacktrace=1 \
    LSAN_OPTIONS=suppressions="$root/fuzz/leaks.supp":print_suppressions=0 \
    "$build/bin/$target" -detect_leaks=0 \
    -max_total_time="$seconds" -timeout=60 -rss_limit_mb=2048 -malloc_limit_mb=512 \
    -max_len="$longest" -dict="$root/fuzz/$target.dict" -artifact_prefix="$build/found/$target-" \
    -print_final_stats=1 -close_fd_mask=3 \
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
