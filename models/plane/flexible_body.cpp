// Numbers the coordinates of a body, and stores its coupling by both sides.

#include "models/plane/flexible_body.h"

#include <cassert>

namespace spoke::plane {

int FlexibleBody::coordinate(int node, int component) const {
  assert(node >= 0 && node <= elements && component >= 0 && component < kTwist);
  if (component == 0) return node == 0 ? -1 : node - 1;
  const int psi = component - 1;  // 0: deflection v, 1: rotation psi
  if (reference_frame == ReferenceFrame::clamped)
    return node == 0 ? -1 : elements + 2 * (node - 1) + psi;
  if (node == 0) return psi ? elements : -1;
  if (node == elements) return psi ? elements + 2 * elements - 1 : -1;
  return elements + 2 * node - 1 + psi;
}

void AxialBendingCoupling::transpose() {
  const int n = static_cast<int>(pairs.size()) / (2 * kHeight);
  for (int i = 0; i < n; ++i)
    for (int place = 0; place < kWidth; ++place) {
      const int column = 2 * i + offset + place;
      if (column < 0 || column >= 2 * n) continue;
      const int k = column / 2;
      pairs[(k * kHeight + (i - k + 2)) * 2 + column % 2] = rows[i * kWidth + place];
    }
}

}  // namespace spoke::plane
