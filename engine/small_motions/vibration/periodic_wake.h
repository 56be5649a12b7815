#pragma once

// Induced velocities and separation over the turns of a periodic motion.

#include <cstddef>
#include <vector>

#include "engine/small_motions/vibration/periodic_system.h"
#include "engine/small_motions/vibration/turn_motion.h"

namespace spoke::steady {
class SteadyModel;
}

namespace spoke::vibration {

/// The states of air on the subsystems at equal parts of a turn, which repeat from turn to turn.
class PeriodicWake {
 public:
  /// Lets the wake follow a motion turn by turn, from the states that it has (of equilibrium, if it
  /// has none for so many parts), until they repeat. `model` is left with the air that was
  /// advanced last. False: they do not, or the motion is beyond the limits of the model.
  bool follow(const TurnMotion& motion, const PeriodicSystem& mean,
              const std::vector<Eigen::VectorXd>& equilibrium, steady::SteadyModel& model);

  /// Holds the air on subsystem i at its states at the l-th azimuth; nothing, if no air acts.
  void hold(std::size_t i, Eigen::Index l, steady::SteadyModel& model) const;
  bool acts() const;

 private:
  using States = std::vector<std::vector<double>>;  ///< by azimuth
  bool turn(std::size_t i, const TurnMotion& motion, const PeriodicSystem& mean,
            const Eigen::VectorXd& q, States& states, steady::SteadyModel& model) const;

  std::vector<States> states_;  ///< by subsystem; empty where no air acts
};

}  // namespace spoke::vibration
