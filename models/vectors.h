#pragma once

// Sizes and vectors of the plane.

#include <Eigen/Core>

namespace spoke {

/// Components of a position: x, y.
inline constexpr int kPosition = 2;
/// Components of a twist: velocity (x, y) and angular velocity. Also the coordinates of a node.
inline constexpr int kTwist = 3;
/// Index of the (last) rotational component of a twist.
inline constexpr int kRotation = 2;

// Unaligned, so that structures of these hold nothing but doubles side by side (no padding): the
// step graph's declaration check compares their memory.
/// Two components of a vector [m, N, ...].
using Position = Eigen::Matrix<double, kPosition, 1, Eigen::DontAlign>;
/// A velocity and an angular velocity, or a force and a moment.
using Twist = Eigen::Matrix<double, kTwist, 1>;
/// A linear map of twists.
using TwistMatrix = Eigen::Matrix<double, kTwist, kTwist>;

}  // namespace spoke
