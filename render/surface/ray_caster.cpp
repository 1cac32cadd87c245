// SPDX-License-Identifier: BSD-3-Clause
#include "render/surface/ray_caster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"

namespace angiomesh {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr std::size_t kRowsPerTask = 4;
constexpr float kOpaque = 0.99F;  // what lies behind is not seen
constexpr float kUnseen = 1.0F / 512.0F;

std::size_t at(int n) { return static_cast<std::size_t>(n); }

struct Rgba {
  float r = 0.0F, g = 0.0F, b = 0.0F, a = 0.0F;
};

/// Trilinear values at indices; those beyond the outermost voxels are clamped to them.
class Field {
 public:
  explicit Field(const Volume<float>& image)
      : voxels_(image.voxels.data()),
        row_(image.geometry.size[0]),
        slice_(static_cast<std::ptrdiff_t>(image.geometry.size[0]) * image.geometry.size[1]) {
    for (int a = 0; a < 3; ++a) last_[a] = static_cast<float>(image.geometry.size[at(a)] - 1);
  }

  [[nodiscard]] float operator()(const Vector3f& index) const {
    const Vector3f p = index.cwiseMax(0.0F).cwiseMin(last_);
    const int x = std::min(static_cast<int>(p[0]), static_cast<int>(last_[0]) - 1);
    const int y = std::min(static_cast<int>(p[1]), static_cast<int>(last_[1]) - 1);
    const int z = std::min(static_cast<int>(p[2]), static_cast<int>(last_[2]) - 1);
    const float tx = p[0] - static_cast<float>(x);
    const float ty = p[1] - static_cast<float>(y);
    const float tz = p[2] - static_cast<float>(z);
    const float* v = voxels_ + z * slice_ + y * row_ + x;
    const auto along = [tx](const float* q) { return q[0] + tx * (q[1] - q[0]); };
    const float low = along(v) + ty * (along(v + row_) - along(v));
    const float* w = v + slice_;
    const float high = along(w) + ty * (along(w + row_) - along(w));
    return low + tz * (high - low);
  }

  /// Per mm along the axes.
  [[nodiscard]] Vector3f slope(const Vector3f& index, const Vector3f& spacing) const {
    Vector3f slope;
    for (int a = 0; a < 3; ++a) {
      const Vector3f step = Vector3f::Unit(a);
      slope[a] = ((*this)(index + step) - (*this)(index - step)) / spacing[a];
    }
    return slope;
  }

  [[nodiscard]] const Vector3f& last() const { return last_; }

 private:
  const float* voxels_;
  std::ptrdiff_t row_, slice_;
  Vector3f last_ = Vector3f::Zero();
};

/// The look by value, in equal steps.
class Table {
 public:
  /// @param voxels that lie between two samples
  Table(const VolumeLook& look, double voxels)
      : from_(static_cast<float>(look.transfer.front().value)) {
    const double width = look.transfer.back().value - look.transfer.front().value;
    scale_ = static_cast<float>((kEntries - 1) / std::max(width, 1e-30));
    const bool lit = look.kind == RayKind::Lit;
    std::size_t next = 1;
    for (int i = 0; i < kEntries; ++i) {
      const double value = look.transfer.front().value + width * i / (kEntries - 1);
      while (next + 1 < look.transfer.size() && value > look.transfer[next].value) ++next;
      const TransferPoint& a = look.transfer[next - 1];
      const TransferPoint& b = look.transfer[next];
      const double t = std::clamp((value - a.value) / (b.value - a.value), 0.0, 1.0);
      const auto mix = [t](double p, double q) { return static_cast<float>(p + t * (q - p)); };
      Rgba& entry = entries_[at(i)];
      entry = {mix(a.colour[0], b.colour[0]), mix(a.colour[1], b.colour[1]),
               mix(a.colour[2], b.colour[2]), mix(a.opacity, b.opacity)};
      if (lit) entry.a = static_cast<float>(1.0 - std::pow(1.0 - entry.a, voxels));
    }
  }

  [[nodiscard]] const Rgba& operator()(float value) const {
    const float place = (value - from_) * scale_;
    return entries_[at(static_cast<int>(std::clamp(place, 0.0F, kEntries - 1.0F)))];
  }

 private:
  static constexpr int kEntries = 1024;
  std::array<Rgba, kEntries> entries_;
  float from_, scale_;
};

/// The part of a ray inside a volume, with samples at whole numbers of steps.
struct Ray {
  Vector3f begin, step;  // index of sample 0, and from one to the next
  int count = 0;         // of the samples
};

/// One task's tools.
class Caster {
 public:
  Caster(const DrawnVolume& volume, const VolumeLook& look, const CastView& view, double stepMm)
      : volume_(volume),
        look_(look),
        view_(view),
        stepMm_(stepMm),
        field_(*volume.image),
        table_(look, stepMm / volume.image->geometry.voxelMm()),
        spacing_(volume.image->geometry.spacing.cast<float>()),
        light_(view.lightAxes.cast<float>()),
        half_((view.lightAxes + view.eyeAxes).normalized().cast<float>()),
        lowest_(static_cast<float>(look.transfer.front().value)),
        highest_(static_cast<float>(look.transfer.back().value)) {}

  [[nodiscard]] Rgba cast(int x, int y, double endMm) const {
    const Ray ray = rayAt(x, y, endMm);
    switch (look_.kind) {
      case RayKind::Greatest:
        return greatest(ray);
      case RayKind::Least:
        return least(ray);
      case RayKind::Lit:
        return lit(ray);
    }
    return {};
  }

 private:
  [[nodiscard]] Ray rayAt(int x, int y, double endMm) const {
    const Vector3d perMm = view_.forward + (2.0 * (x + 0.5) / view_.width - 1.0) * view_.right +
                           (2.0 * (y + 0.5) / view_.height - 1.0) * view_.up;
    double from = 0.0;
    double to = endMm;
    for (int a = 0; a < 3; ++a) {
      const double last = field_.last()[a];
      if (std::abs(perMm[a]) < 1e-12) {
        if (view_.eye[a] < 0.0 || view_.eye[a] > last) return {};
        continue;
      }
      const double enter = -view_.eye[a] / perMm[a];
      const double leave = (last - view_.eye[a]) / perMm[a];
      from = std::max(from, std::min(enter, leave));
      to = std::min(to, std::max(enter, leave));
    }
    if (!(from < to)) return {};
    // At whole steps from the eye: what is seen does not swim when the camera moves along.
    const double first = std::ceil(from / stepMm_);
    Ray ray;
    ray.begin = (view_.eye + first * stepMm_ * perMm).cast<float>();
    ray.step = (stepMm_ * perMm).cast<float>();
    ray.count = std::max(0, static_cast<int>(std::floor(to / stepMm_) - first) + 1);
    return ray;
  }

  /// Calls visit(index, n) with the samples of the blocks for which seen(block) holds, until it
  /// says false.
  template <class Seen, class Visit>
  void walk(const Ray& ray, const Seen& seen, const Visit& visit) const {
    for (int n = 0; n < ray.count;) {
      const Vector3f index = ray.begin + static_cast<float>(n) * ray.step;
      std::array<int, 3> block{};
      float leave = static_cast<float>(ray.count);
      for (int a = 0; a < 3; ++a) {
        block[at(a)] =
            std::clamp(static_cast<int>(index[a]) / kBlockCells, 0, volume_.blocks[at(a)] - 1);
        if (std::abs(ray.step[a]) < 1e-9F) continue;
        const int side = block[at(a)] + (ray.step[a] > 0.0F ? 1 : 0);
        leave =
            std::min(leave, (static_cast<float>(kBlockCells * side) - ray.begin[a]) / ray.step[a]);
      }
      const int end = std::clamp(static_cast<int>(leave) + 1, n + 1, ray.count);
      if (seen((at(block[2]) * at(volume_.blocks[1]) + at(block[1])) * at(volume_.blocks[0]) +
               at(block[0]))) {
        for (; n < end; ++n)
          if (!visit(Vector3f(ray.begin + static_cast<float>(n) * ray.step))) return;
      }
      n = end;
    }
  }

  [[nodiscard]] Rgba greatest(const Ray& ray) const {
    float best = lowest_;
    walk(
        ray, [&](std::size_t block) { return volume_.greatest[block] > best; },
        [&](const Vector3f& index) {
          best = std::max(best, field_(index));
          return best < highest_;
        });
    return best > lowest_ ? premultiplied(table_(best)) : Rgba();
  }

  [[nodiscard]] Rgba least(const Ray& ray) const {
    float best = highest_;
    walk(
        ray, [&](std::size_t block) { return volume_.least[block] < best; },
        [&](const Vector3f& index) {
          best = std::min(best, field_(index));
          return best > lowest_;
        });
    return best < highest_ ? premultiplied(table_(best)) : Rgba();
  }

  [[nodiscard]] Rgba lit(const Ray& ray) const {
    Rgba sum;
    walk(
        ray, [&](std::size_t block) { return volume_.greatest[block] > lowest_; },
        [&](const Vector3f& index) {
          const float value = field_(index);
          if (value <= lowest_) return true;
          const Rgba& sample = table_(value);
          const float share = sample.a * (1.0F - sum.a);
          if (share < kUnseen) return true;
          const auto [diffuse, glossy] = lightAt(index);
          sum.r += share * std::min(1.0F, diffuse * sample.r + glossy);
          sum.g += share * std::min(1.0F, diffuse * sample.g + glossy);
          sum.b += share * std::min(1.0F, diffuse * sample.b + glossy);
          sum.a += share;
          return sum.a < kOpaque;
        });
    return sum;
  }

  /// How much of its colour, and of white, a place sends to the viewer, as its values fall.
  [[nodiscard]] std::array<float, 2> lightAt(const Vector3f& index) const {
    const Vector3f slope = field_.slope(index, spacing_);
    const float length = slope.norm();
    if (!(length > 0.0F)) return {kAmbient + kDiffuse, 0.0F};
    const Vector3f normal = slope / -length;
    const float facing = std::max(0.0F, normal.dot(light_));
    const float shine = std::max(0.0F, normal.dot(half_));
    const float shine4 = shine * shine * shine * shine;
    return {kAmbient + kDiffuse * facing, kGlossy * shine4 * shine4 * shine4 * shine4};
  }

  static Rgba premultiplied(const Rgba& colour) {
    return {colour.a * colour.r, colour.a * colour.g, colour.a * colour.b, colour.a};
  }

  static constexpr float kAmbient = 0.25F, kDiffuse = 0.8F, kGlossy = 0.25F;
  const DrawnVolume& volume_;
  const VolumeLook& look_;
  const CastView& view_;
  double stepMm_;
  Field field_;
  Table table_;
  Vector3f spacing_, light_, half_;
  float lowest_, highest_;
};

}  // namespace

std::vector<std::uint8_t> castRays(const DrawnVolume& volume, const VolumeLook& look,
                                   const CastView& view, double stepMm,
                                   const std::vector<float>& depthsMm) {
  std::vector<std::uint8_t> picture(4 * at(view.width) * at(view.height));
  const Caster caster(volume, look, view, stepMm);
  parallelFor(0, at(view.height), kRowsPerTask, [&](std::size_t from, std::size_t to) {
    for (std::size_t y = from; y < to; ++y)
      for (int x = 0; x < view.width; ++x) {
        const std::size_t pixel = y * at(view.width) + at(x);
        const double end = depthsMm.empty() ? std::numeric_limits<double>::max() : depthsMm[pixel];
        const Rgba colour = caster.cast(x, static_cast<int>(y), end);
        const auto byte = [](float part) {
          return static_cast<std::uint8_t>(255.0F * std::clamp(part, 0.0F, 1.0F) + 0.5F);
        };
        std::uint8_t* target = &picture[4 * pixel];
        target[0] = byte(colour.r);
        target[1] = byte(colour.g);
        target[2] = byte(colour.b);
        target[3] = byte(colour.a);
      }
  });
  return picture;
}

}  // namespace angiomesh
