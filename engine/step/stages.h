#pragma once

// The stages of every pass, those of its nodes: the names by which traces, messages and predictions
// call them, and their roles. Actors (engine/bodies/act/) have stages besides.

#include <array>
#include <string_view>

#include "engine/bodies/table/stage.h"

namespace spoke::stages {

inline constexpr Stage kHubMotion{"hub motion", StageRole::given};
inline constexpr Stage kCoordinates{"coordinates", StageRole::given};
inline constexpr Stage kPosition{"position", StageRole::terms};
inline constexpr Stage kVelocity{"velocity", StageRole::terms};
inline constexpr Stage kAppliedForces{"applied forces", StageRole::terms};
inline constexpr Stage kFlightAcceleration{"flight acceleration", StageRole::system};
inline constexpr Stage kMass{"mass", StageRole::terms};
inline constexpr Stage kInverse{"inverse", StageRole::solution};
inline constexpr Stage kEffective{"effective", StageRole::solution};
inline constexpr Stage kLoopMotion{"loop motion", StageRole::solution};  ///< stages of closed loops
inline constexpr Stage kSharedLoopMotion{"shared loop motion",
                                         StageRole::system};  ///< between subsystems
inline constexpr Stage kLoopColumns{"loop columns", StageRole::solution};
inline constexpr Stage kLoopFactor{"loop factor", StageRole::solution};
inline constexpr Stage kLoopForces{"loop forces", StageRole::solution};
inline constexpr Stage kHubSolve{"hub solve", StageRole::system};
// Stages of a support, in place of hub motion, effective, hub solve and recovery; and the sum of
// what the rotor's subsystems add to its hub.
inline constexpr Stage kSupportMotion{"support motion", StageRole::system};
inline constexpr Stage kRotorSum{"rotor sum", StageRole::system};
inline constexpr Stage kSupportEffective{"support effective", StageRole::system};
inline constexpr Stage kSupportSolve{"support solve", StageRole::system};
inline constexpr Stage kSupportRecovery{"support recovery", StageRole::system};
inline constexpr Stage kSolve{"solve", StageRole::system};  ///< of the augmented formulation
inline constexpr Stage kMultipliers{"multipliers", StageRole::solution};
inline constexpr Stage kRecovery{"recovery", StageRole::solution};
inline constexpr Stage kFinish{"finish", StageRole::system};
inline constexpr Stage kSensors{"sensors", StageRole::system};
// Stages of the slices of a large solid, and the last of such a body.
inline constexpr Stage kMassTile{"mass tile", StageRole::terms};
inline constexpr Stage kForward{"forward", StageRole::solution};
inline constexpr Stage kBackward{"backward", StageRole::solution};
inline constexpr Stage kCompletion{"completion", StageRole::solution};
// Stages where subsystems are shared out over processes.
inline constexpr Stage kShareForces{"share forces", StageRole::system};
inline constexpr Stage kShareInertias{"share inertias", StageRole::system};
inline constexpr Stage kShareReports{"share reports", StageRole::system};

inline constexpr std::array kAll{kHubMotion,     kCoordinates,      kPosition,
                                 kVelocity,      kAppliedForces,    kFlightAcceleration,
                                 kMass,          kInverse,          kEffective,
                                 kLoopMotion,    kSharedLoopMotion, kLoopColumns,
                                 kLoopFactor,    kLoopForces,       kHubSolve,
                                 kSupportMotion, kRotorSum,         kSupportEffective,
                                 kSupportSolve,  kSupportRecovery,  kSolve,
                                 kMultipliers,   kRecovery,         kFinish,
                                 kSensors,       kMassTile,         kForward,
                                 kBackward,      kCompletion,       kShareForces,
                                 kShareInertias, kShareReports};

/// Returns the stage of this name; null: none of every pass.
constexpr const Stage* find(std::string_view name) {
  for (const Stage& stage : kAll)
    if (name == stage.name) return &stage;
  return nullptr;
}

}  // namespace spoke::stages
