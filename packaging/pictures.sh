#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# pictures.sh [--bin DIR] [-o DIR]
# Makes the pictures of the documentation from phantoms, by the programs themselves, in docs/pictures
# (or DIR). Builds the programs first, unless --bin names a folder that holds them. Needs ImageMagick
# (Debian package imagemagick) to crop and join what the programs draw.
set -u
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

bin=
pictures="$root/docs/pictures"
while [ $# -gt 0 ]; do
  case "$1" in
    --bin | -o)
      [ $# -gt 1 ] || fail "$1 needs a folder: use pictures.sh [--bin DIR] [-o DIR]" 2
      if [ "$1" = -o ]; then pictures=$2; else bin=$2; fi
      shift
      ;;
    -h | --help)
      sed -n '3,6s/^# //p' "$0"
      exit 0
      ;;
    *) fail "unknown option, $1: use pictures.sh [--bin DIR] [-o DIR]" 2 ;;
  esac
  shift
done

for tool in convert montage import; do
  command -v "$tool" >/dev/null || fail "$tool is missing: apt-get install imagemagick" 2
done
if [ -z "$bin" ]; then
  compile angiomesh angiomesh-cli angiomesh-pictures window-states
  bin="$build/bin"
fi
for program in angiomesh angiomesh-cli angiomesh-pictures window-states; do
  [ -x "$bin/$program" ] || fail "no program, $bin/$program: build it, or name its folder" 2
done
mkdir -p "$pictures" || fail "cannot make the folder $pictures: check the permissions" 2
bin=$(realpath -- "$bin")
pictures=$(realpath -- "$pictures")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# The commands' output goes to a log; the end of it is shown when one fails.
do_or_fail() {
  "$@" >log 2>&1 </dev/null || {
    tail -n 20 log >&2
    fail "could not make a picture: $*"
  }
}
cli() { do_or_fail "$bin/angiomesh-cli" "$@"; }
on_screen() { do_or_fail xvfb-run -a -s "-screen 0 1440x900x24" "$@"; }
snapshot() { on_screen "$bin/angiomesh-cli" snapshot "$@"; }

# phantom NAME OPTION...: NAME/image.mha
phantom() {
  local name=$1
  shift
  cli phantom "$@" -o "$name"
}
# The surface of a run in a folder of its own, so that it is drawn without the volume's outline.
surface() {
  mkdir -p "$2"
  cp "$1" "$2/vessels.ply"
}
# finish PICTURE [COLOURS]: no metadata, and a palette where it does not show, keep the files small.
finish() {
  local palette=()
  [ $# -lt 2 ] || palette=(+dither -colors "$2" -type Palette)
  do_or_fail convert "$1" -strip -depth 8 ${palette[@]+"${palette[@]}"} -define png:compression-level=9 \
    "$pictures/$1"
}
# row PICTURE FILE...: side by side
row() {
  local picture=$1
  shift
  do_or_fail convert "$@" -bordercolor '#3a3c42' -border 2 +append "$picture"
}

say "overview: the scan, the surface, the triangles"
phantom tree tree --size 128 --noise 20
cli run tree/image.mha -o tree-run --set segmentation.keep=largest
surface tree-run/vessels.ply Angiomesh
snapshot Angiomesh -o whole.png
snapshot Angiomesh --at 74.5,52.5,68.5 --width 13 --edges -o near.png
do_or_fail convert tree-run/preview.png -crop 480x480+8+8 +repage -resize 440x440 scan.png
do_or_fail convert whole.png -crop 700x700+0+50 +repage -resize 440x440 surface.png
do_or_fail convert near.png -crop 560x560+70+620 +repage -resize 440x440 triangles.png
row overview.png scan.png surface.png triangles.png
finish overview.png 256

say "triangles: marching cubes and Angiomesh on the same level set"
surface tree-run/marching-cubes.ply 'marching cubes'
snapshot 'marching cubes' Angiomesh --at 74.5,52.5,68.5 --width 13 --edges -o triangles.png
do_or_fail convert triangles.png -resize 1000x triangles.png
finish triangles.png 64

say "wall: placed voxel by voxel, and as smooth as the vessel"
phantom tree-noise vessel-tree --size 96 --radius 4 --noise 60 --random-seed 5
cli run tree-noise/image.mha -o rough-run --set wall.smooth=false --set segmentation.keep=largest
cli run tree-noise/image.mha -o smooth-run --set segmentation.keep=largest
surface rough-run/vessels.ply 'wall.smooth=false'
surface smooth-run/vessels.ply 'wall.smooth=true'
snapshot 'wall.smooth=false' 'wall.smooth=true' --at 54.3,44.1,70.1 --width 30 -o wall.png
do_or_fail convert wall.png -resize 1000x wall.png
finish wall.png 128

say "preview: what run draws without a display"
do_or_fail convert smooth-run/preview.png -resize 900x preview.png
finish preview.png 96

say "ports: flat openings with sharp rims"
phantom fork bifurcation --size 80 --radius 7 --noise 20 --axis 0.2,-1,0.9
cli run fork/image.mha -o fork-run --cut-borders
surface fork-run/vessels.ply fork
snapshot fork -o fork.png
snapshot fork --at 16.1,4.8,70.8 --width 17 --edges -o cap.png
do_or_fail convert fork.png -crop 700x700+0+20 +repage -resize 500x500 fork.png
do_or_fail convert cap.png -crop 560x560+70+620 +repage -resize 500x500 cap.png
row ports.png fork.png cap.png
finish ports.png 128

say "phantoms"
kinds=(tree vessel-tree capsule-tree bifurcation kissing bent-tube
  stenosis neck-aneurysm aneurysm cone helix torus)
drawn=()
mkdir -p drawn
for kind in "${kinds[@]}"; do
  phantom "of-$kind" "$kind" --size 80 --radius 5
  cli run "of-$kind/image.mha" -o "of-$kind-run" --allow-unsound
  surface "of-$kind-run/vessels.ply" "drawn/$kind"
  drawn+=("drawn/$kind")
done
snapshot "${drawn[@]:0:6}" --at 40,40,40 --width 100 -o first.png
snapshot "${drawn[@]:6}" --at 40,40,40 --width 100 -o second.png
do_or_fail convert first.png second.png -crop 4200x600+0+0 +repage -crop 700x600 +repage \
  -gravity center -crop 480x600+0+0 +repage kind-%02d.png
do_or_fail montage kind-*.png -tile 4x -geometry 300x375+1+1 -background '#3a3c42' phantoms.png
finish phantoms.png 96

say "desktop: the window after a run"
# desktop PICTURE INPUT: the window when it has not changed for nine seconds
cat >desktop.sh <<'SH'
export HOME=$PWD/home XDG_RUNTIME_DIR=$PWD/home
mkdir -p -m 700 "$HOME"
"$1" --run "$2" &
program=$!
last= same=0
for _ in $(seq 60); do
  sleep 3
  import -window root "$3"
  now=$(identify -format '%#' "$3")
  if [ "$now" = "$last" ]; then same=$((same + 1)); else same=0; fi
  if [ "$same" -ge 3 ]; then break; fi
  last=$now
done
kill "$program"
[ "$same" -ge 3 ]
SH
phantom desktop vessel-tree --size 112 --radius 4.6 --noise 30 --random-seed 5
on_screen bash desktop.sh "$bin/angiomesh" desktop/image.mha desktop.png
finish desktop.png 128

say "states: the window in all that it can show"
mkdir -p "$pictures/states" shots
export HOME=$work/home XDG_RUNTIME_DIR=$work/home
for language in en de tr; do
  do_or_fail xvfb-run -a -s "-screen 0 1280x800x24" "$bin/window-states" shots "$language"
done
for shot in shots/*.png; do
  mv "$shot" .
  finish "${shot##*/}" 96
  mv "$pictures/${shot##*/}" "$pictures/states/"
done

say "Written to $pictures:"
du -ch "$pictures"/*.png "$pictures"/states/*.png >&2
