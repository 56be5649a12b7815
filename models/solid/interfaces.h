#pragma once

// Steps of make_geometry() that do not depend on where mass and nodes come from.

#include <string>

#include "models/solid/solid.h"

namespace spoke::solid {

/// Throws InputError with a key within the body.
[[noreturn]] void refuse_field(const std::string& key, const std::string& what);
/// Returns a number for messages.
std::string show_number(double value);

/// Throws InputError, its place().key "scale.length", unless the scale is a positive number.
void check_length_scale(double length_scale);

/// Finds the nodes of all interfaces of a body on geometry.mesh. Throws InputError with the key
/// within the body.
void find_interfaces(const spatial::SolidBody& body, SolidGeometry& geometry);

/// Turns moments about a point of the mesh, by default its origin, into those about the first
/// interface.
void move_moments_to_first(SolidGeometry& geometry,
                           const spatial::Vector& about = spatial::Vector::Zero());

}  // namespace spoke::solid
