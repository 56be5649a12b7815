#pragma once

// Implementation of Simulation: its data, and how its steps are made, saved and restored.

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/courses.h"
#include "engine/load.h"
#include "engine/saved_state.h"
#include "engine/simulation/control_loop.h"
#include "engine/simulation/events.h"
#include "engine/simulation/observations.h"
#include "engine/simulation/sensors.h"
#include "engine/simulation/simulated_model.h"
#include "engine/simulation/simulation_log.h"
#include "engine/simulation_options.h"
#include "engine/step/pass_integration.h"
#include "engine/step/run/step_runner.h"

namespace spoke {

class Simulation;

/// The data of a simulation, open to the functions of Simulation, and the functions that change
/// them.
class SimulationCore {
 public:
  SimulationCore(const Scenario& asked, const SimulationOptions& chosen, const Loads& loads);

  /// Returns a copy that goes on by itself, see Simulation::clone(). Throws StateError, InputError.
  std::unique_ptr<SimulationCore> clone();

  // Each throws DivergenceError or LoadError if a step fails.
  void step();
  void run_to(std::int64_t target, const StepObserver& observe);
  StepTrace trace(std::int64_t target, const StepObserver& observe,
                  const TraceOptions& trace_options);
  void measure(std::int64_t target, graph::Executor& executor);
  void open_window();
  SavedState save();
  void restore(const SavedState& state);
  /// Returns coordinates and observations at the end of step `steps`, the last one.
  std::vector<double> take_values(std::int64_t steps);
  /// Begins again, to the bits of a simulation that is built from `next`, but keeps constants,
  /// factorisations and step graph. `start`: take_values() at t = 0. Preconditions:
  /// may_begin_again(); no loads of the user's. Throws like the constructor, and may then be begun
  /// again.
  void begin_again(const Scenario& next, std::span<const double> start);
  /// Throws StateError if there is no state to `use`.
  void require_state(const char* use) const;
  /// Returns the sensors at the end of the last step.
  const std::vector<double>& values();
  /// Updates accelerations and wrenches to the state at the end of the last step.
  void evaluate();
  /// Updates them after a force has changed, so that the next step starts from them.
  void renew();
  /// Replaces a part in force by `next`, and restores it if there is no acceleration with `next`.
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
  /// Returns the warnings so far.
  std::vector<Warning> make_warnings() const;
  /// Replaces the course of a coordinate that the program prescribes by one that begins with
  /// `begin`.
  void set_joint_motion(const JointPlace& place, const space::PrescribedMotion& begin,
                        const space::DrivenMotion& course);
  /// Replaces the course of an anchor that the program prescribes by one that begins with `begin`.
  void set_anchor_motion(std::string_view name, const SaidAnchorMotion& begin,
                         const decltype(AnchorModel::motion)& course);
  /// Returns the number of the rotor by this name; 0 without a name. Throws InputError if there is
  /// none.
  int find_rotor(std::string_view name) const;
  /// Replaces the drive of a rotor.
  void set_drive(const Drive& next, int rotor);
  // These put courses in force beside a state that was restored: they need not go on from those in
  // force, and nothing is evaluated.
  void put_joint_motion(const JointPlace& place, const space::DrivenMotion& course);
  void put_anchor_motion(std::string_view name, const decltype(AnchorModel::motion)& course);
  void put_drive(const Drive& next, int rotor);
  /// Returns the drive of a rotor that scenario, controller or program have put in force: what
  /// events leave of it is that of the model.
  const Drive& own_drive(int rotor) const {
    return events && rotor == 0 ? events->own_drive() : model->drive(rotor);
  }
  /// Returns the joints of a model in space. Throws InputError, which refuses `what`, if the model
  /// is in the plane.
  SpatialJoints& joints(const char* what) const;
  /// Whether other processes have subsystems of the model, too.
  bool is_shared() const { return options.exchange && options.exchange->count() > 1; }
  /// Returns the context of a rotor in the plane. Throws InputError, which refuses `what`, if the
  /// model is in space.
  SystemContext<Plane>& plane(const char* what) const;

  Scenario given;
  Scenario scenario;  ///< the scenario that is simulated, see skip_start_up()
  SimulationOptions options;
  std::int64_t planned_steps;
  double step_size;
  std::unique_ptr<SimulatedModel> model;
  std::unique_ptr<StepRunner> runner;
  std::int64_t evaluations = 0;
  WorkDone work;
  Observations seen;
  std::vector<Jump> jumps;  ///< of motions that scenario and program prescribe, in order of time
  std::map<std::string, double> load_factors;  ///< that the program has set, by name of the loads
  std::vector<JointTorque> torques;            ///< that the program has set, 0 included
  std::unique_ptr<ControlLoop> control;        ///< null: no controller from outside
  std::unique_ptr<Events> events;              ///< null: none
  double energy_resolution = 0.0;              ///< [J]
  SimulationLog log;
  /// Sensor values, measured when first read after a step.
  std::vector<double> sensor_values;
  std::int64_t measured_step = -1;
  /// Whether forces of the user's loads in the table are not those of the state.
  bool loads_are_stale = false;
  /// The step at whose end accelerations and wrenches were evaluated (see
  /// StepTable::take_evaluated_record).
  std::int64_t evaluated_step = -1;

 private:
  /// Marks a simulation as calling what may call back, as long as it lives.
  class Calling {
   public:
    explicit Calling(SimulationCore& core) : core_(core), before_(core.is_calling_) {
      core_.is_calling_ = true;
    }
    ~Calling() { core_.is_calling_ = before_; }
    Calling(const Calling&) = delete;
    Calling& operator=(const Calling&) = delete;

   private:
    SimulationCore& core_;
    bool before_;
  };

  /// Makes the copy of clone().
  explicit SimulationCore(SimulationCore& original);
  RunnerOptions runner_options() const;
  void prepare(const Loads& loads);
  void begin();
  void put(std::span<const double> values, std::int64_t steps);
  std::int64_t act_between_steps(std::int64_t target);
  void take_events();
  void sample_control();
  std::int64_t next_action(std::int64_t target) const;
  void put_drive_in_force();
  void require_shareable(const Loads& loads) const;
  void sample(std::int64_t step);
  /// Returns the present time [s].
  double now() const { return static_cast<double>(runner->steps()) * step_size; }
  void replace_jumps_of(const JointPlace& place, const space::DrivenMotion& course);
  void replace_jumps_of(std::string_view anchor, const decltype(AnchorModel::motion)& course);
  void replace_jumps_of(const Drive& drive, int rotor);
  void log_jumps();
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

  std::shared_ptr<const std::string> identity_;  ///< of the model; null until first needed
  bool is_calling_ = false;                      ///< whether an observer or a load may be called
};

/// Whether a simulation can begin_again() with a scenario that differs from this one only in values
/// of the drive, not in its kind. It cannot if it starts from an equilibrium, which depends on the
/// drive, or if a controller from outside keeps data.
bool may_begin_again(const Scenario& scenario);

/// Returns the implementation of `simulation`, for functions of Spoke that are not part of its
/// interface.
SimulationCore& core_of(Simulation& simulation);

}  // namespace spoke
