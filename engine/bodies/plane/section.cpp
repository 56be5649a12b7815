// Evaluates the shape functions of an element at a section.

#include "engine/bodies/plane/section.h"

#include <algorithm>
#include <cassert>

namespace spoke::plane {

Section make_section(const FlexibleBody& body, const FlexLayout& layout, double station) {
  assert(station >= -1e-9 && station <= 1.0 + 1e-9);
  const double along = station * body.elements;
  const int e = std::clamp(static_cast<int>(along), 0, body.elements - 1);
  Section section = make_section(body, layout, e, along - e);
  section.x = station * body.length;
  return section;
}

Section make_section(const FlexibleBody& body, const FlexLayout& layout, int e, double s) {
  assert(e >= 0 && e < body.elements && s >= -1e-9 && s <= 1.0 + 1e-9);
  const double l = body.length / body.elements;
  Section section;
  section.x = (e + s) * l;
  for (int side = 0; side < 2; ++side) {
    const auto k = static_cast<std::size_t>(side);
    section.axial_at[k] = layout.offset(body.coordinate(e + side, 0));
    section.bending_at[2 * k] = layout.offset(body.coordinate(e + side, 1));
    section.bending_at[2 * k + 1] = layout.offset(body.coordinate(e + side, 2));
  }
  section.axial = {1.0 - s, s};
  section.strain = {-1.0 / l, 1.0 / l};
  section.deflection = {1.0 - s * s * (3.0 - 2.0 * s), l * s * (1.0 - s * (2.0 - s)),
                        s * s * (3.0 - 2.0 * s), l * s * s * (s - 1.0)};
  section.slope = {6.0 * s * (s - 1.0) / l, 1.0 - s * (4.0 - 3.0 * s), 6.0 * s * (1.0 - s) / l,
                   s * (3.0 * s - 2.0)};
  section.curvature = {(12.0 * s - 6.0) / (l * l), (6.0 * s - 4.0) / l, (6.0 - 12.0 * s) / (l * l),
                       (6.0 * s - 2.0) / l};
  section.curvature_change = {12.0 / (l * l * l), 6.0 / (l * l), -12.0 / (l * l * l),
                              6.0 / (l * l)};
  return section;
}

}  // namespace spoke::plane
