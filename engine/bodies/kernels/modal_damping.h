#pragma once

// Damping of beams by their modes (docs/formulation.md, section 10): forces -w f_k (w.q') on the
// coordinates of all bodies of a beam, f_k and w of models/system/beam_modes.h. They are small
// beside the stiffness, and the iteration of implicit steps follows them.

#include <vector>

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Sets SubsystemData::modal_forces from the velocities of all bodies.
template <class World>
void calc_modal_forces(const Subsystem<World>& subsystem, SubsystemData<World>& data) noexcept;
/// Returns the parts that they depend on; none where no mode damps a beam.
template <class World>
PartList parts_of_modal_forces(const SubsystemData<World>& data) {
  return data.modal_forces.empty() ? PartList{} : data.parts.all(&BodyParts::coordinates);
}

/// Adds what they do to the right-hand side of a body, whose terms are set, and to its dissipation.
template <class World>
void add_modal_damping(const ArenaVector<double>& modal_forces, BodyData<World>& body) noexcept;
/// Returns the parts that it depends on besides the velocities of body `j`.
template <class World>
PartList parts_of_modal_damping(std::size_t j, const SubsystemData<World>& data) {
  return data.bodies[j].model->modal.is_empty() ? PartList{} : PartList{data.parts.modal_forces};
}

/// Returns the deformation (flex vector) of which the elastic forces are those of the damping by
/// modes at the velocities in the table; empty if the body has none.
template <class World>
std::vector<double> calc_modal_deformation(const Subsystem<World>& subsystem,
                                           const SubsystemData<World>& data,
                                           const BodyData<World>& body);

}  // namespace spoke
