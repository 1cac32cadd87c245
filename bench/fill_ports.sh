#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Fills surfaces with tetrahedra by Gmsh, as they are: what `angiomesh-cli study ports -o DIR` wrote. Each
# has to be in one piece: of scans, with --set segmentation.keep=largest.
#   bench/fill_ports.sh DIR
# One line for each that is not filled, then how many were. Debian: apt-get install gmsh
set -eu
[ $# -eq 1 ] && [ -d "$1" ] || { echo "usage: bench/fill_ports.sh DIR" >&2; exit 2; }
command -v gmsh >/dev/null || { echo "gmsh is not installed: apt-get install gmsh" >&2; exit 2; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
all=0
filled=0
for surface in "$1"/*.stl; do
  all=$((all + 1))
  cp "$surface" "$scratch/surface.stl"
  cat >"$scratch/fill.geo" <<'GEO'
Merge "surface.stl";
sides() = Surface{:};
Surface Loop(1) = sides();
Volume(1) = {1};
GEO
  rm -f "$scratch/filled.msh"
  if timeout 900 gmsh -3 "$scratch/fill.geo" -o "$scratch/filled.msh" -format msh2 \
      >"$scratch/log" 2>&1 && awk '
        /^\$Elements/ { getline; inside = 1; next }
        /^\$EndElements/ { inside = 0 }
        inside && $2 == 4 { tetrahedra++ }
        END { exit tetrahedra > 0 ? 0 : 1 }' "$scratch/filled.msh"; then
    filled=$((filled + 1))
  else
    echo "$(basename "$surface"): not filled: $(grep -iE 'error' "$scratch/log" | head -1)"
  fi
done
echo "$filled of $all surfaces filled without a repair"
