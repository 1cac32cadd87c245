// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/itk_image.h"

// Before ITK, whose own older copy of Eigen does not mix with the system's: the same include guards
// then keep it out.
#include <Eigen/Dense>

#include <gdcmTrace.h>
#include <itkGDCMImageIO.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <string>

#include "core/base/error.h"
#include "io/file/quiet_terminal.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;
using Io = itk::ImageIOBase;

/// ITK's text without the place in ITK's sources and the object's address.
std::string reasonOf(const std::exception& error) {
  std::string text = error.what();
  if (const auto* itkError = dynamic_cast<const itk::ExceptionObject*>(&error))
    text = itkError->GetDescription();
  if (const std::size_t at = text.find("): "); at != std::string::npos) text.erase(0, at + 3);
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text.substr(0, 200);
}

template <class From, class Values>
void copyAs(const std::vector<char>& bytes, Values& values) {
  const auto* from = reinterpret_cast<const From*>(bytes.data());
  std::transform(from, from + values.size(), values.begin(),
                 [](From value) { return static_cast<typename Values::value_type>(value); });
}

/// False when the type is none that has a plain number per voxel.
bool convert(Io::IOComponentEnum type, const std::vector<char>& bytes, std::vector<float>& values) {
  switch (type) {
    case Io::IOComponentEnum::UCHAR:
      return copyAs<unsigned char>(bytes, values), true;
    case Io::IOComponentEnum::CHAR:
      return copyAs<signed char>(bytes, values), true;
    case Io::IOComponentEnum::USHORT:
      return copyAs<unsigned short>(bytes, values), true;
    case Io::IOComponentEnum::SHORT:
      return copyAs<short>(bytes, values), true;
    case Io::IOComponentEnum::UINT:
      return copyAs<unsigned int>(bytes, values), true;
    case Io::IOComponentEnum::INT:
      return copyAs<int>(bytes, values), true;
    case Io::IOComponentEnum::ULONG:
      return copyAs<unsigned long>(bytes, values), true;
    case Io::IOComponentEnum::LONG:
      return copyAs<long>(bytes, values), true;
    case Io::IOComponentEnum::ULONGLONG:
      return copyAs<unsigned long long>(bytes, values), true;
    case Io::IOComponentEnum::LONGLONG:
      return copyAs<long long>(bytes, values), true;
    case Io::IOComponentEnum::FLOAT:
      return copyAs<float>(bytes, values), true;
    case Io::IOComponentEnum::DOUBLE:
      return copyAs<double>(bytes, values), true;
    default:
      return false;
  }
}

template <class Function>
auto guarded(const fs::path& path, const Function& function) {
  const QuietTerminal quiet;
  try {
    return function();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw InputError("the volume does not fit into memory", path.string(),
                     "crop or downsample it first");
  } catch (const std::exception& error) {
    throw IoError("cannot read the image (" + reasonOf(error) + ")", path.string(),
                  "copy it again, or convert it with another program");
  }
}

std::vector<char> readBytes(Io& io) {
  const unsigned dimensions = io.GetNumberOfDimensions();
  itk::ImageIORegion region(dimensions);
  for (unsigned a = 0; a < dimensions; ++a) {
    region.SetIndex(a, 0);
    region.SetSize(a, io.GetDimensions(a));
  }
  io.SetIORegion(region);
  std::vector<char> bytes(static_cast<std::size_t>(io.GetImageSizeInBytes()));
  io.Read(bytes.data());
  return bytes;
}

}  // namespace

std::vector<float> itkReadDicomPixels(const fs::path& path, const fs::path& named,
                                      std::size_t count) {
  return guarded(named, [&] {
    itk::Object::GlobalWarningDisplayOff();
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
    const auto io = itk::GDCMImageIO::New();
    io->SetFileName(path.string());
    io->ReadImageInformation();
    if (io->GetNumberOfComponents() != 1)
      throw InputError("a colour image", named.string(), "give a series with one value per pixel");
    const std::vector<char> bytes = readBytes(*io);
    if (bytes.size() != count * io->GetComponentSize())
      throw IoError("the number of decoded pixels is wrong", named.string(), "copy it again");
    std::vector<float> values(count);
    if (!convert(io->GetComponentType(), bytes, values))
      throw InputError("the pixel type is not known", named.string(),
                       "convert the image to 16 bit integers or 32 bit floats");
    // GDCM rescales in some objects and not in others: back to the stored integers.
    const double slope = io->GetRescaleSlope();
    const double intercept = io->GetRescaleIntercept();
    if (slope != 0.0 && (slope != 1.0 || intercept != 0.0))
      for (float& value : values)
        value = static_cast<float>(std::round((static_cast<double>(value) - intercept) / slope));
    return values;
  });
}

}  // namespace angiomesh
