#pragma once

// Loads on a system in steady rotation: the values with which loads, motors and prescribed motions
// end or begin, of which a share can be applied.

#include <memory>
#include <vector>

#include "engine/small_motions/steady/steady_model.h"
#include "models/system/system.h"

namespace spoke::steady {

/// Makes all loads on a system independent of time, and keeps their full size. The system must
/// outlive it, stay in place, and not be copied from.
template <class World>
class SteadyLoads {
 public:
  /// Loads that depend on time take their value at `instant`, motions by azimuth their mean. If the
  /// hub turns (`turns`), vectors that are constant in the inertial frame keep only their part
  /// along the axis. On a free hub there is no gravity.
  SteadyLoads(System<World>& system, bool turns, Instant instant);

  /// Applies this share of all loads and motors, and of gravity.
  void set_share(double share);

 private:
  struct Scaled {
    std::shared_ptr<LoadCourse> course;
    double full = 0.0;
  };
  struct Effort {
    Curve* curve = nullptr;
    double full = 0.0;
  };

  System<World>& system_;
  PositionOf<World> gravity_;
  std::vector<Scaled> courses_;
  std::vector<Effort> efforts_;  ///< of joints, and of loads on the hub
};

}  // namespace spoke::steady
