#pragma once

// What a free model on which nothing acts does with its momentum, which it must keep.

#include <array>
#include <vector>

#include "engine/columns/sensor_columns.h"
#include "engine/simulation/observations.h"
#include "engine/table/step_data.h"

namespace spoke {

/// Whether a scenario's model is free, and neither gravity nor a load nor a drive acts on it.
bool keeps_momentum(const Scenario& scenario);

/// The sensors of a scenario, and behind them that of the momentum of a model that `keeps` it.
std::vector<Sensor> with_momentum(const Scenario& scenario, bool keeps);
/// The columns of that last sensor, taken from all: none if the model keeps none.
std::vector<SensorColumn> take_momentum(const Scenario& scenario, bool keeps,
                                        std::vector<SensorColumn>& columns);

/// Of one world.
template <class World>
class MomentumSensors {
 public:
  /// `columns`: of the momentum, linear components and then angular ones; may be none.
  MomentumSensors(const System<World>& system, std::vector<SensorColumn> columns);

  /// Whether there is anything to measure.
  bool are_there() const { return !columns_.empty(); }
  /// Takes the momentum at the start as reference; its readings must be in the table.
  void start(const System<World>& system, const StepData<World>& data);
  /// Measures at a step, of which readings and samples must be in the table. `kinetic`: energy [J].
  void measure(const System<World>& system, double kinetic, std::int64_t step,
               const StepData<World>& data);
  /// At the step measured last.
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
