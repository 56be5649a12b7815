// What a pass asks a beam.

#include <optional>

#include "engine/bodies/kernels/space/table_terms.h"
#include "engine/bodies/kinds/beam/beam_kind.h"
#include "engine/bodies/kinds/beam/body_terms.h"
#include "engine/bodies/kinds/beam/condense_body.h"

namespace spoke {
namespace {

const space::FlexibleBody& beam_of(const BodyData<Space>& body) {
  return *body.model->body->flexible();
}

/// Adds a wrench in B on a section, and its power.
void add_beam_wrench(const space::Section& section, const space::HandleMotion& motion,
                     const space::Twist& wrench, const space::Twist& twist, BodyData<Space>& body) {
  add_section_wrench(section, motion, wrench, body.terms, body.work);
  body.terms.load_power += calc_wrench_power(wrench, motion, twist);
}

/// Adds the forces on the bodies that a body carries to its tension; `turn`: from the hub's frame.
void add_carried_forces(const TreeBody<Space>& model, const SubsystemData<Space>& data,
                        const space::Rotation& turn, space::AppliedTension& tension) {
  const space::FlexibleBody& beam = *model.body->flexible();
  for (std::size_t h = 1; h <= model.children.size(); ++h)
    tension.add_at_node(
        beam.handles[h],
        turn * data.applied_forces[static_cast<std::size_t>(model.children[h - 1])]);
}

/// Returns a load of the scenario at time t [s].
space::LoadInstant find_instant(const BodyLoad<Space>& load, double t, const space::Rotation& R_HB,
                                const space::Rotation& R_0) {
  const space::Twist wrench = make_wrench(load.force, load.moment);
  const double size = load.course->value(t);
  if (load.frame == spatial::LoadFrame::section) return {true, size * wrench};
  return {false, size * (resolve_load(load.frame, R_HB, R_0, {}) * wrench)};
}

}  // namespace

void BeamKind::follow_state(const HubState<Space>& hub, Data& body) const noexcept {
  if (body.strain) follow_strain(beam_of(body), body.coordinates.q, body.work, *body.strain);
  if (body.tension)
    follow_speed(beam_of(body), *body.model->stiffening, angular(hub.twist), *body.tension);
}

void BeamKind::keep_state(Data& body) const noexcept {
  if (body.strain) keep_wrenches(beam_of(body), body.coordinates.q, *body.strain);
}

void BeamKind::calc_terms(const System<Space>& system, double t,
                          const space::ImplicitShares& shares, std::size_t j,
                          SubsystemData<Space>& data) const noexcept {
  Data& body = data.bodies[j];
  body.terms = calc_body_terms(body_model_of(body), body_state_of(body),
                               body_motion_of(system, t, j, data), system.damping, body.work);
  if (shares.stiffness == 0.0) return;
  if (has_implicit_tension(body))
    add_implicit_tension(beam_of(body), *body.tension, body.coordinates.a, body.alpha, body.work,
                         body.terms);
  if (body.strain)
    add_implicit_strain(beam_of(body), *body.strain, body.coordinates.a, body.alpha, body.work,
                        body.terms);
}

void BeamKind::add_applied(double t, const space::Rotation& R_HB, std::size_t j,
                           SubsystemData<Space>& data) const noexcept {
  Data& body = data.bodies[j];
  const TreeBody<Space>& model = *body.model;
  const space::Twist& twist = data.twists[j];
  std::optional<space::AppliedTension> tension;
  space::Rotation to_undeformed;
  if (has_applied_tension(body)) {
    to_undeformed = model.stiffening->R_HB.inverse();
    tension.emplace(body_model_of(body), body_state_of(body), body.work);
    if (body.forces.carried) add_carried_forces(model, data, to_undeformed, *tension);
  }
  const space::Rotation turn = to_undeformed * R_HB;
  for (const auto& [section, wrench, motion] : body.applied) {
    const space::Twist applied = make_wrench(wrench->force, wrench->moment);
    add_beam_wrench(*section, motion ? *motion : motion_at(body, *section), applied, twist, body);
    if (tension) tension->add_at(*section, turn * wrench->force);
  }
  for (const auto& placed : body.loads)
    add_load(beam_of(body), placed.sections, find_instant(*placed.load, t, R_HB, data.hub->R),
             body_state_of(body), twist, tension ? &*tension : nullptr, turn, body.terms,
             body.work);
  if (tension)
    add_hub_moment(model.stiffening->R_HB * tension->add_to(body.terms), *data.hub, body.terms);
}

void BeamKind::add_forces(double factor, const double* forces, Data& body) const noexcept {
  const space::FlexibleBody& beam = beam_of(body);
  for (int node = beam.first_node(); node < beam.node_count(); ++node)
    for (int c = 0; c < space::kTwist; ++c)
      if (const int k = beam.coordinate(node, c); k >= 0)
        body.work.rows[space::kNodeRows * node + 4 * c + 3] += factor * forces[k];
}

space::Position BeamKind::sum_loads(double t, const space::Rotation& R_HB,
                                    const space::Rotation& R_0, const Data& body) const noexcept {
  space::Position sum = space::Position::Zero();
  for (const auto& placed : body.loads)
    sum += sum_load_forces(beam_of(body), placed.sections, find_instant(*placed.load, t, R_HB, R_0),
                           body.coordinates.q);
  return sum;
}

space::Position BeamKind::calc_linear_momentum(const Data& body,
                                               const space::Twist& twist) const noexcept {
  return calc_deformed_momentum(body, twist);
}

void BeamKind::condense(const space::Twist& twist, bool implicit,
                        const structured::BodyWork<Space>&, Data& body) const noexcept {
  space::condense_body(body_model_of(body), body.terms, angular(twist), implicit, body.work);
}

void BeamKind::recover(const structured::BodyWork<Space>&, bool implicit, Data& body,
                       double* a) const noexcept {
  body.X = space::recover_body(body_model_of(body), body.work.wrenches, implicit, body.work, a);
}

}  // namespace spoke
