#pragma once

// Makes the constants that the engine works on out of the description of a model in space.

#include <cassert>

#include "models/space/body.h"
#include "models/space/hub.h"
#include "models/space/space.h"
#include "models/space/tension_place.h"
#include "models/space/tree_joint.h"
#include "models/spatial_model.h"
#include "models/system/system.h"
#include "models/tree/tree.h"

namespace spoke {

/// Builds the constants of a model; equal beams share them, and the trees are those of
/// build_trees(). Preconditions: check_model() accepts it; each subsystem has one body on the hub.
/// Throws InputError where a joint follows the azimuth of a hub that is free in space.
/// `control`: of solids, whose constants may take seconds.
System<Space> make_system(const spatial::Model& model, const std::vector<spatial::Tree>& trees,
                          const solid::Control& control = {});
System<Space> make_system(const spatial::Model& model);

/// A body in the place of a rotor at its hub: its mass centre is the hub's origin.
struct Ballast {
  double mass = 1.0;     ///< [kg]
  double inertia = 1.0;  ///< about all axes [kg m^2]
};

/// Builds the constants of the support of a model alone, as one subsystem on its base: `ballasts`
/// are its hubs by rotor, and its axles do not turn. Nothing of the rotors acts on it. `trees`:
/// those of build_trees() of the model.
System<Space> make_support_alone(const spatial::Model& model,
                                 const std::vector<spatial::Tree>& trees,
                                 const std::vector<Ballast>& ballasts,
                                 const solid::Control& control = {});

/// Returns the bodies of a support from its base to the hub of a rotor.
std::vector<int> find_path(const System<Space>& system, const SupportedRotor& rotor);

/// Returns the drive: of the hub, or of a rotor's axle on a support.
Drive& drive_of(System<Space>& system, int rotor = 0);
const Drive& drive_of(const System<Space>& system, int rotor = 0);
/// Returns whether that drive prescribes the rotation of the rotor's hub: none behind a drive train
/// does.
bool is_hub_prescribed(const System<Space>& system, int rotor = 0);
inline Drive& drive_of(System<Plane>& system, [[maybe_unused]] int rotor = 0) {
  assert(rotor == 0);
  return system.hub.drive;
}

}  // namespace spoke
