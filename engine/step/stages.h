#pragma once

// Names of the stages of a step, those of its graph's nodes, as traces, messages and predictions
// call them.

namespace spoke::stages {

inline constexpr const char* kControl = "control";
inline constexpr const char* kHubMotion = "hub motion";
inline constexpr const char* kCoordinates = "coordinates";
inline constexpr const char* kPosition = "position";
inline constexpr const char* kVelocity = "velocity";
inline constexpr const char* kLoad = "load";  ///< the user's loads
inline constexpr const char* kAir = "air";
inline constexpr const char* kAppliedForces = "applied forces";
inline constexpr const char* kFlightAcceleration = "flight acceleration";
inline constexpr const char* kMass = "mass";
inline constexpr const char* kInverse = "inverse";
inline constexpr const char* kEffective = "effective";
inline constexpr const char* kLoopMotion = "loop motion";  ///< stages of closed loops
inline constexpr const char* kLoopColumns = "loop columns";
inline constexpr const char* kLoopFactor = "loop factor";
inline constexpr const char* kLoopForces = "loop forces";
inline constexpr const char* kHubSolve = "hub solve";
// Stages of a support, in place of hub motion, effective, hub solve and recovery; and the sum of
// what the rotor's subsystems add to its hub.
inline constexpr const char* kSupportMotion = "support motion";
inline constexpr const char* kRotorSum = "rotor sum";
inline constexpr const char* kSupportEffective = "support effective";
inline constexpr const char* kSupportSolve = "support solve";
inline constexpr const char* kSupportRecovery = "support recovery";
inline constexpr const char* kSolve = "solve";  ///< of the augmented formulation
inline constexpr const char* kMultipliers = "multipliers";
inline constexpr const char* kRecovery = "recovery";
inline constexpr const char* kFinish = "finish";
inline constexpr const char* kSensors = "sensors";
// Stages of the slices of a large solid, and the last of such a body.
inline constexpr const char* kMassTile = "mass tile";
inline constexpr const char* kForward = "forward";
inline constexpr const char* kBackward = "backward";
inline constexpr const char* kCompletion = "completion";
// Stages where subsystems are shared out over processes.
inline constexpr const char* kShareForces = "share forces";
inline constexpr const char* kShareInertias = "share inertias";
inline constexpr const char* kShareReports = "share reports";

}  // namespace spoke::stages
