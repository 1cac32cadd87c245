// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <bit>
#include <fstream>
#include <sstream>

#include "core/base/error.h"
#include "io/header_text.h"
#include "io/image_header.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

using Fields = std::map<std::string, std::string>;

constexpr int kMostFiles = 100000;

VoxelType nrrdType(const std::string& type, const fs::path& path) {
  for (const auto& [voxelType, names] : std::initializer_list<std::pair<VoxelType, std::string>>{
           {VoxelType::Int8, "|signed char|int8|int8_t|"},
           {VoxelType::UInt8, "|uchar|unsigned char|uint8|uint8_t|"},
           {VoxelType::Int16, "|short|short int|signed short|signed short int|int16|int16_t|"},
           {VoxelType::UInt16, "|ushort|unsigned short|unsigned short int|uint16|uint16_t|"},
           {VoxelType::Int32, "|int|signed int|int32|int32_t|"},
           {VoxelType::UInt32, "|uint|unsigned int|uint32|uint32_t|"},
           {VoxelType::Int64,
            "|longlong|long long|long long int|signed long long|signed long long int|int64|"
            "int64_t|"},
           {VoxelType::UInt64,
            "|ulonglong|unsigned long long|unsigned long long int|uint64|uint64_t|"},
           {VoxelType::Float32, "|float|"},
           {VoxelType::Float64, "|double|"}})
    if (names.find("|" + type + "|") != std::string::npos) return voxelType;
  throwBadHeader(path, "type is '" + type + "'");
}

std::string either(Fields& fields, const char* name, const char* other) {
  return fields.count(name) != 0 ? fields[name] : fields[other];
}

/// Which of four axes is none of space: the first or the last. 3 where nothing tells.
std::size_t valueAxis(Fields& fields, const fs::path& path) {
  std::istringstream directions(fields["space directions"]), kinds(fields["kinds"]);
  std::string word;
  for (std::size_t axis = 0; axis < 4 && directions >> word; ++axis) {
    if (word == "none" && (axis == 0 || axis == 3)) return axis;
    // "(1, 0, 0)" may hold blanks.
    while (word.find('(') != std::string::npos && word.find(')') == std::string::npos) {
      std::string more;
      if (!(directions >> more)) break;
      word += more;
    }
  }
  for (std::size_t axis = 0; axis < 4 && kinds >> word; ++axis) {
    if (word == "domain" || word == "space" || word == "???" || word == "none") continue;
    if (axis == 1 || axis == 2) throwBadHeader(path, "kinds is '" + fields["kinds"] + "'");
    return axis;
  }
  return 3;
}

void takeSizes(Fields& fields, const fs::path& path, ImageHeader& header) {
  std::vector<std::uintmax_t> sizes = parseSizes(fields["sizes"]);
  if (sizes.empty()) throwBadHeader(path, "sizes is '" + fields["sizes"] + "'");
  if (fields["dimension"] != std::to_string(sizes.size()))
    throwBadHeader(path, "dimension and sizes differ");
  VoxelData& data = header.data;
  if (sizes.size() > 4)
    throw InputError("a " + std::to_string(sizes.size()) + "D image", path.string(),
                     "give one 3D volume of it");
  if (sizes.size() == 4) {
    const std::size_t axis = valueAxis(fields, path);
    data.values = sizes[axis];
    data.interleaved = axis == 0 && data.values > 1;
    sizes.erase(sizes.begin() + static_cast<std::ptrdiff_t>(axis));
  }
  header.size = sizes;
  data.voxels = productOf(sizes);
}

VoxelPlace nrrdPlace(Fields& fields, std::istream& in, const fs::path& path, VoxelData& data) {
  VoxelPlace place;
  place.file = either(fields, "data file", "datafile");
  place.local = place.file.empty();
  if (place.local) {
    const std::streamoff at = in.tellg();
    place.start = at < 0 ? fs::file_size(path) : static_cast<std::uintmax_t>(at);
  }
  if (place.file.starts_with("LIST")) {
    // The names follow the field, up to the end of the file.
    std::ifstream again(path, std::ios::binary);
    std::string line;
    while (std::getline(again, line) && line.find("LIST") == std::string::npos) continue;
    while (static_cast<int>(place.list.size()) < kMostFiles && std::getline(again, line)) {
      while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
      if (!line.empty()) place.list.push_back(line);
    }
  }
  const std::string lines = either(fields, "line skip", "lineskip");
  const std::string bytes = either(fields, "byte skip", "byteskip");
  if (!lines.empty()) place.skipLines = parseWhole(lines, "line skip", path);
  const long long skip = bytes.empty() ? 0 : parseWhole(bytes, "byte skip", path);
  if (place.skipLines < 0 || skip < -1) throwBadHeader(path, "byte skip is '" + bytes + "'");
  place.atEnd = skip == -1;
  if (skip > 0 && data.deflated) data.skipInflated = static_cast<std::uintmax_t>(skip);
  if (skip > 0 && !data.deflated) place.skipBytes = static_cast<std::uintmax_t>(skip);
  return place;
}

}  // namespace

ImageHeader readNrrdHeader(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  Fields fields = textFields(in, ":", "");
  ImageHeader header;
  VoxelData& data = header.data;
  takeSizes(fields, path, header);
  data.type = nrrdType(fields["type"], path);
  data.swapBytes = fields["endian"] == "big" && std::endian::native == std::endian::little;
  if (fields.count("space directions") == 0 && fields.count("spacings") == 0)
    header.warnings.emplace_back(kNoSpacing);
  for (const auto& [key, value] : fields)
    if (key.ends_with(':')) header.fields[key.substr(0, key.size() - 1)] = value;

  const std::string encoding = fields["encoding"];
  data.deflated = encoding == "gzip" || encoding == "gz";
  const bool text = encoding == "ascii" || encoding == "text" || encoding == "txt";
  const VoxelPlace place = nrrdPlace(fields, in, path, data);
  if (encoding == "raw" || data.deflated)
    placeVoxels(place, path, header);
  else if (text)
    placeText(place, path, 2 * data.voxels * data.values - 1, header);
  else if (encoding == "hex")
    placeText(place, path, 2 * data.bytes(), header);
  else
    throw InputError("the voxels are encoded as '" + encoding + "', which is not read",
                     path.string(), "save the image with encoding raw or gzip");
  return header;
}

}  // namespace angiomesh
