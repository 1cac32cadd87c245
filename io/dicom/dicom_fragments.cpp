// SPDX-License-Identifier: BSD-3-Clause
#include "io/dicom/dicom_fragments.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace angiomesh {
namespace {

/// The head of a picture lies within so many bytes of its first fragment. That of JPEG 2000 may
/// list the lengths of all packets.
constexpr std::uint64_t kHead = 1U << 16U, kJpeg2000Head = 1U << 20U;
/// A tile of a JPEG 2000 picture takes the markers SOT and SOD at least.
constexpr std::uint64_t kLeastTile = 14;

class Bytes {
 public:
  explicit Bytes(const std::vector<unsigned char>& bytes) : bytes_(bytes) {}

  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  /// The number of `count` bytes, the most significant first; 0 behind the end.
  [[nodiscard]] std::uint64_t at(std::size_t offset, std::size_t count) const {
    std::uint64_t value = 0;
    for (std::size_t i = offset; i < offset + count; ++i)
      value = (value << 8U) | (i < bytes_.size() ? bytes_[i] : 0U);
    return value;
  }

 private:
  const std::vector<unsigned char>& bytes_;
};

struct CodedPicture {
  std::uint64_t width = 0, height = 0;  ///< 0: not stated
  // Of JPEG 2000:
  std::uint64_t tiles = 1;
  std::uint64_t components = 1;
  std::uint64_t sample = 0;  ///< bits and sign, then the steps between samples, a byte each
};

/// By the frame header of JPEG (ITU-T T.81 B.2.2) and JPEG-LS (T.87 C.2.2).
CodedPicture jpegPicture(const Bytes& bytes) {
  for (std::size_t at = 2; at + 9 <= bytes.size();) {
    if (bytes.at(at, 1) != 0xff) break;
    const auto marker = static_cast<unsigned>(bytes.at(at + 1, 1));
    const bool frame =
        (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc) ||
        marker == 0xf7;
    if (frame) return {bytes.at(at + 7, 2), bytes.at(at + 5, 2)};
    if (marker == 0xda || marker == 0xd9) break;
    if (marker == 0xff)
      ++at;  // fills up
    else if (marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8))
      at += 2;  // stands alone
    else
      at += 2 + static_cast<std::size_t>(bytes.at(at + 2, 2));
  }
  return {};
}

/// By the marker SIZ (T.800 A.5.1) at `at`.
CodedPicture jpeg2000Picture(const Bytes& bytes, std::size_t at) {
  const auto extent = [&](std::size_t end, std::size_t begin) {
    const std::uint64_t to = bytes.at(at + end, 4), from = bytes.at(at + begin, 4);
    return to > from ? to - from : 0;
  };
  const auto count = [&](std::size_t end, std::size_t begin, std::size_t tile) {
    const std::uint64_t each = std::max<std::uint64_t>(bytes.at(at + tile, 4), 1);
    return (extent(end, begin) + each - 1) / each;
  };
  return {extent(6, 14), extent(10, 18), count(6, 30, 22) * count(10, 34, 26), bytes.at(at + 38, 2),
          bytes.at(at + 40, 3)};
}

/// Where the JPEG 2000 codestream begins: at the front, or in the boxes of a JP2 file (T.800 I.4).
/// npos where the boxes lead nowhere.
std::size_t codestreamStart(const Bytes& bytes) {
  constexpr std::uint64_t kCodestreamBox = 0x6a703263;  // jp2c
  if (bytes.at(0, 2) == 0xff4f) return 0;
  for (std::size_t at = 0; at + 10 <= bytes.size();) {
    const std::uint64_t length = bytes.at(at, 4);
    if (bytes.at(at + 4, 4) == kCodestreamBox)
      return bytes.at(at + 8, 2) == 0xff4f ? at + 8 : std::string::npos;
    if (length < 8) break;
    at += static_cast<std::size_t>(length);
  }
  return std::string::npos;
}

/// Whether all markers from the start of the codestream to the data of the first tile are there.
/// GDCM follows them, and out of the stream where it has to.
bool hasWholeHead(const Bytes& bytes, std::size_t start) {
  for (std::size_t at = start + 2; at + 4 <= bytes.size();) {
    const std::uint64_t marker = bytes.at(at, 2), length = bytes.at(at + 2, 2);
    if (marker == 0xff93) return true;
    if (marker < 0xff50 || marker > 0xff90 || length < 2) return false;
    at += 2 + static_cast<std::size_t>(length);
  }
  return false;
}

int bitsOf(const CodedPicture& picture) {
  return static_cast<int>((picture.sample >> 16U) & 0x7fU) + 1;
}

std::string sizeText(const CodedPicture& picture) {
  return "a compressed picture has " + std::to_string(picture.width) + " x " +
         std::to_string(picture.height) + " pixels";
}

/// Whether DCMTK, looking for the frame header, comes to the marker TEM, which no encoder leaves in
/// a file: it never goes on from there.
bool comesToTem(const Bytes& bytes) {
  for (std::size_t at = 0; at + 4 <= bytes.size();) {
    const std::uint64_t marker = bytes.at(at, 2);
    if (marker == 0xff01) return true;
    if (marker == 0xffff) {
      ++at;  // fills up
      continue;
    }
    const bool alone =
        (marker >= 0xffd0 && marker <= 0xffd9) || (marker > 0xff02 && marker < 0xffc0);
    const bool segment = marker == 0xffc4 || marker == 0xffc8 || marker == 0xffcc ||
                         (marker >= 0xffda && marker <= 0xfffe);
    if (!alone && !segment) return false;  // the frame header, or nothing that DCMTK knows
    at += 2 + (segment ? static_cast<std::size_t>(bytes.at(at + 2, 2)) : 0);
  }
  return false;
}

std::string jpegDamage(const Bytes& head, const DicomFile& file) {
  if (comesToTem(head)) return "the marker TEM in a JPEG picture";
  if (head.at(0, 2) != 0xffd8) return {};
  const CodedPicture picture = jpegPicture(head);
  return picture.width * picture.height > file.pixels() ? sizeText(picture) : std::string();
}

/// GDCM copies what it decodes, whatever its size is. `sample`: of the first frame, 0 before it.
std::string jpeg2000Damage(const Bytes& head, const DicomFile& file, std::uint64_t fileBytes,
                           std::uint64_t& sample) {
  const std::size_t start = codestreamStart(head);
  if (start == std::string::npos || !hasWholeHead(head, start))
    return "the head of a JPEG 2000 picture";
  const CodedPicture picture = jpeg2000Picture(head, start + 2);
  if (picture.width != static_cast<std::uint64_t>(file.columns) ||
      picture.height != static_cast<std::uint64_t>(file.rows))
    return sizeText(picture);
  if (picture.tiles > 1 && picture.tiles * kLeastTile > fileBytes)
    return "a compressed picture claims " + std::to_string(picture.tiles) + " tiles";
  if (sample == 0) sample = picture.sample;
  // GDCM ends the program where bytes are not used up by 8 bits, or four of them by 32.
  const int bits = bitsOf(picture);
  if ((bits < 8 || bits > 16) && bits != 32)
    return "a compressed picture of " + std::to_string(bits) + " bits";
  const bool everyPixel = (picture.sample & 0xffffU) == 0x0101U;
  if (picture.components != 1 || !everyPixel || picture.sample != sample)
    return "compressed pictures of another kind than the header states";
  return {};
}

/// The first bytes of a fragment.
bool readHead(DcmPixelItem& item, std::uint64_t most, std::vector<unsigned char>& bytes) {
  bytes.resize(std::min<std::uint64_t>(item.getLengthField(), most));
  return item.getPartialValue(bytes.data(), 0, static_cast<Uint32>(bytes.size())).good();
}

/// Of RLE and JPEG 2000.
std::string streamsDamage(DcmPixelSequence& fragments, const DicomFile& file,
                          std::uint64_t fileBytes) {
  const auto streams = frameStreams(fragments, file);
  if (streams.empty()) return "it is not clear which of its fragments belong to which frame";
  std::uint64_t sample = 0;
  for (const std::vector<unsigned char>& stream : streams) {
    if (stream.empty()) return "a fragment is empty";
    if (!file.layout.jpeg2000) continue;
    const std::vector<unsigned char> begin(
        stream.begin(), stream.begin() + static_cast<std::ptrdiff_t>(
                                             std::min<std::size_t>(stream.size(), kJpeg2000Head)));
    std::string damage = jpeg2000Damage(Bytes(begin), file, fileBytes, sample);
    if (!damage.empty()) return damage;
  }
  return {};
}

std::string fragmentsDamage(DcmPixelSequence& fragments, const DicomFile& file,
                            std::uint64_t fileBytes) {
  std::uint64_t total = 0;
  for (unsigned long i = 0; i < fragments.card(); ++i) {
    DcmPixelItem* item = nullptr;
    if (fragments.getItem(item, i).bad() || item == nullptr) return "a fragment is missing";
    const std::uint64_t length = item->getLengthField();
    total += length;
    if (total > fileBytes) return "its fragments are longer than the file";
  }
  if (file.layout.jpeg2000 || file.layout.rle) return streamsDamage(fragments, file, fileBytes);
  for (unsigned long i = 1; i < fragments.card(); ++i) {
    DcmPixelItem* item = nullptr;
    std::vector<unsigned char> bytes;
    if (fragments.getItem(item, i).bad() || !readHead(*item, kHead, bytes))
      return "a fragment cannot be read";
    if (bytes.empty()) continue;
    std::string damage = jpegDamage(Bytes(bytes), file);
    if (!damage.empty()) return damage;
  }
  return {};
}

/// Whether a fragment begins a frame: an RLE head states its segments and where the first one is, a
/// JPEG 2000 codestream or JP2 file has a signature.
bool beginsFrame(const std::vector<unsigned char>& bytes, const DicomFile& file) {
  const Bytes head(bytes);
  if (file.layout.jpeg2000)
    return head.at(0, 4) == 0xff4fff51 || head.at(4, 4) == 0x6a502020;  // SOC and SIZ, "jP  "
  const auto segments = static_cast<std::uint64_t>(std::max(file.layout.allocated / 8, 1));
  return bytes.size() >= 64 && head.at(0, 4) == segments << 24U && head.at(4, 4) == 64U << 24U;
}

/// The numbers of the fragments with which frames begin, by the table of offsets; empty without
/// one.
std::vector<unsigned long> startsByTable(DcmPixelSequence& fragments) {
  DcmPixelItem* table = nullptr;
  std::vector<unsigned char> bytes;
  if (fragments.getItem(table, 0).bad() || !readHead(*table, kJpeg2000Head, bytes)) return {};
  std::vector<unsigned long> starts;
  std::uint64_t at = 0;
  for (unsigned long i = 1; i < fragments.card() && 4 * starts.size() + 4 <= bytes.size(); ++i) {
    const std::size_t entry = 4 * starts.size();
    std::uint64_t offset = 0;
    for (std::size_t b = 4; b-- > 0;) offset = offset << 8U | bytes[entry + b];
    if (offset == at) starts.push_back(i);
    DcmPixelItem* item = nullptr;
    if (fragments.getItem(item, i).bad()) return {};
    at += 8 + item->getLengthField();  // behind its tag and length
  }
  return starts;
}

/// The same, whatever says it; empty where nothing does.
std::vector<unsigned long> frameStarts(DcmPixelSequence& fragments, const DicomFile& file) {
  const unsigned long count = fragments.card();
  const auto frames = static_cast<std::size_t>(file.frames);
  if (count < 2) return {};
  if (frames == 1) return {1};
  std::vector<unsigned long> starts;
  if (count == frames + 1) {
    for (unsigned long i = 1; i < count; ++i) starts.push_back(i);
    return starts;
  }
  starts = startsByTable(fragments);
  if (starts.size() == frames) return starts;
  starts.clear();
  for (unsigned long i = 1; i < count; ++i) {
    DcmPixelItem* item = nullptr;
    std::vector<unsigned char> bytes;
    if (fragments.getItem(item, i).bad() || !readHead(*item, 64, bytes)) return {};
    if (beginsFrame(bytes, file)) starts.push_back(i);
  }
  return starts.size() == frames && starts.front() == 1 ? starts : std::vector<unsigned long>{};
}

}  // namespace

DcmPixelSequence* fragmentsOf(DcmDataset& data) {
  DcmElement* element = nullptr;
  if (data.findAndGetElement(DCM_PixelData, element).bad()) return nullptr;
  auto* pixels = dynamic_cast<DcmPixelData*>(element);
  if (pixels == nullptr) return nullptr;
  E_TransferSyntax syntax = EXS_Unknown;
  const DcmRepresentationParameter* parameter = nullptr;
  pixels->getOriginalRepresentationKey(syntax, parameter);
  DcmPixelSequence* fragments = nullptr;
  return pixels->getEncapsulatedRepresentation(syntax, parameter, fragments).good() ? fragments
                                                                                    : nullptr;
}

std::vector<std::vector<unsigned char>> frameStreams(DcmPixelSequence& fragments,
                                                     const DicomFile& file) {
  const std::vector<unsigned long> starts = frameStarts(fragments, file);
  std::vector<std::vector<unsigned char>> streams(starts.size());
  for (std::size_t n = 0; n < starts.size(); ++n) {
    const unsigned long end = n + 1 < starts.size() ? starts[n + 1] : fragments.card();
    for (unsigned long i = starts[n]; i < end; ++i) {
      DcmPixelItem* item = nullptr;
      std::vector<unsigned char> bytes;
      constexpr std::uint64_t kAll = 0xffffffffU;
      if (fragments.getItem(item, i).bad() || !readHead(*item, kAll, bytes)) return {};
      streams[n].insert(streams[n].end(), bytes.begin(), bytes.end());
    }
  }
  return streams;
}

Jpeg2000Sample jpeg2000Sample(DcmDataset& data) {
  DcmPixelSequence* fragments = fragmentsOf(data);
  DcmPixelItem* item = nullptr;
  std::vector<unsigned char> bytes;
  if (fragments == nullptr || fragments->getItem(item, 1).bad() ||
      !readHead(*item, kJpeg2000Head, bytes))
    return {};
  const Bytes head(bytes);
  const std::size_t start = codestreamStart(head);
  if (start == std::string::npos) return {};
  const CodedPicture picture = jpeg2000Picture(head, start + 2);
  return {bitsOf(picture), (picture.sample >> 23U) != 0};
}

std::string fragmentDamage(DcmDataset& data, const DicomFile& file, std::uintmax_t fileBytes) {
  if (file.layout.encapsulated) {
    DcmPixelSequence* fragments = fragmentsOf(data);
    return fragments != nullptr ? fragmentsDamage(*fragments, file, fileBytes)
                                : "no compressed pixels";
  }
  DcmElement* element = nullptr;
  if (data.findAndGetElement(DCM_PixelData, element).bad() || element == nullptr)
    return "no pixel data";
  return element->getLengthField() > fileBytes ? "they are longer than the file" : "";
}

}  // namespace angiomesh
