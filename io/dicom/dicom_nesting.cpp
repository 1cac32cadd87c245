// SPDX-License-Identifier: BSD-3-Clause
#include "io/dicom/dicom_nesting.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "io/file/open_file.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDeepest = 100;  // real files nest less than ten
constexpr std::uint32_t kUndefined = 0xffffffffU;
constexpr std::uint32_t kItem = 0xfffee000U, kItemEnd = 0xfffee00dU, kSequenceEnd = 0xfffee0ddU;
constexpr std::uint64_t kNoEnd = std::numeric_limits<std::uint64_t>::max();

/// Bytes of a file by their place, through a window.
class Window {
 public:
  explicit Window(const fs::path& file) : file_(file) {
    if (!file_.isOpen()) throwNotOpened(file.filename().string(), file_.error());
  }

  /// Null behind the end.
  const unsigned char* at(std::uint64_t place, std::size_t count) {
    if (place < start_ || place + count > start_ + got_) fill(place);
    return place >= start_ && place + count <= start_ + got_ ? bytes_.data() + (place - start_)
                                                             : nullptr;
  }

 private:
  void fill(std::uint64_t place) {
    start_ = place;
    got_ = file_.readAt(place, bytes_.data(), bytes_.size());
  }

  OpenFile file_;
  std::array<unsigned char, 1U << 13U> bytes_{};
  std::uint64_t start_ = 0;
  std::size_t got_ = 0;
};

struct Encoding {
  bool implicit = false, bigEndian = false;
};

std::uint32_t number(const unsigned char* bytes, std::size_t count, bool bigEndian) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i)
    value = (value << 8U) | bytes[bigEndian ? i : count - 1 - i];
  return value;
}

std::uint32_t tagAt(const unsigned char* bytes, bool bigEndian) {
  return (number(bytes, 2, bigEndian) << 16U) | number(bytes + 2, 2, bigEndian);
}

/// The head of an element (PS3.5 7.1).
struct Head {
  std::uint32_t tag = 0, length = 0;
  std::string vr;  ///< empty: implicit
  std::size_t bytes = 8;
};

bool isDelimiter(std::uint32_t tag) { return tag >> 16U == 0xfffeU; }

bool readHead(Window& window, std::uint64_t at, const Encoding& encoding, Head& head) {
  const unsigned char* bytes = window.at(at, 8);
  if (bytes == nullptr) return false;
  head = {};
  head.tag = tagAt(bytes, encoding.bigEndian);
  const bool named = bytes[4] >= 'A' && bytes[4] <= 'Z' && bytes[5] >= 'A' && bytes[5] <= 'Z';
  if (encoding.implicit || isDelimiter(head.tag) || !named) {
    head.length = number(bytes + 4, 4, encoding.bigEndian);
    return true;
  }
  head.vr.assign(reinterpret_cast<const char*>(bytes) + 4, 2);
  constexpr std::string_view kLong = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
  if (kLong.find(head.vr) == std::string_view::npos) {
    head.length = number(bytes + 6, 2, encoding.bigEndian);
    return true;
  }
  head.bytes = 12;
  bytes = window.at(at, 12);
  if (bytes == nullptr) return false;
  head.length = number(bytes + 8, 4, encoding.bigEndian);
  return true;
}

struct Start {
  std::uint64_t at = 0;
  Encoding encoding;
  bool deflated = false;
  bool sequences = false;  ///< in group 2
};

/// Skips the elements of group 2 and finds out how those behind them are written.
Start startOf(Window& window) {
  Start start;
  const unsigned char* magic = window.at(128, 4);
  start.at = magic != nullptr && std::memcmp(magic, "DICM", 4) == 0 ? 132 : 0;
  std::string syntax;
  Head head;
  while (readHead(window, start.at, {}, head) && head.tag >> 16U == 2) {
    start.at += head.bytes;
    if (head.length == kUndefined || head.vr == "SQ" || head.vr == "UN") start.sequences = true;
    if (head.tag == 0x00020010U && head.length < 65)
      if (const unsigned char* text = window.at(start.at, head.length))
        syntax.assign(reinterpret_cast<const char*>(text), head.length);
    start.at += head.length;
  }
  while (!syntax.empty() && (syntax.back() == '\0' || syntax.back() == ' ')) syntax.pop_back();
  start.deflated = syntax == "1.2.840.10008.1.2.1.99";
  start.encoding.bigEndian = syntax == "1.2.840.10008.1.2.2";
  // The first element tells, as it does DCMTK, whatever group 2 says.
  if (readHead(window, start.at, {false, start.encoding.bigEndian}, head))
    start.encoding.implicit = head.vr.empty();
  return start;
}

struct Level {
  std::uint64_t end = kNoEnd;
  Encoding encoding;
  bool item = false;
  bool fragments = false;  ///< a sequence of raw bytes
};

}  // namespace

bool nestsTooDeeply(const fs::path& file) {
  Window window(file);
  const Start start = startOf(window);
  if (start.sequences || start.deflated) return start.sequences;
  std::uint64_t at = start.at;
  Level top;
  top.encoding = start.encoding;
  std::vector<Level> levels{top};
  Head head;
  while (levels.size() <= 2 * kDeepest) {
    while (levels.size() > 1 && at >= levels.back().end) levels.pop_back();
    const Level& here = levels.back();
    if (!readHead(window, at, here.encoding, head)) return false;
    at += head.bytes;
    const std::uint64_t end = head.length == kUndefined ? kNoEnd : at + head.length;
    if (head.tag == kItemEnd || head.tag == kSequenceEnd) {
      while (levels.size() > 1) {
        const bool found = levels.back().item == (head.tag == kItemEnd);
        levels.pop_back();
        if (found) break;
      }
    } else if (head.tag == kItem) {
      if (here.fragments && end != kNoEnd)
        at = end;
      else
        levels.push_back({end, here.encoding, true, false});
    } else {
      // What is unknown is written without names inside (PS3.5 6.2.2). Whether a value without a
      // name is a sequence shows in its first bytes.
      const bool unnamed = head.vr.empty() || head.vr == "UN";
      Encoding inside = here.encoding;
      inside.implicit = inside.implicit || unnamed;
      const unsigned char* first = unnamed ? window.at(at, 4) : nullptr;
      const bool sequence = head.vr == "SQ" || (first != nullptr && head.length >= 8 &&
                                                tagAt(first, inside.bigEndian) == kItem);
      if (end == kNoEnd || sequence)
        levels.push_back({end, inside, false, !unnamed && head.vr != "SQ"});
      else
        at = end;
    }
  }
  return true;
}

}  // namespace angiomesh
