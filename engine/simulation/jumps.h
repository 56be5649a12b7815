#pragma once

// Motions that are prescribed - by the drive, in joints, of the mount - and that jump: what they
// change within a few steps, the steps see next to nothing of, and the energy of it comes from
// nowhere.

#include <string>
#include <vector>

#include "models/curve.h"
#include "models/scenario.h"

namespace spoke {

/// Steps that a change is to take at least.
inline constexpr double kLeastSteps = 4.0;

/// A change within less than kLeastSteps steps.
struct Jump {
  double time = 0.0;      ///< at which it begins [s]
  double duration = 0.0;  ///< [s]
  std::string source{};   ///< what jumps: kDriveSource, or the name of a joint or of the mount
  std::string text{};     ///< by how much: "the drive changes the speed by 4 rad/s"
};
inline constexpr const char* kDriveSource = "the drive";

/// All that a scenario prescribes, in order of time; of those at one time the drive's first.
std::vector<Jump> find_jumps(const Scenario& scenario, double step_size);

/// Of a drive from `begin` on up to `end` [s].
std::vector<Jump> find_drive_jumps(const Drive& drive, double begin, double end, double step_size);
/// Of a joint's coordinate, or another one, that follows a curve from `begin` on up to `end` [s].
/// `unit`: "rad" or "m"; `name`: in words.
std::vector<Jump> find_course_jumps(const Curve& course, const std::string& name,
                                    const std::string& unit, double begin, double end,
                                    double step_size);

/// Puts those of a motion that is replaced at time t [s] in the place of those to come.
void replace_jumps(const std::string& source, double t, std::vector<Jump> next,
                   std::vector<Jump>& jumps);

/// Of one that is just before time t [s], what jumps and what to do about it; empty: there is none.
std::string blame_jump(const std::vector<Jump>& jumps, double t, double step_size);

/// What to do about one.
std::string advise_on_jump(const Jump& jump, double step_size);

}  // namespace spoke
