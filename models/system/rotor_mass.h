#pragma once

// Masses of rotors as what carries them feels them, and the mass centre of a machine that flies.

#include <vector>

#include "models/space/space.h"
#include "models/system/spatial_subsystem.h"
#include "models/tree/tree.h"

namespace spoke {

/// Returns the rotation from the hub's frame H, whose z axis is that of the drive, to the hub's
/// frame in the description.
inline space::Rotation axis_rotation(const spatial::Hub& hub) {
  return {spatial::rotor_placement(hub).rotation};
}

/// Returns what trees have to know of the rotors that they carry, by number: hub and blades, and
/// the rotors that these carry. Precondition: the model has a support, whose tree is the last.
std::vector<CarriedRotor> list_carried(const spatial::Model& model,
                                       const std::vector<spatial::Tree>& trees);

/// The mass centre of a machine that flies, undeformed and with joint coordinates zero [m].
struct MachineCentre {
  space::Position from_base = space::Position::Zero();
  /// By rotor, from its hub in H; zero where the hub does not move as the base does.
  std::vector<space::Position> from_hubs{};
};
/// Finds it; zero where nothing flies.
MachineCentre find_machine_centre(const spatial::Model& model,
                                  const std::vector<spatial::Tree>& trees);

}  // namespace spoke
