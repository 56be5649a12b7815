#pragma once

// Types of the world that a model moves in, for the templates over it: `Plane` of plane.h.

namespace spoke {

template <class World>
using PositionOf = typename World::Position;
template <class World>
using AngularOf = typename World::Angular;
template <class World>
using TwistOf = typename World::Twist;
template <class World>
using TwistMatrixOf = typename World::TwistMatrix;
template <class World>
using RotationOf = typename World::Rotation;
template <class World>
using PoseOf = typename World::Pose;

}  // namespace spoke
