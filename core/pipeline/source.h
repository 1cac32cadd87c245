// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "core/image/volume.h"

namespace angiomesh {

/// The image that a pipeline starts from. Loaders make it; `hash` is contentHash(image).
struct Source {
  std::shared_ptr<const Volume<float>> image;
  std::string hash;
  std::string name;  ///< shown to the user and used for folder names; never a patient's
};
/// 16 hexadecimal digits.
std::string textHash(const std::string& text);
std::string contentHash(const Volume<float>& image);
Source makeSource(Volume<float> image, const std::string& name);

}  // namespace angiomesh
