// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <bit>
#include <fstream>
#include <numeric>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "io/file/text_scanner.h"
#include "io/volume/header_text.h"
#include "io/volume/image_header.h"
#include "io/volume/nrrd_geometry.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

using Fields = NrrdFields;

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

bool isField(const std::string& name) {
  static const std::set<std::string> names = {"content",      "number",
                                              "type",         "block size",
                                              "blocksize",    "dimension",
                                              "space",        "space dimension",
                                              "sizes",        "spacings",
                                              "thicknesses",  "axis mins",
                                              "axismins",     "axis maxs",
                                              "axismaxs",     "space directions",
                                              "centers",      "centerings",
                                              "kinds",        "labels",
                                              "units",        "min",
                                              "max",          "old min",
                                              "oldmin",       "old max",
                                              "oldmax",       "endian",
                                              "encoding",     "line skip",
                                              "lineskip",     "byte skip",
                                              "byteskip",     "sample units",
                                              "sampleunits",  "space units",
                                              "space origin", "measurement frame",
                                              "data file",    "datafile"};
  return names.count(name) != 0;
}

struct Lines {
  Fields fields;                               ///< of the format
  std::map<std::string, std::string> foreign;  ///< "key:=value"
};

/// The lines up to an empty one or a list of files; `in` then stands behind it.
Lines readLines(std::istream& in, const fs::path& path) {
  constexpr int kMost = 100000;
  Lines lines;
  std::string line;
  std::getline(in, line);  // the format and its version
  for (int n = 0; n < kMost && std::getline(in, line); ++n) {
    if (trimmed(line).empty()) break;
    if (line[0] == '#') continue;
    const std::size_t key = line.find(":="), sign = line.find(':');
    if (sign == std::string::npos)
      throwBadHeader(path, "line " + std::to_string(n + 2) + " is no field");
    const std::string name = inSmall(trimmed(line.substr(0, sign)));
    const std::string value = trimmed(line.substr(sign + 1));
    if (isField(name) && key != sign)
      addField(lines.fields, name, value, path);
    else if (key != std::string::npos)
      lines.foreign[trimmed(line.substr(0, key))] = trimmed(line.substr(key + 2));
    else
      throw InputError("the header's field '" + trimmed(line.substr(0, sign)).substr(0, 40) +
                           "' is none of NRRD",
                       path.string(),
                       "remove that line, or write ':=' in it, as for keys of other programs");
    if ((name == "data file" || name == "datafile") && value.starts_with("LIST")) break;
  }
  return lines;
}

bool ofSpace(const std::string& kind) {
  return kind == "domain" || kind == "space" || kind == "???" || kind == "none";
}

/// Which axis holds several values or points in time: the first or the last, or none of three.
std::optional<std::size_t> valueAxis(const Fields& fields, std::size_t dimension,
                                     const fs::path& path) {
  const auto text = [&](const char* name) {
    const auto found = fields.find(name);
    return found == fields.end() ? std::string() : found->second;
  };
  const auto isEnd = [&](std::size_t axis) { return axis == 0 || axis + 1 == dimension; };
  const auto vectors = nrrdVectors(text("space directions"), "space directions", path);
  const bool some = std::any_of(vectors.begin(), vectors.end(), [](const auto& v) { return !!v; });
  for (std::size_t axis = 0; some && axis < vectors.size() && axis < dimension; ++axis) {
    const auto& v = vectors[axis];
    // In spaces with time an axis may lead through time alone.
    const bool time = v && v->size() == 4 && (*v)[0] == 0.0 && (*v)[1] == 0.0 && (*v)[2] == 0.0;
    if ((!v || time) && isEnd(axis)) return axis;
    // A kind such as "list" makes no difference to slices that lie in space.
    if (axis == 2 && dimension == 3) return {};
  }
  const std::vector<std::string> kinds = nrrdWords(inSmall(text("kinds")));
  for (std::size_t axis = 0; axis < kinds.size() && axis < dimension; ++axis) {
    if (ofSpace(kinds[axis])) continue;
    if (!isEnd(axis)) throwBadHeader(path, "kinds is '" + text("kinds") + "'");
    return axis;
  }
  return dimension == 4 ? std::optional<std::size_t>(3) : std::nullopt;
}

/// The sizes, and the numbers of the file's axes that are of space.
std::vector<std::size_t> takeSizes(Fields& fields, const fs::path& path, ImageHeader& header) {
  header.size = parseSizes(fields["sizes"]);
  if (header.size.empty()) throwBadHeader(path, "sizes is '" + fields["sizes"] + "'");
  if (fields["dimension"] != std::to_string(header.size.size()))
    throwBadHeader(path, "dimension and sizes differ");
  VoxelData& data = header.data;
  if (header.size.size() > 4)
    throw InputError("a " + std::to_string(header.size.size()) + "D image", path.string(),
                     "give one 3D volume of it");
  std::vector<std::size_t> axes(header.size.size());
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  const auto axis = axes.size() < 3 ? std::nullopt : valueAxis(fields, axes.size(), path);
  if (axis) {
    data.values = header.size[*axis];
    data.interleaved = *axis == 0 && data.values > 1;
    header.size.erase(header.size.begin() + static_cast<std::ptrdiff_t>(*axis));
    axes.erase(axes.begin() + static_cast<std::ptrdiff_t>(*axis));
  }
  data.voxels = productOf(header.size);
  return axes;
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
  Lines lines = readLines(in, path);
  Fields& fields = lines.fields;
  ImageHeader header;
  header.fields = std::move(lines.foreign);
  VoxelData& data = header.data;
  const std::vector<std::size_t> axes = takeSizes(fields, path, header);
  data.type = nrrdType(inSmall(fields["type"]), path);
  const std::string endian = inSmall(fields["endian"]);
  data.swapBytes = endian == "big" && std::endian::native == std::endian::little;
  if (axes.size() == 3)
    header.geometry = nrrdGeometry(fields, axes, header.size, path, header.warnings);

  const std::string encoding = inSmall(fields["encoding"]);
  data.deflated = encoding == "gzip" || encoding == "gz";
  const bool text = encoding == "ascii" || encoding == "text" || encoding == "txt";
  const VoxelPlace place = nrrdPlace(fields, in, path, data);
  if (encoding == "raw" || data.deflated)
    placeVoxels(place, path, header);
  else if (text)
    placeText(place, path, VoxelText::Numbers, header);
  else if (encoding == "hex")
    placeText(place, path, VoxelText::Hexadecimal, header);
  else
    throw InputError("the voxels are encoded as '" + fields["encoding"] + "', which is not read",
                     path.string(), "save the image with encoding raw or gzip");
  return header;
}

}  // namespace angiomesh
