// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <bit>
#include <fstream>

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

/// The first three of `all` numbers, or of `all` by `all` those of space.
std::string numbersOfSpace(const Fields& fields, const std::string& key, std::size_t all,
                           bool square, const fs::path& path) {
  const auto found = fields.find(key);
  if (found == fields.end()) return {};
  std::istringstream in(found->second);
  std::ostringstream out;
  out.precision(17);
  out << key << " =";
  const std::size_t rows = square ? all : 1;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < all; ++column) {
      double value = 0.0;
      if (!(in >> value)) throwBadHeader(path, key + " is '" + found->second + "'");
      if (row < 3 && column < 3) out << ' ' << value;
    }
  out << '\n';
  return out.str();
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

std::unique_ptr<MemoryFile> plainMetaImage(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  Fields fields = metaFields(in, path);
  const std::size_t dimensions = parseSizes(fields["DimSize"]).size();
  if (dimensions < 3) throwBadHeader(path, "DimSize is '" + fields["DimSize"] + "'");
  metaType(fields["ElementType"], path);
  std::string header = "ObjectType = Image\nNDims = 3\nBinaryData = True\n";
  for (const char* key :
       {"DimSize", "ElementSpacing", "ElementSize", "Offset", "Position", "Origin"})
    header += numbersOfSpace(fields, key, dimensions, false, path);
  for (const char* key : {"TransformMatrix", "Rotation", "Orientation"})
    header += numbersOfSpace(fields, key, dimensions, true, path);
  header += "ElementType = " + fields["ElementType"] + "\nElementDataFile = LOCAL\n";
  auto copy = std::make_unique<MemoryFile>();
  if (!copy->append(header)) throw std::bad_alloc();
  return copy;
}

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

  if (const std::string& unit = fields["DistanceUnits"]; !unit.empty() && unit != "?") {
    const std::optional<double> mm = millimetresOf(unit);
    if (!mm) header.warnings.push_back(unknownUnit(unit));
    header.unitMm = mm.value_or(1.0);
  }

  const VoxelPlace place = metaPlace(fields, in, path);
  data.deflated = isTrue(fields["CompressedData"]);
  if (fields.count("BinaryData") != 0 && !isTrue(fields["BinaryData"]))
    placeText(place, path, VoxelText::Numbers, header);
  else
    placeVoxels(place, path, header);
  return header;
}

}  // namespace angiomesh
