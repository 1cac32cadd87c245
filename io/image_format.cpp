// SPDX-License-Identifier: BSD-3-Clause
#include "io/image_format.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <system_error>
#include <vector>

#include "core/base/error.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

const char* const kCopyAgain = "copy or download it again";
const char* const kNoSpacing = "the file does not state the voxel spacing: 1 mm is assumed";
const char* const kFormats = "give a DICOM file or folder, .mha/.mhd, .nrrd/.nhdr or .nii/.nii.gz";

[[noreturn]] void truncated(const fs::path& path, std::uintmax_t expected, std::uintmax_t found) {
  throw IoError("the file is truncated (" + std::to_string(found) + " of " +
                    std::to_string(expected) + " bytes of voxels)",
                path.string(), kCopyAgain);
}

[[noreturn]] void truncatedStream(const fs::path& path, std::uintmax_t found) {
  throw IoError(
      "the file is truncated (its compressed voxels end after " + std::to_string(found) + " bytes)",
      path.string(), kCopyAgain);
}

[[noreturn]] void badHeader(const fs::path& path, const std::string& what) {
  throw InputError("the image header is not usable (" + what + ")", path.string(),
                   "write the image again with another program");
}

[[noreturn]] void damaged(const fs::path& path) {
  throw IoError("the compressed voxels are damaged", path.string(), kCopyAgain);
}

struct GzClose {
  void operator()(gzFile file) const { gzclose(file); }
};
/// Reads plain files as well as gzip files.
using GzFile = std::unique_ptr<gzFile_s, GzClose>;

GzFile openGz(const fs::path& path) {
  GzFile file(gzopen(path.c_str(), "rb"));
  if (!file)
    throw IoError("cannot read the file (" + std::generic_category().message(errno) + ")",
                  path.string(), "check the name and the permissions");
  gzbuffer(file.get(), 1U << 17U);
  return file;
}

std::string firstBytes(const fs::path& path, std::size_t count) {
  const GzFile file = openGz(path);
  std::string bytes(count, '\0');
  const int got = gzread(file.get(), bytes.data(), static_cast<unsigned>(count));
  bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return bytes;
}

/// Bytes that the file yields from `start` on when inflated (zlib or gzip).
std::uintmax_t countInflated(const fs::path& path, std::streamoff start) {
  std::ifstream in(path, std::ios::binary);
  in.seekg(start);
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 32) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_streamp)> guard(&stream, inflateEnd);
  std::vector<char> packed(1U << 16U);
  std::vector<unsigned char> plain(1U << 18U);
  std::uintmax_t total = 0;
  int state = Z_OK;
  while (state == Z_OK && in) {
    in.read(packed.data(), static_cast<std::streamsize>(packed.size()));
    stream.next_in = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_in = static_cast<unsigned>(in.gcount());
    do {
      stream.next_out = plain.data();
      stream.avail_out = static_cast<unsigned>(plain.size());
      state = inflate(&stream, Z_NO_FLUSH);
      total += plain.size() - stream.avail_out;
    } while (state == Z_OK && stream.avail_out == 0);
    if (state == Z_BUF_ERROR) state = Z_OK;
  }
  if (state == Z_DATA_ERROR) damaged(path);
  if (state != Z_STREAM_END) truncatedStream(path, total);
  return total;
}

/// Throws unless at least `expected` bytes of voxels follow `start`, inflated where `packed`.
void countVoxelBytes(const fs::path& path, std::streamoff start, std::uintmax_t expected,
                     bool packed) {
  std::uintmax_t found = 0;
  if (packed) {
    found = start < 0 ? 0 : countInflated(path, start);
  } else {
    const std::uintmax_t all = fs::file_size(path);
    const auto skip = static_cast<std::uintmax_t>(std::max<std::streamoff>(start, 0));
    found = start >= 0 && all > skip ? all - skip : 0;
  }
  if (found < expected) truncated(path, expected, found);
}

/// "key SIGN value" lines up to an empty line or the key `last`; `in` then stands behind it.
std::map<std::string, std::string> textFields(std::istream& in, const char* signs,
                                              const std::string& last) {
  std::map<std::string, std::string> fields;
  std::string line;
  const auto trim = [](const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string::npos) return std::string();
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
  };
  for (int lines = 0; lines < 5000 && std::getline(in, line); ++lines) {
    if (trim(line).empty()) break;
    const std::size_t sign = line.find_first_of(signs);
    if (sign == std::string::npos) continue;
    const std::string key = trim(line.substr(0, sign));
    fields[key] = trim(line.substr(sign + 1));
    if (key == last) break;
  }
  return fields;
}

std::uintmax_t metaElementBytes(const std::string& type) {
  static const std::map<std::string, std::uintmax_t> sizes = {
      {"MET_CHAR", 1},      {"MET_UCHAR", 1},      {"MET_SHORT", 2}, {"MET_USHORT", 2},
      {"MET_INT", 4},       {"MET_UINT", 4},       {"MET_LONG", 4},  {"MET_ULONG", 4},
      {"MET_LONG_LONG", 8}, {"MET_ULONG_LONG", 8}, {"MET_FLOAT", 4}, {"MET_DOUBLE", 8}};
  const auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

bool isTrue(const std::string& text) {
  return !text.empty() && (text[0] == 'T' || text[0] == 't' || text[0] == '1');
}

struct Sizes {
  int count = 0;
  std::uintmax_t product = 0;  ///< 0: a size is not positive or the product is absurd
};

Sizes parseSizes(const std::string& text) {
  std::istringstream in(text);
  Sizes sizes{0, 1};
  for (long long size = 0; in >> size; ++sizes.count) {
    if (size < 1 || size > (1LL << 31) || sizes.product > (1ULL << 44U)) return {};
    sizes.product *= static_cast<std::uintmax_t>(size);
  }
  if (sizes.count == 0 || !in.eof() || sizes.product > (1ULL << 44U)) return {};
  return sizes;
}

template <class T>
T fromBytes(const std::string& bytes, std::size_t at, bool swap) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), bytes.data() + at, sizeof(T));
  if (swap)
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  return std::bit_cast<T>(raw);
}

constexpr std::size_t kNiftiHeader = 348;
constexpr int kNiftiFloat = 16;
constexpr int kNiftiDouble = 64;

bool looksLikeMetaImage(const std::string& head) {
  return head.find("NDims") != std::string::npos && head.find('=') != std::string::npos;
}

bool isDicomHead(const std::string& head) {
  if (head.size() > 132 && head.compare(128, 4, "DICM") == 0) return true;
  // Old files have no preamble: they begin with a tag of group 8, little endian.
  return head.size() > 8 && head[0] == 8 && head[1] == 0 && head[3] == 0 &&
         (head[2] == 0 || head[2] == 1 || head[2] == 5 || head[2] == 8 || head[2] == 0x16);
}

void requireVoxelFile(const fs::path& dataPath, const std::string& name, const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(dataPath, error))
    throw IoError("the voxel file '" + name + "' that the header names is missing", path.string(),
                  "put it beside the header");
}

HeaderFacts checkMetaImage(const fs::path& path, bool countVoxels) {
  std::ifstream header(path, std::ios::binary);
  auto fields = textFields(header, "=:", "ElementDataFile");
  const std::string file = fields["ElementDataFile"];
  if (file.empty()) badHeader(path, "ElementDataFile is missing");
  const std::uintmax_t bytes = metaElementBytes(fields["ElementType"]);
  if (bytes == 0) badHeader(path, "ElementType is '" + fields["ElementType"] + "'");
  const Sizes sizes = parseSizes(fields["DimSize"]);
  if (sizes.product == 0) badHeader(path, "DimSize is '" + fields["DimSize"] + "'");
  if (fields["NDims"] != std::to_string(sizes.count)) badHeader(path, "NDims and DimSize differ");
  std::uintmax_t channels = 1;
  if (fields.count("ElementNumberOfChannels") != 0)
    channels = parseSizes(fields["ElementNumberOfChannels"]).product;

  HeaderFacts facts;
  if (fields["Modality"] == "MET_MOD_MR") facts.modality = "MR";
  if (fields["Modality"] == "MET_MOD_CT") facts.modality = "CT";
  if (fields.count("ElementSpacing") == 0 && fields.count("ElementSize") == 0)
    facts.warnings.emplace_back(kNoSpacing);

  const bool ascii = fields.count("BinaryData") != 0 && !isTrue(fields["BinaryData"]);
  // One file per slice: ITK fails by itself when one is missing.
  if (ascii || file.starts_with("LIST") || file.find('%') != std::string::npos) return facts;
  const bool local = file == "LOCAL" || file == "Local" || file == "local";
  const fs::path dataPath = local ? path : path.parent_path() / file;
  requireVoxelFile(dataPath, file, path);
  if (!countVoxels) return facts;
  const auto start = local ? static_cast<std::streamoff>(header.tellg()) : std::streamoff{0};
  countVoxelBytes(dataPath, start, sizes.product * channels * bytes,
                  isTrue(fields["CompressedData"]));
  return facts;
}

/// 0 for a type that has no fixed size.
std::uintmax_t nrrdTypeBytes(std::string type) {
  for (const char* word : {"signed ", "unsigned "})
    if (type.starts_with(word)) type.erase(0, std::strlen(word));
  for (const auto& [bytes, names] : std::initializer_list<std::pair<int, std::string>>{
           {1, "|char|uchar|int8|int8_t|uint8|uint8_t|"},
           {2, "|short|short int|ushort|int16|int16_t|uint16|uint16_t|"},
           {4, "|int|uint|int32|int32_t|uint32|uint32_t|float|"},
           {8,
            "|long long|long long int|longlong|ulonglong|int64|int64_t|uint64|uint64_t|double|"}})
    if (names.find("|" + type + "|") != std::string::npos) return static_cast<unsigned>(bytes);
  return 0;
}

HeaderFacts checkNrrd(const fs::path& path, bool countVoxels) {
  std::ifstream header(path, std::ios::binary);
  auto fields = textFields(header, ":", "");
  const Sizes sizes = parseSizes(fields["sizes"]);
  if (sizes.product == 0) badHeader(path, "sizes is '" + fields["sizes"] + "'");
  const std::uintmax_t bytes = nrrdTypeBytes(fields["type"]);
  if (bytes == 0) badHeader(path, "type is '" + fields["type"] + "'");
  HeaderFacts facts;
  if (fields.count("space directions") == 0 && fields.count("spacings") == 0)
    facts.warnings.emplace_back(kNoSpacing);
  if (!countVoxels) return facts;

  const std::string encoding = fields["encoding"];
  const std::string file =
      fields.count("data file") != 0 ? fields["data file"] : fields["datafile"];
  const bool skips = fields.count("byte skip") + fields.count("byteskip") +
                         fields.count("line skip") + fields.count("lineskip") >
                     0;
  const bool packed = encoding == "gzip" || encoding == "gz";
  // Text, lists of files and skipped bytes are left to ITK, which counts NRRD's voxels as well.
  if (skips || (encoding != "raw" && !packed) || file.starts_with("LIST") ||
      file.find('%') != std::string::npos)
    return facts;
  const fs::path dataPath = file.empty() ? path : path.parent_path() / file;
  requireVoxelFile(dataPath, file, path);
  const auto start = file.empty() ? static_cast<std::streamoff>(header.tellg()) : std::streamoff{0};
  countVoxelBytes(dataPath, start, sizes.product * bytes, packed);
  return facts;
}

template <class T>
bool allFinite(const std::string& block, std::size_t bytes, bool swap) {
  for (std::size_t at = 0; at + sizeof(T) <= bytes; at += sizeof(T))
    if (!std::isfinite(fromBytes<T>(block, at, swap))) return false;
  return true;
}

/// Counts, and looks for NaN and infinity, which the NIfTI library would turn into 0.
void checkNiftiVoxels(const fs::path& path, z_off_t start, std::uintmax_t expected, int floatBytes,
                      bool swap) {
  const GzFile file = openGz(path);
  std::string block(1U << 18U, '\0');
  std::uintmax_t found = 0;
  int count = gzseek(file.get(), start, SEEK_SET) == start ? 1 : 0;
  while (count > 0 && found < expected) {
    count = gzread(file.get(), block.data(),
                   static_cast<unsigned>(std::min<std::uintmax_t>(block.size(), expected - found)));
    if (count > 0) found += static_cast<std::uintmax_t>(count);
    const auto bytes = static_cast<std::size_t>(std::max(count, 0));
    if ((floatBytes == 4 && !allFinite<float>(block, bytes, swap)) ||
        (floatBytes == 8 && !allFinite<double>(block, bytes, swap)))
      throw InputError("the volume holds values that are not finite numbers", path.string(),
                       "replace NaN and infinity before loading it");
  }
  // What follows the voxels is read as well: the check sum comes last.
  while (count > 0) count = gzread(file.get(), block.data(), static_cast<unsigned>(block.size()));
  int state = Z_OK;
  gzerror(file.get(), &state);
  if (state == Z_DATA_ERROR) damaged(path);
  if (found < expected) truncated(path, expected, found);
  if (state == Z_BUF_ERROR) truncatedStream(path, found);
}

HeaderFacts checkNifti(const fs::path& path, bool countVoxels) {
  const GzFile file = openGz(path);
  std::string header(kNiftiHeader, '\0');
  if (gzread(file.get(), header.data(), static_cast<unsigned>(kNiftiHeader)) !=
      static_cast<int>(kNiftiHeader))
    throw IoError("the file is truncated", path.string(), kCopyAgain);
  const bool swap = fromBytes<std::int32_t>(header, 0, false) != static_cast<int>(kNiftiHeader);
  if (header.compare(344, 3, "n+1") != 0)
    throw InputError("a NIfTI header without its voxels, or an Analyze file", path.string(),
                     "convert the .hdr/.img pair to .nii");
  const int dimensions = fromBytes<std::int16_t>(header, 40, swap);
  if (dimensions < 1 || dimensions > 7) badHeader(path, "dim[0] is not 1 to 7");
  std::uintmax_t voxels = 1;
  for (int a = 1; a <= dimensions; ++a) {
    const int size = fromBytes<std::int16_t>(header, 40 + 2 * static_cast<std::size_t>(a), swap);
    if ((size < 1 && a < 4) || voxels > (1ULL << 44U)) badHeader(path, "a size is not positive");
    voxels *= static_cast<std::uintmax_t>(std::max(size, 1));
  }
  const int bits = fromBytes<std::int16_t>(header, 72, swap);
  if (bits < 8 || bits % 8 != 0 || bits > 256) badHeader(path, "bits per voxel");
  const auto offset = fromBytes<float>(header, 108, swap);
  if (!(offset >= static_cast<float>(kNiftiHeader)) || offset > 1e8F) badHeader(path, "vox_offset");

  HeaderFacts facts;
  for (std::size_t a = 1; a <= 3; ++a)
    if (!(std::fabs(fromBytes<float>(header, 76 + 4 * a, swap)) > 0.0F))
      badHeader(path, "a voxel spacing is not positive");
  if (fromBytes<std::int16_t>(header, 252, swap) <= 0 &&
      fromBytes<std::int16_t>(header, 254, swap) <= 0)
    facts.warnings.emplace_back("the file does not state the patient's orientation");
  if (!countVoxels) return facts;

  const std::uintmax_t expected = voxels * static_cast<std::uintmax_t>(bits) / 8;
  const int datatype = fromBytes<std::int16_t>(header, 70, swap);
  const int floatBytes = datatype == kNiftiFloat ? 4 : datatype == kNiftiDouble ? 8 : 0;
  checkNiftiVoxels(path, static_cast<z_off_t>(offset), expected, floatBytes, swap);
  return facts;
}

}  // namespace

ImageFormat imageFormat(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw IoError("there is no such file", path.string(), "check the name");
  if (!fs::is_regular_file(status)) throw IoError("not a regular file", path.string(), kFormats);
  if (fs::file_size(path, error) == 0)
    throw IoError("the file is empty", path.string(), kCopyAgain);
  const std::string head = firstBytes(path, 4096);
  std::array<unsigned char, 2> magic{};
  std::ifstream(path, std::ios::binary).read(reinterpret_cast<char*>(magic.data()), 2);
  const bool gzip = magic[0] == 0x1f && magic[1] == 0x8b;
  if (gzip && head.empty()) throw IoError("the file is truncated", path.string(), kCopyAgain);
  const bool nrrd = head.starts_with("NRRD00");
  const bool dicom = isDicomHead(head);
  if (head.size() >= 4) {
    const auto size = fromBytes<std::int32_t>(head, 0, false);
    const auto swapped = fromBytes<std::int32_t>(head, 0, true);
    if (size == 540 || swapped == 540)
      throw InputError("a NIfTI-2 file, which is not read", path.string(), "convert it to NIfTI-1");
    if (size == kNiftiHeader || swapped == kNiftiHeader) {
      if (head.size() < kNiftiHeader)
        throw IoError("the file is truncated", path.string(), kCopyAgain);
      if (gzip != (path.extension() == ".gz"))
        throw InputError(
            gzip ? "a compressed NIfTI file without .gz" : "a plain NIfTI file with .gz",
            path.string(), "rename it");
      return ImageFormat::Nifti;
    }
  }
  if (gzip && (nrrd || dicom || looksLikeMetaImage(head)))
    throw InputError("the whole file is compressed with gzip", path.string(), "gunzip it first");
  if (nrrd) return ImageFormat::Nrrd;
  if (dicom) return ImageFormat::Dicom;
  if (looksLikeMetaImage(head)) return ImageFormat::MetaImage;
  throw InputError("not an image file", path.string(), kFormats);
}

bool looksLikeDicom(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string head(140, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return isDicomHead(head);
}

HeaderFacts checkHeader(const fs::path& path, ImageFormat format, bool countVoxels) {
  if (format == ImageFormat::MetaImage) return checkMetaImage(path, countVoxels);
  if (format == ImageFormat::Nrrd) return checkNrrd(path, countVoxels);
  return checkNifti(path, countVoxels);
}

}  // namespace angiomesh
