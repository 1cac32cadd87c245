// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Before a function of plain loops over floats: it is compiled for AVX2 too, and the version that
// the processor has is taken at run time. Neither contracts a product and a sum, so that both give
// the same bits. Defined as nothing, only the version for all processors is compiled.
#if defined(ANGIOMESH_SIMD)
#elif defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ANGIOMESH_SIMD __attribute__((target_clones("avx2", "default")))
#else
#define ANGIOMESH_SIMD
#endif
