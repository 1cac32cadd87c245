// SPDX-License-Identifier: BSD-3-Clause
#include "io/dicom/dicom_source.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcistrmf.h>
#include <dcmtk/dcmdata/dctk.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <mutex>
#include <new>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

/// The elements of group 2, where the transfer syntax stands, lie within so many bytes.
constexpr std::size_t kHead = 1U << 14U;
constexpr const char* kDeflated = "1.2.840.10008.1.2.1.99";
constexpr std::string_view kPlain("1.2.840.10008.1.2.1\0", 20);

struct MetaInfo {
  bool deflated = false;
  std::size_t end = 0;  ///< where the data set begins
  std::string sopClass;
};

MetaInfo readMetaInfo(const fs::path& file) {
  MetaInfo info;
  DcmInputFileStream stream(file.c_str());
  DcmMetaInfo meta;
  meta.transferInit();
  const OFCondition status = meta.read(stream, EXS_Unknown, EGL_noChange, 1024);
  meta.transferEnd();
  OFString syntax, sopClass;
  if (status.bad() || meta.findAndGetOFString(DCM_TransferSyntaxUID, syntax).bad()) return info;
  meta.findAndGetOFString(DCM_MediaStorageSOPClassUID, sopClass);
  info.deflated = DcmXfer(syntax.c_str()).getXfer() == EXS_DeflatedLittleEndianExplicit;
  info.end = static_cast<std::size_t>(stream.tell());
  info.sopClass.assign(sopClass.c_str(), std::min<std::size_t>(sopClass.size(), 64));
  return info;
}

/// A UID of group 2.
std::string uid(char element, std::string text) {
  if (text.size() % 2 == 1) text += '\0';
  return std::string({'\2', '\0', element, '\0', 'U', 'I', static_cast<char>(text.size()), '\0'}) +
         text;
}

/// What can be inflated of `packed`; of a damaged stream, its beginning.
bool inflateTo(const MemoryFile& copy, std::string_view packed) {
  z_stream stream{};
  if (inflateInit2(&stream, -15) != Z_OK) return false;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<unsigned>(packed.size());
  std::array<char, 1U << 16U> part{};
  bool good = true;
  for (int state = Z_OK; state == Z_OK && good;) {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<unsigned>(part.size());
    state = inflate(&stream, Z_NO_FLUSH);
    good = copy.append({part.data(), part.size() - stream.avail_out});
  }
  inflateEnd(&stream);
  return good;
}

/// Loads DCMTK's dictionary, without which all attributes would be read as of unknown kind. Once,
/// by one thread: what fails within it, as for want of memory, leaves its lock held.
void requireDictionary() {
  enum class State { Unknown, Loaded, Missing, NoMemory };
  static std::mutex mutex;
  static State state = State::Unknown;
  const std::lock_guard lock(mutex);
  if (state == State::Unknown) {
    state = State::NoMemory;
    state = dcmDataDict.isDictionaryLoaded() ? State::Loaded : State::Missing;
  }
  if (state == State::NoMemory) throw std::bad_alloc();
  if (state == State::Missing)
    throw IoError("the dictionary of DICOM's attributes cannot be read", "DCMTK",
                  "raise the limit on open files (ulimit -n), unset DCMDICTPATH, or install DCMTK "
                  "anew");
}

}  // namespace

DicomSource::DicomSource(const fs::path& file) : path_(file) {
  requireDictionary();
  std::ifstream in(file, std::ios::binary);
  if (!in) throwNotOpened(file.filename().string(), errno);
  std::string bytes(kHead, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  if (bytes.find(kDeflated) == std::string::npos) return;
  const MetaInfo meta = readMetaInfo(file);
  if (!meta.deflated) return;
  bytes.append(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  copy_ = std::make_unique<MemoryFile>();
  const std::string head =
      std::string(128, '\0') + "DICM" + uid(2, meta.sopClass) + uid(0x10, std::string(kPlain));
  if (!copy_->append(head) ||
      !inflateTo(*copy_, std::string_view(bytes).substr(std::min(meta.end, bytes.size()))))
    throw IoError("there is no memory to inflate the file", file.filename().string(),
                  "close other programs");
  path_ = copy_->path();
}

void checkOpened(const fs::path& file, const OFCondition& status) {
  if (status.good()) return;
  const OpenFile again(file);
  if (!again.isOpen()) throwNotOpened(file.filename().string(), again.error());
  constexpr unsigned short kNotOpened = 18;  // DCMTK's own, with the system's words
  if (status.module() == OFM_dcmdata && status.code() == kNotOpened)
    throw IoError(std::string("it cannot be opened or read (") + status.text() + ")",
                  file.filename().string(),
                  "close other programs, or raise the limit on open files (ulimit -n)");
}

}  // namespace angiomesh
