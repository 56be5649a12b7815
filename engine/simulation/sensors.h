#pragma once

// The sensors of a simulation in the plane: names, units and values.

#include <string>
#include <vector>

#include "engine/bodies/columns/sensor_columns.h"
#include "engine/bodies/table/step_data.h"
#include "engine/simulation/momentum_sensors.h"
#include "engine/simulation/sensor_values.h"

namespace spoke {

/// Returns the energies at the state in the table, whose kinematics it recalculates. Where
/// subsystems follow a prescribed hub, its motion must be that of the state.
Energies calc_energies(const System<Plane>& system, StepData<Plane>& data);

/// Names, units and values of the sensors of a system.
class Sensors : public SensorValues {
 public:
  /// `asked`: columns of the scenario, behind those that every simulation has. `momentum`: columns
  /// of a free model, see MomentumSensors.
  Sensors(const System<Plane>& system, std::vector<SensorColumn> asked,
          std::vector<SensorColumn> momentum = {});

  /// Returns the balance of a free model on which nothing acts at the step measured last; else
  /// null.
  const MomentumBalance* momentum() const {
    return momentum_.are_there() ? &momentum_.balance() : nullptr;
  }
  /// Takes the state at the start as reference of energy.
  void start(const System<Plane>& system, StepData<Plane>& data);
  /// Fills the samples and readings of step `step`, time t [s], from the state in the table, which
  /// must be that of the step.
  static void sample(const System<Plane>& system, std::int64_t step, double t,
                     StepData<Plane>& data);
  /// Returns the values at the end of step `step`, whose records and samples must be in the table,
  /// in the order of names(). `work`: work up to that step.
  const std::vector<double>& measure(const System<Plane>& system, const WorkDone& work,
                                     std::int64_t step, const StepData<Plane>& data);

 private:
  void add_subsystem_values(const System<Plane>& system, std::int64_t step,
                            const StepData<Plane>& data);

  std::vector<SensorColumn> asked_;
  MomentumSensors<Plane> momentum_;
};

}  // namespace spoke
