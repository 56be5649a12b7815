// Looks through a body's coordinates for the largest deflection and for violations of the limits.

#include "engine/bodies/kinds/beam/deformation_limits.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace spoke::space {
namespace {

/// Returns the coordinates of one node.
Twist node_values(const FlexibleBody& body, int node, const double* q) {
  assert(node >= 0 && node < body.node_count());
  Twist values = Twist::Zero();
  for (int c = 0; c < kTwist; ++c)
    if (const int at = body.coordinate(node, c); at >= 0) values[c] = q[at];
  return values;
}

/// Returns the largest deflection of an element's outer node from the section of its inner one, by
/// the element's length.
double find_largest_bending(const FlexibleBody& body, const double* q) {
  double largest = 0.0;
  Twist before = node_values(body, 0, q);
  for (int node = 1; node < body.node_count(); ++node) {
    const BeamElement& element = body.beam[static_cast<std::size_t>(node - 1)];
    const Twist after = node_values(body, node, q);
    const Position moved =
        linear(after) - linear(before) - cross(Position(angular(before)), element.chord);
    const Position axis = element.axes.col(0);
    largest = std::max(largest, Position(moved - axis.dot(moved) * axis).norm() / element.length);
    before = after;
  }
  return largest;
}

}  // namespace

double find_largest_deflection(const FlexibleBody& body, const double* q) noexcept {
  if (body.is_nonlinear()) return find_largest_bending(body, q);
  double largest = 0.0;
  Twist before = node_values(body, 0, q);
  for (int node = 1; node < body.node_count(); ++node) {
    const Twist after = node_values(body, node, q);
    // The slopes are v' = tz, w' = -ty; the cubic's value in the middle follows.
    const Position turned = 0.125 * (angular(before) - angular(after));
    const Position across = 0.5 * (linear(before) + linear(after)) +
                            cross(turned, body.beam[static_cast<std::size_t>(node - 1)].chord);
    largest =
        std::max({largest, std::hypot(after[1], after[2]), std::hypot(across.y(), across.z())});
    before = after;
  }
  return largest / body.length();
}

LimitViolation find_limit_violation(const FlexibleBody& body, const double* q) noexcept {
  LimitViolation worst;
  for (int node = 0; node < body.node_count(); ++node)
    for (int c = 0; c < kTwist; ++c) {
      const int at = body.coordinate(node, c);
      if (at < 0) continue;
      const double limit = c < kRotation ? body.length() : std::numbers::pi;
      if (!std::isfinite(q[at])) return {node, c, q[at], limit};
      const bool is_worst =
          worst.node < 0 || std::abs(q[at]) / limit > std::abs(worst.value) / worst.limit;
      if (std::abs(q[at]) > limit && is_worst) worst = {node, c, q[at], limit};
    }
  return worst;
}

}  // namespace spoke::space
