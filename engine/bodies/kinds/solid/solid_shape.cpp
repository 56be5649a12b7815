// A solid in sensors of the scenario, in pictures, and in states at rest; its limits.

#include <cmath>

#include "engine/bodies/kernels/space/body_shape.h"
#include "engine/bodies/kernels/space/dense_body.h"
#include "engine/bodies/kernels/space/table_access.h"
#include "engine/bodies/kinds/frame_inertia.h"
#include "engine/bodies/kinds/solid/solid_kind.h"
#include "engine/bodies/kinds/solid/solid_places.h"
#include "engine/bodies/kinds/solid/solid_table_terms.h"
#include "engine/bodies/space/solid_limits.h"

namespace spoke {

bool SolidKind::has_left_limits(const Data& body) const noexcept {
  return find_limit_violation(solid_of(body), body.coordinates.q).coordinate >= 0;
}

double SolidKind::find_large_deflection(const Data& body) const noexcept {
  const space::Solid& solid = solid_of(body);
  const double found = find_largest_deflection(solid, body.coordinates.q);
  return found * solid.constants->extent > body.linear_range ? found : 0.0;
}

CoordinateViolation SolidKind::find_violation(const Data& body) const {
  const space::Solid& solid = solid_of(body);
  const space::ModeViolation found = find_limit_violation(solid, body.coordinates.q);
  if (found.coordinate < 0) return {};
  return {name_coordinate(*solid.constants, found.coordinate), found.value, found.limit};
}

std::string SolidKind::find_lost(const Data& body) const {
  const space::Solid& solid = solid_of(body);
  for (int k = 0; k < solid.coordinates(); ++k)
    if (!std::isfinite(body.a_found[k])) return name_coordinate(*solid.constants, k);
  return {};
}

std::vector<CoordinateName> SolidKind::name_coordinates(const space::Body& body) const {
  const space::SolidConstants& constants = *body.solid()->constants;
  std::vector<CoordinateName> list;
  for (int k = 0; k < constants.coordinates; ++k)
    list.push_back(
        {name_coordinate(constants, k), 0, false, constants.limits[static_cast<std::size_t>(k)]});
  return list;
}

double SolidKind::length(const space::Body& body) const noexcept { return body.extent(); }

double SolidKind::coordinate_size(const space::Body& body) const noexcept {
  return body.solid()->constants->least_limit;
}

void SolidKind::place_reading(const std::optional<double>&, const TreeBody<Space>& member,
                              Reading<Space>& reading) const {
  reading.section = section_at(*member.body, 0.0);
}

std::shared_ptr<const space::SolidConstants> SolidKind::mesh(const space::Body& body) const {
  return body.solid()->constants;
}

space::Section SolidKind::section_at_place(const space::Body& body, int place) const {
  return make_solid_section(*body.solid(), place);
}

space::Section SolidKind::section_at_node(const space::Body& body, int node) const {
  return make_node_section(*body.solid(), node);
}

// The nodes are the frame, then the places.
void SolidKind::add_shape(const Data& body, space::BodyShape& shape) const {
  const double *q = body.coordinates.q, *v = body.coordinates.v;
  const std::vector<space::SolidPlace>& places = solid_of(body).constants->places;
  const space::Position origin = space::Position::Zero();
  shape.nodes.push_back({{}, origin, space::make_fixed_handle(origin)});
  for (std::size_t i = 0; i < places.size(); ++i) {
    const space::PlaceDrawn drawn = calc_solid_drawn(body, static_cast<int>(i), q, v, nullptr);
    shape.nodes.push_back(
        {{}, places[i].p, calc_place_motion(places[i], q, v), -drawn.place, -drawn.rate});
  }
}

std::size_t SolidKind::node_of_handle(const space::Body& body, std::size_t handle) const {
  return 1 + static_cast<std::size_t>(body.solid()->handles[handle]);
}

// The frame of a solid and its places have no mass; then some nodes, at most kMost evenly from its
// list, have each an equal share.
std::vector<LumpedNode> SolidKind::lump(const Data& body, const space::Pose& pose) const {
  constexpr std::size_t kMost = 200;
  const space::SolidConstants& constants = *solid_of(body).constants;
  const double* q = body.coordinates.q;
  const std::size_t count = constants.nodes.size(), stride = (count + kMost - 1) / kMost;
  const std::size_t taken = (count + stride - 1) / stride;
  const double share = constants.mass / static_cast<double>(taken);
  std::vector<LumpedNode> lumped{{pose.p, pose.R.axes, pose.p}};
  for (const space::SolidPlace& place : constants.places) {
    const space::HandleMotion motion = calc_place_motion(place, q, q);
    const space::Position p = pose.p + pose.R * motion.s;
    lumped.push_back({p, (pose.R * motion.turn.R).axes, p});
  }
  const Eigen::VectorXd u = calc_displacements(constants, q);
  for (std::size_t i = 0; i < count; i += stride) {
    const space::Position moved = u.segment<3>(static_cast<Eigen::Index>(3 * i));
    const space::Position p = pose.p + pose.R * space::Position(constants.nodes[i] + moved);
    lumped.push_back({p, pose.R.axes, p, share});
  }
  return lumped;
}

Eigen::Matrix3d SolidKind::outer_axes(const Data& body, const space::Pose& pose) const {
  const space::SolidPlace& tip = solid_of(body).constants->tip;
  return (pose.R * calc_place_motion(tip, body.coordinates.q, body.coordinates.v).turn.R).axes;
}

Eigen::Matrix3d SolidKind::inboard_axes(const Data& body) const {
  return calc_place_motion(solid_of(body).handle(0), body.coordinates.q, body.coordinates.v)
      .turn.R.axes;
}

void SolidKind::add_stiffness_trace(const space::Body& body, double& trace) const {
  trace += calc_stiffness_trace(*body.solid()->constants);
}

Eigen::VectorXd SolidKind::calc_frame_force(const Data& body) const {
  const space::Solid& solid = solid_of(body);
  const space::Twist& X = body.X;
  Eigen::VectorXd force(space::dense_size(solid));
  calc_dense_force(body, force);
  subtract_frame_inertia(body, force);
  for (int k = 0; k < solid.coordinates(); ++k) {
    const double* row = body.work.rows + space::kSolidRow * k;
    force[space::kTwist + k] -= solid.constants->C_t().row(k).dot(X.head<3>()) + row[0] * X[3] +
                                row[1] * X[4] + row[2] * X[5];
  }
  return force;
}

}  // namespace spoke
