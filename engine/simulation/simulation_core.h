#pragma once

// What stands behind the front door: the data of a simulation, how its steps are made, saved and
// restored.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/load.h"
#include "engine/run/step_runner.h"
#include "engine/saved_state.h"
#include "engine/simulation/observations.h"
#include "engine/simulation/sensors.h"
#include "engine/simulation/simulated_model.h"
#include "engine/simulation/simulation_log.h"
#include "engine/simulation_options.h"
#include "engine/step/pass_integration.h"

namespace spoke {

class Simulation;

/// The data of a simulation, open to the functions of Simulation, and what changes them.
class SimulationCore {
 public:
  SimulationCore(const Scenario& asked, const SimulationOptions& chosen, const Loads& loads);

  // Each throws DivergenceError or LoadError if a step fails.
  void step();
  void run_to(std::int64_t target, const StepObserver& observe);
  StepTrace trace(std::int64_t target, const StepObserver& observe,
                  const TraceOptions& trace_options);
  void measure(std::int64_t target, graph::Executor& executor);
  void open_window();
  SavedState save();
  void restore(const SavedState& state);
  /// Coordinates and observations at the end of step `steps`, the last one.
  std::vector<double> take_values(std::int64_t steps);
  /// Begins anew, to the bits of a simulation that is built from `next`, with constants,
  /// factorisations and step graph as they are. `start`: take_values() at t = 0. Preconditions: see
  /// may_begin_again(); no loads of the user's. Throws like the constructor, and may then be begun
  /// again.
  void begin_again(const Scenario& next, std::span<const double> start);
  /// Throws StateError if there is no state to `use`.
  void require_state(const char* use) const;
  /// The sensors at the last step's end.
  const std::vector<double>& values();
  /// Brings accelerations and wrenches to the state at the last step's end.
  void evaluate();
  /// The same, after a force has changed: the next step starts from it.
  void renew();
  /// Puts `next` in the place of something that is in force, and takes it back if there is no
  /// acceleration with it.
  template <class T>
  void replace(T& in_force, T next) {
    std::swap(in_force, next);
    try {
      renew();
    } catch (...) {
      std::swap(in_force, next);
      throw;
    }
  }
  /// What makes the results doubtful so far.
  std::vector<Warning> make_warnings() const;
  /// Replaces the course of a coordinate that the program prescribes, which begins like this.
  void set_joint_motion(const JointPlace& place, const space::PrescribedMotion& begin,
                        const space::DrivenMotion& course);
  /// Replaces the drive.
  void set_drive(const Drive& next);
  /// Of a model in space. Throws InputError if it is in the plane: `what` is then refused.
  SpatialJoints& joints(const char* what) const;
  /// Whether other processes have subsystems of the model, too.
  bool is_shared() const { return options.exchange && options.exchange->count() > 1; }
  /// A rotor in the plane. Throws InputError if the model is in space: `what` is then refused.
  SystemContext<Plane>& plane(const char* what) const;

  Scenario given;
  Scenario scenario;  ///< that is simulated, see skip_start_up()
  SimulationOptions options;
  std::int64_t planned_steps;
  double step_size;
  std::unique_ptr<SimulatedModel> model;
  std::unique_ptr<StepRunner> runner;
  std::int64_t evaluations = 0;
  WorkDone work;
  Observations seen;
  std::vector<Jump> jumps;  ///< of what the scenario and the program prescribe, in order of time
  double energy_resolution = 0.0;  ///< [J]
  SimulationLog log;
  /// Sensors are measured when first read after a step.
  std::vector<double> sensor_values;
  std::int64_t measured_step = -1;
  /// What loads of the user's exert, as the table has it, is not that of the state.
  bool loads_are_stale = false;
  /// The step at whose end accelerations and wrenches were evaluated (see
  /// StepTable::take_evaluated_record).
  std::int64_t evaluated_step = -1;

 private:
  void prepare(const Loads& loads);
  void begin();
  void put(std::span<const double> values, std::int64_t steps);
  void require_shareable(const Loads& loads) const;
  void sample(std::int64_t step);
  void set_jumps(const std::string& source, std::vector<Jump> next);
  void evaluate_again();
  void require_kept_declarations();
  const std::shared_ptr<const std::string>& identity();
  bool stops_on_growth() const;
  void count_step(std::int64_t step);
  bool has_jump(std::int64_t step) const;
  void complete_step(std::int64_t step, const StepObserver& observe);
  void log_news();
  template <class Advance>
  void require_done(const Advance& advance);
  [[noreturn]] void throw_failure(StepOutcome outcome, std::int64_t step);

  std::shared_ptr<const std::string> identity_;  ///< of the model, once somebody wants to know
};

/// Whether a simulation can begin_again() as another scenario that differs from this one in values
/// of the drive alone, not in its kind: unless it starts from an equilibrium, which depends on it.
bool may_begin_again(const Scenario& scenario);

/// What stands behind `simulation`, for functions of Spoke's own that are none of its interface.
SimulationCore& core_of(Simulation& simulation);

}  // namespace spoke
