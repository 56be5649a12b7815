#pragma once

// The sensors of a simulation in space: names, units and values.

#include <string>
#include <vector>

#include "engine/simulation/observations.h"
#include "engine/simulation/sensors.h"
#include "engine/table/step_data.h"
#include "models/tree/tree.h"

namespace spoke {

/// Names, units and values of the sensors of a system in space (docs/results.md).
class SpatialSensors {
 public:
  SpatialSensors(const System<Space>& system, const std::vector<spatial::Tree>& trees);

  const std::vector<std::string>& names() const { return names_; }
  const std::vector<std::string>& units() const { return units_; }

  /// Takes the state at the start, of which the samples must be in the table, as reference of
  /// energy.
  void start(const System<Space>& system, const StepData<Space>& data);
  double initial_energy() const { return initial_energy_; }  ///< kinetic and strain energy [J]
  /// Values at the end of step `step`, of which records and samples must be in the table, in the
  /// order of names(). `work`: up to then.
  const std::vector<double>& measure(const System<Space>& system, const WorkDone& work,
                                     std::int64_t step, const StepData<Space>& data);
  /// Of the step measured last.
  const EnergyBalance& balance() const { return balance_; }

 private:
  void add(std::string name, std::string unit);
  void add_joints(const std::string& tree_name, const spatial::Tree& tree);

  std::vector<std::string> names_;
  std::vector<std::string> units_;
  std::vector<double> values_;
  EnergyBalance balance_;
  double initial_energy_ = 0.0;
  double initial_gravity_ = 0.0;
};

}  // namespace spoke
