#pragma once

// The sensors of a simulation in space: names, units and values.

#include <string>
#include <vector>

#include "engine/bodies/columns/sensor_columns.h"
#include "engine/bodies/table/step_data.h"
#include "engine/simulation/momentum_sensors.h"
#include "engine/simulation/sensor_values.h"
#include "models/tree/tree.h"

namespace spoke {

/// Names, units and values of the sensors of a system in space (docs/results.md).
class SpatialSensors : public SensorValues {
 public:
  /// `data`: the table with the actors whose columns it has. `asked`: columns of the scenario,
  /// behind those that every simulation has. `momentum`: columns of a free model, see
  /// MomentumSensors.
  SpatialSensors(const System<Space>& system, const std::vector<spatial::Tree>& trees,
                 const StepData<Space>& data, std::vector<SensorColumn> asked,
                 std::vector<SensorColumn> momentum = {});

  /// Returns the balance of a free model on which nothing acts at the step measured last; else
  /// null.
  const MomentumBalance* momentum() const {
    return momentum_.are_there() ? &momentum_.balance() : nullptr;
  }
  /// Takes the state at the start, whose samples must be in the table, as reference of energy.
  void start(const System<Space>& system, const StepData<Space>& data);
  /// Returns the values at the end of step `step`, whose records and samples must be in the table,
  /// in the order of names(). `work`: work up to that step.
  const std::vector<double>& measure(const System<Space>& system, const WorkDone& work,
                                     std::int64_t step, const StepData<Space>& data);

 private:
  void add_joints(const spatial::Tree& tree);
  /// Adds columns of the hubs of rotors besides the first: "tail.hub.angle".
  void add_other_hubs(std::size_t rotors, const std::vector<spatial::Tree>& trees);
  void add_actors(ColumnPlace place, const StepData<Space>& data);
  void append_actors(ColumnPlace place, std::int64_t step, const StepData<Space>& data);

  std::vector<SensorColumn> asked_;
  MomentumSensors<Space> momentum_;
  std::vector<std::size_t> joint_values_;  ///< of the joints, by subsystem
  std::vector<const double*> kept_;        ///< by subsystem, what the actor at hand has kept
};

}  // namespace spoke
