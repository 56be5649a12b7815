// What sensors, loads and markers ask a beam of places on it.

#include "engine/bodies/kernels/marker_rules.h"
#include "engine/bodies/kernels/space/relative_motion.h"
#include "engine/bodies/kernels/space/table_access.h"
#include "engine/bodies/kinds/beam/beam_energies.h"
#include "engine/bodies/kinds/beam/beam_kind.h"

namespace spoke {
namespace {

const space::FlexibleBody& shape_of(const BodyData<Space>& body) {
  return *body.model->body->flexible();
}

/// Returns the section at the tip.
space::Section tip_of(const space::FlexibleBody& beam) {
  space::Section tip;
  tip.element = beam.elements - 1;
  tip.s0 = beam.nodes.back();
  return tip;
}

}  // namespace

void BeamKind::place_handles(Data& body) const noexcept {
  calc_handles(shape_of(body), body.coordinates.q, body.coordinates.v, body.work.handles);
}

void BeamKind::leave_inboard(const Data& body, space::JointMotion& joint,
                             space::Twist& twist) const noexcept {
  if (shape_of(body).reference_frame == ReferenceFrame::chord)
    leave_section(body.work.handles[0].turn, joint, twist);
}

space::Section BeamKind::place_marker(const std::string& whose, const Marker& marker,
                                      const space::Body& body) const {
  require_on_beam(whose, marker);
  const space::FlexibleBody& beam = *body.flexible();
  const double from = beam.stations.front(), to = beam.stations.back();
  return section_at(body, from + marker.station * (to - from));
}

space::Section BeamKind::section_at(const space::Body& body, double station) const {
  return make_section(*body.beam, *body.flexible(), station);
}

space::HandleMotion BeamKind::motion_at(const Data& body,
                                        const space::Section& section) const noexcept {
  return calc_section_motion(shape_of(body), section, body.coordinates.q, body.coordinates.v);
}

space::Twist BeamKind::calc_section_acceleration(const Data& body, const space::Section& section,
                                                 const space::HandleMotion& motion,
                                                 const space::Twist& X, const space::Angular& w,
                                                 const double* a) const noexcept {
  return space::calc_section_acceleration(shape_of(body), section, motion, X, w, a);
}

space::Twist BeamKind::calc_handle_deformation(const Data& body, int handle) const noexcept {
  const space::FlexibleBody& beam = shape_of(body);
  space::Twist acceleration = space::Twist::Zero();
  const int node = beam.handles[static_cast<std::size_t>(handle)];
  for (int c = 0; c < space::kTwist; ++c)
    if (const int at = beam.coordinate(node, c); at >= 0) acceleration[c] = body.coordinates.a[at];
  const space::Angular turn = body.work.handles[handle].turn.H.lazyProduct(angular(acceleration));
  angular(acceleration) = turn;
  return acceleration;
}

void BeamKind::add_handle_turning(const Data& body, int handle,
                                  space::Angular& sum) const noexcept {
  const space::FlexibleBody& beam = shape_of(body);
  const int node = beam.handles[static_cast<std::size_t>(handle)];
  for (int c = 0; c < 3; ++c)
    if (const int at = beam.coordinate(node, space::kRotation + c); at >= 0)
      sum += body.coordinates.a[at] * body.work.handles[handle].turn.H.col(c);
}

space::DrawnInward BeamKind::calc_handle_drawn(const Data& body, int handle) const noexcept {
  const space::FlexibleBody& beam = shape_of(body);
  return calc_drawn_inward(beam, beam.handles[static_cast<std::size_t>(handle)], body.coordinates.q,
                           body.coordinates.v);
}

space::DrawnInward BeamKind::calc_section_drawn(const Data& body,
                                                const space::Section& section) const noexcept {
  return calc_drawn_inward(shape_of(body), section, body.coordinates.q, body.coordinates.v);
}

// All that a beam carries counts as carried at its tip.
space::Position BeamKind::calc_shown_drawn(const Data& body, int) const noexcept {
  return {-calc_foreshortening(body_model_of(body), body.coordinates.q, body.work), 0.0, 0.0};
}

space::Position BeamKind::calc_shown_drawn(const Data& body,
                                           const space::Section& section) const noexcept {
  const double* q = body.coordinates.q;
  return {-calc_foreshortening(body_model_of(body), section, q, q, q, body.work).length, 0.0, 0.0};
}

void BeamKind::add_shown_drawn(const Data& body, int, const SpatialMotion& frame,
                               SpatialMotion& shown) const noexcept {
  add_shown_drawn(body, tip_of(shape_of(body)), frame, shown);
}

// It is along the x axis of the frame.
void BeamKind::add_shown_drawn(const Data& body, const space::Section& section,
                               const SpatialMotion& frame, SpatialMotion& shown) const noexcept {
  const CoordinateBlock& c = body.coordinates;
  const space::Foreshortening l =
      calc_foreshortening(body_model_of(body), section, c.q, c.v, c.a, body.work);
  const space::Position e = frame.R * space::Position(space::Position::UnitX());
  const space::Position e_rate = cross(frame.w, e);
  shown.p -= l.length * e;
  shown.v -= l.length * e_rate + l.rate * e;
  shown.a -= l.length * (cross(frame.alpha, e) + cross(frame.w, e_rate)) + 2.0 * l.rate * e_rate +
             l.acceleration * e;
}

space::Position BeamKind::find_tip(const Data& body) const noexcept {
  const space::FlexibleBody& beam = shape_of(body);
  space::Position tip = beam.nodes.back();
  for (int c = 0; c < space::kPosition; ++c) {
    const int k = beam.coordinate(beam.elements, c);
    if (k >= 0) tip[c] += body.coordinates.q[k];
  }
  return tip;
}

space::BodyEnergies BeamKind::calc_energies(const Data& body, const space::Twist& twist,
                                            const space::BodyMotion& motion) const noexcept {
  return calc_body_energies(body_model_of(body), body_state_of(body), twist, motion, body.work);
}

double BeamKind::calc_strain_energy(const Data& body) const noexcept {
  return space::calc_strain_energy(shape_of(body), body.coordinates.q, body.work);
}

}  // namespace spoke
