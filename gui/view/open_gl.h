// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace angiomesh {

/// Sets the surface format that VTK needs (OpenGL 3.2 core). To be called before the application
/// object is made.
void prepareOpenGl();

}  // namespace angiomesh
