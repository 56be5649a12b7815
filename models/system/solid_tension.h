#pragma once

// Geometric stiffness of a solid by its place in the undeformed tree (docs/formulation.md, section
// 13).

#include <cstddef>
#include <memory>
#include <vector>

#include "models/space/joint.h"
#include "models/space/solid.h"
#include "models/space/tension_place.h"
#include "models/tree/mass_properties.h"

namespace spoke {

/// All that hangs at a place of a solid, about the centre of rotation, in B.
struct OutboardMass {
  std::size_t place = 0;
  double mass = 0.0;                                ///< [kg]
  space::Position first = space::Position::Zero();  ///< first moment [kg m]
  space::Matrix3 second = space::Matrix3::Zero();   ///< int r r^T dm [kg m^2]
  // What the joint hands on to the place: nothing along and about the axes of its free coordinates.
  space::Matrix3 of_force = space::Matrix3::Identity();
  space::Matrix3 of_moment = space::Matrix3::Identity();
};

/// Sets what a joint hands on; its offset leads from the handle that carries it.
void set_handed_on(const space::Joint& joint, OutboardMass& mass);

/// Makes it from mass properties in the description's frame of the hub. `to_axis` takes these to H,
/// in which `centre` is the centre of rotation, and `to_body` takes H to B.
OutboardMass make_outboard_mass(std::size_t place, const spatial::MassProperties& mass,
                                const space::Rotation& to_axis, const space::Position& centre,
                                const space::Rotation& to_body);

/// Combines the stiffness matrices of the stresses under unit loads. `origin`: origin of B from the
/// centre of rotation, in B [m].
std::shared_ptr<const space::SolidTension> make_solid_tension(
    const space::SolidConstants& constants, const space::Position& origin,
    const std::vector<OutboardMass>& outboard);

}  // namespace spoke
