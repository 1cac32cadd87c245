// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/error.h"
#include "io/polygon_mesh.h"

/// The mesh readers; the first byte chooses which one.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace angiomesh;
  if (size == 0) return 0;
  const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    PolygonMesh mesh;
    switch (data[0] % 5) {
      case 0:
        mesh = readPly(bytes, "input.ply");
        break;
      case 1:
        mesh = readStl(bytes, "input.stl");
        break;
      case 2:
        mesh = readObj(bytes, "input.obj");
        break;
      case 3:
        mesh = readVtkPolyData(bytes, "input.vtp");
        break;
      default:
        mesh = readLegacyVtk(bytes, "input.vtk");
    }
  } catch (const Error&) {
    return 0;
  }
  return 0;
}
