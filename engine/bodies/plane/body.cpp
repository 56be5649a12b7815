// Places the coordinates of a planar body in memory, and finds their limits.

#include "engine/bodies/plane/body.h"

#include <algorithm>
#include <cassert>

namespace spoke::plane {

FlexLayout make_layout(const FlexibleBody& body) { return {body.axial(), body.bending()}; }

namespace {

/// Finds the places of a handle's coordinates in flex vectors.
std::array<int, kTwist> find_places(const FlexLayout& layout, const Handle& handle) {
  std::array<int, kTwist> places{};
  for (std::size_t c = 0; c < places.size(); ++c) places[c] = layout.offset(handle.coordinate[c]);
  return places;
}

/// Returns the distance from one flex vector to the next, both with the zeros before and behind.
std::size_t stride_of(const FlexLayout& layout) {
  return static_cast<std::size_t>(layout.stride());
}

}  // namespace

std::size_t count_fields(const FlexibleBody& body) { return 2 * stride_of(make_layout(body)); }

void place_fields(const FlexibleBody& body, double* memory, Fields& fields) {
  assert(memory && is_aligned(memory));
  const FlexLayout layout = make_layout(body);
  fields.inboard_at = find_places(layout, body.inboard);
  fields.outboard_at = find_places(layout, body.outboard);
  fields.c_theta = memory;
  fields.Q_f = memory + stride_of(layout);
}

std::size_t count_condensed(const FlexibleBody& body) {
  const FlexLayout layout = make_layout(body);
  return 2 * stride_of(layout) + FlexLayout::kPad +
         2 * static_cast<std::size_t>(layout.scratch_size());
}

void place_condensed(const FlexibleBody& body, double* memory, Condensed& condensed) {
  assert(memory && is_aligned(memory));
  const FlexLayout layout = make_layout(body);
  condensed.W_theta = memory;
  condensed.z = memory + stride_of(layout);
  condensed.scratch = reinterpret_cast<Double2*>(memory + 2 * stride_of(layout) + FlexLayout::kPad);
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
  assert(range >= 0.0 && body.elements > 0);
  const double l = body.length / body.elements;
  return range * range / std::max(1.0, 0.5 + l * l / 32.0);
}

}  // namespace spoke::plane
