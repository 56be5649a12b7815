// Hands the table's data to the kernels of planar bodies.

#include "engine/bodies/kernels/plane/table_terms.h"

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

}  // namespace spoke
