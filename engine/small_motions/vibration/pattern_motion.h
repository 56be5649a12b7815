#pragma once

// What patterns of blades, or shafts, do in a mode that is seen from outside.

#include <string>

#include "engine/small_motions/vibration/mode_parts.h"
#include "engine/small_motions/vibration/multi_blade.h"

namespace spoke::vibration {

/// Rotors in the frame that stands, and what they were made from.
struct SeenFromOutside {
  const Linearised& all;
  const FixedFrame& frame;

  const BladeFamily& family_of(std::size_t pattern) const {
    return frame.families[frame.patterns[pattern].family];
  }
  double speed(std::size_t pattern) const { return family_of(pattern).speed; }
  std::size_t first_of(std::size_t pattern) const { return family_of(pattern).blades[0]; }
  bool is_shaft(std::size_t pattern) const { return family_of(pattern).is_shaft(); }
  /// Returns the motion of the first blade of a pattern that has these coordinates y, on a hub that
  /// stays where it is.
  SubsystemShape shape_of(std::size_t pattern, const Eigen::VectorXcd& y) const;
  /// Returns the mass matrix of the first blade of a pattern.
  Eigen::MatrixXd mass_of(std::size_t pattern) const {
    return family_of(pattern).take_first(all.linear.subsystem(first_of(pattern)).M);
  }
};

/// The motion of a pattern in a mode: that of a blade, y exp(i (w t + n psi_b)) as it turns along.
struct PatternMotion {
  Eigen::VectorXcd y;         ///< coordinates of a blade
  double mass = 0.0;          ///< of the whole pattern: x^H M x
  double rate = 0.0;          ///< w, not negative: the blade's own frequency [rad/s]
  int sense = 0;              ///< n by its magnitude; 0: all alike, next ones opposite, or standing
  bool is_conjugate = false;  ///< w is that of the conjugate motion
  std::string name;
};

/// Describes what a pattern does in a root of the frame. Of two senses that with more mass counts.
PatternMotion describe_pattern(std::size_t pattern, const Root& root, const SeenFromOutside& fixed);

/// Names the kind of this motion, after those that had its name before.
std::string name_kind(std::size_t pattern, const PatternMotion& motion,
                      const SeenFromOutside& fixed, KindNames& kinds);

}  // namespace spoke::vibration
