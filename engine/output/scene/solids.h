#pragma once

// Solids in scenes: rigid bodies and the hub.

#include "engine/output/scene/scene.h"

namespace spoke::scene {

/// Returns a disc of steel about z, as thick as its radius, by its moment of inertia [kg m^2].
Solid make_disc(double inertia);

/// Makes the box with this mass and inertia [kg, kg m^2] about its centre, its axes the principal
/// ones; the cylinder if two principal moments are equal.
Solid make_body(const Vector& center, double mass, const spatial::Tensor& inertia);

/// Makes a cylinder about an axis through the origin [m].
Solid make_cylinder(const Vector& axis, double radius, double half_height);

/// Moves a solid: a vertex v goes to p + R v.
void place(const Vector& p, const spatial::Tensor& R, Solid& solid);

}  // namespace spoke::scene
