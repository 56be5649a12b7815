#pragma once

// Jumps of prescribed motions: of the drive, of joints, of the mount, of anchors. A motion jumps if
// it changes within a few steps. The steps hardly see such a change, and its energy comes from
// nowhere.

#include <string>
#include <string_view>
#include <vector>

#include "models/curve.h"
#include "models/scenario.h"

namespace spoke {

/// Least number of steps that a change should take.
inline constexpr double kLeastSteps = 4.0;

/// A change within less than kLeastSteps steps.
struct Jump {
  double time = 0.0;      ///< at which it begins [s]
  double duration = 0.0;  ///< [s]
  std::string
      source{};  ///< describe_drive(), or the name of the joint, the mount or the anchor that jumps
  std::string text{};  ///< with its size: "the drive changes the speed by 4 rad/s"
};
/// Returns the drive of a rotor in words: "the drive", of a further one "the drive of "tail"".
std::string describe_drive(const Scenario& scenario, int rotor);

/// Returns the jumps of all motions that a scenario prescribes, in order of time; at equal times
/// those of drives come first.
std::vector<Jump> find_jumps(const Scenario& scenario, double step_size);

/// Returns the jumps of a drive, which describe_drive() names, between `begin` and `end` [s].
std::vector<Jump> find_drive_jumps(const Drive& drive, const std::string& name, double begin,
                                   double end, double step_size);
/// Returns the jumps of a coordinate that follows a curve, between `begin` and `end` [s]. `unit`:
/// "rad" or "m"; `name`: the coordinate in words.
std::vector<Jump> find_course_jumps(const Curve& course, const std::string& name,
                                    const std::string& unit, double begin, double end,
                                    double step_size);

/// Returns the jumps of the anchor of that name if it moves so, between `begin` and `end` [s].
std::vector<Jump> find_anchor_jumps(std::string_view name, const spatial::MountMotion& motion,
                                    double begin, double end, double step_size);

/// Replaces the jumps of a source after time t [s], where its motion is replaced, by `next`.
void replace_jumps(const std::string& source, double t, std::vector<Jump> next,
                   std::vector<Jump>& jumps);

/// Returns a sentence about a jump just before time t [s] and what to do about it; empty if there
/// is none.
std::string blame_jump(const std::vector<Jump>& jumps, double t, double step_size);

/// Returns what to do about a jump.
std::string advise_on_jump(const Jump& jump, double step_size);

}  // namespace spoke
