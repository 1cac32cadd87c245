// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <type_traits>
#include <vector>

#include "core/image/volume.h"
#include "core/mesh/tri_mesh.h"
#include "core/pipeline/source.h"

namespace angiomesh::analytic {

/// The bytes of a result, one after the other, for tests that hold its bits.
class Bytes {
 public:
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(const T& value) { text_.append(reinterpret_cast<const char*>(&value), sizeof value); }
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(const std::vector<T>& values) {
    text_.append(reinterpret_cast<const char*>(values.data()), sizeof(T) * values.size());
  }
  void add(const std::string& text) { text_ += text; }
  void add(const Eigen::Vector3d& point) {
    for (const double x : point) add(x);
  }
  template <class T>
  void add(const Volume<T>& volume) {
    text_.append(reinterpret_cast<const char*>(volume.voxels.data()),
                 sizeof(T) * volume.voxels.size());
  }
  void add(const TriMesh& mesh) {
    for (const Eigen::Vector3d& point : mesh.points) add(point);
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t corner : triangle) add(corner);
  }
  [[nodiscard]] std::string hash() const { return textHash(text_); }

 private:
  std::string text_;
};

}  // namespace angiomesh::analytic
