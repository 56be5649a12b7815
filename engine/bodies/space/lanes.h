#pragma once

// Values by node, component by component, of bodies whose directions do not meet.

#include <cassert>

#include "engine/bodies/space/body_scratch.h"
#include "models/support/simd.h"

namespace spoke::space {

/// Components of a node in its directions: u, tx, then the place and slope of either plane of
/// bending, (v, tz) and (w, -ty).
enum LaneComponent { kAxialPlace, kTorsion, kPlace1, kSlope1, kPlace2, kSlope2 };

/// Rows of BodyScratch::lanes that belong together: one for each component.
class LaneRows {
 public:
  enum Kind { coordinates, velocities, elastic_coordinates, inner_forces, outer_forces };

  LaneRows(const FlexibleBody& body, const BodyScratch& scratch, Kind kind)
      : stride_(lane_stride(body)),
        first_(scratch.lanes + kTwist * static_cast<std::size_t>(kind) * stride_ + 1) {}

  /// Returns the place of node k's value.
  double* at(int component, int k) const {
    assert(component >= 0 && component < kTwist);
    return first_ + static_cast<std::size_t>(component) * stride_ + k;
  }

 private:
  std::size_t stride_;
  double* first_;
};

[[gnu::always_inline]] inline Double4 lanes(const Lanes& values) { return load4(values.data()); }
[[gnu::always_inline]] inline double total(const Double4& value) {
  return (value[0] + value[1]) + (value[2] + value[3]);
}

/// Four nodes with their neighbours.
struct Around {
  Double4 inner, own, outer;

  [[gnu::always_inline]] static Around from(const double* x) {
    return {load4(x - 1), load4(x), load4(x + 1)};
  }
};

[[gnu::always_inline]] inline Double4 operator*(const Band& band, const Around& x) {
  return lanes(band.inner) * x.inner + lanes(band.own) * x.own + lanes(band.outer) * x.outer;
}

}  // namespace spoke::space
