// SPDX-License-Identifier: BSD-3-Clause
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <mutex>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "io/dicom/dicom_fragments.h"
#include "io/dicom/dicom_rle.h"
#include "io/dicom/dicom_series.h"
#include "io/dicom/dicom_source.h"
#include "io/file/memory_file.h"
#include "io/file/open_file.h"
#include "io/volume/itk_image.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

/// Takes the stored values of the n-th wanted frame, as words of the layout's size or as numbers.
struct FrameSink {
  std::function<void(std::size_t n, const unsigned char* words)> words;
  std::function<void(std::size_t n, const float* values)> values;
};

void registerCodecs() {
  static const bool done = [] {
    DJDecoderRegistration::registerCodecs();
    DJLSDecoderRegistration::registerCodecs();
    return true;
  }();
  static_cast<void>(done);
}

[[noreturn]] void damaged(const fs::path& file, const std::string& what) {
  throw IoError("the pixels are truncated or damaged (" + what + ")", file.filename().string(),
                "copy the file again");
}

std::size_t frameBytes(const DicomFile& file) {
  return file.pixels() * static_cast<std::size_t>(file.layout.allocated / 8);
}

/// Where uncompressed pixels begin when they are the last element of the file, else 0.
std::uint64_t pixelsAtEnd(const OpenFile& open, const DicomFile& file) {
  const std::uint64_t bytes = frameBytes(file) * static_cast<std::uint64_t>(file.frames);
  const std::uint64_t length = bytes + bytes % 2;
  const std::uint64_t size = open.size();
  constexpr std::uint64_t kExplicit = 12;  // tag, VR, two bytes of nothing, length
  std::array<unsigned char, kExplicit> head{};
  if (length > 0xfffffffeU || size < length + 132 ||
      open.readAt(size - length - kExplicit, head.data(), head.size()) < head.size())
    return 0;
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, head.data() + at, sizeof(value));
    return value;
  };
  constexpr std::uint32_t kPixelData = 0x00107fe0;  // (7fe0,0010) as it lies in the file
  const bool isExplicit =
      number(0) == kPixelData && (head[4] == 'O' && head[5] != 'V') && number(8) == length;
  const bool isImplicit = number(4) == kPixelData && number(8) == length;
  return isExplicit || isImplicit ? size - length : 0;
}

bool readNative(const DicomFile& file, const std::vector<int>& frames, const FrameSink& sink) {
  const PixelLayout& layout = file.layout;
  if (layout.encapsulated || layout.deflated || layout.bigEndian) return false;
  const OpenFile open(file.path);
  if (!open.isOpen()) throwNotOpened(file.path.filename().string(), open.error());
  const std::uint64_t start = pixelsAtEnd(open, file);
  if (start == 0) return false;
  thread_local std::vector<unsigned char> words;  // fresh memory costs more than the reading
  words.resize(frameBytes(file));
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const std::uint64_t at =
        start + static_cast<std::uint64_t>(frames[n]) * static_cast<std::uint64_t>(words.size());
    if (open.readAt(at, words.data(), words.size()) < words.size()) {
      if (errno != 0) throwNotOpened(file.path.filename().string(), errno);
      damaged(file.path, "it cannot be read");
    }
    sink.words(n, words.data());
  }
  return true;
}

/// Frame by frame, so that a long multi-frame object is never in memory as a whole; false when
/// DCMTK's codec does not do this.
bool readCompressed(DcmDataset& data, const DicomFile& file, const std::vector<int>& frames,
                    const FrameSink& sink) {
  DcmElement* element = nullptr;
  if (data.findAndGetElement(DCM_PixelData, element).bad() || element == nullptr)
    damaged(file.path, "no pixel data");
  Uint32 bytes = 0;
  if (element->getUncompressedFrameSize(&data, bytes).bad()) return false;
  const std::size_t wanted = frameBytes(file);
  if (bytes < wanted || bytes > wanted + 1) return false;
  std::vector<unsigned char> words(wanted + 1 + (wanted + 1) % 2);
  Uint32 fragment = 0;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    OFString colour;
    if (n > 0 && frames[n] != frames[n - 1] + 1) fragment = 0;
    if (element
            ->getUncompressedFrame(&data, static_cast<Uint32>(frames[n]), fragment, words.data(),
                                   static_cast<Uint32>(words.size()), colour)
            .bad()) {
      if (n == 0) return false;
      damaged(file.path, "frame " + std::to_string(frames[n] + 1));
    }
    sink.words(n, words.data());
  }
  return true;
}

/// All frames at once, through DCMTK's own conversion.
void readWhole(DcmDataset& data, const DicomFile& file, const std::vector<int>& frames,
               const FrameSink& sink) {
  const E_TransferSyntax syntax = data.getOriginalXfer();
  const OFCondition status = data.chooseRepresentation(EXS_LittleEndianExplicit, nullptr);
  if (status.bad()) {
    if (!file.layout.encapsulated) damaged(file.path, status.text());
    throw InputError(std::string("cannot decompress ") + DcmXfer(syntax).getXferName() + " (" +
                         status.text() + ")",
                     file.path.filename().string(), "decompress the series with another program");
  }
  DcmElement* element = nullptr;
  if (data.findAndGetElement(DCM_PixelData, element).bad() || element == nullptr)
    damaged(file.path, "no pixel data");
  const std::size_t bytes = frameBytes(file) * static_cast<std::size_t>(file.frames);
  if (element->getLength() < bytes)
    damaged(file.path,
            std::to_string(element->getLength()) + " of " + std::to_string(bytes) + " bytes");
  Uint8* bytes8 = nullptr;
  Uint16* words16 = nullptr;
  const unsigned char* start = nullptr;
  if (file.layout.allocated == 8 && element->getUint8Array(bytes8).good())
    start = bytes8;
  else if (element->getUint16Array(words16).good())
    start = reinterpret_cast<const unsigned char*>(words16);  // 8 bit: two pixels in a word
  if (start == nullptr) damaged(file.path, "no pixels");
  for (std::size_t n = 0; n < frames.size(); ++n)
    sink.words(n, start + static_cast<std::size_t>(frames[n]) * frameBytes(file));
}

void readRle(DcmDataset& data, const DicomFile& file, const std::vector<int>& frames,
             const FrameSink& sink) {
  DcmPixelSequence* fragments = fragmentsOf(data);
  if (fragments == nullptr) damaged(file.path, "no pixel data");
  const auto streams = frameStreams(*fragments, file);
  std::vector<unsigned char> words(frameBytes(file));
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const auto frame = static_cast<std::size_t>(frames[n]);
    if (frame >= streams.size() ||
        !unpackRle(streams[frame], file.pixels(), words.size() / file.pixels(), words.data()))
      damaged(file.path, "frame " + std::to_string(frames[n] + 1));
    sink.words(n, words.data());
  }
}

/// The same fragments, one for each frame: GDCM ends the program where their numbers differ.
void insertStreams(DcmDataset& from, const DicomFile& file, DcmDataset& to) {
  DcmPixelSequence* fragments = fragmentsOf(from);
  if (fragments == nullptr) damaged(file.path, "no pixel data");
  auto* pixels = new DcmPixelData(DCM_PixelData);
  auto* sequence = new DcmPixelSequence(DCM_PixelSequenceTag);
  sequence->insert(new DcmPixelItem(DCM_PixelItemTag));  // a table without entries
  for (const std::vector<unsigned char>& stream : frameStreams(*fragments, file)) {
    std::vector<unsigned char> even = stream;
    if (even.size() % 2 != 0) even.push_back(0);
    auto* item = new DcmPixelItem(DCM_PixelItemTag);
    item->putUint8Array(even.data(), static_cast<unsigned long>(even.size()));
    sequence->insert(item);
  }
  pixels->putOriginalRepresentation(from.getOriginalXfer(), nullptr, sequence);
  to.insert(pixels, true);
}

/// GDCM makes room for whatever lengths the elements of a file state, and ends the program where an
/// element is not of the usual kind or differs from the picture. It gets a file that holds the
/// pixels and what describes them.
void readJpeg2000(DcmDataset& data, const DicomFile& file, const std::vector<int>& frames,
                  const FrameSink& sink) {
  const Jpeg2000Sample sample = jpeg2000Sample(data);
  DcmFileFormat lean;
  DcmDataset& copy = *lean.getDataset();
  copy.putAndInsertString(DCM_SOPClassUID, UID_SecondaryCaptureImageStorage);
  copy.putAndInsertString(DCM_SOPInstanceUID, "1.2.3");
  copy.putAndInsertString(DCM_PhotometricInterpretation, "MONOCHROME2");
  copy.putAndInsertString(DCM_NumberOfFrames, std::to_string(file.frames).c_str());
  for (const auto& [tag, value] :
       {std::pair{DCM_SamplesPerPixel, 1},
        {DCM_Rows, file.rows},
        {DCM_Columns, file.columns},
        {DCM_BitsAllocated, sample.bits <= 8 ? 8 : (sample.bits <= 16 ? 16 : 32)},
        {DCM_BitsStored, sample.bits},
        {DCM_HighBit, sample.bits - 1},
        {DCM_PixelRepresentation, sample.isSigned ? 1 : 0}})
    copy.putAndInsertUint16(tag, static_cast<Uint16>(value));
  insertStreams(data, file, copy);
  const MemoryFile memory;
  const OFCondition status = lean.saveFile(memory.path().c_str(), data.getOriginalXfer());
  if (status.bad()) damaged(file.path, status.text());
  std::vector<float> all = itkReadDicomPixels(
      memory.path(), file.path, file.pixels() * static_cast<std::size_t>(file.frames));
  // Where the two differ in the sign, the header is right, as in other syntaxes.
  const auto turn = static_cast<float>(std::ldexp(1.0, sample.bits));
  for (float& value : all) {
    if (file.layout.isSigned && !sample.isSigned && value >= turn / 2)
      value -= turn;
    else if (!file.layout.isSigned && sample.isSigned && value < 0)
      value += turn;
  }
  for (std::size_t n = 0; n < frames.size(); ++n)
    sink.values(n, all.data() + static_cast<std::size_t>(frames[n]) * file.pixels());
}

/// The whole file. @throws IoError (not to be opened, damaged)
DcmDataset& loadWhole(const DicomFile& file, const DicomSource& source, DcmFileFormat& format) {
  const OFCondition status = format.loadFile(source.path().c_str());
  checkOpened(file.path, status);
  if (status.bad()) damaged(file.path, status.text());
  return *format.getDataset();
}

/// Float and Double Float Pixel Data, which are never compressed.
void readReal(const DicomFile& file, const std::vector<int>& frames, const FrameSink& sink) {
  const DicomSource source(file.path);
  DcmFileFormat format;
  DcmDataset& data = loadWhole(file, source, format);
  const bool single = file.layout.allocated == 32;
  DcmElement* element = nullptr;
  const DcmTagKey tag = single ? DCM_FloatPixelData : DCM_DoubleFloatPixelData;
  const std::size_t wanted = frameBytes(file) * static_cast<std::size_t>(file.frames);
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(source.path(), error);
  if (data.findAndGetElement(tag, element).bad() || element == nullptr)
    damaged(file.path, "no pixel data");
  if (element->getLengthField() > bytes) damaged(file.path, "they are longer than the file");
  if (element->getLength() < wanted)
    damaged(file.path,
            std::to_string(element->getLength()) + " of " + std::to_string(wanted) + " bytes");
  Float32* floats = nullptr;
  Float64* doubles = nullptr;
  if ((single ? element->getFloat32Array(floats) : element->getFloat64Array(doubles)).bad())
    damaged(file.path, "no pixels");
  std::vector<float> values(file.pixels());
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const std::size_t first = static_cast<std::size_t>(frames[n]) * file.pixels();
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = single ? floats[first + i] : static_cast<float>(doubles[first + i]);
    sink.values(n, values.data());
  }
}

void readFile(const DicomFile& file, const std::vector<int>& frames, const FrameSink& sink) {
  const int allocated = file.layout.allocated;
  if (file.layout.real) return readReal(file, frames, sink);
  if (allocated != 8 && allocated != 16 && allocated != 32)
    throw InputError("BitsAllocated is not 8, 16 or 32", file.path.filename().string(),
                     "convert the series with another program");
  if (readNative(file, frames, sink)) return;
  registerCodecs();
  const DicomSource source(file.path);
  DcmFileFormat format;
  DcmDataset& data = loadWhole(file, source, format);
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(source.path(), error);
  if (const std::string damage = fragmentDamage(data, file, error ? 0 : bytes); !damage.empty())
    damaged(file.path, damage);
  if (file.layout.rle) return readRle(data, file, frames, sink);
  if (file.layout.jpeg2000) return readJpeg2000(data, file, frames, sink);
  if (file.layout.encapsulated && readCompressed(data, file, frames, sink)) return;
  readWhole(data, file, frames, sink);
}

struct Rescale {
  double slope, intercept;
  std::optional<std::array<double, 2>> padding;
};

/// What a conversion met beside plain values.
struct Padding {
  std::size_t voxels = 0;
  float smallest = std::numeric_limits<float>::infinity();  ///< of the others
};

template <class Value>
void rescale(const Value& valueAt, std::size_t count, const Rescale& how, float* to,
             Padding& padding) {
  for (std::size_t i = 0; i < count; ++i)
    to[i] = static_cast<float>(how.slope * static_cast<double>(valueAt(i)) + how.intercept);
  if (!how.padding) return;
  const auto [from, until] = *how.padding;
  for (std::size_t i = 0; i < count; ++i) {
    const auto stored = static_cast<double>(valueAt(i));
    if (stored >= from && stored <= until) {
      to[i] = std::numeric_limits<float>::quiet_NaN();
      ++padding.voxels;
    } else {
      padding.smallest = std::min(padding.smallest, to[i]);
    }
  }
}

/// Value of `stored` bits that end at bit `high`, with its sign.
template <class Word, class Wide>
void rescaleWords(const unsigned char* words, std::size_t count, const PixelLayout& layout,
                  const Rescale& how, float* to, Padding& padding) {
  // Shifted up to the top and down again: the sign comes along, foreign bits above go.
  const auto bits = static_cast<int>(8 * sizeof(Wide));
  const int up = bits - 1 - layout.high;
  const int down = bits - layout.stored;
  const auto valueAt = [&](std::size_t i) {
    Word word;
    std::memcpy(&word, words + i * sizeof(Word), sizeof(Word));
    return static_cast<Wide>(
        static_cast<Wide>(static_cast<std::make_unsigned_t<Wide>>(word) << up) >> down);
  };
  rescale(valueAt, count, how, to, padding);
}

void convertFrame(const DicomFile& file, const DicomFrame& frame, const unsigned char* words,
                  float* to, Padding& padding) {
  const PixelLayout& layout = file.layout;
  const Rescale how{frame.slope, frame.intercept, layout.padding};
  const std::size_t count = file.pixels();
  if (layout.allocated == 8 && layout.isSigned)
    rescaleWords<std::uint8_t, std::int32_t>(words, count, layout, how, to, padding);
  else if (layout.allocated == 8)
    rescaleWords<std::uint8_t, std::uint32_t>(words, count, layout, how, to, padding);
  else if (layout.allocated == 16 && layout.isSigned)
    rescaleWords<std::uint16_t, std::int32_t>(words, count, layout, how, to, padding);
  else if (layout.allocated == 16)
    rescaleWords<std::uint16_t, std::uint32_t>(words, count, layout, how, to, padding);
  else if (layout.isSigned)
    rescaleWords<std::uint32_t, std::int32_t>(words, count, layout, how, to, padding);
  else
    rescaleWords<std::uint32_t, std::uint32_t>(words, count, layout, how, to, padding);
}

/// Reads the frames `wanted` (numbers of stack.frames), all of one file, to where `place` says.
Padding readFramesOfFile(const DicomStack& stack, std::vector<std::size_t> wanted,
                         const std::function<float*(std::size_t)>& place) {
  std::sort(wanted.begin(), wanted.end(), [&](std::size_t a, std::size_t b) {
    return stack.frames[a].index < stack.frames[b].index;
  });
  const DicomFile& file = stack.fileOf(stack.frames[wanted.front()]);
  std::vector<int> indices;
  for (const std::size_t w : wanted) indices.push_back(stack.frames[w].index);
  Padding padding;
  FrameSink sink;
  sink.words = [&](std::size_t n, const unsigned char* words) {
    convertFrame(file, stack.frames[wanted[n]], words, place(wanted[n]), padding);
  };
  sink.values = [&](std::size_t n, const float* values) {
    const DicomFrame& frame = stack.frames[wanted[n]];
    rescale([&](std::size_t i) { return values[i]; }, file.pixels(),
            {frame.slope, frame.intercept, file.layout.padding}, place(wanted[n]), padding);
  };
  readFile(file, indices, sink);
  return padding;
}

void fillPadding(float* values, std::size_t count, float with) {
  for (std::size_t i = 0; i < count; ++i)
    if (std::isnan(values[i])) values[i] = with;
}

float fillingOf(const Padding& padding) {
  return std::isfinite(padding.smallest) ? padding.smallest : 0.0F;
}

}  // namespace

std::size_t readFrames(const DicomStack& stack, Volume<float>& image, const Progress& progress) {
  std::vector<std::vector<std::size_t>> framesOfFile(stack.files.size());
  for (std::size_t f = 0; f < stack.frames.size(); ++f)
    framesOfFile[stack.frames[f].file].push_back(f);
  const std::size_t pixels = stack.fileOf(stack.frames.front()).pixels();
  Padding all;
  std::mutex mutex;
  std::atomic<std::size_t> done{0};
  parallelForEach(framesOfFile.size(), 1, [&](std::size_t i) {
    progress.report(static_cast<double>(done++) / static_cast<double>(framesOfFile.size()));
    if (framesOfFile[i].empty()) return;
    const Padding padding = readFramesOfFile(
        stack, framesOfFile[i], [&](std::size_t f) { return image.voxels.data() + f * pixels; });
    if (!stack.files[i].layout.padding) return;
    const std::lock_guard lock(mutex);
    all.voxels += padding.voxels;
    all.smallest = std::min(all.smallest, padding.smallest);
  });
  if (all.voxels > 0) fillPadding(image.voxels.data(), image.voxels.size(), fillingOf(all));
  return all.voxels;
}

std::vector<float> readFrame(const DicomStack& stack, const DicomFrame& frame) {
  std::vector<float> values(stack.fileOf(frame).pixels());
  const auto number = static_cast<std::size_t>(&frame - stack.frames.data());
  const Padding padding =
      readFramesOfFile(stack, {number}, [&](std::size_t) { return values.data(); });
  if (padding.voxels > 0) fillPadding(values.data(), values.size(), fillingOf(padding));
  return values;
}

}  // namespace angiomesh
