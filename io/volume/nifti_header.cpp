// SPDX-License-Identifier: BSD-3-Clause
#include <zlib.h>

#include <Eigen/Dense>
#include <cerrno>
#include <cmath>
#include <memory>
#include <numbers>
#include <sstream>

#include "core/base/error.h"
#include "io/file/files.h"
#include "io/file/open_file.h"
#include "io/volume/header_text.h"
#include "io/volume/image_header.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHeader = 348;
constexpr double kSkew = 1e-4;  // of the dot product of two unit axes, as in ITK
// From where on sform and qform disagree.
constexpr double kSeenDegrees = 0.1, kSeenScale = 1e-3, kSeenVoxels = 0.1;
constexpr double kLongestQuaternion = 1.001;  // single precision leaves less

/// The fields of a NIfTI-1 header by their offsets (nifti1.h).
class Fields {
 public:
  explicit Fields(std::string bytes) : bytes_(std::move(bytes)) {
    swap_ = fromBytes<std::int32_t>(bytes_, 0, false) != static_cast<std::int32_t>(kHeader);
  }
  template <class T>
  [[nodiscard]] T at(std::size_t offset) const {
    return fromBytes<T>(bytes_, offset, swap_);
  }
  [[nodiscard]] double real(std::size_t offset) const {
    return static_cast<double>(at<float>(offset));
  }
  [[nodiscard]] int whole(std::size_t offset) const { return at<std::int16_t>(offset); }
  [[nodiscard]] bool swapped() const { return swap_; }
  [[nodiscard]] bool singleFile() const { return bytes_.compare(344, 3, "n+1") == 0; }
  [[nodiscard]] int unitsOfSpace() const { return bytes_[123] & 7; }

 private:
  std::string bytes_;
  bool swap_ = false;
};

Fields readFields(const fs::path& path, bool& deflated) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  std::string bytes(kHeader, '\0');
  if (!file) throwNotOpened(path.string(), errno);
  if (gzread(file.get(), bytes.data(), static_cast<unsigned>(kHeader)) != static_cast<int>(kHeader))
    throw IoError("the file is truncated", path.string(), kCopyAgain);
  deflated = gzdirect(file.get()) == 0;
  return Fields(bytes);
}

VoxelType niftiType(int code, const fs::path& path) {
  static const std::map<int, VoxelType> types = {
      {256, VoxelType::Int8},   {2, VoxelType::UInt8},     {4, VoxelType::Int16},
      {512, VoxelType::UInt16}, {8, VoxelType::Int32},     {768, VoxelType::UInt32},
      {1024, VoxelType::Int64}, {1280, VoxelType::UInt64}, {16, VoxelType::Float32},
      {64, VoxelType::Float64}};
  const auto found = types.find(code);
  if (found != types.end()) return found->second;
  if (code == 128 || code == 2304)
    throw InputError("a colour image", path.string(), "give an image with one value per voxel");
  if (code == 32 || code == 1792 || code == 2048)
    throw InputError("an image of complex numbers", path.string(),
                     "save their magnitude and give that");
  throwBadHeader(path, "datatype is " + std::to_string(code));
}

/// Index to mm, RAS.
using Affine = Eigen::Matrix<double, 3, 4>;

Affine sform(const Fields& h) {
  Affine m;
  for (Eigen::Index row = 0; row < 3; ++row)
    for (Eigen::Index column = 0; column < 4; ++column)
      m(row, column) =
          h.real(280 + 16 * static_cast<std::size_t>(row) + 4 * static_cast<std::size_t>(column));
  return m;
}

/// The quaternion (a, b, c, d), a >= 0 left to be found from the others (nifti1.h, method 2).
Affine qform(const Fields& h, const Eigen::Vector3d& spacing) {
  Eigen::Vector3d v(h.real(256), h.real(260), h.real(264));
  double rest = 1.0 - v.squaredNorm();
  if (rest < 1e-7) {
    v.normalize();
    rest = 0.0;
  }
  const Eigen::Quaterniond q(std::sqrt(rest), v.x(), v.y(), v.z());
  Affine m;
  m.leftCols<3>() = q.toRotationMatrix() * spacing.asDiagonal();
  if (h.real(76) < 0.0) m.col(2) *= -1.0;
  m.col(3) = Eigen::Vector3d(h.real(268), h.real(272), h.real(276));
  return m;
}

std::string rounded(double value) {
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}

std::string sizeOf(const Eigen::Vector3d& voxel) {
  return rounded(voxel.x()) + " x " + rounded(voxel.y()) + " x " + rounded(voxel.z());
}

bool orthogonal(const Affine& m) {
  if (!m.allFinite()) return false;
  Eigen::Matrix3d axes = m.leftCols<3>();
  for (Eigen::Index a = 0; a < 3; ++a) {
    if (!(axes.col(a).norm() > 0.0)) return false;
    axes.col(a).normalize();
  }
  return (axes.transpose() * axes - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= kSkew;
}

/// "turned by 180 degrees, mirrored, ...": how one form differs from the other; "" where it is
/// less than anyone would see.
std::string difference(const Affine& s, const Affine& q) {
  const Eigen::Vector3d ofS = s.leftCols<3>().colwise().norm(),
                        ofQ = q.leftCols<3>().colwise().norm();
  Eigen::Matrix3d turn = (s.leftCols<3>() * ofS.cwiseInverse().asDiagonal()) *
                         (q.leftCols<3>() * ofQ.cwiseInverse().asDiagonal()).transpose();
  std::string text;
  const auto add = [&](const std::string& what) { text += (text.empty() ? "" : ", ") + what; };
  if (turn.determinant() < 0.0) {
    add("mirrored");
    turn *= -1.0;
  }
  // In degrees; a mirrored one also has an angle, which says nothing.
  const double angle =
      std::acos(std::clamp(0.5 * (turn.trace() - 1.0), -1.0, 1.0)) * 180.0 / std::numbers::pi;
  if (text.empty() && angle > kSeenDegrees) add("turned by " + rounded(angle) + " degrees");
  if (((ofS - ofQ).array() / ofQ.array()).abs().maxCoeff() > kSeenScale)
    add("voxels of " + sizeOf(ofS) + " against " + sizeOf(ofQ) + " mm");
  const double shift = (s.col(3) - q.col(3)).norm();
  if (shift > kSeenVoxels * ofQ.minCoeff()) add("the first voxel " + rounded(shift) + " mm apart");
  return text;
}

/// Which of the two ways of NIfTI to say where the patient lies is taken, as nibabel and 3D Slicer
/// do: the sform where there is one, unless it is skewed and there is a qform.
Affine chosenForm(const Fields& h, const Eigen::Vector3d& spacing, const fs::path& path,
                  std::vector<std::string>& warnings) {
  const int qCode = h.whole(252), sCode = h.whole(254);
  Affine identity = Affine::Zero();  // in LPS, as ITK has it
  identity.leftCols<3>() = Eigen::Vector3d(-spacing.x(), -spacing.y(), spacing.z()).asDiagonal();
  if (qCode <= 0 && sCode <= 0) {
    warnings.emplace_back("the file does not state the patient's orientation");
    return identity;
  }
  const Affine s = sform(h), q = qform(h, spacing);
  if (sCode > 0 && orthogonal(s)) {
    const Eigen::Vector3d ofS = s.leftCols<3>().colwise().norm();
    if (qCode > 0 && q.allFinite()) {
      if (const std::string how = difference(s, q); !how.empty())
        warnings.push_back("the sform and the qform of the file disagree (" + how +
                           "): the sform is taken");
    } else if (((ofS - spacing).array() / spacing.array()).abs().maxCoeff() > kSeenScale) {
      warnings.push_back("the sform of the file has voxels of " + sizeOf(ofS) + " mm and pixdim " +
                         sizeOf(spacing) + " mm: the sform is taken");
    }
    return s;
  }
  const bool empty = sCode > 0 && !s.leftCols<3>().colwise().norm().allFinite();
  const char* const fault =
      empty ? "the sform is not finite" : "the axes of the grid are skewed or empty (sform)";
  if (sCode > 0 && qCode <= 0)
    throw InputError(fault, path.string(), "resample the image to a rectangular grid");
  if (sCode > 0)
    warnings.push_back(std::string(fault) + ", which is left out: the qform of the file is taken");
  if (!q.allFinite()) throwBadHeader(path, "the qform is not finite");
  if (const double length = Eigen::Vector3d(h.real(256), h.real(260), h.real(264)).norm();
      length > kLongestQuaternion)
    warnings.push_back("the quaternion of the file's qform has a length of " + rounded(length) +
                       " instead of 1: where the patient lies may be wrong");
  return q;
}

Geometry geometryOf(const Fields& h, const ImageHeader& header, const fs::path& path,
                    std::vector<std::string>& warnings) {
  // nifti1.h: metres, millimetres, micrometres; unknown units are taken for mm.
  const int units = h.unitsOfSpace();
  const double mm = units == 1 ? 1000.0 : units == 3 ? 0.001 : 1.0;
  Geometry g;
  bool negative = false;
  for (std::size_t a = 0; a < 3; ++a) {
    negative = negative || h.real(80 + 4 * a) < 0.0;
    const double spacing = std::fabs(h.real(80 + 4 * a));
    if (!(spacing > 0.0) || !std::isfinite(spacing))
      throwBadHeader(path, "a voxel spacing is not positive");
    g.size[a] = static_cast<int>(header.size[a]);
    g.spacing[static_cast<Eigen::Index>(a)] = spacing;
  }
  if (negative)
    warnings.emplace_back(
        "a voxel spacing of the file (pixdim) is negative: it is taken without its sign");
  Affine m = chosenForm(h, g.spacing, path, warnings) * mm;
  m.topRows<2>() *= -1.0;  // RAS to LPS
  for (Eigen::Index a = 0; a < 3; ++a) {
    g.spacing[a] = m.col(a).norm();
    g.direction.col(a) = m.col(a) / g.spacing[a];
  }
  g.origin = m.col(3);
  g.direction.array() += 0.0;  // -0 becomes 0
  g.origin.array() += 0.0;
  return g;
}

void takeSizes(const Fields& h, const fs::path& path, ImageHeader& header) {
  const int dimensions = h.whole(40);
  if (dimensions < 1 || dimensions > 7) throwBadHeader(path, "dim[0] is not 1 to 7");
  VoxelData& data = header.data;
  for (int a = 1; a <= dimensions; ++a) {
    const int size = h.whole(40 + 2 * static_cast<std::size_t>(a));
    if (size < 1 && a < 4) throwBadHeader(path, "a size is not positive");
    const auto length = static_cast<std::uintmax_t>(std::max(size, 1));
    if (a <= 3)
      header.size.push_back(length);
    else
      data.values *= length;
    if (data.values > (1ULL << 44U) / productOf(header.size))
      throwBadHeader(path, "the sizes in dim");
  }
  data.voxels = productOf(header.size);
}

}  // namespace

ImageHeader readNiftiHeader(const fs::path& path) {
  bool deflated = false;
  const Fields h = readFields(path, deflated);
  if (!h.singleFile())
    throw InputError("a NIfTI header without its voxels, or an Analyze file", path.string(),
                     "convert the .hdr/.img pair to .nii");
  ImageHeader header;
  VoxelData& data = header.data;
  takeSizes(h, path, header);
  const int bits = h.whole(72);
  if (bits < 8 || bits % 8 != 0 || bits > 256) throwBadHeader(path, "bits per voxel");
  data.type = niftiType(h.whole(70), path);
  if (static_cast<std::size_t>(bits) != 8 * voxelTypeBytes(data.type))
    throwBadHeader(path, "datatype and bitpix differ");
  data.swapBytes = h.swapped();
  const double offset = h.real(108);
  if (!(offset >= static_cast<double>(kHeader)) || offset > 1e8) throwBadHeader(path, "vox_offset");
  const double slope = h.real(112), intercept = h.real(116);
  // As nibabel and niftilib read it: a slope of 0 or NaN stands for no scaling.
  const bool scaled = slope != 0.0 && std::isfinite(slope);
  if (scaled && !std::isfinite(intercept)) throwBadHeader(path, "scl_inter is not a finite number");
  if (scaled) {
    data.slope = slope;
    data.intercept = intercept;
  }
  if (header.size.size() == 3) header.geometry = geometryOf(h, header, path, header.warnings);

  data.deflated = deflated;
  VoxelPlace place;
  place.local = true;
  (data.deflated ? data.skipInflated : place.start) = static_cast<std::uintmax_t>(offset);
  placeVoxels(place, path, header);
  return header;
}

}  // namespace angiomesh
