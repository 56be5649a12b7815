#pragma once

// What controllers are told: measurements of a model in space.

#include <span>
#include <string>
#include <vector>

#include "engine/controller.h"
#include "engine/simulation/simulated_model.h"

namespace spoke {

/// Makes the record of a controller of the first rotor.
class ControlMeasurement {
 public:
  /// `model`: in space, allocated; that of `scenario`.
  ControlMeasurement(const Scenario& scenario, SimulatedModel& model);

  /// Returns the trees on the hub of the rotor, blades before subsystems.
  const std::vector<std::size_t>& blades() const { return blades_; }
  /// Measures at time t [s]; `sensors` are those of that time.
  ControlRecord measure(const Scenario& scenario, SimulatedModel& model, double t,
                        std::span<const double> sensors) const;

 private:
  void add_nacelle(const Scenario& scenario, SimulatedModel& model, ControlRecord& record) const;

  double direction_ = 1.0;
  std::vector<std::size_t> blades_;
  std::vector<std::size_t> moments_;                ///< by blade, the first of three sensors
  std::vector<Eigen::Vector3d> across_, along_;     ///< by blade: axes of moments, frame of the hub
  std::size_t speed_ = 0, angle_ = 0, torque_ = 0;  ///< sensors
};

}  // namespace spoke
