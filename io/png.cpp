// SPDX-License-Identifier: BSD-3-Clause
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <string_view>

#include "core/base/error.h"
#include "io/files.h"

namespace angiomesh {

void writePng(const Picture& picture, const std::filesystem::path& path) {
  const auto row = static_cast<std::size_t>(std::max(picture.width, 0)) * 3;
  const auto rows = static_cast<std::size_t>(std::max(picture.height, 0));
  if (row == 0 || rows == 0 || picture.rgb.size() != row * rows)
    throw InputError("the picture is empty", path.string(), "make it from a volume first");
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.width, picture.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* to = static_cast<std::uint8_t*>(image->GetScalarPointer());
  // VTK's rows go upwards.
  for (std::size_t y = 0; y < rows; ++y)
    std::copy_n(picture.rgb.data() + (rows - 1 - y) * row, row, to + y * row);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  const vtkUnsignedCharArray* bytes = writer->GetResult();
  if (bytes == nullptr || bytes->GetNumberOfValues() == 0)
    throw IoError("cannot make the PNG", path.string(), "free some memory");
  const auto* data = reinterpret_cast<const char*>(writer->GetResult()->GetPointer(0));
  writeText(path, std::string_view(data, static_cast<std::size_t>(bytes->GetNumberOfValues())));
}

}  // namespace angiomesh
