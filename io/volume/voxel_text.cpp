// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/voxel_text.h"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

#include "core/base/error.h"
#include "io/file/open_file.h"

namespace angiomesh {
namespace {

constexpr std::size_t kCheckEvery = std::size_t{1} << 16;

std::string textOf(const VoxelPiece& piece) {
  const OpenFile file(piece.file);
  std::string text(static_cast<std::size_t>(piece.bytes), '\0');
  if (file.isOpen()) text.resize(file.readAt(piece.start, text.data(), text.size()));
  if (!file.isOpen() || (text.size() < piece.bytes && errno != 0))
    throw IoError("cannot read the file (" + std::generic_category().message(errno) + ")",
                  piece.file.string(), "check the name and the permissions");
  return text;
}

/// Numbers one after the other, between blanks, line ends and commas.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}
  /// Empty behind the last one.
  std::string_view next() {
    constexpr std::string_view kBetween(" \t\r\n\v\f,\0", 8);
    const std::size_t first = text_.find_first_not_of(kBetween, at_);
    if (first == std::string_view::npos) return {};
    at_ = std::min(text_.find_first_of(kBetween, first), text_.size());
    return text_.substr(first, at_ - first);
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

template <class T>
bool parse(std::string_view word, T& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  const auto whole = std::from_chars(word.data(), end, value);
  if (whole.ec == std::errc() && whole.ptr == end) return true;
  if constexpr (std::is_integral_v<T>) {
    // "12.0" in a file of integers.
    double real = 0.0;
    const auto other = std::from_chars(word.data(), end, real);
    if (other.ec != std::errc() || other.ptr != end || real != std::floor(real) ||
        std::fabs(real) > 9e15 || real < static_cast<double>(std::numeric_limits<T>::min()) ||
        real > static_cast<double>(std::numeric_limits<T>::max()))
      return false;
    value = static_cast<T>(real);
    return true;
  }
  return false;
}

[[noreturn]] void throwNoNumber(const VoxelData& data, std::size_t n, std::string_view word) {
  throw InputError("value " + std::to_string(n + 1) + " of its voxels is '" +
                       std::string(word.substr(0, 20)) + "', which is no " +
                       voxelTypeName(data.type),
                   data.pieces.front().file.string(), "write the image again");
}

template <class T>
std::vector<std::byte> numbers(const VoxelData& data, std::string_view text, std::uintmax_t& more,
                               const Progress& progress) {
  const auto count = static_cast<std::size_t>(data.voxels * data.values);
  std::vector<std::byte> bytes(count * sizeof(T));
  Words words(text);
  for (std::size_t n = 0; n < count; ++n) {
    if (n % kCheckEvery == 0) progress.check();
    const std::string_view word = words.next();
    if (word.empty()) throwTruncated(data.pieces.front().file, bytes.size(), n * sizeof(T));
    T value{};
    if (!parse(word, value)) throwNoNumber(data, n, word);
    std::memcpy(bytes.data() + n * sizeof(T), &value, sizeof(T));
  }
  for (more = 0; !words.next().empty(); ++more) continue;
  return bytes;
}

/// The bytes of the file as pairs of hexadecimal digits.
std::vector<std::byte> hexadecimal(const VoxelData& data, std::string_view text,
                                   std::uintmax_t& more) {
  const auto count = static_cast<std::size_t>(data.bytes());
  std::vector<std::byte> bytes(count);
  std::size_t digits = 0;
  for (const char c : text) {
    unsigned digit = 0;
    if (std::from_chars(&c, &c + 1, digit, 16).ec != std::errc()) continue;
    if (digits < 2 * count) bytes[digits / 2] = bytes[digits / 2] << 4 | std::byte(digit);
    ++digits;
  }
  if (digits < 2 * count) throwTruncated(data.pieces.front().file, count, digits / 2);
  more = (digits / 2 - count) / voxelTypeBytes(data.type);
  return bytes;
}

}  // namespace

std::vector<std::byte> bytesOfText(const VoxelData& data, std::uintmax_t& more,
                                   const Progress& progress) {
  const std::string text = textOf(data.pieces.front());
  if (data.text == VoxelText::Hexadecimal) return hexadecimal(data, text, more);
  return withVoxelType(
      data.type, [&](auto zero) { return numbers<decltype(zero)>(data, text, more, progress); });
}

}  // namespace angiomesh
