// Sums over the slots of the elements of a beam at a state, their accelerations and velocities.

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/space/section_balance.h"
#include "engine/bodies/kernels/space/table_access.h"
#include "engine/bodies/kinds/beam/beam_kind.h"
#include "engine/bodies/space/body_scratch.h"
#include "engine/bodies/space/body_stiffening.h"
#include "engine/bodies/space/nonlinear_strain.h"

namespace spoke {
namespace {

using space::Angular;
using space::BeamElement;
using space::FlexibleBody;
using space::Position;

constexpr int kSlots = space::kElementSlots;
using Slots = std::array<Position, kSlots>;

/// Finds the slots of an element (see models/space/beam_element.h) of a flex vector; `rest`: with
/// their places and axes, else only their displacements.
Slots find_slots(const FlexibleBody& body, std::size_t e, const double* flex, bool rest) {
  assert(e < body.beam.size());
  const BeamElement& element = body.beam[e];
  Slots slots;
  Position u[2], th[2];
  for (std::size_t node = 0; node < 2; ++node)
    for (int c = 0; c < space::kPosition; ++c) {
      const int at_u = body.coordinate(static_cast<int>(e + node), c);
      const int at_th = body.coordinate(static_cast<int>(e + node), c + space::kRotation);
      u[node][c] = at_u < 0 ? 0.0 : flex[at_u];
      th[node][c] = at_th < 0 ? 0.0 : flex[at_th];
    }
  const Position e1 = element.axes.col(0);
  const double stretch = e1.dot(u[1] - u[0]) / element.length;
  for (std::size_t node = 0; node < 2; ++node) {
    Position* slot = slots.data() + space::kNodeSlots * node;
    slot[0] = u[node];
    for (int axis = 0; axis < 3; ++axis) {
      const Position direction = element.axes.col(axis);
      slot[1 + axis] = cross(th[node], direction);
      if (rest) slot[1 + axis] += direction;
    }
    slot[1] += stretch * e1;
    if (rest) slot[0] += body.nodes[e + node];
  }
  return slots;
}

bool is_place(int slot) { return slot % space::kNodeSlots == 0; }

/// Returns force and moment about B's origin of slot vectors b: the sums of m_ij b_j over the
/// places i, and of a_i x m_ij b_j over all slots a_i of an element.
space::Twist sum_moments(const space::SlotMatrix& m, const Slots& places, const Slots& b) {
  space::Twist sum = space::Twist::Zero();
  for (int i = 0; i < kSlots; ++i) {
    Position weighted = Position::Zero();
    for (int j = 0; j < kSlots; ++j) weighted += m(i, j) * b[static_cast<std::size_t>(j)];
    if (is_place(i)) linear(sum) += weighted;
    angular(sum) += cross(places[static_cast<std::size_t>(i)], weighted);
  }
  return sum;
}

/// Returns the accelerations of the slots of an element, less gravity: a_i = e_i X_t + X_w x rho_i
/// + w x (w x rho_i) + 2 w x rho_i' + rho_i''.
Slots accelerate(const Slots& places, const Slots& rates, Slots accelerations,
                 const space::Twist& X, const Angular& w) {
  for (int i = 0; i < kSlots; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (is_place(i)) accelerations[k] += linear(X);
    accelerations[k] +=
        cross(angular(X), places[k]) + centripetal(w, places[k]) + 2.0 * cross(w, rates[k]);
  }
  return accelerations;
}

Slots move(const Slots& places, Slots rates, const space::Twist& twist) {
  for (int i = 0; i < kSlots; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (is_place(i)) rates[k] += linear(twist);
    rates[k] += cross(angular(twist), places[k]);
  }
  return rates;
}

/// Returns force and moment about B's origin that the inertia of a body's part outboard exerts.
space::Twist calc_inertia_force(const BodyData<Space>& body, const space::Twist& X,
                                const Angular& w, const Reading<Space>& reading) {
  const FlexibleBody& flexible = *body.model->body->flexible();
  const CoordinateBlock& c = body.coordinates;
  const auto first = static_cast<std::size_t>(reading.section.element);
  space::Twist sum = space::Twist::Zero();
  for (std::size_t e = first; e < flexible.beam.size(); ++e) {
    const Slots places = find_slots(flexible, e, c.q, true);
    const Slots rates = find_slots(flexible, e, c.v, false);
    const Slots a = accelerate(places, rates, find_slots(flexible, e, c.a, false), X, w);
    sum -= sum_moments(e == first ? reading.mass : flexible.beam[e].mass, places, a);
  }
  return sum;
}

/// Returns force and moment of the loads on the part outboard of a section, in B, about B's origin.
space::Twist calc_applied(const BodyData<Space>& body, const space::Rotation& R_HB,
                          const space::Rotation& R_0, double t, const Reading<Space>& reading) {
  const FlexibleBody& flexible = *body.model->body->flexible();
  space::Twist sum = space::Twist::Zero();
  for (const auto& [load, sections] : reading.loads)
    for (std::size_t k = 0; k < sections.size(); ++k) {
      const space::HandleMotion motion = motion_at(body, sections[k]);
      const space::Rotation section = motion.turn.R * sections[k].axes;
      sum += translate(motion.s, calc_load_wrench(load, k, t, R_HB, R_0, section));
    }
  for (const AppliedWrench<Space>& at : body.applied) {
    const double along = at.section->element + place_in_element(flexible, *at.section);
    if (along < reading.along - 1e-9) continue;
    sum +=
        translate(motion_at(body, *at.section).s, make_wrench(at.wrench->force, at.wrench->moment));
  }
  return sum;
}

/// Returns force and moment of the bodies that the part outboard carries, in B, about B's origin.
space::Twist calc_carried(const TreeBody<Space>& model, const SubsystemData<Space>& data,
                          const BodyData<Space>& body, const Reading<Space>& reading) {
  const FlexibleBody& flexible = *body.model->body->flexible();
  space::Twist sum = space::Twist::Zero();
  for (std::size_t h = 1; h <= model.children.size(); ++h) {
    if (flexible.handles[h] < reading.along - 1e-9) continue;
    const auto child = static_cast<std::size_t>(model.children[h - 1]);
    const space::JointMotion& joint = data.joints[child];
    const Position at = body.work.handles[h].s + joint.p;
    sum -= translate(at, joint.R * data.joint_loads[child]);
  }
  return sum;
}

}  // namespace

space::Twist calc_section_load(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                               double t, const space::Twist& X,
                               const Reading<Space>& reading) noexcept {
  assert(!reading.path.empty() && std::cmp_less(reading.body(), data.bodies.size()));
  const auto j = static_cast<std::size_t>(reading.body());
  const BodyData<Space>& body = data.bodies[j];
  const space::Rotation R_HB = calc_rotation_to_hub(subsystem, data, reading.body());
  const space::Twist about_origin = calc_inertia_force(body, X, angular(data.twists[j]), reading) +
                                    calc_applied(body, R_HB, data.hub->R, t, reading) +
                                    calc_carried(subsystem.bodies[j], data, body, reading);
  return translate(-motion_at(body, reading.section).s, about_origin);
}

space::Twist BeamKind::calc_momentum(const Data& body, const space::Twist& twist) const noexcept {
  const FlexibleBody& beam = *body.model->body->flexible();
  space::Twist sum = space::Twist::Zero();
  for (std::size_t e = 0; e < beam.beam.size(); ++e) {
    const Slots places = find_slots(beam, e, body.coordinates.q, true);
    const Slots rates = move(places, find_slots(beam, e, body.coordinates.v, false), twist);
    sum += sum_moments(beam.beam[e].mass, places, rates);
  }
  if (beam.is_nonlinear()) {
    const space::ScratchRoom scratch(beam, body.work);
    space::expand(beam, body.coordinates.q, scratch->nodal[0]);
    angular(sum) -= calc_turned_inertia(beam, scratch->nodal[0]) * angular(twist);
  }
  return sum;
}

Angular BeamKind::calc_stiffening_momentum(const Data& body, const Angular& hub_w) const noexcept {
  const FlexibleBody& beam = *body.model->body->flexible();
  const space::ScratchRoom scratch(beam, body.work);
  space::expand(beam, body.coordinates.q, scratch->nodal[0]);
  space::expand(beam, body.coordinates.v, scratch->nodal[1]);
  std::fill_n(scratch->force, space::kTwist * beam.node_count(), 0.0);
  const space::StiffeningSums sums =
      add_stiffening(body_model_of(body), {Angular::Zero(), hub_w, space::Position::Zero()},
                     scratch->nodal[0], scratch->nodal[1], scratch->force);
  const space::HubStiffening stiffening =
      calc_hub_stiffening(*body.model->stiffening, space::Position::Zero(), sums);
  return stiffening.inertia.lazyProduct(hub_w);
}

}  // namespace spoke
