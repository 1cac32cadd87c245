// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "fuzz/fuzz_file.h"
#include "io/dicom/dicom.h"
#include "io/mesh/mesh_io.h"
#include "io/scan/image_io.h"
#include "io/scan/label_image.h"
#include "io/volume/image_header.h"

/// What an input is handed to, by the fuzzers and by the test that goes through the kept inputs. A
/// refusal is an Error; anything else that is thrown is a fault, and so is an Error within must().
namespace angiomesh::fuzz {

template <class Work>
void attempt(const Work& work) {
  try {
    work();
  } catch (const Error&) {
    return;
  }
}

/// Work on what was read: once an input is taken, nothing may refuse it. @throws std::logic_error
template <class Work>
void must(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    throw std::logic_error(error.what());
  }
}

/// @throws std::logic_error that says what does not hold
inline void expect(bool holds, const std::string& what) {
  if (!holds) throw std::logic_error(what);
}

/// The parts of an input between the characters `mark`; at least one, and one more than marks.
inline std::vector<std::string_view> partsOf(std::string_view text, char mark) {
  std::vector<std::string_view> parts;
  for (std::size_t at = text.find(mark); at != std::string_view::npos; at = text.find(mark)) {
    parts.push_back(text.substr(0, at));
    text.remove_prefix(at + 1);
  }
  parts.push_back(text);
  return parts;
}

/// Part `n`, empty where the input ends before.
inline std::string_view part(const std::vector<std::string_view>& parts, std::size_t n) {
  return n < parts.size() ? parts[n] : std::string_view();
}

/// An input as text. It ends with the input.
inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// A DICOM file, whatever its first bytes are: its header, its series and, where they make a
/// volume, its pixels.
inline void readDicomInput(const std::uint8_t* data, std::size_t size) {
  const InputFile file(data, size, "");
  attempt([&] {
    for (const ImageSummary& entry : describeImages(file.path())) {
      if (entry.info.format != "DICOM") return;
      static_cast<void>(thumbnail(entry, 16));
      static_cast<void>(readImage(entry, file.path(), true));
    }
  });
}

/// The header checks of MetaImage, NRRD and NIfTI, and the voxels where they let it pass.
inline void readImageInput(const std::uint8_t* data, std::size_t size) {
  const bool gzip = size > 1 && data[0] == 0x1f && data[1] == 0x8b;
  const InputFile file(data, size, gzip ? ".nii.gz" : "");
  attempt([&] {
    const ImageFormat& format = imageFormat(file.path());
    if (format.isDicom()) return;
    const ImageHeader header = readHeader(file.path(), format);
    const bool several = header.data.values > 1;
    static_cast<void>(readNative(file.path(), {}, several ? std::optional<int>(1) : std::nullopt));
    attempt([&] { static_cast<void>(readImage(file.path())); });
    attempt([&] { static_cast<void>(readMask(file.path())); });
    static_cast<void>(readLabels(file.path()));
  });
}

/// A mesh; the first byte says of which format, from '0' on.
inline void readMeshInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return;
  constexpr std::array<const char*, 6> kEndings{".ply", ".stl", ".obj", ".vtp", ".vtk", ".off"};
  const InputFile file(data + 1, size - 1, kEndings[(data[0] + 240U - '0') % kEndings.size()]);
  attempt([&] { static_cast<void>(loadMesh(file.path())); });
}

}  // namespace angiomesh::fuzz
