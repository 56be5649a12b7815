#pragma once

// Ranges of numbers that several keys have.

#include "models/support/quantity.h"

namespace spoke {

// Sizes beyond these are slips of the keyboard, not machines anybody simulates; below them
// the engine still compares its need with the memory there is.
inline constexpr int kMostOfAKind = 100'000;
inline constexpr int kMostIterations = 1000;

inline constexpr Quantity kGravity = Quantity::any("m/s^2");
inline constexpr Quantity kForce = Quantity::any("N");
inline constexpr Quantity kFactor = Quantity::any("");
inline constexpr Quantity kTime = Quantity::any("s");
inline constexpr Quantity kSpeed = Quantity::any("rad/s");
inline constexpr Quantity kTorque = Quantity::any("N m");
inline constexpr Quantity kForcePerLength = Quantity::any("N/m");
inline constexpr Quantity kLength = Quantity::any("m");
inline constexpr Quantity kRamp = Quantity::not_negative("s");
inline constexpr Quantity kStation = Quantity::not_negative("m");

/// Slopes of materials lie between 3 and some 20.
inline constexpr Quantity kExponent = Quantity::between(1.0, 100.0);
inline constexpr Quantity kFactorOfStiffness = Quantity::not_negative("s");
/// A greater ratio is no vibration; below it the iteration of implicit steps contracts.
inline constexpr Quantity kDampingRatioOfBeams{"", 0.0, 1.0, true, false};

}  // namespace spoke

namespace spoke::spatial {

inline constexpr Quantity kAngle = Quantity::any("rad");
inline constexpr Quantity kInertia = Quantity::any("kg m^2");
inline constexpr Quantity kDirection = Quantity::any("");
inline constexpr Quantity kVelocity = Quantity::any("m/s");
inline constexpr Quantity kMoment = Quantity::any("N m");
inline constexpr Quantity kMomentPerLength = Quantity::any("N");

// Of joints, whose coordinates are angles or ways.
inline constexpr Quantity kJointPosition = Quantity::any("rad, m");
inline constexpr Quantity kJointSpeed = Quantity::any("rad/s, m/s");
inline constexpr Quantity kJointStiffness = Quantity::not_negative("N m/rad, N/m");
inline constexpr Quantity kJointDamping = Quantity::not_negative("N m s/rad, N s/m");

// Of solids.
inline constexpr Quantity kTraction = Quantity::any("Pa");
inline constexpr Quantity kFrequency = Quantity::positive("Hz");
inline constexpr Quantity kDampingRatio = Quantity::not_negative("");
inline constexpr Quantity kLengthScale = Quantity::positive("");
inline constexpr Count kModes{0, 10'000};

// Of aerofoils.
inline constexpr Quantity kReynolds = Quantity::not_negative("");
inline constexpr Quantity kMach = Quantity::not_negative("");
inline constexpr Quantity kCoefficient = Quantity::any("");

}  // namespace spoke::spatial
