// How far a beam may deform, and what its coordinates are called.

#include <cassert>
#include <cmath>

#include "engine/bodies/kinds/beam/beam_kind.h"
#include "engine/bodies/kinds/beam/deformation_limits.h"

namespace spoke {
namespace {

/// Returns a name like "rotation ty of node 3".
std::string describe_coordinate(int node, int component) {
  assert(node >= 0 && component >= 0 && component < space::kTwist);
  static constexpr const char* kNames[] = {"displacement u", "displacement v", "displacement w",
                                           "rotation tx",    "rotation ty",    "rotation tz"};
  return std::string(kNames[component]) + " of node " + std::to_string(node);
}

}  // namespace

bool BeamKind::has_left_limits(const Data& body) const noexcept {
  return find_limit_violation(*body.model->body->flexible(), body.coordinates.q).node >= 0;
}

double BeamKind::find_large_deflection(const Data& body) const noexcept {
  const space::FlexibleBody& beam = *body.model->body->flexible();
  const double largest = find_largest_deflection(beam, body.coordinates.q);
  return largest * beam.length() > body.linear_range ? largest : 0.0;
}

CoordinateViolation BeamKind::find_violation(const Data& body) const {
  const space::LimitViolation found =
      find_limit_violation(*body.model->body->flexible(), body.coordinates.q);
  if (found.node < 0) return {};
  return {describe_coordinate(found.node, found.component), found.value, found.limit};
}

std::string BeamKind::find_lost(const Data& body) const {
  const space::FlexibleBody& beam = *body.model->body->flexible();
  for (int node = 0; node < beam.node_count(); ++node)
    for (int c = 0; c < space::kTwist; ++c)
      if (const int at = beam.coordinate(node, c); at >= 0 && !std::isfinite(body.a_found[at]))
        return describe_coordinate(node, c);
  return {};
}

std::vector<CoordinateName> BeamKind::name_coordinates(const space::Body& body) const {
  static constexpr const char* kNames[] = {"u", "v", "w", "tx", "ty", "tz"};
  const space::FlexibleBody& beam = *body.flexible();
  std::vector<CoordinateName> list(static_cast<std::size_t>(beam.coordinates()));
  for (int node = 0; node < beam.node_count(); ++node)
    for (int c = 0; c < space::kTwist; ++c) {
      const int at = beam.coordinate(node, c);
      if (at < 0) continue;
      const bool turns = c >= space::kRotation;
      list[static_cast<std::size_t>(at)] = {"node " + std::to_string(node) + " / " + kNames[c],
                                            node, turns, turns ? 1.0 : body.extent()};
    }
  return list;
}

double BeamKind::length(const space::Body& body) const noexcept { return body.extent(); }

}  // namespace spoke
