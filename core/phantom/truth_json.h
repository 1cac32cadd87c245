// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/phantom/phantom.h"

namespace angiomesh {

/// `truth.json`: kind and all parameters, centre lines and radii, pieces of clutter.
std::string truthJson(const PhantomParams& params, const Phantom& phantom);

/// The parameters of a truth.json, which make the same phantom again.
/// @param text its content
/// @param where names the file in messages
/// @throws InputError when it is no truth.json, says something impossible, or when this version
/// makes other vessels of its parameters
PhantomParams phantomFromTruthJson(const std::string& text, const std::string& where);

}  // namespace angiomesh
