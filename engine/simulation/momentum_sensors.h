#pragma once

// Sensors of the momentum of a free model on which nothing acts, and which must keep it.

#include <array>
#include <vector>

#include "engine/bodies/columns/sensor_columns.h"
#include "engine/bodies/table/step_data.h"
#include "engine/simulation/observations.h"

namespace spoke {

/// Whether the model of a scenario is free, and neither gravity nor a load nor a drive acts on it.
bool keeps_momentum(const Scenario& scenario);

/// Returns the sensors of a scenario, and behind them one of the momentum if the model `keeps` it.
std::vector<Sensor> with_momentum(const Scenario& scenario, bool keeps);
/// Takes the columns of this last sensor from all; returns none if the model does not keep its
/// momentum.
std::vector<SensorColumn> take_momentum(const Scenario& scenario, bool keeps,
                                        std::vector<SensorColumn>& columns);

/// Sensors of the momentum of a model of one world.
template <class World>
class MomentumSensors {
 public:
  /// `columns`: those of the momentum, linear components and then angular ones; may be empty.
  MomentumSensors(const System<World>& system, std::vector<SensorColumn> columns);

  /// Whether there is anything to measure.
  bool are_there() const { return !columns_.empty(); }
  /// Takes the momentum at the start as reference; its readings must be in the table.
  void start(const System<World>& system, const StepData<World>& data);
  /// Measures at a step whose readings and samples must be in the table. `kinetic`: energy [J].
  void measure(const System<World>& system, double kinetic, std::int64_t step,
               const StepData<World>& data);
  /// Returns the balance at the step measured last.
  const MomentumBalance& balance() const { return balance_; }

 private:
  using Momentum = std::array<double, World::kTwist>;
  Momentum read(const System<World>& system, std::int64_t step, const StepData<World>& data) const;

  std::vector<SensorColumn> columns_;
  double mass_ = 0.0;  ///< of the model [kg]
  Momentum start_{};
  MomentumBalance balance_;
};

}  // namespace spoke
