#pragma once

// Products of a body's banded matrices with flex vectors, two neighbouring rows at a time.

#include "engine/bodies/plane/flex_layout.h"
#include "models/plane/symmetric_band.h"
#include "models/support/simd.h"

namespace spoke::plane {

/// Pointers to the two parts of a flex vector.
struct FlexParts {
  const double* u;
  const double* v;
};

inline FlexParts flex_parts(const double* flex, const FlexLayout& layout) {
  return {flex + layout.u(), flex + layout.v()};
}

/// Returns rows i and i + 1 of a banded product; `rows` are theirs, see SymmetricBand::pairs().
template <int Half>
[[gnu::always_inline]] inline Double2 band_rows(const double* rows, int i, const double* x) {
  Double2 sum = load_aligned(rows) * load(x + i - Half);
  for (int k = 1; k <= 2 * Half; ++k) sum += load_aligned(rows + 2 * k) * load(x + i - Half + k);
  return sum;
}

/// Adds the first, then the second value: a sum over coordinates runs from the first to the last,
/// whether products take one row at a time or two.
[[gnu::always_inline]] inline void add_in_order(Double2 terms, double& sum) {
  sum += terms[0];
  sum += terms[1];
}

}  // namespace spoke::plane
