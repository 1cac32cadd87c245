// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/App.hpp>

#include <cstdint>

#include "app/session/session.h"
#include "core/phantom/phantom.h"

namespace angiomesh::cli {

/// The thesis's synthetic image: a vascular tree in `size`^3, 1 mm, Gaussian noise, clipped to the
/// intensity range that it states, [0, 255]. The clipping matters: c and b follow from the range.
Phantom thesisTree(int size, std::uint64_t randomSeed, double noiseSigma,
                   const Progress& progress = {});

/// `study table-a`: Tables A.1 and A.2 of the thesis on a generated tree.
void addTableA(CLI::App& study, Session& session);

}  // namespace angiomesh::cli
