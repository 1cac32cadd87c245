// SPDX-License-Identifier: BSD-3-Clause
#include "io/itk_image.h"

// Before ITK, whose own older copy of Eigen does not mix with the system's: the same include guards
// then keep it out.
#include <Eigen/Dense>

#include <gdcmTrace.h>
#include <itkGDCMImageIO.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>
#include <string>

#include "core/base/error.h"
#include "io/quiet_terminal.h"

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

Io::Pointer makeIo(ImageFormat format) {
  itk::Object::GlobalWarningDisplayOff();
  switch (format) {
    case ImageFormat::MetaImage:
      return itk::MetaImageIO::New().GetPointer();
    case ImageFormat::Nrrd:
      return itk::NrrdImageIO::New().GetPointer();
    case ImageFormat::Nifti:
      return itk::NiftiImageIO::New().GetPointer();
    case ImageFormat::Dicom:
      break;
  }
  return itk::GDCMImageIO::New().GetPointer();
}

std::string pixelTypeName(Io::IOComponentEnum type, std::size_t bytes) {
  const std::string bits = std::to_string(8 * bytes);
  switch (type) {
    case Io::IOComponentEnum::FLOAT:
    case Io::IOComponentEnum::DOUBLE:
    case Io::IOComponentEnum::LDOUBLE:
      return "float" + bits;
    case Io::IOComponentEnum::UCHAR:
    case Io::IOComponentEnum::USHORT:
    case Io::IOComponentEnum::UINT:
    case Io::IOComponentEnum::ULONG:
    case Io::IOComponentEnum::ULONGLONG:
      return "uint" + bits;
    default:
      return "int" + bits;
  }
}

template <class From, class Values>
void copyAs(const std::vector<char>& bytes, Values& values) {
  const auto* from = reinterpret_cast<const From*>(bytes.data());
  std::transform(from, from + values.size(), values.begin(),
                 [](From value) { return static_cast<typename Values::value_type>(value); });
}

/// False when the type is none that has a plain number per voxel.
bool convert(Io::IOComponentEnum type, const std::vector<char>& bytes, BigVector<float>& values) {
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

std::string sizeText(const Io& io) {
  std::string text;
  for (unsigned a = 0; a < io.GetNumberOfDimensions(); ++a)
    text += (a == 0 ? "" : " x ") + std::to_string(io.GetDimensions(a));
  return text;
}

Geometry geometryOf(const Io& io, const fs::path& path) {
  const unsigned dimensions = io.GetNumberOfDimensions();
  if (io.GetNumberOfComponents() != 1)
    throw InputError("each voxel holds " + std::to_string(io.GetNumberOfComponents()) +
                         " values (a colour or vector image)",
                     path.string(), "give an image with one value per voxel");
  if (dimensions < 3)
    throw InputError("a 2D image (" + sizeText(io) + ")", path.string(), "give a 3D volume");
  for (unsigned a = 3; a < dimensions; ++a)
    if (io.GetDimensions(a) > 1)
      throw InputError("a " + std::to_string(dimensions) + "D image (" + sizeText(io) + ")",
                       path.string(), "give one 3D volume of it");
  Geometry geometry;
  for (unsigned a = 0; a < 3; ++a) {
    if (io.GetDimensions(a) < 1 || io.GetDimensions(a) > (1U << 30U))
      throw InputError("the size " + sizeText(io) + " is not usable", path.string(),
                       "give a 3D volume");
    geometry.size[a] = static_cast<int>(io.GetDimensions(a));
    geometry.spacing[a] = io.GetSpacing(a);
    geometry.origin[a] = io.GetOrigin(a);
    const std::vector<double> column = io.GetDirection(a);
    for (unsigned row = 0; row < 3; ++row) geometry.direction(row, a) = column[row];
    // A negative spacing is the same grid with this axis turned round.
    if (geometry.spacing[a] < 0.0) {
      geometry.spacing[a] = -geometry.spacing[a];
      geometry.direction.col(a) = -geometry.direction.col(a);
    }
  }
  geometry.direction.array() += 0.0;  // -0 becomes 0
  return geometry;
}

const char* formatName(ImageFormat format) {
  switch (format) {
    case ImageFormat::MetaImage:
      return "MetaImage";
    case ImageFormat::Nrrd:
      return "NRRD";
    case ImageFormat::Nifti:
      return "NIfTI";
    case ImageFormat::Dicom:
      break;
  }
  return "DICOM";
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

BigVector<float> readVoxels(Io& io, const fs::path& path) {
  const unsigned dimensions = io.GetNumberOfDimensions();
  itk::ImageIORegion region(dimensions);
  std::size_t count = 1;
  for (unsigned a = 0; a < dimensions; ++a) {
    region.SetIndex(a, 0);
    region.SetSize(a, io.GetDimensions(a));
    count *= io.GetDimensions(a);
  }
  io.SetIORegion(region);
  std::vector<char> bytes(static_cast<std::size_t>(io.GetImageSizeInBytes()));
  io.Read(bytes.data());
  BigVector<float> values(count);
  if (!convert(io.GetComponentType(), bytes, values))
    throw InputError("the pixel type is not known", path.string(),
                     "convert the image to 16 bit integers or 32 bit floats");
  return values;
}

ImageSummary summaryOf(const Io& io, const fs::path& path, ImageFormat format) {
  ImageSummary summary;
  summary.geometry = geometryOf(io, path);
  summary.info.format = formatName(format);
  summary.info.pixelType = pixelTypeName(io.GetComponentType(), io.GetComponentSize());
  return summary;
}

template <class T>
void write(const Volume<T>& volume, Io::IOComponentEnum type, const fs::path& path) {
  const std::string name = path.filename().string();
  ImageFormat format = ImageFormat::MetaImage;
  if (name.ends_with(".nrrd"))
    format = ImageFormat::Nrrd;
  else if (name.ends_with(".nii") || name.ends_with(".nii.gz"))
    format = ImageFormat::Nifti;
  const Io::Pointer io = makeIo(format);
  const Geometry& g = volume.geometry;
  io->SetNumberOfDimensions(3);
  itk::ImageIORegion region(3);
  for (unsigned a = 0; a < 3; ++a) {
    io->SetDimensions(a, static_cast<Io::SizeValueType>(g.size[a]));
    io->SetSpacing(a, g.spacing[a]);
    io->SetOrigin(a, g.origin[a]);
    const Eigen::Vector3d column = g.direction.col(a);
    io->SetDirection(a, std::vector<double>(column.data(), column.data() + 3));
    region.SetIndex(a, 0);
    region.SetSize(a, static_cast<Io::SizeValueType>(g.size[a]));
  }
  io->SetIORegion(region);
  io->SetPixelType(itk::IOPixelEnum::SCALAR);
  io->SetNumberOfComponents(1);
  io->SetComponentType(type);
  io->SetUseCompression(!name.ends_with(".nii"));
  io->SetFileName(path.string());
  const QuietTerminal quiet;
  try {
    io->WriteImageInformation();
    io->Write(volume.voxels.data());
  } catch (const itk::ExceptionObject& error) {
    throw IoError("cannot write the image (" + reasonOf(error) + ")", path.string(),
                  "check that the folder may be written to and has free space");
  }
}

}  // namespace

ImageSummary itkDescribe(const fs::path& path, ImageFormat format) {
  return guarded(path, [&] {
    const Io::Pointer io = makeIo(format);
    io->SetFileName(path.string());
    io->ReadImageInformation();
    return summaryOf(*io, path, format);
  });
}

LoadedImage itkRead(const fs::path& path, ImageFormat format) {
  return guarded(path, [&] {
    const Io::Pointer io = makeIo(format);
    io->SetFileName(path.string());
    io->ReadImageInformation();
    ImageSummary summary = summaryOf(*io, path, format);
    LoadedImage loaded;
    loaded.image.geometry = summary.geometry;
    loaded.info = std::move(summary.info);
    loaded.image.voxels = readVoxels(*io, path);
    return loaded;
  });
}

std::vector<float> itkReadDicomPixels(const fs::path& path, std::size_t count) {
  return guarded(path, [&] {
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
    const auto io = itk::GDCMImageIO::New();
    io->SetFileName(path.string());
    io->ReadImageInformation();
    if (io->GetNumberOfComponents() != 1)
      throw InputError("a colour image", path.string(), "give a series with one value per pixel");
    BigVector<float> values = readVoxels(*io, path);
    if (values.size() != count)
      throw IoError("the number of decoded pixels is wrong", path.string(), "copy it again");
    // GDCM rescales in some objects and not in others: back to the stored integers.
    const double slope = io->GetRescaleSlope();
    const double intercept = io->GetRescaleIntercept();
    if (slope != 0.0 && (slope != 1.0 || intercept != 0.0))
      for (float& value : values)
        value = static_cast<float>(std::round((static_cast<double>(value) - intercept) / slope));
    return std::vector<float>(values.begin(), values.end());
  });
}

void itkWrite(const Volume<float>& volume, const fs::path& path) {
  write(volume, Io::IOComponentEnum::FLOAT, path);
}

void itkWrite(const Volume<std::uint8_t>& volume, const fs::path& path) {
  write(volume, Io::IOComponentEnum::UCHAR, path);
}

}  // namespace angiomesh
