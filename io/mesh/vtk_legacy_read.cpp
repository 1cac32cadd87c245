// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <map>

#include "core/base/error.h"
#include "io/file/mesh_number.h"
#include "io/mesh/mesh_patch.h"
#include "io/mesh/polygon_mesh.h"
#include "io/mesh/vtp_data.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

/// VTK's own reader crashes on damaged lists of cells.
class LegacyReader {
 public:
  LegacyReader(const std::string& bytes, const fs::path& path) : text_(bytes), path_(path) {}

  PolygonMesh read() {
    readHeader();
    for (std::string_view word = text_.word(); !word.empty(); word = text_.word()) {
      if (word == "DATASET") {
        if (text_.word() != "POLYDATA")
          throw InputError("the VTK file does not hold a surface", path_.string(),
                           "give a file with DATASET POLYDATA");
      } else if (word == "POINTS") {
        readPoints();
      } else if (word == "VERTICES" || word == "LINES") {
        others_ += readCells().size();
      } else if (word == "POLYGONS") {
        for (auto& polygon : readCells()) mesh_.polygons.push_back(std::move(polygon));
      } else if (word == "TRIANGLE_STRIPS") {
        for (auto& strip : readCells()) strips_.push_back(std::move(strip));
      } else if (word == "METADATA") {
        skipMetadata();
      } else if (word == "FIELD") {
        skipField();
      } else if (word == "POINT_DATA" || word == "CELL_DATA") {
        mesh_.hasNormals = text_.rest().find("\nNORMALS ") != std::string_view::npos;
        mesh_.hasQuality = text_.rest().find("\nSCALARS quality ") != std::string_view::npos;
        findFaces(word);
        break;
      } else {
        throwTruncated(path_);
      }
    }
    if (!faces_.empty()) takeFaces();
    for (const auto& strip : strips_) appendStrip(strip, mesh_.polygons);
    if (!faces_.empty() && entities_)
      groupByEntity(mesh_, faces_);
    else if (!faces_.empty())
      groupByNumber(mesh_, faces_, {}, "face_");
    return std::move(mesh_);
  }

 private:
  using Cells = std::vector<std::vector<std::uint32_t>>;

  void readHeader() {
    const std::string_view first = text_.line();
    newCells_ = first.find("Version 5") != std::string_view::npos;
    mesh_.header.read(text_.line());
    const std::string_view encoding = text_.word();
    if (encoding != "ASCII" && encoding != "BINARY") throwTruncated(path_);
    encoding_ = encoding == "ASCII" ? Encoding::Ascii : Encoding::BigEndian;
  }

  Scalar typeOf(std::string_view name) const {
    static const std::map<std::string_view, Scalar> types = {{"char", Scalar::Int8},
                                                             {"signed_char", Scalar::Int8},
                                                             {"unsigned_char", Scalar::Uint8},
                                                             {"short", Scalar::Int16},
                                                             {"unsigned_short", Scalar::Uint16},
                                                             {"int", Scalar::Int32},
                                                             {"vtkIdType", Scalar::Int32},
                                                             {"vtktypeint32", Scalar::Int32},
                                                             {"unsigned_int", Scalar::Uint32},
                                                             {"long", Scalar::Int64},
                                                             {"vtktypeint64", Scalar::Int64},
                                                             {"unsigned_long", Scalar::Uint64},
                                                             {"vtktypeuint64", Scalar::Uint64},
                                                             {"float", Scalar::Float32},
                                                             {"double", Scalar::Float64}};
    const auto found = types.find(name);
    if (found == types.end()) throwTruncated(path_);
    return found->second;
  }

  std::size_t takeCount() {
    double count = -1.0;
    if (!text_.number(count) || !(count >= 0.0) || count > 1e12) throwTruncated(path_);
    return static_cast<std::size_t>(count);
  }

  /// Stands before a block of `count` numbers afterwards. Refuses more than the file can hold, so
  /// that no memory is reserved for nonsense.
  void beginBlock(std::size_t count, Scalar type) {
    text_.line();
    const std::size_t each = encoding_ == Encoding::Ascii ? 2 : bytesOf(type);
    if (count > (text_.rest().size() + 1) / each) throwTruncated(path_);
  }

  double take(Scalar type) { return takeNumber(text_, encoding_, type, path_); }

  std::uint32_t takeIndex(Scalar type) {
    const double value = take(type);
    if (!(value >= 0.0) || value >= std::numeric_limits<std::uint32_t>::max())
      throw InputError("a face names a point that does not exist", path_.string(),
                       "write the mesh again with another program");
    return static_cast<std::uint32_t>(value);
  }

  void readPoints() {
    const std::size_t count = takeCount();
    const Scalar type = typeOf(text_.word(false));
    beginBlock(3 * count, type);
    mesh_.points.resize(count);
    for (Eigen::Vector3d& point : mesh_.points)
      for (int a = 0; a < 3; ++a) point[a] = take(type);
  }

  Cells readCells() {
    const std::size_t count = takeCount();
    const std::size_t numbers = takeCount();
    return newCells_ ? readOffsets(count, numbers) : readCounted(count, numbers);
  }

  /// Each cell is the number of its corners and the corners.
  Cells readCounted(std::size_t count, std::size_t numbers) {
    beginBlock(numbers, Scalar::Int32);
    Cells cells;
    for (std::size_t c = 0; c < count; ++c) {
      if (numbers == 0) throwTruncated(path_);
      const std::uint32_t corners = takeIndex(Scalar::Int32);
      if (corners > --numbers) throwTruncated(path_);
      numbers -= corners;
      std::vector<std::uint32_t> cell(corners);
      for (std::uint32_t& corner : cell) corner = takeIndex(Scalar::Int32);
      cells.push_back(std::move(cell));
    }
    if (numbers != 0) throwTruncated(path_);
    return cells;
  }

  /// File version 5: where each cell begins, then all corners.
  Cells readOffsets(std::size_t count, std::size_t numbers) {
    if (count == 0) return {};
    if (text_.word() != "OFFSETS") throwTruncated(path_);
    Scalar type = typeOf(text_.word(false));
    beginBlock(count, type);
    std::vector<std::uint32_t> ends(count);
    for (std::uint32_t& end : ends) end = takeIndex(type);
    if (text_.word() != "CONNECTIVITY") throwTruncated(path_);
    type = typeOf(text_.word(false));
    beginBlock(numbers, type);
    if (ends.front() != 0 || ends.back() != numbers) throwTruncated(path_);
    Cells cells;
    for (std::size_t c = 1; c < count; ++c) {
      if (ends[c] < ends[c - 1] || ends[c] > numbers) throwTruncated(path_);
      std::vector<std::uint32_t> cell(ends[c] - ends[c - 1]);
      for (std::uint32_t& corner : cell) corner = takeIndex(type);
      cells.push_back(std::move(cell));
    }
    return cells;
  }

  /// Names of components and the like, in words up to an empty line.
  void skipMetadata() {
    text_.line();
    while (!text_.done() && !text_.line().empty()) continue;
  }

  /// Of the attributes behind the cells only one array is of interest: it is looked for by its
  /// names, among the cells' attributes and not the points'.
  void findFaces(std::string_view section) {
    std::string_view attributes = text_.rest();
    if (section == "POINT_DATA") {
      const std::size_t cells = attributes.find("\nCELL_DATA ");
      if (cells == std::string_view::npos) return;
      attributes.remove_prefix(cells);
    } else {
      attributes = attributes.substr(0, attributes.find("\nPOINT_DATA "));
    }
    findFaces(attributes, kFaceId);
    entities_ = faces_.empty();
    if (entities_) findFaces(attributes, kEntityIds);
  }

  void findFaces(std::string_view attributes, const std::string& name) {
    const std::size_t cells = others_ + mesh_.polygons.size() + strips_.size();
    if (const std::size_t at = attributes.find("\nSCALARS " + name + " ");
        at != std::string_view::npos) {
      text_ = TextScanner(attributes.substr(at + 10 + name.size()));
      const Scalar type = typeOf(text_.word(false));
      if (text_.word(false) == "1" || text_.rest().starts_with('\n')) {
        text_.line();
        readFaces(cells, type);
      }
    } else if (const std::size_t in = attributes.find("\n" + name + " 1 ");
               in != std::string_view::npos) {
      text_ = TextScanner(attributes.substr(in + 4 + name.size()));
      if (takeCount() != cells) return;
      readFaces(cells, typeOf(text_.word(false)));
    }
  }

  void readFaces(std::size_t cells, Scalar type) {
    beginBlock(cells, type);
    for (std::size_t c = 0; c < cells; ++c) faces_.push_back(take(type));
  }

  /// From one for each cell to one for each polygon: strips come last and are of several triangles.
  void takeFaces() {
    const std::size_t polygons = others_ + mesh_.polygons.size();
    std::vector<double> faces(faces_.begin() + static_cast<std::ptrdiff_t>(others_),
                              faces_.begin() + static_cast<std::ptrdiff_t>(polygons));
    for (std::size_t s = 0; s < strips_.size(); ++s)
      if (strips_[s].size() >= 3)
        faces.insert(faces.end(), strips_[s].size() - 2, faces_[polygons + s]);
    faces_ = std::move(faces);
  }

  void skipField() {
    text_.word();
    for (std::size_t arrays = takeCount(); arrays > 0; --arrays) {
      std::string_view name = text_.word();
      if (name == "METADATA") {
        skipMetadata();
        name = text_.word();
      }
      const std::size_t components = takeCount();
      const std::size_t tuples = takeCount();
      const Scalar type = typeOf(text_.word(false));
      if (components > 0 && tuples > text_.rest().size() / components) throwTruncated(path_);
      beginBlock(components * tuples, type);
      for (std::size_t i = 0; i < components * tuples; ++i) take(type);
    }
  }

  TextScanner text_;
  const fs::path& path_;
  PolygonMesh mesh_;
  Cells strips_;
  std::size_t others_ = 0;     ///< points and lines, which are no surface
  std::vector<double> faces_;  ///< of the cells, then of the polygons
  bool entities_ = false;      ///< they are VMTK's
  Encoding encoding_ = Encoding::Ascii;
  bool newCells_ = false;
};

}  // namespace

PolygonMesh readLegacyVtk(const std::string& bytes, const fs::path& path) {
  PolygonMesh mesh = LegacyReader(bytes, path).read();
  for (const auto& polygon : mesh.polygons)
    if (polygon.size() < 3) throwTruncated(path);
  return mesh;
}

}  // namespace angiomesh
