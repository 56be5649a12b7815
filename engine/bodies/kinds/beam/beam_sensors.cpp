// A beam in sensors of the scenario, and in states at rest.

#include <algorithm>

#include "engine/bodies/kernels/space/dense_body.h"
#include "engine/bodies/kernels/space/table_access.h"
#include "engine/bodies/kinds/beam/beam_kind.h"
#include "engine/bodies/kinds/frame_inertia.h"
#include "engine/bodies/space/nonlinear_strain.h"
#include "models/space/beam_element.h"
#include "models/system/spatial_loads.h"

namespace spoke {
namespace {

/// Returns stiffness and damping by strains of second order.
space::StrainMatrices find_strain_matrices(double stiffness_factor, const BodyData<Space>& body) {
  const space::FlexibleBody& beam = *body.model->body->flexible();
  Eigen::VectorXd q(space::kTwist * beam.node_count());
  space::expand(beam, body.q_elastic, q.data());
  return space::calc_strain_matrices(beam, stiffness_factor, q.data());
}

}  // namespace

double BeamKind::station_of(const TreeBody<Space>& member) const noexcept {
  return member.begin + member.body->flexible()->stations.front();
}

void BeamKind::place_reading(const std::optional<double>& station, const TreeBody<Space>& member,
                             Reading<Space>& reading) const {
  const space::FlexibleBody& beam = *member.body->flexible();
  const double from = beam.stations.front(), to = beam.stations.back();
  reading.section =
      section_at(*member.body, station ? std::clamp(*station - member.begin, from, to) : to);
  reading.along = reading.section.element + place_in_element(beam, reading.section);
}

void BeamKind::find_outboard(const TreeBody<Space>& member, Reading<Space>& reading) const {
  const space::FlexibleBody& beam = *member.body->flexible();
  const auto e = static_cast<std::size_t>(reading.section.element);
  const double from = beam.stations[e], to = beam.stations[e + 1];
  reading.mass =
      calc_outboard_mass(*member.body->beam, {beam.stations, beam.pose, beam.nodes}, beam.beam[e],
                         e, from + (reading.along - reading.section.element) * (to - from));
  for (const BodyLoad<Space>& load : member.loads) {
    OutboardLoad outboard{take_outboard(load, reading.along), {}};
    for (const BodyLoad<Space>::Point& point : outboard.load.points)
      outboard.sections.push_back(make_element_section(*member.body, point.element, point.s));
    if (!outboard.sections.empty()) reading.loads.push_back(std::move(outboard));
  }
}

std::optional<space::Twist> BeamKind::calc_stress(const Data& body, const space::Section& section,
                                                  double stiffness_factor,
                                                  const double* modal) const {
  const space::FlexibleBody& beam = *body.model->body->flexible();
  const CoordinateBlock& c = body.coordinates;
  space::Twist sum = calc_section_load(beam, section, c.q).resultants +
                     calc_section_damping(beam, section, stiffness_factor, c.q, c.v);
  if (modal) sum += calc_section_stress(beam, section, modal);
  return sum;
}

std::vector<LumpedNode> BeamKind::lump(const Data& body, const space::Pose& pose) const {
  const space::FlexibleBody& beam = *body.model->body->flexible();
  std::vector<LumpedNode> lumped;
  const double mass = beam.mass / beam.elements;
  for (int node = 0; node < beam.node_count(); ++node) {
    space::Twist value = space::Twist::Zero();
    for (int c = 0; c < space::kTwist; ++c) {
      const int at = beam.coordinate(node, c);
      if (at >= 0) value[c] = body.coordinates.q[at];
    }
    const auto k = static_cast<std::size_t>(node);
    const space::Position s = beam.nodes[k] + space::Position(value.head<3>());
    const bool is_end = node == 0 || node == beam.elements;
    // The linear shape of torsion spreads a node's inertia by 2/3 to itself.
    const space::Position p = pose.p + pose.R * s;
    lumped.push_back({p, (pose.R * space::exponential(value.tail<3>())).axes, p,
                      is_end ? 0.5 * mass : mass,
                      1.5 * beam.M.diagonal[k](space::kRotation, space::kRotation)});
  }
  return lumped;
}

Eigen::Matrix3d BeamKind::inboard_axes(const Data& body) const {
  const space::Body& shape = *body.model->body;
  const space::Section section = section_at(shape, shape.flexible()->stations.front());
  return (motion_at(body, section).turn.R * section.axes).axes;
}

Eigen::MatrixXd BeamKind::calc_stiffness(const Data& body) const {
  if (!has_nonlinear_strain(*body.model->body)) return BodyKind<Space>::calc_stiffness(body);
  return find_strain_matrices(0.0, body).stiffness;
}

Eigen::MatrixXd BeamKind::calc_damping(const Damping& damping, const Data& body) const {
  if (!has_nonlinear_strain(*body.model->body)) return BodyKind<Space>::calc_damping(damping, body);
  return make_dense_block(*body.model->body, {damping.mass_factor, 0.0, 0.0}) +
         find_strain_matrices(damping.stiffness_factor, body).damping;
}

void BeamKind::add_stiffness_trace(const space::Body& body, double& trace) const {
  for (const space::TwistMatrix& block : body.flexible()->K.diagonal) trace += block.trace();
}

Eigen::VectorXd BeamKind::calc_frame_force(const Data& body) const {
  const space::FlexibleBody& beam = *body.model->body->flexible();
  Eigen::VectorXd force(space::dense_size(beam));
  calc_dense_force(body, force);
  subtract_frame_inertia(body, force);
  const space::Position a = linear(body.X);
  const space::Angular alpha = angular(body.X);
  for (int node = 0; node < beam.node_count(); ++node)
    for (int c = 0; c < space::kTwist; ++c) {
      const int at = beam.coordinate(node, c);
      if (at < 0) continue;
      const double* row = body.work.rows + space::kNodeRows * node + 4 * c;
      force[space::kTwist + at] -=
          beam.C_t[static_cast<std::size_t>(node)].row(c).dot(a.transpose()) + row[0] * alpha[0] +
          row[1] * alpha[1] + row[2] * alpha[2];
    }
  return force;
}

}  // namespace spoke
