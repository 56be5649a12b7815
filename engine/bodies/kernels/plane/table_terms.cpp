// Hands the table's data to the kernels of planar bodies.

#include "engine/bodies/kernels/plane/table_terms.h"

#include <algorithm>
#include <optional>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/plane/applied_tension.h"
#include "engine/bodies/kernels/plane/body_terms.h"
#include "engine/bodies/kernels/plane/section_loads.h"

namespace spoke {
namespace {

/// Adds all that is applied to body `j`, its tension, and that of the forces beyond.
void add_all_applied(double t, const plane::Rotation& root, int j,
                     SubsystemData<Plane>& data) noexcept {
  const Twist& twist = data.twists[j];
  BodyData<Plane>& body = data.bodies[j];
  if (!body.forces) return;
  const bool has_tension = body.model->stiffening.centrifugal != nullptr;
  plane::Rotation R_HB;
  if (!body.loads.empty() || (has_tension && body.forces.applied))
    R_HB = calc_rotation_to_hub(data, j);
  std::optional<plane::AppliedTension> tension;
  const plane::Rotation to_root = root.inverse();
  if (has_tension) tension.emplace(to_root * R_HB, body);
  plane::AppliedTension* const taker = tension ? &*tension : nullptr;
  if (!body.loads.empty()) add_loads(t, R_HB, data.hub->R, twist, body, taker);
  if (!body.drags.empty()) add_drags(t, j, data, taker);
  if (!body.applied.empty()) add_applied(twist, body, taker);
  if (!tension) return;
  if (body.forces.carried)
    for (const int child : body.model->children)
      tension->add_beyond(to_root * data.applied_forces[static_cast<std::size_t>(child)]);
  tension->finish(data.hub->twist[kRotation]);
}

/// Adds the power of gravity that rises, and the tension of the field that all masses feel.
void add_fields(const System<Plane>& system, const plane::Rotation& root, double t, int j,
                SubsystemData<Plane>& data) noexcept {
  const Twist& twist = data.twists[j];
  BodyData<Plane>& body = data.bodies[j];
  const bool has_rising_gravity = system.gravity_ramp > 0.0;
  if (has_rising_gravity) {
    const auto R = data.hub->R * calc_rotation_to_hub(data, j);
    add_gravity_power(R.inverse() * system.gravity_at(t), twist, body);
  }
  if (!body.model->stiffening.outboard_mass) return;
  const double power =
      add_field_tension(root.inverse() * plane::calc_tension_field(system, t, data),
                        data.hub->twist[kRotation], body);
  // The power of gravity that does not rise is the rate of a potential, see calc_sample().
  if (has_rising_gravity || system.hub.support == HubSupport::free) body.terms.load_power += power;
}

}  // namespace

void calc_terms(const System<Plane>& system, const Subsystem<Plane>& subsystem, double t, int j,
                SubsystemData<Plane>& data) noexcept {
  const plane::Rotation& root = subsystem.root.R;
  calc_body_terms({angular(data.twists[j]), angular(data.hub->twist)}, system.damping,
                  data.bodies[j]);
  add_all_applied(t, root, j, data);
  add_fields(system, root, t, j, data);
}

PartList parts_of_terms(const System<Plane>& system, std::size_t i, std::size_t j,
                        bool has_implicit, const StepData<Plane>& table) {
  const SubsystemData<Plane>& data = table.subsystems[i];
  const BodyData<Plane>& body = data.bodies[j];
  const SubsystemParts& parts = data.parts;
  const std::vector<BodyLoad<Plane>>& loads = body.model->loads;
  const std::vector<BodyDrag<Plane>>& drags = body.model->drags;
  const auto any_load_in = [&loads](LoadFrame frame) {
    return std::any_of(loads.begin(), loads.end(),
                       [frame](const BodyLoad<Plane>& load) { return load.frame == frame; });
  };
  const bool has_tension = static_cast<bool>(body.model->stiffening);
  const bool has_rising_gravity = system.gravity_ramp > 0.0;
  const bool follows_hub = std::any_of(drags.begin(), drags.end(), [](const BodyDrag<Plane>& drag) {
    return drag.relative_to == DragFrame::hub;
  });
  PartList list = loads_on(i, j, table);
  graph::add_to(list, parts.bodies[j].coordinates, parts.twists);
  if (has_implicit && !has_nonlinear_strain(body))  // q_elastic and v_elastic, if not q and v
    list.push_back(parts.bodies[j].history);
  if (has_tension && body.forces.carried) list.push_back(parts.applied_forces);
  if (has_tension && data.flight_acceleration) list.push_back(table.parts.flight_acceleration);
  if (follows_hub) list.push_back(parts.drag_poses);
  if (has_rising_gravity || (has_tension && body.forces.applied) || any_load_in(LoadFrame::hub) ||
      any_load_in(LoadFrame::inertial))
    list.push_back(parts.rotations);
  // The tension may stand on either side of the equations.
  if (has_rising_gravity || has_tension || follows_hub || any_load_in(LoadFrame::inertial))
    list.push_back(parts.hub_state);
  return list;
}

}  // namespace spoke
