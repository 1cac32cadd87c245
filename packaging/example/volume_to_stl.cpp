// SPDX-License-Identifier: BSD-3-Clause
#include <angiomesh/parameters.h>
#include <angiomesh/pipeline.h>
#include <angiomesh/quality.h>
#include <angiomesh/readers.h>
#include <angiomesh/writers.h>

#include <iostream>

// volume-to-stl IMAGE STL: the vessels of an angiogram as a surface, LPS mm.
int main(int argc, char** argv) {
  using namespace angiomesh;
  if (argc != 3) {
    std::cerr << "usage: volume-to-stl IMAGE STL\n";
    return 2;
  }
  try {
    LoadedImage input = readImage(argv[1]);
    Pipeline pipeline(makeSource(std::move(input.image), "scan"));
    Parameters params = preset("angiomesh");
    setFieldFromText(params, "segmentation.keep", "largest");
    const RunResult result = pipeline.run(params);
    writeMesh(*result.smoothed, argv[2]);
    std::cout << result.smoothed->triangles.size() << " triangles, "
              << result.quality->mesh.volumeMm3 << " mm3\n";
  } catch (const Error& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
