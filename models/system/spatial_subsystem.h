#pragma once

// Makes one subsystem in space, with its constants, out of its tree.

#include <vector>

#include "models/drive.h"
#include "models/system/shared_bodies.h"
#include "models/system/system.h"
#include "models/tree/tree.h"

namespace spoke {

/// A rotor that a tree may carry.
struct CarriedRotor {
  spatial::MassProperties mass{};  ///< with its blades, in its hub's frame H
  Drive drive = FreeDrive{};
};

/// What carries a subsystem, and what it carries itself.
struct SubsystemSetting {
  /// From the frame of the description's hub to H, whose z axis is that of the drive.
  space::Rotation to_axis{};
  /// Point about which the undeformed model turns freely, in H [m].
  space::Position centre = space::Position::Zero();
  std::vector<CarriedRotor> rotors{};  ///< by number, those of the model, if it has a support
  /// Of a support, whether its hub is an ordinary body, and its axle held.
  bool is_alone = false;
  spatial::RigidBody base{};  ///< of a support, the fuselage that it stands on, if there is one
};

/// Makes the subsystem of a tree; equal beams and solids are shared with those made before.
/// `loads`: by body, as the description resolves them.
Subsystem<Space> make_subsystem(const spatial::Tree& tree, const SubsystemSetting& setting,
                                std::vector<std::vector<BodyLoad<Space>>> loads,
                                SharedBodies& bodies);

}  // namespace spoke
