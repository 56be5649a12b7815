// Looks through a body's coordinates for the largest deflection and for violations of the limits.

#include "engine/bodies/kernels/deformation_limits.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace spoke {
namespace {

double limit_of(const plane::FlexibleBody& body, int coordinate) {
  assert(coordinate >= 0 && coordinate < body.coordinates());
  const bool is_displacement = coordinate < body.axial() || [&] {
    // Bending coordinates alternate v, psi; a chord frame's begin with psi_0 and end with psi_E.
    const int at = coordinate - body.axial();
    if (body.reference_frame == ReferenceFrame::clamped) return at % 2 == 0;
    return at % 2 == 1 && at != body.bending() - 1;
  }();
  return is_displacement ? body.length : std::numbers::pi;
}

}  // namespace

double find_large_deflection(const BodyData<Plane>& body) noexcept {
  const plane::FlexibleBody& model = *body.model->body;
  const double l = model.length / model.elements;
  const auto at = [&](int node, int c) {
    return body.coordinates.q[body.layout.offset(model.coordinate(node, c))];
  };
  double largest = 0.0;
  for (int node = 1; node <= model.elements; ++node) {
    const double before = at(node - 1, 1), after = at(node, 1);
    const double turned = at(node - 1, kRotation) - at(node, kRotation);
    const double between = 0.5 * (before + after) + 0.125 * l * turned;
    largest = std::max({largest, std::abs(after), std::abs(between)});
  }
  return largest > body.linear_range ? largest / model.length : 0.0;
}

LimitViolation find_limit_violation(const BodyData<Plane>& body) {
  const plane::FlexibleBody& model = *body.model->body;
  LimitViolation worst;
  for (int k = 0; k < model.coordinates(); ++k) {
    const double value = body.coordinates.q[body.layout.offset(k)];
    const double limit = limit_of(model, k);
    if (!std::isfinite(value)) return {k, value, limit};
    const bool is_worst =
        worst.coordinate < 0 || std::abs(value) / limit > std::abs(worst.value) / worst.limit;
    if (std::abs(value) > limit && is_worst) worst = {k, value, limit};
  }
  return worst;
}

bool has_left_limits(const BodyData<Plane>& body) noexcept {
  return find_limit_violation(body).coordinate >= 0;
}

}  // namespace spoke
