// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace angiomesh {

/// Counter-based random numbers: a pure function of (seed, counter), the same bits on every machine
/// and for any number of threads. The mixing function is the finaliser of SplitMix64 (Steele, Lea,
/// Flood 2014), applied twice.
std::uint64_t randomBits(std::uint64_t seed, std::uint64_t counter);

/// Uniform in [0, 1), 53 bits.
double randomUniform(std::uint64_t seed, std::uint64_t counter);

/// Standard normal (Box and Muller 1958); uses the library's own logarithm and cosine.
double randomNormal(std::uint64_t seed, std::uint64_t counter);

}  // namespace angiomesh
