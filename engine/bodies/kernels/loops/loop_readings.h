#pragma once

// What sensors and queries show of a closed loop, in vectors of space. Rotations, twists and
// `loops.poses` must be those of the state at time t [s] (see update_loops()); multipliers those
// of its evaluation.

#include <span>

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// A vector of a loop, and the axes in which it may be resolved.
struct LoopVector {
  space::Twist in_hub = space::Twist::Zero();  ///< in H
  /// In the frame `loop` of sensors: along the axes of the place `to`. Of a loop of kind
  /// `distance`, x is the tension or the elongation, and all others are 0.
  space::Twist in_loop = space::Twist::Zero();
};

/// Returns the wrench of loop `k` of subsystem `i` on its place `from`, about it [N, N m], by the
/// multipliers of all rows of the subsystem.
template <class World>
LoopVector calc_loop_reaction(const System<World>& system, std::size_t i, std::size_t k, double t,
                              const StepData<World>& data,
                              std::span<const double> multipliers) noexcept;

/// Returns the opening of the loop: displacement and small rotation of `from` from where the
/// closure wants it, along the directions that it locks [m, rad].
template <class World>
LoopVector calc_loop_opening(const System<World>& system, std::size_t i, std::size_t k, double t,
                             const StepData<World>& data) noexcept;

/// Returns the reaction, by the multipliers at the end of the last step, or the opening that a
/// sensor of a loop asks for.
template <class World>
LoopVector calc_loop_reading(const System<World>& system, std::size_t i, double t,
                             const Reading<World>& asked, const StepData<World>& data) noexcept {
  const LoopData<World>& loops = data.subsystems[i].loops;
  return asked.quantity == SensorQuantity::loop_reaction
             ? calc_loop_reaction(system, i, asked.loop, t, data, loops.kept_multipliers)
             : calc_loop_opening(system, i, asked.loop, t, data);
}

}  // namespace spoke
