// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh/vtp_data.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace angiomesh {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

/// zlib packs no more than so many bytes into one; other packers do not come near for points.
constexpr std::uint64_t kMostPacking = 1032;
/// A block may be this large whatever it is packed into.
constexpr std::uint64_t kUsualBlock = 1U << 22U;

int base64Value(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  return c == '/' ? 63 : -1;
}

/// Takes bytes off a stored array. VTK encodes the numbers before packed data and the data each to
/// a base64 text of its own.
class ByteSource {
 public:
  ByteSource(std::string_view data, bool raw) : data_(data), raw_(raw) {}

  /// The next `count` bytes; false when there are not so many.
  bool take(std::uint64_t count, std::string& bytes) {
    bytes.clear();
    if (count > data_.size()) return false;
    if (raw_) {
      bytes = data_.substr(0, count);
      data_.remove_prefix(count);
      return true;
    }
    while (bytes.size() < count) {
      if (held_ == 0 && !decodeGroup()) return false;
      const std::size_t part = std::min<std::size_t>(count - bytes.size(), held_);
      bytes.append(group_ + (length_ - held_), part);
      held_ -= part;
    }
    return true;
  }

  /// Leaves what is left of the text that was begun, with its padding.
  void nextText() { held_ = 0; }

 private:
  /// Four characters to three bytes, less where they end in '='.
  bool decodeGroup() {
    data_.remove_prefix(std::min(data_.find_first_not_of(kBlanks), data_.size()));
    if (data_.size() < 4) return false;
    std::uint32_t bits = 0;
    length_ = 3;
    for (std::size_t i = 0; i < 4; ++i) {
      const bool padding = i >= 2 && data_[i] == '=';
      const int value = padding ? 0 : base64Value(data_[i]);
      if (value < 0) return false;
      if (padding) length_ = std::min(length_, i - 1);
      bits = (bits << 6U) | static_cast<std::uint32_t>(value);
    }
    for (std::size_t i = 0; i < 3; ++i)
      group_[i] = static_cast<char>((bits >> (16U - 8U * static_cast<unsigned>(i))) & 0xffU);
    held_ = length_;
    data_.remove_prefix(4);
    return true;
  }

  std::string_view data_;
  bool raw_;
  char group_[3] = {};
  std::size_t length_ = 0, held_ = 0;
};

bool takeWords(ByteSource& source, const VtpEncoding& encoding, std::uint64_t count,
               std::vector<std::uint64_t>& words) {
  std::string bytes;
  for (std::uint64_t w = 0; w < count; ++w) {
    if (!source.take(encoding.wordBytes, bytes)) return false;
    if (encoding.order == Encoding::BigEndian) std::reverse(bytes.begin(), bytes.end());
    std::uint64_t word = 0;
    for (std::size_t i = bytes.size(); i-- > 0;)
      word = (word << 8U) | static_cast<unsigned char>(bytes[i]);
    words.push_back(word);
  }
  return true;
}

bool unpack(const std::string& packer, std::string_view packed, std::uint64_t size,
            std::string& bytes) {
  if (size > std::max(kUsualBlock, kMostPacking * packed.size())) return false;
  if (packer != "vtkZLibDataCompressor") return unpackWithVtk(packer, packed, size, bytes);
  bytes.resize(size);
  uLongf length = size;
  return ::uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                      reinterpret_cast<const Bytef*>(packed.data()),
                      static_cast<uLong>(packed.size())) == Z_OK &&
         length == size;
}

std::optional<std::string> unpackBlocks(ByteSource& source, const VtpEncoding& encoding) {
  // Number of blocks, size of each unpacked, of the last one unless 0, and all sizes packed.
  std::vector<std::uint64_t> head, sizes;
  if (!takeWords(source, encoding, 3, head) || !takeWords(source, encoding, head[0], sizes))
    return {};
  source.nextText();
  std::string whole, packed, bytes;
  for (std::size_t b = 0; b < sizes.size(); ++b) {
    const bool shorter = b + 1 == sizes.size() && head[2] != 0;
    if (!source.take(sizes[b], packed) ||
        !unpack(encoding.packer, packed, shorter ? head[2] : head[1], bytes))
      return {};
    whole += bytes;
  }
  return whole;
}

}  // namespace

std::optional<std::string_view> xmlAttribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at)) {
    const bool whole = at > 0 && kBlanks.find(tag[at - 1]) != std::string_view::npos;
    at += name.size();
    const std::size_t equals = tag.find_first_not_of(kBlanks, at);
    if (!whole || equals == std::string_view::npos || tag[equals] != '=') continue;
    const std::size_t quote = tag.find_first_not_of(kBlanks, equals + 1);
    if (quote == std::string_view::npos || (tag[quote] != '"' && tag[quote] != '\'')) return {};
    const std::size_t end = tag.find(tag[quote], quote + 1);
    if (end == std::string_view::npos) return {};
    return tag.substr(quote + 1, end - quote - 1);
  }
  return {};
}

std::optional<std::string> vtpArrayBytes(std::string_view data, bool raw,
                                         const VtpEncoding& encoding) {
  ByteSource source(data, raw);
  if (!encoding.packer.empty()) return unpackBlocks(source, encoding);
  std::vector<std::uint64_t> length;
  std::string bytes;
  if (!takeWords(source, encoding, 1, length) || !source.take(length[0], bytes)) return {};
  return bytes;
}

}  // namespace angiomesh
