// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/voxel_data.h"

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <new>
#include <system_error>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "io/file/files.h"
#include "io/file/open_file.h"
#include "io/volume/voxel_text.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kRun = std::size_t{1} << 18;  // bytes of a run: they stay in the cache

using Take = std::function<void(std::size_t, std::span<const std::byte>)>;

/// A file of voxels, whose faults are thrown.
class VoxelFile {
 public:
  explicit VoxelFile(const fs::path& path) : path_(path), file_(path) {
    if (!file_.isOpen()) refuse("check the name and the permissions");
  }

  /// The number of bytes read, less than asked for at the end of the file only.
  std::size_t readAt(std::uintmax_t start, std::byte* to, std::size_t bytes) const {
    const std::size_t got = file_.readAt(start, to, bytes);
    if (got < bytes && errno != 0) refuse("check the medium");
    return got;
  }

 private:
  [[noreturn]] void refuse(const char* advice) const {
    throw IoError("cannot read the file (" + std::generic_category().message(errno) + ")",
                  path_.string(), advice);
  }

  fs::path path_;
  OpenFile file_;
};

/// Which part of the data is wanted, and how it is laid out in runs.
struct Layout {
  std::size_t itemBytes;  ///< of one value
  std::size_t stride;     ///< bytes from one voxel to the next in the data
  std::size_t offset;     ///< of the wanted value among those of a voxel
  std::uintmax_t start;   ///< of the first voxel in the data
  std::size_t voxels;
  std::size_t runVoxels;

  Layout(const VoxelData& data, std::uintmax_t value)
      : itemBytes(voxelTypeBytes(data.type)),
        stride(data.interleaved ? itemBytes * static_cast<std::size_t>(data.values) : itemBytes),
        offset(data.interleaved ? itemBytes * static_cast<std::size_t>(value) : 0),
        start(data.interleaved ? 0 : value * data.voxels * itemBytes),
        voxels(static_cast<std::size_t>(data.voxels)),
        runVoxels(std::max<std::size_t>(kRun / stride, 1)) {}

  [[nodiscard]] std::size_t inRun(std::size_t first) const {
    return std::min(runVoxels, voxels - first);
  }
};

template <std::size_t size>
void swapEach(std::byte* bytes, std::size_t count) {
  for (std::byte* at = bytes; at != bytes + count * size; at += size) std::reverse(at, at + size);
}

/// Brings the wanted values of a run to its front, in this machine's byte order.
std::span<const std::byte> wanted(std::byte* run, std::size_t count, const Layout& layout,
                                  bool swapBytes) {
  if (layout.stride != layout.itemBytes)
    for (std::size_t i = 0; i < count; ++i)
      std::memmove(run + i * layout.itemBytes, run + i * layout.stride + layout.offset,
                   layout.itemBytes);
  if (swapBytes && layout.itemBytes == 2) swapEach<2>(run, count);
  if (swapBytes && layout.itemBytes == 4) swapEach<4>(run, count);
  if (swapBytes && layout.itemBytes == 8) swapEach<8>(run, count);
  return {run, count * layout.itemBytes};
}

void readPlain(const VoxelData& data, const Layout& layout, const Take& take,
               const Progress& progress) {
  const std::vector<VoxelPiece>& pieces = data.pieces;
  std::vector<std::uintmax_t> begin;  // of each piece in the data
  std::uintmax_t total = 0;
  for (const VoxelPiece& piece : pieces) {
    begin.push_back(total);
    total += piece.bytes;
  }
  std::unique_ptr<VoxelFile> only;
  if (pieces.size() == 1) only = std::make_unique<VoxelFile>(pieces.front().file);
  const auto fetch = [&](std::uintmax_t at, std::byte* to, std::size_t bytes) {
    while (bytes > 0) {
      const auto next = std::upper_bound(begin.begin(), begin.end(), at);
      const auto n = static_cast<std::size_t>(next - begin.begin()) - 1;
      const VoxelPiece& piece = pieces[n];
      const std::uintmax_t inside = at - begin[n];
      const auto part = static_cast<std::size_t>(
          std::min<std::uintmax_t>(bytes, piece.bytes > inside ? piece.bytes - inside : 0));
      const std::size_t got = only ? only->readAt(piece.start + inside, to, part)
                                   : VoxelFile(piece.file).readAt(piece.start + inside, to, part);
      if (got < part || part == 0) throwTruncated(piece.file, piece.bytes, inside + got);
      at += part;
      to += part;
      bytes -= part;
    }
  };
  parallelFor(0, layout.voxels, layout.runVoxels, [&](std::size_t first, std::size_t last) {
    progress.check();
    thread_local std::vector<std::byte> run;
    run.resize((last - first) * layout.stride);
    fetch(layout.start + first * layout.stride, run.data(), run.size());
    take(first, wanted(run.data(), last - first, layout, data.swapBytes));
    progress.report(static_cast<double>(last) / static_cast<double>(layout.voxels));
  });
}

/// What a zlib or gzip stream, or several gzip streams in a row, yields.
class Inflater {
 public:
  explicit Inflater(const VoxelPiece& piece) : piece_(piece), file_(piece.file) {
    if (inflateInit2(&stream_, 15 + 32) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// The number of bytes put to `to`, less than asked for at the end of the last stream only.
  std::size_t read(std::byte* to, std::size_t bytes) {
    std::size_t got = 0;
    while (got < bytes && !ended_) {
      if (stream_.avail_in == 0 && !refill()) truncated();
      stream_.next_out = reinterpret_cast<Bytef*>(to + got);
      stream_.avail_out = static_cast<unsigned>(bytes - got);
      const int state = inflate(&stream_, Z_NO_FLUSH);
      const std::size_t now = bytes - got - stream_.avail_out;
      got += now;
      total_ += now;
      if (state == Z_STREAM_END)
        nextStream();
      else if (state == Z_BUF_ERROR && stream_.avail_in == 0)
        continue;
      else if (state != Z_OK)
        throw IoError("the compressed voxels are damaged", piece_.file.string(), kCopyAgain);
    }
    return got;
  }

 private:
  bool refill() {
    const std::uintmax_t left = piece_.bytes - at_;
    const std::size_t got =
        file_.readAt(piece_.start + at_, packed_.data(),
                     static_cast<std::size_t>(std::min<std::uintmax_t>(left, packed_.size())));
    at_ += got;
    stream_.next_in = reinterpret_cast<Bytef*>(packed_.data());
    stream_.avail_in = static_cast<unsigned>(got);
    return got > 0;
  }

  /// Bytes behind a stream that begin no other one are left alone, as gzip does.
  void nextStream() {
    if (stream_.avail_in == 0) refill();
    ended_ = stream_.avail_in == 0 || stream_.next_in[0] != 0x1f;
    if (!ended_) inflateReset(&stream_);
  }

  [[noreturn]] void truncated() const {
    throw IoError("the file is truncated (its compressed voxels end after " +
                      std::to_string(total_) + " bytes)",
                  piece_.file.string(), kCopyAgain);
  }

  VoxelPiece piece_;
  VoxelFile file_;
  std::uintmax_t at_ = 0;
  std::uintmax_t total_ = 0;
  bool ended_ = false;
  std::vector<std::byte> packed_ = std::vector<std::byte>(std::size_t{1} << 16);
  z_stream stream_{};
};

std::uintmax_t readDeflated(const VoxelData& data, const Layout& layout, const Take& take,
                            const Progress& progress) {
  const VoxelPiece& piece = data.pieces.front();
  Inflater inflater(piece);
  std::vector<std::byte> run(std::max(layout.runVoxels * layout.stride, kRun));
  for (std::uintmax_t skip = data.skipInflated + layout.start; skip > 0;) {
    progress.check();
    const auto part = static_cast<std::size_t>(std::min<std::uintmax_t>(skip, run.size()));
    if (inflater.read(run.data(), part) < part) throwTruncated(piece.file, data.bytes(), 0);
    skip -= part;
  }
  for (std::size_t first = 0; first < layout.voxels; first += layout.runVoxels) {
    const std::size_t count = layout.inRun(first);
    const std::size_t bytes = count * layout.stride;
    if (const std::size_t got = inflater.read(run.data(), bytes); got < bytes)
      throwTruncated(piece.file, data.bytes(), layout.start + first * layout.stride + got);
    take(first, wanted(run.data(), count, layout, data.swapBytes));
    progress.report(static_cast<double>(first + count) / static_cast<double>(layout.voxels));
  }
  // To the end: the check sum comes last. A little beyond what is due: a file may unpack for hours.
  const std::uintmax_t due = data.bytes() - layout.start - layout.voxels * layout.stride;
  std::uintmax_t rest = 0;
  for (std::size_t got = 1; got > 0 && rest < due + kMostCounted; rest += got) {
    progress.check();
    got = inflater.read(run.data(), run.size());
  }
  if (rest < due) throwTruncated(piece.file, data.bytes(), data.bytes() - due + rest);
  return (rest - due) / layout.itemBytes;
}

std::uintmax_t readText(const VoxelData& data, const Layout& layout, const Take& take,
                        const Progress& progress) {
  std::uintmax_t more = 0;
  const std::vector<std::byte> bytes = bytesOfText(data, more, progress.sub(0.0, 0.8));
  const bool swap = data.swapBytes && data.text == VoxelText::Hexadecimal;
  std::vector<std::byte> run;
  for (std::size_t first = 0; first < layout.voxels; first += layout.runVoxels) {
    const std::size_t count = layout.inRun(first);
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(layout.start) +
                      static_cast<std::ptrdiff_t>(first * layout.stride);
    run.assign(from, from + static_cast<std::ptrdiff_t>(count * layout.stride));
    take(first, wanted(run.data(), count, layout, swap));
  }
  return more;
}

}  // namespace

void throwTruncated(const fs::path& path, std::uintmax_t expected, std::uintmax_t found) {
  throw IoError("the file is truncated (" + std::to_string(found) + " of " +
                    std::to_string(expected) + " bytes of voxels)",
                path.string(), kCopyAgain);
}

std::uintmax_t readVoxels(const VoxelData& data, std::uintmax_t value, const Take& take,
                          const Progress& progress) {
  const Layout layout(data, value);
  if (data.text != VoxelText::None) return readText(data, layout, take, progress);
  if (data.deflated) return readDeflated(data, layout, take, progress);
  readPlain(data, layout, take, progress);
  return 0;
}

}  // namespace angiomesh
