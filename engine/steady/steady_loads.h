#pragma once

// What acts on a system in steady rotation: the values that loads, motors and prescribed motions
// end or begin with, of which a share can be applied.

#include <memory>
#include <vector>

#include "engine/steady/steady_model.h"
#include "models/system/system.h"

namespace spoke::steady {

/// Makes all that acts on a system independent of time, and keeps it in its full size. The system
/// must outlive it, stay in place, and not be copied from.
template <class World>
class SteadyLoads {
 public:
  /// Loads that depend on time take the value that they have at `instant`, motions by azimuth their
  /// mean. If the hub turns (`turns`), of what is constant in the inertial frame only the part
  /// along the axis is kept; of a free hub gravity is none.
  SteadyLoads(System<World>& system, bool turns, Instant instant);

  /// Applies that share of all loads and motors, and of gravity.
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
