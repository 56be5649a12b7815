#pragma once

// Random models in space as a user describes them.

#include <random>

#include "models/spatial_model.h"

namespace spoke::spatial::testing {

/// Motion of a random model's hub.
enum class RandomHub {
  fixed,   ///< nothing
  driven,  ///< a spin-up
  torque,  ///< a constant torque, kRandomTorque
  free     ///< it flies
};

/// The constant torque on a hub that one turns [N m].
inline constexpr double kRandomTorque = 0.8;

/// Subsystems of several trees on the hub, of rigid bodies and beams in both frames, and one that
/// often has no coordinates at all; joints of all kinds, sprung, damped, with motors, or of
/// prescribed motion; gravity, and loads in all frames. Soft enough for steps of 0.1 ms.
Model make_random_model(RandomHub hub, std::mt19937& random);

/// Rotors with forests on a body of a support, each further one on the support or on a body of what
/// one before it carries; springs between bodies of different subsystems; gravity and loads. The
/// support flies, or hangs by a joint of any kind on the ground.
Model make_random_levels(bool flies, std::mt19937& random);

/// Returns the model without gravity and loads. Nothing else acts from outside, but for the torque
/// on a hub that one turns.
Model without_loads(Model model);

}  // namespace spoke::spatial::testing
