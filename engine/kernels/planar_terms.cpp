// Hands the table's data to the kernels of planar bodies.

#include "engine/kernels/planar_terms.h"

#include <optional>

#include "engine/kernels/axial_tension.h"
#include "engine/kernels/blade_loads.h"
#include "engine/kernels/body_terms.h"
#include "engine/kernels/kinematics.h"
#include "engine/kernels/load_terms.h"

namespace spoke {
namespace {

/// Adds all that is applied to body `j`, and the tension of it and of what is applied beyond.
void add_all_applied(double t, const Rotation& root, int j, SubsystemData<Plane>& blade) noexcept {
  const Twist& twist = blade.twists[j];
  BodyData<Plane>& body = blade.bodies[j];
  if (!body.forces) return;
  const bool has_tension = body.model->stiffening.centrifugal != nullptr;
  Rotation R_HB;
  if (!body.loads.empty() || (has_tension && body.forces.applied))
    R_HB = calc_rotation_to_hub(blade, j);
  std::optional<AppliedTension> tension;
  const Rotation to_blade = root.inverse();
  if (has_tension) tension.emplace(to_blade * R_HB, body);
  AppliedTension* const taker = tension ? &*tension : nullptr;
  if (!body.loads.empty()) add_loads(t, R_HB, blade.hub->R, twist, body, taker);
  if (!body.drags.empty()) add_drags(t, j, blade, taker);
  if (!body.applied.empty()) add_applied(twist, body, taker);
  if (!tension) return;
  if (body.forces.carried)
    for (const int child : body.model->children)
      tension->add_beyond(to_blade * blade.applied_forces[static_cast<std::size_t>(child)]);
  tension->finish(blade.hub->twist[kRotation]);
}

/// Adds the power of gravity that rises, and the tension of the field that all masses feel.
void add_fields(const System<Plane>& system, const Rotation& root, double t, int j,
                SubsystemData<Plane>& blade) noexcept {
  const Twist& twist = blade.twists[j];
  BodyData<Plane>& body = blade.bodies[j];
  const bool has_rising_gravity = system.gravity_ramp > 0.0;
  if (has_rising_gravity) {
    const auto R = blade.hub->R * calc_rotation_to_hub(blade, j);
    add_gravity_power(R.inverse() * system.gravity_at(t), twist, body);
  }
  if (!body.model->stiffening.outboard_mass) return;
  const double power = add_field_tension(root.inverse() * calc_tension_field(system, t, blade),
                                         blade.hub->twist[kRotation], body);
  // Of gravity that does not rise it is the rate of a potential, see calc_sample().
  if (has_rising_gravity || system.hub.support == HubSupport::free) body.terms.load_power += power;
}

}  // namespace

void calc_terms(const System<Plane>& system, const Subsystem<Plane>& subsystem, double t, int j,
                SubsystemData<Plane>& data) noexcept {
  const Rotation& root = subsystem.root.R;
  calc_body_terms({angular(data.twists[j]), angular(data.hub->twist)}, system.damping,
                  data.bodies[j]);
  add_all_applied(t, root, j, data);
  add_fields(system, root, t, j, data);
}

}  // namespace spoke
