// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <sstream>

#include "io/file/length_unit.h"
#include "io/volume/header_text.h"
#include "io/volume/image_header.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

constexpr int kMostFiles = 100000;

VoxelType metaType(const std::string& type, const fs::path& path) {
  // MET_LONG has 4 bytes in every file, whatever the machine.
  static const std::map<std::string, VoxelType> types = {
      {"MET_CHAR", VoxelType::Int8},       {"MET_UCHAR", VoxelType::UInt8},
      {"MET_SHORT", VoxelType::Int16},     {"MET_USHORT", VoxelType::UInt16},
      {"MET_INT", VoxelType::Int32},       {"MET_UINT", VoxelType::UInt32},
      {"MET_LONG", VoxelType::Int32},      {"MET_ULONG", VoxelType::UInt32},
      {"MET_LONG_LONG", VoxelType::Int64}, {"MET_ULONG_LONG", VoxelType::UInt64},
      {"MET_FLOAT", VoxelType::Float32},   {"MET_DOUBLE", VoxelType::Float64}};
  const auto found = types.find(type);
  if (found == types.end()) throwBadHeader(path, "ElementType is '" + type + "'");
  return found->second;
}

bool isTrue(const std::string& text) {
  return !text.empty() && (text[0] == 'T' || text[0] == 't' || text[0] == '1');
}

VoxelPlace metaPlace(std::map<std::string, std::string>& fields, std::istream& in,
                     const fs::path& path) {
  VoxelPlace place;
  place.file = fields["ElementDataFile"];
  place.local = place.file == "LOCAL" || place.file == "Local" || place.file == "local";
  if (place.local) {
    const std::streamoff at = in.tellg();
    // Without a line end behind LOCAL no voxel follows.
    place.start = at < 0 ? fs::file_size(path) : static_cast<std::uintmax_t>(at);
    return place;
  }
  if (place.file.starts_with("LIST")) {
    std::string line;
    while (place.list.size() < kMostFiles && std::getline(in, line)) {
      while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
      if (!line.empty()) place.list.push_back(line);
    }
  }
  if (fields.count("HeaderSize") != 0) {
    const long long skip = parseWhole(fields["HeaderSize"], "HeaderSize", path);
    if (skip < -1) throwBadHeader(path, "HeaderSize is '" + fields["HeaderSize"] + "'");
    place.atEnd = skip == -1;
    place.start = static_cast<std::uintmax_t>(std::max(skip, 0LL));
  }
  return place;
}

using Fields = HeaderFields;

/// The first three of `all` numbers, or of `all` by `all` those of space, of the first of the
/// fields that is there; empty: none is.
std::vector<double> numbersOfSpace(const Fields& fields, std::initializer_list<const char*> keys,
                                   std::size_t all, bool square, const fs::path& path) {
  std::vector<double> first;
  for (const char* key : keys) {
    const auto found = fields.find(key);
    if (found == fields.end()) continue;
    std::istringstream in(found->second);
    std::vector<double> numbers;
    for (std::size_t row = 0; row < (square ? all : 1); ++row)
      for (std::size_t column = 0; column < all; ++column) {
        double value = 0.0;
        if (!(in >> value)) throwBadHeader(path, std::string(key) + " is '" + found->second + "'");
        if (row < 3 && column < 3) numbers.push_back(value);
      }
    if (first.empty()) first = std::move(numbers);
  }
  return first;
}

/// That of space, of an image with `dimensions` axes; lengths as they stand in the file.
Geometry metaGeometry(const Fields& fields, const std::vector<std::uintmax_t>& size,
                      std::size_t dimensions, const fs::path& path) {
  const auto numbers = [&](std::initializer_list<const char*> keys, bool square) {
    return numbersOfSpace(fields, keys, dimensions, square, path);
  };
  const std::vector<double> spacing = numbers({"ElementSpacing", "ElementSize"}, false);
  const std::vector<double> origin = numbers({"Offset", "Position", "Origin"}, false);
  const std::vector<double> axes = numbers({"TransformMatrix", "Rotation", "Orientation"}, true);
  Geometry g;
  if (!spacing.empty()) g.spacing = Eigen::Vector3d(spacing.data());
  if (!origin.empty()) g.origin = Eigen::Vector3d(origin.data());
  if (!axes.empty()) g.direction = Eigen::Matrix3d(axes.data());  // one after the other
  for (std::size_t a = 0; a < 3; ++a) {
    const auto i = static_cast<Eigen::Index>(a);
    g.size[a] = static_cast<int>(size[a]);
    // A negative spacing is the same grid with this axis turned round.
    if (g.spacing[i] < 0.0) g.direction.col(i) *= -1.0;
    g.spacing[i] = std::fabs(g.spacing[i]);
  }
  g.direction.array() += 0.0;  // -0 becomes 0
  return g;
}

/// The fields of a header, in which no two names of one thing have different values.
Fields metaFields(std::istream& in, const fs::path& path) {
  Fields fields = textFields(in, "=:", "ElementDataFile", path);
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"Offset", "Position", "Origin"},
        {"TransformMatrix", "Rotation", "Orientation"}}) {
    Fields::const_iterator first = fields.end();
    for (const std::string& name : names) {
      const auto found = fields.find(name);
      if (found == fields.end()) continue;
      if (first != fields.end() && !saysTheSame(first->second, found->second))
        throwBadHeader(path, first->first + " is '" + first->second + "', " + name + " '" +
                                 found->second + "'");
      first = found;
    }
  }
  return fields;
}

}  // namespace

ImageHeader readMetaImageHeader(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  Fields fields = metaFields(in, path);
  if (fields["ElementDataFile"].empty()) throwBadHeader(path, "ElementDataFile is missing");
  ImageHeader header;
  VoxelData& data = header.data;
  data.type = metaType(fields["ElementType"], path);
  header.size = parseSizes(fields["DimSize"]);
  if (header.size.empty()) throwBadHeader(path, "DimSize is '" + fields["DimSize"] + "'");
  if (fields["NDims"] != std::to_string(header.size.size()))
    throwBadHeader(path, "NDims and DimSize differ");
  std::uintmax_t channels = 1;
  if (fields.count("ElementNumberOfChannels") != 0) {
    channels = productOf(parseSizes(fields["ElementNumberOfChannels"]));
    if (channels > 4096) throwBadHeader(path, "ElementNumberOfChannels");
  }
  const std::size_t dimensions = header.size.size();
  const std::uintmax_t all = productOf(header.size);
  header.size.resize(std::min<std::size_t>(header.size.size(), 3));
  data.voxels = productOf(header.size);
  data.values = all / data.voxels * channels;
  data.interleaved = channels > 1;
  if (channels > 1 && all > data.voxels) throwBadHeader(path, "several channels in 4D");
  data.swapBytes =
      (isTrue(fields["BinaryDataByteOrderMSB"]) || isTrue(fields["ElementByteOrderMSB"])) ==
      (std::endian::native == std::endian::little);

  if (fields["Modality"] == "MET_MOD_MR") header.modality = "MR";
  if (fields["Modality"] == "MET_MOD_CT") header.modality = "CT";
  if (fields.count("ElementSpacing") == 0 && fields.count("ElementSize") == 0)
    header.warnings.emplace_back(kNoSpacing);

  std::optional<double> unitMm;
  if (const std::string& unit = fields["DistanceUnits"]; !unit.empty() && unit != "?") {
    unitMm = millimetresOf(unit);
    if (!unitMm) header.warnings.push_back(unknownUnit(unit));
  }

  const VoxelPlace place = metaPlace(fields, in, path);
  data.deflated = isTrue(fields["CompressedData"]);
  if (fields.count("BinaryData") != 0 && !isTrue(fields["BinaryData"]))
    placeText(place, path, VoxelText::Numbers, header);
  else
    placeVoxels(place, path, header);
  if (dimensions >= 3) header.geometry = metaGeometry(fields, header.size, dimensions, path);
  header.geometry.spacing *= unitMm.value_or(1.0);
  header.geometry.origin *= unitMm.value_or(1.0);
  return header;
}

}  // namespace angiomesh
