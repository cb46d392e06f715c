// SPDX-License-Identifier: GPL-2.0-or-later
// Rows and columns of four registers changed about.
// Scope: processors with AVX2.
#pragma once

#if defined(__AVX2__)
#include <immintrin.h>

namespace muckpile {

struct FourRegisters {
  __m256d n0, n1, n2, n3;
};

/// n_k: the numbers k of a, b, c and d.
[[nodiscard, gnu::always_inline]] inline FourRegisters transposed(__m256d a, __m256d b, __m256d c,
                                                                  __m256d d) {
  const __m256d n02 = _mm256_unpacklo_pd(a, b), more_n02 = _mm256_unpacklo_pd(c, d);
  const __m256d n13 = _mm256_unpackhi_pd(a, b), more_n13 = _mm256_unpackhi_pd(c, d);
  return {_mm256_permute2f128_pd(n02, more_n02, 0x20), _mm256_permute2f128_pd(n13, more_n13, 0x20),
          _mm256_permute2f128_pd(n02, more_n02, 0x31), _mm256_permute2f128_pd(n13, more_n13, 0x31)};
}

}  // namespace muckpile
#endif
