// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/image_format.h"

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <memory>
#include <new>
#include <system_error>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "io/file/files.h"
#include "io/file/open_file.h"
#include "io/file/text_scanner.h"
#include "io/volume/header_text.h"
#include "io/volume/image_header.h"
#include "io/volume/writable_image.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

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

bool isMetaImage(const std::string& head, const fs::path& /*path*/) {
  return head.find("NDims") != std::string::npos && head.find('=') != std::string::npos;
}

bool isNrrd(const std::string& head, const fs::path& /*path*/) {
  return head.starts_with("NRRD00");
}

bool isNifti(const std::string& head, const fs::path& path) {
  constexpr int kHeader = 348, kHeader2 = 540;
  if (head.size() < 4) return false;
  const auto size = fromBytes<std::int32_t>(head, 0, false);
  const auto swapped = fromBytes<std::int32_t>(head, 0, true);
  if (size == kHeader2 || swapped == kHeader2)
    throw InputError("a NIfTI-2 file, which is not read", path.string(), "convert it to NIfTI-1");
  if (size != kHeader && swapped != kHeader) return false;
  if (head.size() < kHeader) throw IoError("the file is truncated", path.string(), kCopyAgain);
  return true;
}

bool isDicom(const std::string& head, const fs::path& /*path*/) {
  if (head.size() > 132 && head.compare(128, 4, "DICM") == 0) return true;
  // Old files have no preamble: they begin with a tag of group 8, little endian.
  return head.size() > 8 && head[0] == 8 && head[1] == 0 && head[3] == 0 &&
         (head[2] == 0 || head[2] == 1 || head[2] == 5 || head[2] == 8 || head[2] == 0x16);
}

/// What to give instead of a file that is none.
std::string allFormats() {
  std::vector<std::string> words{"a DICOM file or folder"};
  for (const ImageFormat& format : imageFormats())
    if (!format.isDicom()) words.push_back(joined(format.endings, "/", &ImageEnding::text));
  return "give " + eitherOf(words);
}

}  // namespace

const std::vector<ImageFormat>& imageFormats() {
  static const std::vector<ImageFormat> formats{
      {"MetaImage",
       {{".mha", writeMha}, {".mhd", writeMhd}},
       false,
       isMetaImage,
       readMetaImageHeader},
      {"NRRD", {{".nrrd", writeNrrd}, {".nhdr", writeNhdr}}, false, isNrrd, readNrrdHeader},
      {"NIfTI", {{".nii.gz", writeNiiGz}, {".nii", writeNii}}, true, isNifti, readNiftiHeader},
      {"DICOM", {{".dcm", nullptr}}, false, isDicom, nullptr},
  };
  return formats;
}

const ImageFormat& imageFormat(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw IoError("there is no such file", path.string(), "check the name");
  if (!fs::is_regular_file(status))
    throw IoError("not a regular file", path.string(), allFormats());
  if (fs::file_size(path, error) == 0)
    throw IoError("the file is empty", path.string(), kCopyAgain);
  bool gzip = false;
  const std::string head = firstBytes(path, 4096, gzip);
  if (gzip && head.empty()) throw IoError("the file is truncated", path.string(), kCopyAgain);
  const auto& all = imageFormats();
  // From the strictest on: what MetaImage is known by may stand in the comments of any other.
  const auto found = std::find_if(all.rbegin(), all.rend(), [&](const ImageFormat& format) {
    return format.begins(head, path);
  });
  if (found == all.rend()) throw InputError("not an image file", path.string(), allFormats());
  if (gzip && !found->zipped)
    throw InputError("the whole file is compressed with gzip", path.string(), "gunzip it first");
  return *found;
}

std::vector<std::string> imageEndings(bool onlyWritten) {
  std::vector<std::string> endings;
  for (const ImageFormat& format : imageFormats())
    for (const ImageEnding& ending : format.endings)
      if (ending.write != nullptr || !onlyWritten) endings.emplace_back(ending.text);
  return endings;
}

const ImageEnding* imageEndingOf(const fs::path& path) {
  const std::string name = inSmall(path.filename().string());
  for (const ImageFormat& format : imageFormats())
    for (const ImageEnding& ending : format.endings)
      if (name.ends_with(ending.text)) return &ending;
  return nullptr;
}

bool looksLikeDicom(const fs::path& path) {
  const OpenFile file(path);
  if (!file.isOpen()) throwNotOpened(path.filename().string(), file.error());
  std::string head(140, '\0');
  head.resize(file.readAt(0, head.data(), head.size()));
  if (head.size() < 140 && errno != 0) throwNotOpened(path.filename().string(), errno);
  return isDicom(head, path);
}

}  // namespace angiomesh
