#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# run.sh [--headless] [INPUT]
# Builds Angiomesh and opens INPUT (an image file or a DICOM folder; without one, the built-in
# sample) in the desktop program, running. Without a display, or with --headless, runs the whole
# pipeline and writes the result to angiomesh-out/<name>/ in the current folder.
set -u
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

headless=no
input=
while [ $# -gt 0 ]; do
  case "$1" in
    --headless) headless=yes ;;
    -h | --help)
      sed -n '3,6s/^# //p' "$0"
      exit 0
      ;;
    --)
      shift
      break
      ;;
    -*) fail "unknown option, $1: use run.sh [--headless] [INPUT]" 2 ;;
    *)
      [ -z "$input" ] || fail "more than one input, $1: give one file or folder" 2
      input=$1
      ;;
  esac
  shift
done
if [ $# -gt 0 ]; then
  [ $# -eq 1 ] && [ -z "$input" ] || fail "more than one input, $1: give one file or folder" 2
  input=$1
fi
if [ -n "$input" ] && [ ! -e "$input" ]; then
  fail "no such file or folder, $input: check the name" 2
fi

compile angiomesh angiomesh-cli angiomesh-display-check
cli="$build/bin/angiomesh-cli"

truth=()
if [ -z "$input" ]; then
  name=sample
  input="$build/sample/image.mha"
  truth=(--truth "$build/sample/truth.mha")
  if [ ! "$build/sample/truth.json" -nt "$cli" ]; then
    "$cli" phantom tree --size 128 --noise 20 -o "$build/sample" >/dev/null ||
      fail "the built-in sample could not be made"
  fi
else
  input=$(realpath -- "$input") || fail "cannot resolve the input, $input: check the name" 2
  name=$(basename -- "$input")
  if [ ! -d "$input" ]; then
    name=${name%.gz}
    case "$name" in ?*.*) name=${name%.*} ;; esac
  fi
fi

display_opens() {
  [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] || return 1
  # The outer braces keep the shell's own word about an aborted program off the terminal.
  {
    (
      ulimit -c 0
      env -u QT_QPA_PLATFORM timeout 20 "$build/bin/angiomesh-display-check"
    ) >/dev/null 2>&1
  } 2>/dev/null
}

if [ "$headless" = no ] && display_opens; then
  say "Opening the desktop program"
  exec env -u QT_QPA_PLATFORM "$build/bin/angiomesh" --run "$input"
fi
[ "$headless" = yes ] || say "No display opens here: running without one."

out="angiomesh-out/$name"
"$cli" run "$input" -o "$out" --force "${truth[@]}" || exit $?
if [ -f "$out/vessels.ply" ]; then
  xvfb-run -a -s "-screen 0 1280x900x24" "$cli" snapshot "$out" -o "$out/surface.png" >/dev/null ||
    fail "the surface was computed but its picture could not be rendered, $out/surface.png"
fi
printf '\nWritten to %s/:\n' "$out"
for file in vessels.ply vessels.stl report.json preview.png surface.png; do
  [ ! -f "$out/$file" ] || printf '  %-12s %s\n' "$file" "$(du -h "$out/$file" | cut -f 1)"
done
