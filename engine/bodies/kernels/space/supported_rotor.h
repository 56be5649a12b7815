#pragma once

// A rotor on a support: its hub is a body of the support's tree, from which the rotor's subsystems
// have the hub's motion, and to which they hand what the hub feels of them, (P 10). The support is
// eliminated towards its base with that, as any tree is (docs/formulation.md, section 14).

#include <cstddef>

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Sets the motion of a rotor's hub from the support's tree, whose rotations and twists must be
/// set. `t` [s]; the hub's acceleration is that of the last iterate, and is set only in implicit
/// passes, `is_implicit`, and of hubs that move as prescribed.
inline void place_rotor(const System<Plane>&, std::size_t, double, bool,
                        StepData<Plane>&) noexcept {}
void place_rotor(const System<Space>& system, std::size_t rotor, double t, bool is_implicit,
                 StepData<Space>& data) noexcept;
/// Return the parts that it depends on; `has_implicit`: whether any pass is implicit.
inline PartList parts_of_rotor_place(const System<Plane>&, std::size_t, bool,
                                     const StepData<Plane>&) {
  return {};
}
PartList parts_of_rotor_place(const System<Space>& system, std::size_t rotor, bool has_implicit,
                              const StepData<Space>& data);

/// Sums what the subsystems of a rotor add to its hub: M_0 + sum M^C and sum Q^C, with the terms of
/// their stiffening by rotation. `is_condensed`: whether they are condensed; else, in the augmented
/// formulation, only the terms of stiffening count.
inline void sum_rotor(const System<Plane>&, std::size_t, bool, StepData<Plane>&) noexcept {}
void sum_rotor(const System<Space>& system, std::size_t rotor, bool is_condensed,
               StepData<Space>& data) noexcept;
/// Return the parts that it depends on.
inline PartList parts_of_rotor_sum(std::size_t, bool, const StepData<Plane>&) { return {}; }
PartList parts_of_rotor_sum(std::size_t rotor, bool is_condensed, const StepData<Space>& data);

/// Follows the state once more after the last correction of a step: the trees of supports, and the
/// hubs on them, at time t [s].
inline void update_rotors(const System<Plane>&, double, StepData<Plane>&) noexcept {}
void update_rotors(const System<Space>& system, double t, StepData<Space>& data) noexcept;

/// Returns the hub that is shown as that of the model: of the first rotor on a support, if there is
/// one. Precondition: the table is coupled, or the caller has set data.hub.
const HubState<Space>& shown_hub(const StepData<Space>& data) noexcept;

/// Records the motion of the hubs of rotors on supports, the wrench of each one's axle on it and
/// the torque of its drive at the end of step `step`, at time t [s].
inline void record_rotors(const System<Plane>&, double, std::int64_t, StepData<Plane>&) noexcept {}
void record_rotors(const System<Space>& system, double t, std::int64_t step,
                   StepData<Space>& data) noexcept;

}  // namespace spoke
