// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/image_format.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <system_error>

#include "core/base/error.h"
#include "io/file/files.h"
#include "io/file/open_file.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

const char* const kFormats = "give a DICOM file or folder, .mha/.mhd, .nrrd/.nhdr or .nii/.nii.gz";

struct GzClose {
  void operator()(gzFile file) const { gzclose(file); }
};
/// Reads plain files as well as gzip files.
using GzFile = std::unique_ptr<gzFile_s, GzClose>;

GzFile openGz(const fs::path& path) {
  GzFile file(gzopen(path.c_str(), "rb"));
  if (!file) throwNotOpened(path.string(), errno);
  gzbuffer(file.get(), 1U << 17U);
  return file;
}

std::string firstBytes(const fs::path& path, std::size_t count, bool& gzip) {
  const GzFile file = openGz(path);
  gzip = gzdirect(file.get()) == 0;
  std::string bytes(count, '\0');
  const int got = gzread(file.get(), bytes.data(), static_cast<unsigned>(count));
  int fault = Z_OK;
  if (got < 0) (void)gzerror(file.get(), &fault);
  if (fault == Z_MEM_ERROR) throw std::bad_alloc();
  bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return bytes;
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

bool looksLikeMetaImage(const std::string& head) {
  return head.find("NDims") != std::string::npos && head.find('=') != std::string::npos;
}

bool isDicomHead(const std::string& head) {
  if (head.size() > 132 && head.compare(128, 4, "DICM") == 0) return true;
  // Old files have no preamble: they begin with a tag of group 8, little endian.
  return head.size() > 8 && head[0] == 8 && head[1] == 0 && head[3] == 0 &&
         (head[2] == 0 || head[2] == 1 || head[2] == 5 || head[2] == 8 || head[2] == 0x16);
}

}  // namespace

ImageFormat imageFormat(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw IoError("there is no such file", path.string(), "check the name");
  if (!fs::is_regular_file(status)) throw IoError("not a regular file", path.string(), kFormats);
  if (fs::file_size(path, error) == 0)
    throw IoError("the file is empty", path.string(), kCopyAgain);
  bool gzip = false;
  const std::string head = firstBytes(path, 4096, gzip);
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
  const OpenFile file(path);
  if (!file.isOpen()) throwNotOpened(path.filename().string(), file.error());
  std::string head(140, '\0');
  head.resize(file.readAt(0, head.data(), head.size()));
  if (head.size() < 140 && errno != 0) throwNotOpened(path.filename().string(), errno);
  return isDicomHead(head);
}

}  // namespace angiomesh
