// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/image_write.h"

#include <zlib.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <new>
#include <span>
#include <system_error>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "io/file/files.h"
#include "io/file/staged_folder.h"
#include "io/file/text_scanner.h"
#include "io/volume/image_format.h"
#include "io/volume/writable_image.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

constexpr int kLevel = 2;       // of zlib: further ones cost more time than they save bytes
constexpr double kSkew = 1e-5;  // of the axes that NIfTI's quaternion holds as rotation
const char* const kAdvice = "check that the folder may be written to and has free space";

[[noreturn]] void throwNotWritten(const fs::path& path) {
  throw IoError("cannot write the image (" + std::generic_category().message(errno) + ")",
                path.string(), kAdvice);
}

void put(std::ostream& out, std::span<const std::byte> bytes) {
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
}

enum class Wrapper { Zlib, Gzip };

/// Writes `parts` one after the other as one zlib or gzip stream; the number of bytes written.
std::uintmax_t deflateTo(std::ostream& out, Wrapper wrapper,
                         std::initializer_list<std::span<const std::byte>> parts) {
  z_stream stream{};
  const int bits = wrapper == Wrapper::Gzip ? 15 + 16 : 15;
  if (deflateInit2(&stream, kLevel, Z_DEFLATED, bits, 9, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_streamp)> guard(&stream, deflateEnd);
  std::vector<std::byte> packed(std::size_t{1} << 17);
  std::uintmax_t total = 0;
  const auto drain = [&](int flush) {
    int state = Z_OK;
    do {
      stream.next_out = reinterpret_cast<Bytef*>(packed.data());
      stream.avail_out = static_cast<unsigned>(packed.size());
      state = deflate(&stream, flush);
      const std::size_t got = packed.size() - stream.avail_out;
      put(out, {packed.data(), got});
      total += got;
    } while (out && stream.avail_out == 0 && state != Z_STREAM_END);
  };
  for (const std::span<const std::byte> part : parts)
    for (std::size_t at = 0; at < part.size() && out;) {
      const std::size_t count = std::min(part.size() - at, std::size_t{1} << 24);
      // zlib reads its input only; its interface is older than const.
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(part.data() + at));
      stream.avail_in = static_cast<unsigned>(count);
      drain(Z_NO_FLUSH);
      at += count;
    }
  drain(Z_FINISH);
  return total;
}

std::string metaTypeName(VoxelType type) {
  static const std::array<const char*, 10> names = {
      "MET_CHAR", "MET_UCHAR",     "MET_SHORT",      "MET_USHORT", "MET_INT",
      "MET_UINT", "MET_LONG_LONG", "MET_ULONG_LONG", "MET_FLOAT",  "MET_DOUBLE"};
  return names[static_cast<std::size_t>(type)];
}

std::string nrrdTypeName(VoxelType type) {
  if (type == VoxelType::Float32) return "float";
  if (type == VoxelType::Float64) return "double";
  return voxelTypeName(type);
}

template <class Vector>
std::string spaced(const Vector& v) {
  return shortestText(v[0]) + " " + shortestText(v[1]) + " " + shortestText(v[2]);
}

std::string sizesText(const Geometry& g) {
  return std::to_string(g.size[0]) + " " + std::to_string(g.size[1]) + " " +
         std::to_string(g.size[2]);
}

constexpr bool kBigEndian = std::endian::native == std::endian::big;

/// A MetaImage header up to the fields that say where the voxels are.
std::string metaHeader(const WritableImage& image) {
  const Geometry& g = image.geometry;
  std::string axes;
  for (Eigen::Index a = 0; a < 3; ++a) axes += " " + spaced(g.direction.col(a));
  return std::string("ObjectType = Image\nNDims = 3\nBinaryData = True\n") +
         "BinaryDataByteOrderMSB = " + (kBigEndian ? "True" : "False") +
         "\nTransformMatrix =" + axes + "\nOffset = " + spaced(g.origin) +
         "\nCenterOfRotation = 0 0 0\nElementSpacing = " + spaced(g.spacing) +
         "\nDimSize = " + sizesText(g) + "\nElementType = " + metaTypeName(image.type) + "\n";
}

std::string nrrdHeader(const WritableImage& image, const std::string& encoding,
                       const std::string& dataFile) {
  const Geometry& g = image.geometry;
  const auto vector = [](const Eigen::Vector3d& v) {
    return "(" + shortestText(v[0]) + "," + shortestText(v[1]) + "," + shortestText(v[2]) + ")";
  };
  std::string axes;
  for (Eigen::Index a = 0; a < 3; ++a) axes += " " + vector(g.spacing[a] * g.direction.col(a));
  std::string text = "NRRD0004\n# http://teem.sourceforge.net/nrrd/format.html\ntype: " +
                     nrrdTypeName(image.type) +
                     "\ndimension: 3\nspace: left-posterior-superior\nsizes: " + sizesText(g) +
                     "\nspace directions:" + axes + "\nkinds: domain domain domain\n";
  if (voxelTypeBytes(image.type) > 1)
    text += std::string("endian: ") + (kBigEndian ? "big" : "little") + "\n";
  text += "encoding: " + encoding + "\nspace origin: " + vector(g.origin) + "\n";
  return dataFile.empty() ? text + "\n" : text + "data file: " + dataFile + "\n";
}

template <class T>
void set(std::array<std::byte, 352>& header, std::size_t offset, T value) {
  std::memcpy(header.data() + offset, &value, sizeof value);
}

/// The quaternion and the sign of the third axis (nifti1.h, method 2) of an orthogonal matrix.
Eigen::Quaterniond quaternionOf(Eigen::Matrix3d axes, float& sign) {
  sign = axes.determinant() < 0.0 ? -1.0F : 1.0F;
  axes.col(2) *= static_cast<double>(sign);
  Eigen::Quaterniond q(axes);
  q.normalize();
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  return q;
}

void checkNiftiHolds(const Geometry& g, const fs::path& path) {
  if (*std::max_element(g.size.begin(), g.size.end()) > 32767)
    throw InputError("NIfTI holds no side above 32767 voxels", path.string(),
                     "end the name in .mha or .nrrd");
  const Eigen::Matrix3d skew = g.direction.transpose() * g.direction - Eigen::Matrix3d::Identity();
  if (!(skew.cwiseAbs().maxCoeff() <= kSkew))
    throw InputError("NIfTI holds no skewed axes", path.string(), "end the name in .mha or .nrrd");
}

/// Header and the empty extension behind it; positions turned to RAS.
std::array<std::byte, 352> niftiHeader(const WritableImage& image) {
  static constexpr std::array<std::int16_t, 10> kTypes = {256, 2,    4,    512, 8,
                                                          768, 1024, 1280, 16,  64};
  const Geometry& g = image.geometry;
  std::array<std::byte, 352> h{};
  set<std::int32_t>(h, 0, 348);
  set<char>(h, 38, 'r');
  set<std::int16_t>(h, 40, 3);
  for (std::size_t a = 0; a < 7; ++a)
    set(h, 42 + 2 * a, static_cast<std::int16_t>(a < 3 ? g.size[a] : 1));
  set(h, 70, kTypes[static_cast<std::size_t>(image.type)]);
  set(h, 72, static_cast<std::int16_t>(8 * voxelTypeBytes(image.type)));
  Eigen::Matrix3d axes = g.direction;
  axes.topRows<2>() *= -1.0;
  const Eigen::Vector3d origin(-g.origin.x(), -g.origin.y(), g.origin.z());
  float sign = 1.0F;
  const Eigen::Quaterniond q = quaternionOf(axes, sign);
  set(h, 76, sign);
  for (std::size_t a = 0; a < 3; ++a)
    set(h, 80 + 4 * a, static_cast<float>(g.spacing[static_cast<Eigen::Index>(a)]));
  for (std::size_t a = 3; a < 7; ++a) set(h, 80 + 4 * a, 1.0F);
  set(h, 108, 352.0F);
  set(h, 112, 1.0F);     // scl_slope
  set<char>(h, 123, 2);  // mm
  set<std::int16_t>(h, 252, 1);
  set<std::int16_t>(h, 254, 1);
  const std::array<double, 6> form{q.x(), q.y(), q.z(), origin.x(), origin.y(), origin.z()};
  for (std::size_t n = 0; n < 6; ++n) set(h, 256 + 4 * n, static_cast<float>(form[n]));
  for (std::size_t row = 0; row < 3; ++row) {
    const auto r = static_cast<Eigen::Index>(row);
    for (std::size_t a = 0; a < 3; ++a) {
      const auto c = static_cast<Eigen::Index>(a);
      set(h, 280 + 16 * row + 4 * a, static_cast<float>(axes(r, c) * g.spacing[c]));
    }
    set(h, 292 + 16 * row, static_cast<float>(origin[r]));
  }
  std::memcpy(h.data() + 344, "n+1", 4);
  return h;
}

void writeFile(const fs::path& path, const std::function<void(std::ofstream&)>& write) {
  writeAtomically(path, [&](const fs::path& temporary) {
    errno = 0;
    std::ofstream out(temporary, std::ios::binary);
    write(out);
    out.close();
    if (!out) throwNotWritten(path);
  });
}

/// Whether a header in the folder, other than `header`, names the voxel file.
bool isNamedElsewhere(const std::string& voxelFile, const fs::path& header) {
  std::error_code error;
  const fs::path folder = folderOf(header);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const fs::path& other = entry.path();
    if (other.filename() == header.filename()) continue;
    const std::string extension = inSmall(other.extension().string());
    if (extension != ".mhd" && extension != ".nhdr") continue;
    std::string head(std::size_t{1} << 16, '\0');
    std::ifstream in(other, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
    if (head.find(voxelFile) != std::string::npos) return true;
  }
  return false;
}

/// The voxel file that a former header names, when it is one that we would have named so.
std::string formerVoxelFile(const fs::path& header, const std::string& stem,
                            const std::string& extension) {
  std::ifstream in(header, std::ios::binary);
  for (std::string line; std::getline(in, line);)
    for (const char* key : {"ElementDataFile = ", "data file: "})
      if (line.starts_with(key)) {
        const std::string name = line.substr(std::strlen(key));
        if (name.starts_with(stem) && name.ends_with(extension) &&
            name.find('/') == std::string::npos)
          return name;
      }
  return {};
}

/// A name for the voxel file beside a header that no reader takes for a pattern or a keyword.
std::string voxelStem(const fs::path& header) {
  std::string stem = header.stem().string();
  for (char& c : stem)
    if (c == '%' || static_cast<unsigned char>(c) < 0x20) c = '_';
  for (const std::size_t end : {std::size_t{0}, stem.size() - 1})
    if (stem[end] == ' ') stem[end] = '_';
  const std::string word = inSmall(stem.substr(0, 5));
  return word.starts_with("list") || word == "local" ? "_" + stem : stem;
}

/// Writes the voxels under a name that is free, and the header that names them. The header's rename
/// is the moment at which the new image is there; what the old header named goes last.
void writePair(const fs::path& path, const std::string& extension,
               const std::function<void(std::ofstream&)>& voxels,
               const std::function<std::string(const std::string&)>& headerFor) {
  std::error_code error;
  const fs::path header = fs::is_symlink(path, error) ? fs::weakly_canonical(path) : path;
  checkTarget(header);
  const fs::path folder = folderOf(header);
  // What a killed program left unfinished may give the header other voxels.
  finishCommits(folder);
  const std::string stem = voxelStem(header);
  std::string name = stem + extension;
  for (int n = 1; fs::exists(fs::symlink_status(folder / name, error)); ++n)
    name = stem + "-" + std::to_string(n) + extension;
  std::vector<std::string> names{name, header.filename().string()};
  const std::string former = formerVoxelFile(header, stem, extension);
  if (fs::is_regular_file(fs::symlink_status(folder / former, error)) &&
      !isNamedElsewhere(former, header))
    names.push_back(former);
  StagedFolder staged(folder, names, true, StagedFolder::Writers::Many);
  staged.add(names[0], [&](const fs::path& place) { writeFile(place, voxels); });
  staged.add(names[1], [&](const fs::path& place) {
    writeFile(place, [&](std::ofstream& out) { out << headerFor(name); });
  });
  staged.commit();
}

void writeNifti(const WritableImage& image, const fs::path& path, bool packed) {
  checkNiftiHolds(image.geometry, path);
  const std::array<std::byte, 352> header = niftiHeader(image);
  writeFile(path, [&](std::ofstream& out) {
    if (packed) {
      deflateTo(out, Wrapper::Gzip, {header, image.bytes});
    } else {
      put(out, header);
      put(out, image.bytes);
    }
  });
}

void write(const WritableImage& image, const fs::path& path) {
  if (image.bytes.empty() ||
      image.bytes.size() != image.geometry.voxelCount() * voxelTypeBytes(image.type))
    throw InputError("there are no voxels to write", path.string(), "compute the volume first");
  const ImageEnding* ending = imageEndingOf(path);
  if (ending == nullptr || ending->write == nullptr)
    throw InputError("cannot tell the image format from the name", path.string(),
                     "end the name in " + eitherOf(imageEndings(true)));
  ending->write(image, path);
}

template <class T>
WritableImage imageOf(const Volume<T>& volume, VoxelType type) {
  return {volume.geometry, type, std::as_bytes(std::span(volume.voxels))};
}

}  // namespace

void writeMha(const WritableImage& image, const fs::path& path) {
  constexpr int kDigits = 20;
  writeFile(path, [&](std::ofstream& out) {
    out << metaHeader(image) << "CompressedData = True\nCompressedDataSize = ";
    const std::streampos place = out.tellp();
    out << std::string(kDigits, ' ') << "\nElementDataFile = LOCAL\n";
    const std::uintmax_t packed = deflateTo(out, Wrapper::Zlib, {image.bytes});
    out.seekp(place);
    out << packed;
  });
}

void writeMhd(const WritableImage& image, const fs::path& path) {
  writePair(
      path, ".raw", [&](std::ofstream& out) { put(out, image.bytes); },
      [&](const std::string& name) {
        return metaHeader(image) + "CompressedData = False\nElementDataFile = " + name + "\n";
      });
}

void writeNrrd(const WritableImage& image, const fs::path& path) {
  writeFile(path, [&](std::ofstream& out) {
    out << nrrdHeader(image, "gzip", {});
    deflateTo(out, Wrapper::Gzip, {image.bytes});
  });
}

void writeNhdr(const WritableImage& image, const fs::path& path) {
  writePair(
      path, ".raw.gz", [&](std::ofstream& out) { deflateTo(out, Wrapper::Gzip, {image.bytes}); },
      [&](const std::string& name) { return nrrdHeader(image, "gzip", name); });
}

void writeNii(const WritableImage& image, const fs::path& path) { writeNifti(image, path, false); }

void writeNiiGz(const WritableImage& image, const fs::path& path) { writeNifti(image, path, true); }

void writeVolume(const Volume<float>& volume, const fs::path& path) {
  write(imageOf(volume, VoxelType::Float32), path);
}

void writeVolume(const Volume<std::uint8_t>& volume, const fs::path& path) {
  write(imageOf(volume, VoxelType::UInt8), path);
}

void writeVolume(const AnyVolume& volume, const fs::path& path) {
  std::visit([&](const auto& v) { write(imageOf(v, voxelTypeOf(volume)), path); }, volume);
}

}  // namespace angiomesh
