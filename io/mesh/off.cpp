// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/error.h"
#include "io/file/files.h"
#include "io/file/mesh_text.h"
#include "io/file/text_scanner.h"
#include "io/mesh/polygon_mesh.h"

namespace angiomesh {
namespace {

/// The lines that say something; comments go to the header.
class OffLines {
 public:
  OffLines(std::string_view text, MeshHeader& header) : lines_(text), header_(header) {}

  TextScanner next() {
    while (!lines_.done()) {
      const std::string_view line = lines_.line();
      const std::size_t comment = line.find('#');
      if (comment != std::string_view::npos) header_.read(line.substr(comment));
      const std::string_view said = line.substr(0, comment);
      if (said.find_first_not_of(" \t") != std::string_view::npos) return TextScanner(said);
    }
    return TextScanner({});
  }

 private:
  TextScanner lines_;
  MeshHeader& header_;
};

/// A number from 0 to `most`. @throws InputError
std::size_t count(TextScanner& line, double most, const char* what,
                  const std::filesystem::path& path) {
  double value = -1.0;
  if (!line.number(value, false) || value < 0.0 || value > most ||
      value != static_cast<double>(static_cast<std::size_t>(value)))
    throw InputError(std::string("the OFF file has ") + what + " that cannot be", path.string(),
                     "copy it again or write it with another program");
  return static_cast<std::size_t>(value);
}

}  // namespace

PolygonMesh readOff(const std::string& bytes, const std::filesystem::path& path) {
  PolygonMesh mesh;
  OffLines lines(bytes, mesh.header);
  TextScanner line = lines.next();
  const std::string_view kind = line.word();
  if (kind != "OFF" && kind != "COFF" && kind != "NOFF" && kind != "CNOFF")
    throw InputError("not an OFF file of three dimensions", path.string(),
                     "write it as plain OFF, or as PLY");
  if (line.word() == "BINARY")
    throw InputError("binary OFF files are not read", path.string(), "write it as text, or as PLY");
  mesh.hasNormals = kind.find('N') != std::string_view::npos;
  line = lines.next();
  // A point and a face take at least six bytes each.
  const auto most = static_cast<double>(bytes.size());
  const std::size_t points = count(line, most, "a number of points", path);
  const std::size_t faces = count(line, most, "a number of faces", path);
  for (std::size_t n = 0; n < points; ++n) {
    line = lines.next();
    if (line.done())
      throw IoError("the OFF file ends within its points", path.string(), kCopyAgain);
    Eigen::Vector3d p;
    for (int a = 0; a < 3; ++a)
      if (!line.number(p[a], false))
        throw InputError("point " + std::to_string(n) + " of the OFF file is not usable",
                         path.string(), "copy it again or write it with another program");
    mesh.points.push_back(p);
  }
  for (std::size_t n = 0; n < faces; ++n) {
    line = lines.next();
    if (line.done()) throw IoError("the OFF file ends within its faces", path.string(), kCopyAgain);
    const std::size_t corners = count(line, most, "a face with a number of corners", path);
    std::vector<std::uint32_t> polygon;
    for (std::size_t k = 0; k < corners; ++k)
      polygon.push_back(static_cast<std::uint32_t>(
          count(line, static_cast<double>(points) - 1.0, "a face with a point", path)));
    // Points and edges by themselves are no surface.
    if (corners >= 3) mesh.polygons.push_back(std::move(polygon));
  }
  if (!lines.next().done())
    mesh.remarks.push_back("the OFF file goes on after its last face, which is left out");
  return mesh;
}

std::string offBytes(const WritableMesh& mesh) {
  std::string text = "OFF\n# Angiomesh\n# " + headerWords(mesh.options, "\n# ") + "\n";
  text += std::to_string(mesh.mesh.points.size()) + " " +
          std::to_string(mesh.mesh.triangles.size()) + " 0\n";
  for (const Eigen::Vector3d& p : mesh.mesh.points)
    for (int a = 0; a < 3; ++a) {
      appendShortest(text, p[a]);
      text += a < 2 ? ' ' : '\n';
    }
  for (const auto& t : mesh.mesh.triangles)
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) +
            "\n";
  return text;
}

}  // namespace angiomesh
