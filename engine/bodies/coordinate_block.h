#pragma once

// Coordinates that are integrated together.

#include <array>

namespace spoke {

/// Coordinates that are integrated together: a body's deformation, or the hub's x, y and angle.
/// All arrays have `size` values (for a body: in its FlexLayout). Coordinates stand in the places
/// from `margin` to `gap_begin`, and from `gap_end` to size - margin; what stands elsewhere is
/// padding, and zero.
struct CoordinateBlock {
  int size = 0;
  int margin = 0;
  int gap_begin = 0;
  int gap_end = 0;
  double* q = nullptr;               ///< coordinates
  double* v = nullptr;               ///< velocities
  double* a = nullptr;               ///< accelerations
  std::array<double*, 5> history{};  ///< the integrator's own, see engine/step/integrator

  /// The block of coordinate `c` alone.
  CoordinateBlock component(int c) const {
    CoordinateBlock one{1, 0, 0, 0, q + c, v + c, a + c, history};
    for (double*& h : one.history)
      if (h) h += c;
    return one;
  }
  /// Calls `apply(first, n)` with the place of the first of n neighbouring coordinates, for all.
  template <class Apply>
  void for_parts(Apply&& apply) const {
    if (gap_begin > margin) apply(margin, gap_begin - margin);
    apply(gap_end, size - margin - gap_end);
  }
};

}  // namespace spoke
