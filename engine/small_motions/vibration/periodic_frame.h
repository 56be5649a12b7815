#pragma once

// The frames in which the matrices of a model have one period: rotors that turn with it are seen
// from their hubs, those that turn at other speeds from outside.

#include <cstddef>
#include <vector>

#include "engine/small_motions/vibration/multi_blade.h"
#include "engine/small_motions/vibration/pattern_motion.h"
#include "engine/small_motions/vibration/periodic_system.h"

namespace spoke::vibration {

class PeriodicFrame {
 public:
  /// Throws like require_period(). `all` is to live as long.
  explicit PeriodicFrame(const Linearised& all);

  /// Returns the system, on its support if it has one. Coordinates of a rotor that is seen from
  /// outside are those of its patterns.
  PeriodicSystem make_system() const;
  /// Returns the motion of the independent coordinates of a subsystem, by that of all coordinates
  /// of the system, where all hubs are at azimuth zero.
  Eigen::VectorXcd motion_of(std::size_t subsystem, const Eigen::VectorXcd& x,
                             const PeriodicSystem& system) const;
  /// Whether a subsystem is of a rotor that is seen from outside.
  bool is_outside(std::size_t subsystem) const;
  /// Returns the patterns of a rotor that is seen from outside, by the number of one of its
  /// subsystems.
  std::vector<std::size_t> patterns_of(std::size_t subsystem) const;
  /// Returns all rotors that are seen from outside, without their support.
  SeenFromOutside outside() const { return {all_, outside_}; }
  /// Returns the motion of outside(), of the patterns alone.
  Eigen::VectorXcd motion_outside(const Eigen::VectorXcd& x, const PeriodicSystem& system) const;

 private:
  /// A rotor on a support.
  struct Seat {
    bool is_outside = false;
    double speed = 0.0;                    ///< at which its matrices turn [rad/s]
    std::size_t place = 0;                 ///< among those that are seen from outside
    std::vector<std::size_t> parts = {};   ///< subsystems of the model, or patterns
    std::vector<std::size_t> starts = {};  ///< of these, the numbers in the system
  };

  void take_seats();
  double speed() const;
  StandingAxes make_axes() const;
  steady::LinearModel join_at(std::size_t part,
                              const std::vector<steady::LinearModel>& turned) const;
  PeriodicSystem make_on_hubs() const;

  const Linearised& all_;
  FixedFrame outside_;
  std::vector<Seat> seats_;           ///< by rotor on a support; empty: there is none
  std::vector<std::size_t> numbers_;  ///< in the system, by subsystem that is not of a pattern
};

}  // namespace spoke::vibration
