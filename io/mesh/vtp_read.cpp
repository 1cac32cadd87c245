// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
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

/// VTK's own reader crashes on damaged arrays, and reserves whatever memory they announce.
class VtpReader {
 public:
  VtpReader(std::string_view xml, const fs::path& path) : xml_(xml), path_(path) {}

  PolygonMesh read() {
    readFileTag();
    findAppendedData();
    std::size_t at = xml_.find('<');
    while (at < inlineEnd_) {
      if (xml_.substr(at, 4) == "<!--") {
        at = xml_.find('<', xml_.find("-->", at));
        continue;
      }
      const std::size_t end = xml_.find('>', at);
      if (end == std::string_view::npos) throwTruncated(path_);
      readTag(xml_.substr(at, end - at), end + 1);
      at = xml_.find('<', end);
    }
    if (piece_) finishPiece();
    if (!faces_.empty() && entities_)
      groupByEntity(mesh_, faces_);
    else if (!faces_.empty())
      groupByNumber(mesh_, faces_, std::move(faceNames_), "face_");
    return std::move(mesh_);
  }

 private:
  /// An array of the file as one of the three forms holds it.
  struct Array {
    Scalar type = Scalar::None;
    Encoding encoding = Encoding::Ascii;
    std::string_view text;  ///< of an ASCII array
    std::string bytes;      ///< of any other
  };

  void readFileTag() {
    const std::size_t at = xml_.find("<VTKFile");
    const std::size_t end = xml_.find('>', at);
    if (at == std::string_view::npos || end == std::string_view::npos) throwTruncated(path_);
    const std::string_view tag = xml_.substr(at, end - at);
    const auto word = xmlAttribute(tag, "header_type").value_or("UInt32");
    if (word != "UInt32" && word != "UInt64") throwTruncated(path_);
    stored_.wordBytes = word == "UInt64" ? 8 : 4;
    if (xmlAttribute(tag, "byte_order").value_or("LittleEndian") == "BigEndian")
      stored_.order = Encoding::BigEndian;
    stored_.packer = xmlAttribute(tag, "compressor").value_or("");
  }

  void findAppendedData() {
    const std::size_t at = xml_.find("<AppendedData");
    inlineEnd_ = std::min(at, xml_.size());
    if (at == std::string_view::npos) return;
    const std::size_t end = std::min(xml_.find('>', at), xml_.size());
    rawAppended_ = xmlAttribute(xml_.substr(at, end - at), "encoding").value_or("") == "raw";
    const std::size_t mark = xml_.find('_', end);
    if (mark != std::string_view::npos) appended_ = xml_.substr(mark + 1);
  }

  void readTag(std::string_view tag, std::size_t content) {
    const std::string_view name = tag.substr(1, tag.find_first_of(" \t\r\n/", 1) - 1);
    if (tag.starts_with("</Piece")) {
      finishPiece();
    } else if (name == "Piece") {
      if (piece_) throwTruncated(path_);
      piece_ = true;
      points_ = countOf(tag, "NumberOfPoints");
      polys_ = countOf(tag, "NumberOfPolys");
      strips_ = countOf(tag, "NumberOfStrips");
      others_ = countOf(tag, "NumberOfVerts") + countOf(tag, "NumberOfLines");
      arrays_.clear();
      if (tag.ends_with('/')) finishPiece();
    } else if (name == "PointData" || name == "CellData") {
      section_ = name;
      mesh_.hasNormals = mesh_.hasNormals || (name == "PointData" && xmlAttribute(tag, "Normals"));
    } else if (name == "DataArray" || name == "Array") {
      readArray(tag, content);
    } else if (name == "Points" || name == "Polys" || name == "Strips" || name == "FieldData" ||
               name == "Verts" || name == "Lines") {
      section_ = name;
    }
  }

  std::uint64_t countOf(std::string_view tag, const char* name) const {
    TextScanner scan(xmlAttribute(tag, name).value_or("0"));
    double count = -1.0;
    if (!scan.number(count) || !(count >= 0.0) || count > 1e15) throwTruncated(path_);
    return static_cast<std::uint64_t>(count);
  }

  static Scalar typeOf(std::string_view name) {
    static const std::map<std::string_view, Scalar> types = {
        {"Int8", Scalar::Int8},       {"UInt8", Scalar::Uint8},   {"Int16", Scalar::Int16},
        {"UInt16", Scalar::Uint16},   {"Int32", Scalar::Int32},   {"UInt32", Scalar::Uint32},
        {"Int64", Scalar::Int64},     {"UInt64", Scalar::Uint64}, {"Float32", Scalar::Float32},
        {"Float64", Scalar::Float64}, {"String", Scalar::Int8}};
    const auto found = types.find(name);
    return found == types.end() ? Scalar::None : found->second;
  }

  void readArray(std::string_view tag, std::size_t content) {
    const std::string_view name = xmlAttribute(tag, "Name").value_or("");
    if (section_ == "FieldData") {
      if (name == "SPACE" || name == "UNIT" || name == "KEY")
        mesh_.header.read(std::string(name) + "=" + textsOf(arrayOf(tag, content)).front());
      if (name == kFaceNames) takeFaceNames(textsOf(arrayOf(tag, content)));
    } else if (section_ == "PointData" || section_ == "CellData") {
      mesh_.hasQuality = mesh_.hasQuality || name == "quality";
      if (section_ == "CellData" && (name == kFaceId || name == kEntityIds) &&
          xmlAttribute(tag, "NumberOfComponents").value_or("1") == "1")
        arrays_[std::string(name)] = arrayOf(tag, content);
    } else if (section_ == "Points") {
      if (countOf(tag, "NumberOfComponents") != 3) throwTruncated(path_);
      arrays_["Points"] = arrayOf(tag, content);
    } else if (section_ == "Polys" || section_ == "Strips") {
      arrays_[std::string(section_) + " " + std::string(name)] = arrayOf(tag, content);
    }
  }

  Array arrayOf(std::string_view tag, std::size_t content) const {
    Array array;
    array.type = typeOf(xmlAttribute(tag, "type").value_or(""));
    if (array.type == Scalar::None) throwTruncated(path_);
    const std::string_view format = xmlAttribute(tag, "format").value_or("ascii");
    // Information keys of the array may follow the data.
    const std::string_view inside = xml_.substr(content, xml_.find('<', content) - content);
    if (format == "ascii") {
      if (!tag.ends_with('/')) array.text = inside;
      return array;
    }
    array.encoding = stored_.order;
    std::string_view data = inside;
    if (format == "appended") {
      const std::uint64_t offset = countOf(tag, "offset");
      if (offset > appended_.size()) throwTruncated(path_);
      data = appended_.substr(offset);
    }
    auto bytes = vtpArrayBytes(data, format == "appended" && rawAppended_, stored_);
    if (!bytes) throwTruncated(path_);
    array.bytes = std::move(*bytes);
    return array;
  }

  /// Of a string array, one at least. What is no ASCII becomes '?'.
  static std::vector<std::string> textsOf(const Array& array) {
    std::string bytes = array.bytes;
    if (array.encoding == Encoding::Ascii) {
      TextScanner scan(array.text);
      for (double code = 0.0; scan.number(code);)
        bytes += code >= 0.0 && code < 128.0 ? static_cast<char>(code) : '?';
    }
    std::vector<std::string> texts;
    for (std::size_t at = 0; at < bytes.size() || texts.empty();) {
      const std::size_t end = std::min(bytes.find('\0', at), bytes.size());
      texts.push_back(bytes.substr(at, end - at));
      at = end + 1;
    }
    return texts;
  }

  void takeFaceNames(const std::vector<std::string>& names) {
    for (std::uint32_t n = 0; n < names.size(); ++n)
      if (!names[n].empty()) faceNames_[n + 1] = names[n];
  }

  /// The face of each polygon of the piece; of the cells, points and lines come first and strips,
  /// of several triangles each, last.
  void takeFaces(const std::vector<std::vector<std::uint32_t>>& polygons,
                 const std::vector<std::vector<std::uint32_t>>& strips) {
    const char* const name = arrays_.count(kFaceId) > 0 ? kFaceId : kEntityIds;
    if (arrays_.count(name) == 0) return;
    entities_ = name == kEntityIds;
    const std::vector<double> faces = numbers(name, others_ + polys_ + strips_);
    auto face = faces.begin() + static_cast<std::ptrdiff_t>(others_);
    for (const auto& polygon : polygons) {
      if (polygon.size() >= 3) faces_.push_back(*face);
      ++face;
    }
    for (const auto& strip : strips) {
      if (strip.size() >= 3) faces_.insert(faces_.end(), strip.size() - 2, *face);
      ++face;
    }
  }

  /// Exactly `count` numbers where that is given, else all there are.
  std::vector<double> numbers(const std::string& name, std::uint64_t count) const {
    const auto found = arrays_.find(name);
    if (found == arrays_.end()) throwTruncated(path_);
    const Array& array = found->second;
    const bool ascii = array.encoding == Encoding::Ascii;
    const std::string_view data = ascii ? array.text : std::string_view(array.bytes);
    // In text, a number takes a digit and a blank.
    if (count > (data.size() + 1) / (ascii ? 2 : bytesOf(array.type))) throwTruncated(path_);
    std::vector<double> values(count);
    TextScanner scan(data);
    for (double& value : values) value = takeNumber(scan, array.encoding, array.type, path_);
    return values;
  }

  std::vector<std::vector<std::uint32_t>> cells(const std::string& kind, std::uint64_t count,
                                                std::uint32_t firstPoint) const {
    std::vector<std::vector<std::uint32_t>> result;
    if (count == 0) return result;
    const std::vector<double> ends = numbers(kind + " offsets", count);
    double begin = 0.0;
    for (const double end : ends) {
      if (!(end >= begin) || end > 1e15) throwTruncated(path_);
      begin = end;
    }
    const std::vector<double> corners =
        numbers(kind + " connectivity", static_cast<std::uint64_t>(begin));
    auto corner = corners.begin();
    for (const double end : ends) {
      std::vector<std::uint32_t> cell;
      for (; corner != corners.begin() + static_cast<std::ptrdiff_t>(end); ++corner)
        cell.push_back(pointNumber(*corner, firstPoint));
      result.push_back(std::move(cell));
    }
    return result;
  }

  /// What is no point of the piece is out of range of the whole mesh, and refused there.
  [[nodiscard]] std::uint32_t pointNumber(double value, std::uint32_t firstPoint) const {
    if (!(value >= 0.0) || value >= static_cast<double>(points_))
      return std::numeric_limits<std::uint32_t>::max();
    return firstPoint + static_cast<std::uint32_t>(value);
  }

  void finishPiece() {
    if (!piece_) throwTruncated(path_);
    piece_ = false;
    const auto firstPoint = static_cast<std::uint32_t>(mesh_.points.size());
    if (points_ > 0) {
      const std::vector<double> values = numbers("Points", 3 * points_);
      if (mesh_.points.size() + points_ > std::numeric_limits<std::uint32_t>::max())
        throwTruncated(path_);
      for (std::size_t i = 0; i + 2 < values.size(); i += 3)
        mesh_.points.emplace_back(values[i], values[i + 1], values[i + 2]);
    }
    auto polygons = cells("Polys", polys_, firstPoint);
    const auto strips = cells("Strips", strips_, firstPoint);
    takeFaces(polygons, strips);
    for (auto& polygon : polygons)
      if (polygon.size() >= 3) mesh_.polygons.push_back(std::move(polygon));
    for (const auto& strip : strips) appendStrip(strip, mesh_.polygons);
  }

  std::string_view xml_;
  const fs::path& path_;
  PolygonMesh mesh_;
  VtpEncoding stored_;
  std::string_view appended_;
  std::size_t inlineEnd_ = 0;
  bool rawAppended_ = false;
  std::string_view section_;
  bool piece_ = false;  ///< one is open
  std::uint64_t points_ = 0, polys_ = 0, strips_ = 0;
  std::uint64_t others_ = 0;             ///< points and lines, which are no surface
  std::map<std::string, Array> arrays_;  ///< of the piece
  std::vector<double> faces_;            ///< of the mesh's polygons
  bool entities_ = false;                ///< they are VMTK's
  std::map<std::uint32_t, std::string> faceNames_;
};

}  // namespace

PolygonMesh readVtp(const std::string& bytes, const fs::path& path) {
  if (bytes.substr(0, 1000).find("PolyData") == std::string::npos)
    throw InputError("the VTK file does not hold a surface", path.string(),
                     "give a .vtp file (PolyData)");
  if (bytes.rfind("</VTKFile>") == std::string::npos) throwTruncated(path);
  return VtpReader(bytes, path).read();
}

}  // namespace angiomesh
