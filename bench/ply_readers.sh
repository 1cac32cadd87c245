#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Opens a vessels.ply with ports, its text form and its OBJ file in the programs that are installed, and says what each
# of them sees: points, triangles and patches.
#   bench/ply_readers.sh PATH/TO/angiomesh-cli
# Debian 12: apt-get install --no-install-recommends python3-meshio python3-vtk9 meshlab blender xvfb
# ParaView takes the place of python3-vtk9 and of libvtk9-dev, so it belongs into a container of its own:
#            apt-get install --no-install-recommends paraview python3-paraview
set -u
[ $# -ge 1 ] && [ -x "$1" ] || { echo "usage: bench/ply_readers.sh PATH/TO/angiomesh-cli" >&2; exit 2; }
program=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 2
"$program" phantom bifurcation --size 40 --radius 3 -o case >/dev/null || exit 2
"$program" mesh case/truth.mha --cut-ends 3 -o vessels.ply >/dev/null 2>&1 || exit 2
"$program" convert vessels.ply --ascii -o text.ply >/dev/null 2>&1 || exit 2
"$program" convert vessels.ply -o vessels.obj >/dev/null 2>&1 || exit 2
count() { grep -a -m1 "^element $1 " vessels.ply | cut -d' ' -f3; }
points=$(count vertex)
triangles=$(count face)
patches=$(grep -a -c '^comment patch ' vessels.ply)
echo "vessels.ply: $points points, $triangles triangles, $patches patches"

cat >vtk_sees.py <<'PY'
def say(mesh):
    colours = mesh.GetCellData().GetArray("RGB")
    seen = {colours.GetTuple(i) for i in range(mesh.GetNumberOfCells())} if colours else ()
    print("sees", mesh.GetNumberOfPoints(), mesh.GetNumberOfCells(), len(seen), "colours of cells (RGB)")
PY
cat >with_vtk.py <<'PY'
import sys, vtk
from vtk_sees import say
reader = vtk.vtkPLYReader()
reader.SetFileName(sys.argv[1])
reader.Update()
say(reader.GetOutput())
PY
cat >with_paraview.py <<'PY'
import sys
from paraview import servermanager, simple
sys.path.insert(0, ".")
from vtk_sees import say
reader = simple.OpenDataFile(sys.argv[1])
reader.UpdatePipeline()
say(servermanager.Fetch(reader))
PY
cat >with_meshio.py <<'PY'
import sys, meshio
mesh = meshio.read(sys.argv[1])
patch = mesh.cell_data["patch"][0] if "patch" in mesh.cell_data else ()
print("sees", len(mesh.points), len(mesh.cells[0].data), len(set(patch)), "numbers of cells (patch)")
PY
cat >with_blender.py <<'PY'
import sys, bpy
bpy.ops.wm.read_factory_settings(use_empty=True)
if sys.argv[-1].endswith(".obj"):
    bpy.ops.import_scene.obj(filepath=sys.argv[-1], use_split_objects=False, use_split_groups=True)
else:
    bpy.ops.import_mesh.ply(filepath=sys.argv[-1])
meshes = [o.data for o in bpy.data.objects if o.type == "MESH"]
print("sees", sum(len(m.vertices) for m in meshes) if len(meshes) == 1 else "-",
      sum(len(m.polygons) for m in meshes), len(meshes) if len(meshes) > 1 else 0, "objects")
PY
cat >with_meshlab.sh <<'SH'
QT_QPA_PLATFORM=offscreen xvfb-run -a meshlabserver -i "$1" -o seen.off -m fc
awk 'NR == 2 { points = $1; faces = $2 }
     NR > 2 && $1 == 3 && NF >= 7 { colours[$5 " " $6 " " $7] }
     END { for (c in colours) n++; print "sees", points, faces, n + 0, "colours of faces" }' seen.off
SH

faults=0
# NAME FILE COMMAND...: its line "sees POINTS TRIANGLES PATCHES as what"
row() {
  local name=$1 file=$2
  shift 2
  command -v "$1" >/dev/null || { echo "$name: not installed"; return; }
  timeout 300 "$@" "$file" >log 2>&1
  local seen
  seen=$(grep -a '^sees ' log | tail -1)
  if [ -z "$seen" ]; then
    grep -aqE "No module named '(meshio|vtk)'" log && { echo "$name: not installed"; return; }
    echo "$name, $file: does not open: $(grep -a . log | tail -1)"
    faults=$((faults + 1))
    return
  fi
  local p t n as
  read -r _ p t n as <<<"$seen"
  [ "$t" = "$triangles" ] && { [ "$p" = "$points" ] || [ "$p" = - ]; } || faults=$((faults + 1))
  echo "$name, $file: $p points, $t triangles, patches: $n $as"
}
python=/usr/bin/python3
row meshio vessels.ply $python with_meshio.py
row meshio text.ply $python with_meshio.py
row VTK vessels.ply $python with_vtk.py
row ParaView vessels.ply pvbatch with_paraview.py
command -v meshlabserver >/dev/null && row MeshLab vessels.ply bash with_meshlab.sh
row Blender vessels.ply blender -b --factory-startup -P with_blender.py --
row Blender vessels.obj blender -b --factory-startup -P with_blender.py --
[ $faults -eq 0 ]
