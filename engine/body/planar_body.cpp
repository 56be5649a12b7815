// Where the coordinates of a planar body lie, and how far they may go.

#include "engine/body/planar_body.h"

#include <algorithm>

namespace spoke {

FlexLayout make_layout(const FlexibleBody& body) { return {body.axial(), body.bending()}; }

std::array<int, kTwist> find_places(const FlexLayout& layout, const Handle& handle) {
  std::array<int, kTwist> places{};
  for (std::size_t c = 0; c < places.size(); ++c) places[c] = layout.offset(handle.coordinate[c]);
  return places;
}

void set_extent(const FlexLayout& layout, CoordinateBlock& block) {
  block.size = layout.size();
  block.margin = FlexLayout::kPad;
  block.gap_begin = layout.u_end();
  block.gap_end = layout.v();
}

// The deflection between two nodes is at most (v1 + v2) / 2 + l / 8 (psi1 - psi2) in the middle: by
// the Cauchy-Schwarz inequality no more than sqrt(1/2 + l^2/32) times the root of the sum of the
// squares.
double calc_surely_linear(const FlexibleBody& body, double range) {
  const double l = body.length / body.elements;
  return range * range / std::max(1.0, 0.5 + l * l / 32.0);
}

}  // namespace spoke
