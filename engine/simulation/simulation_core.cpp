// Checks options, builds the parts of a simulation, and runs and completes its steps.

#include "engine/simulation/simulation_core.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <exception>
#include <sstream>
#include <utility>

#include "engine/bodies/table/state_values.h"
#include "engine/simulation/make_model.h"
#include "engine/simulation/model_identity.h"
#include "engine/simulation/require_range.h"
#include "engine/small_motions/steady/steady_start.h"
#include "graph/declaration_check.h"
#include "models/count_text.h"
#include "models/error.h"
#include "models/reader/scenario_check.h"
#include "models/reader/spatial/model_check.h"
#include "models/start.h"

namespace spoke {
namespace {

/// Returns the number of steps of at most integration.step that divide the duration; a relative
/// slack of 1e-9 keeps round values from gaining one.
std::int64_t count_steps(const Integration& integration) {
  assert(integration.step > 0.0 && integration.duration > 0.0);
  return static_cast<std::int64_t>(
      std::ceil(integration.duration / integration.step * (1.0 - 1e-9)));
}

Method make_method(const Integration& integration, double step) {
  if (integration.method == IntegrationMethod::rk4) return Rk4{step};
  return make_generalized_alpha(integration.spectral_radius, step);
}

/// Throws unless the state is finite: a state that has diverged is not saved.
void require_finite(const SavedState& state) {
  const auto is_finite = [](double value) { return std::isfinite(value); };
  const auto bad = std::find_if_not(state.values.begin(), state.values.end(), is_finite);
  if (bad != state.values.end())
    throw InputError("value " + std::to_string(bad - state.values.begin() + 1) +
                     " of the saved state is not finite");
  if (!is_finite(state.work) || !is_finite(state.dissipated))
    throw InputError("the work of the saved state is not finite");
}

/// Returns the scenario with the meshes of its solids, which are read once.
Scenario checked(Scenario scenario) {
  if (scenario.space) spatial::read_model_files(*scenario.space);
  check_scenario(scenario);
  return scenario;
}

const SimulationOptions& checked(const SimulationOptions& options) {
  require_range("SimulationOptions::window", options.window, 0, kMostWindow);
  graph::check_threads(options.executor, options.threads);
  return options;
}

IterationLimits make_limits(const Scenario& scenario) {
  const Integration& integration = scenario.integration;
  IterationLimits limits{integration.tolerance, integration.iterations, integration.max_iterations,
                         scenario.space.has_value(), goal_of(integration) == IterationGoal::error};
  if (scenario.space && scenario.space->air) limits.highest_order = 2;
  if (integration.tolerance != Integration{}.tolerance) limits.most_left = integration.tolerance;
  return limits;
}

/// Thrown to end a run at a step whose energy has grown, if the scenario says so. Never leaves the
/// functions of Simulation.
struct EnergyHasGrown {};

}  // namespace

SimulationCore::SimulationCore(const Scenario& asked, const SimulationOptions& chosen,
                               const Loads& loads)
    : given(checked(asked)),
      scenario(skip_start_up(given)),
      options(checked(chosen)),
      planned_steps(count_steps(given.integration)),
      step_size(given.integration.duration / static_cast<double>(planned_steps)) {
  prepare(loads);
  control = make_control_loop(scenario, step_size, options.controller, *model);
  events = make_events(scenario, step_size, *model);
  begin();
}

/// Begins from the state at t = 0.
void SimulationCore::begin() {
  const StepOutcome outcome = runner->start();
  if (outcome != StepOutcome::done) throw_failure(outcome, 0);
  observe_start(model->start_sensors(), seen);
  energy_resolution = model->energy_resolution();
  jumps = find_jumps(scenario, step_size);
  complete_step(0, {});
}

RunnerOptions SimulationCore::runner_options() const {
  return {options.make_executor ? ExecutorKind::serial : options.executor,
          options.threads,
          options.window,
          planned_steps,
          options.make_executor,
          is_shared()};
}

void SimulationCore::prepare(const Loads& loads) {
  const Integrator integrator{make_method(scenario.integration, step_size), make_limits(scenario)};
  model = make_model(scenario, options.formulation, integrator, loads);
  const RunnerOptions how = runner_options();
  if (is_shared()) require_shareable(loads);
  model->allocate(window_records(how, model->ring_bytes()));
  if (is_shared()) model->share_out(*options.exchange);
  if (scenario.initial.state == InitialState::equilibrium)
    model->put_bodies(steady::find_start(scenario));
  runner = std::make_unique<StepRunner>(model->context(), how);
#ifndef NDEBUG
  require_kept_declarations();
#endif
}

void SimulationCore::require_shareable(const Loads& loads) const {
  const int count = options.exchange->count();
  const std::string text = std::to_string(count) + " processes simulate the model together: ";
  if (options.formulation == Formulation::augmented)
    throw InputError(text + "the formulation is augmented, expected structured or subsystem");
  if (!loads.empty()) throw InputError(text + "expected no loads of the program's");
  if (scenario.space && !scenario.space->events.empty())
    throw InputError(text + "[[event]] acts between steps, expected one process");
  if (scenario.space && scenario.space->outer_control &&
      scenario.space->outer_control->has_controller)
    throw InputError(text + "[" + std::string(scenario.space->outer_control->table()) +
                     "] is called between steps, expected one process");
  for (const Anchor& anchor : scenario.space ? scenario.space->anchors : scenario.rotor.anchors)
    if (anchor.frame == Anchor::Frame::axle)
      throw InputError(text + "anchor \"" + anchor.name +
                       "\" stands beside the axle, whose wrench takes the forces on it from all "
                       "blades, of which each process has its own; expected one process");
  if (const SystemContext<Space>* space = model->space();
      space && !space->system.shared_loops.empty())
    throw InputError(
        text +
        "a loop or a coupling is between subsystems, of which each process has its own; "
        "expected one process");
  const int subsystems = model->extent().subsystems;
  if (count > subsystems)
    throw InputError(text + "it has " + counted(subsystems, "subsystem") +
                     ", expected at most so many processes");
}

/// Runs every node once on its declared data alone, in debug builds.
[[maybe_unused]] void SimulationCore::require_kept_declarations() {
  constexpr int kLargest = 500;  // nodes: the check costs their number times the memory
  if (runner->step_graph().node_count() > kLargest) return;
  for (const graph::DeclarationFault& fault : graph::check_declarations(runner->step_graph()))
    throw Error(ErrorCode::internal, fault.message);
  model->context().table().clear_load_failures();
}

void SimulationCore::step() {
  if (runner->steps() >= planned_steps) return;
  act_between_steps(planned_steps);
  require_done([this] {
    return runner->advance_one([this](std::int64_t step) {
      if (stops_on_growth()) sample(step);
      complete_step(step, {});
    });
  });
}

void SimulationCore::run_to(std::int64_t target, const StepObserver& observe) {
  const auto completed = [this, &observe](std::int64_t step) { complete_step(step, observe); };
  const bool observed = observe || stops_on_growth();
  target = std::min(target, planned_steps);
  do {
    const std::int64_t end = act_between_steps(target);
    require_done([&] { return runner->advance_to(end, observed, completed); });
  } while (runner->steps() < target && !runner->is_stopping());
}

/// Lets events and a controller from outside act where the simulation stands. Returns the step at
/// whose end something acts next; at most `target`.
std::int64_t SimulationCore::act_between_steps(std::int64_t target) {
  take_events();
  sample_control();
  return next_action(target);
}

/// Returns the step at whose end something acts next; at most `target`.
std::int64_t SimulationCore::next_action(std::int64_t target) const {
  const std::int64_t step = runner->steps();
  if (control && !(events && events->stops_controller()))
    target = std::min(target, control->next(step));
  return events ? std::min(target, events->next(step, *model)) : target;
}

void SimulationCore::take_events() {
  const std::int64_t step = runner->steps();
  if (!events || step >= planned_steps || !events->is_due(step)) return;
  require_state("go on from");
  const Calling calling(*this);
  const std::span<const double> sensors =
      events->reads_sensors() ? std::span<const double>(values()) : std::span<const double>{};
  if (events->take(step, sensors, *model)) set_drive(events->own_drive(), 0);
}

/// Lets a controller from outside take a sample where the simulation stands, if it is due.
void SimulationCore::sample_control() {
  const std::int64_t step = runner->steps();
  if (!control || step >= planned_steps || !control->is_due(step)) return;
  if (events && events->stops_controller()) return;
  require_state("go on from");
  const Calling calling(*this);
  const DemandedDrive demanded = control->sample(step, scenario, values(), *model);
  if (demanded.jumps)
    set_drive(demanded.drive, 0);
  else
    put_drive(demanded.drive, 0);
}

StepTrace SimulationCore::trace(std::int64_t target, const StepObserver& observe,
                                const TraceOptions& trace_options) {
  const auto completed = [this, &observe](std::int64_t step) { complete_step(step, observe); };
  const bool observed = observe || stops_on_growth();
  if (is_shared())
    throw InputError("a trace: several processes simulate the model together, expected one");
  StepTrace trace;
  try {
    require_done([&] {
      return runner->advance_traced(
          std::min(target, planned_steps), observed, completed,
          [this](std::int64_t end) { return act_between_steps(end); }, trace_options, trace);
    });
  } catch (...) {
    if (trace_options.unfinished) trace_options.unfinished(std::move(trace));
    throw;
  }
  return trace;
}

void SimulationCore::measure(std::int64_t target, graph::Executor& executor) {
  require_done([&] {
    return runner->advance_by(
        executor, std::min(target, planned_steps), stops_on_growth(),
        [this](std::int64_t step) { complete_step(step, {}); },
        [this](std::int64_t end) { return act_between_steps(end); });
  });
}

void SimulationCore::open_window() {
  require_done([this] {
    return runner->open_window(
        stops_on_growth(), [this](std::int64_t step) { complete_step(step, {}); },
        [this](std::int64_t end) { return act_between_steps(end); });
  });
}

void SimulationCore::require_state(const char* use) const {
  const StepTable& data = model->context().table();
  if (!are_together(data) || last_complete_step(data) != runner->steps())
    throw StateError(std::string("there is no state to ") + use +
                     ": a step failed or was not brought to its end");
}

void SimulationCore::sample(std::int64_t step) {
  model->sample(step, static_cast<double>(step) * step_size);
}

const std::vector<double>& SimulationCore::values() {
  if (measured_step == runner->steps()) return sensor_values;
  if (loads_are_stale && model->context().table().has_loads() && !scenario.sensors.empty())
    evaluate_again();
  sample(runner->steps());
  sensor_values = model->measure(work, runner->steps());
  measured_step = runner->steps();
  return sensor_values;
}

void SimulationCore::evaluate() {
  require_state("evaluate");
  if (evaluated_step == runner->steps()) return;
  if (!scenario.sensors.empty()) values();  // those that the step has left
  evaluate_again();
}

void SimulationCore::evaluate_again() {
  const Calling calling(*this);
  const StepOutcome outcome = runner->evaluate(false);
  if (outcome != StepOutcome::done) throw_failure(outcome, runner->steps());
  evaluated_step = runner->steps();
  loads_are_stale = false;
}

void SimulationCore::renew() {
  values();
  evaluated_step = -1;
  const Calling calling(*this);
  const StepOutcome outcome = runner->evaluate(true);
  if (outcome != StepOutcome::done) throw_failure(outcome, runner->steps());
}

/// Makes the identity when first needed: it takes long for a simulation of milliseconds, and is
/// seldom needed.
const std::shared_ptr<const std::string>& SimulationCore::identity() {
  if (!identity_)
    identity_ = std::make_shared<const std::string>(
        make_identity(scenario, options.formulation, step_size));
  return identity_;
}

SavedState SimulationCore::save() {
  require_state("save");
  const std::int64_t steps = runner->steps();
  return {identity(),
          static_cast<double>(steps) * step_size,
          steps,
          evaluations,
          work.by_drive_and_loads,
          work.dissipated,
          take_values(steps),
          control ? std::optional(control->save()) : std::nullopt};
}

// Returns the values of the table, then those of events, then the observations.
std::vector<double> SimulationCore::take_values(std::int64_t steps) {
  std::vector<double> values = take_state_values(steps, model->context().table());
  if (events) events->save(values);
  const std::span<const double> observed = doubles(seen);
  values.insert(values.end(), observed.begin(), observed.end());
  return values;
}

void SimulationCore::restore(const SavedState& state) {
  constexpr std::int64_t most_steps = std::int64_t{1} << 53;  // values are doubles
  if (!state.model) throw InputError("the saved state is empty");
  if (state.steps < 0 || state.steps > most_steps)
    throw InputError("the saved state has made " + std::to_string(state.steps) +
                     " steps, expected 0 to 2^53");
  if (state.model != identity()) {
    const std::string difference = find_difference(*state.model, *identity());
    if (!difference.empty()) throw InputError("the saved state is of another model: " + difference);
  }
  const std::size_t table_count = model->count_state();
  const std::size_t of_events = events ? events->count_saved() : 0;
  const std::size_t count = table_count + of_events + doubles(seen).size();
  if (state.values.size() != count)
    throw InputError("the saved state has " + counted(std::ssize(state.values), "value") +
                     ", expected " + std::to_string(count) +
                     ", as where loads between blades act on one of the two simulations only");
  require_finite(state);
  Observations before;
  const std::span<double> observed = doubles(before);
  std::copy(state.values.end() - static_cast<std::ptrdiff_t>(observed.size()), state.values.end(),
            observed.begin());
  const auto has_body = [this](std::int64_t subsystem, std::int64_t body) {
    return model->has_body(subsystem, body);
  };
  const auto has_loop_row = [this](std::int64_t subsystem, std::int64_t row) {
    return model->has_loop_row(subsystem, row);
  };
  if (!is_possible(before, has_body, has_loop_row))
    throw InputError("the saved state names a body or a loop that there is not");
  const std::span<const double> saved_events =
      std::span<const double>(state.values).subspan(table_count, of_events);
  if (events && !events->is_possible(saved_events, state.steps))
    throw InputError("the saved state has events at steps that it has not made");
  if (control) control->restore(state.control, state.steps);
  if (events) events->restore(saved_events);
  put_drive_in_force();
  seen = before;
  put(state.values, state.steps);
  evaluations = state.evaluations;
  work = {state.work, state.dissipated};
  SimulationLog::log_restored(scenario, static_cast<double>(state.steps) * step_size, state.steps);
}

/// Puts the drive into the model that controller and events of a restored state demand.
void SimulationCore::put_drive_in_force() {
  if (!control && !events) return;
  const Drive own = control ? control->make_drive() : own_drive(0);
  model->drive(0) = events ? events->act_on(own) : own;
  if (events) events->set_own_drive(own);
}

/// Puts the coordinates of a state of this model into the table.
void SimulationCore::put(std::span<const double> values, std::int64_t steps) {
  model->context().table().put_state(values.first(model->count_state()), steps);
  runner->continue_from(steps);
  measured_step = evaluated_step = -1;
  loads_are_stale = true;
}

void SimulationCore::begin_again(const Scenario& next, std::span<const double> start) {
  assert(may_begin_again(next) && !model->context().table().has_loads());
  check_scenario(next);
  put(start, 0);
  given = scenario = next;
  identity_.reset();
  evaluations = 0;
  work = {};
  seen = {};
  log = {};
  loads_are_stale = false;
  model->begin_drive(drive_of(scenario));
  begin();
}

bool may_begin_again(const Scenario& scenario) {
  return scenario.initial.state != InitialState::equilibrium &&
         !(scenario.space && (scenario.space->outer_control || !scenario.space->events.empty()));
}

/// Whether the energies of every step are looked at.
bool SimulationCore::stops_on_growth() const {
  return scenario.limits.energy_growth > 0.0 &&
         scenario.limits.on_energy_growth == EnergyGrowth::stop;
}

template <class Advance>
void SimulationCore::require_done(const Advance& advance) {
  const Calling calling(*this);
  try {
    const StepOutcome outcome = advance();
    if (outcome != StepOutcome::done) throw_failure(outcome, runner->steps() + 1);
  } catch (const EnergyHasGrown&) {
    throw_failure(StepOutcome::energy_grew, runner->steps());
  } catch (...) {
    loads_are_stale = true;
    throw;
  }
}

void SimulationCore::count_step(std::int64_t step) {
  const StepRecord& record = model->record(step);
  evaluations += record.passes;
  work.add(record);
  observe_step(static_cast<double>(step), record, scenario.limits.step_error, seen);
}

/// Whether a prescribed motion jumps within the step.
bool SimulationCore::has_jump(std::int64_t step) const {
  const double end = static_cast<double>(step) * step_size, begin = end - step_size;
  return std::any_of(jumps.begin(), jumps.end(), [&](const Jump& jump) {
    return jump.time + jump.duration > begin && jump.time < end;
  });
}

/// Completes a step. Its samples must be in the table if it is observed, or if growth of the energy
/// stops the run.
void SimulationCore::complete_step(std::int64_t step, const StepObserver& observe) {
  count_step(step);
  log_news();
  if (!observe && !stops_on_growth()) return;
  const std::vector<double>& values = model->measure(work, step);
  const GrowthLimit limit{scenario.limits.energy_growth, energy_resolution, has_jump(step)};
  const bool has_grown = observe_energy(static_cast<double>(step), model->balance(), limit, seen);
  const MomentumBalance* momentum = model->momentum();
  const bool is_lost = momentum && observe_momentum(static_cast<double>(step), *momentum,
                                                    scenario.limits.momentum, seen);
  if (has_grown || is_lost) log_news();
  if (observe) observe(static_cast<double>(step) * step_size, values);
  if (has_grown && stops_on_growth()) throw EnergyHasGrown();
}

std::vector<Warning> SimulationCore::make_warnings() const {
  return spoke::make_warnings(scenario, step_size, jumps, seen);
}

/// Logs news of a complete step. Costs no more than some comparisons if there are none.
void SimulationCore::log_news() {
  if (log.has_warnings(seen)) log.log_warnings(scenario, seen, make_warnings());
  if (runner->choices() > log.logged_choices() && runner->steps() > 0)
    log.log_choice(scenario, runner->choices(), runner->describe());
}

void SimulationCore::throw_failure(StepOutcome outcome, std::int64_t step) {
  evaluated_step = -1;
  if (outcome == StepOutcome::load_failed) {
    std::ostringstream at;
    at << "at t = " << static_cast<double>(step) * step_size << " s, step " << step;
    const FailedLoad failed = model->find_failed_load(at.str());
    model->context().table().clear_load_failures();  // what was thrown is the caller's alone
    SimulationLog::log_failure(scenario, failed.sentence);
    try {
      std::rethrow_exception(failed.thrown);
    } catch (...) {
      std::throw_with_nested(LoadError(failed.sentence));
    }
  }
  const DivergenceError error =
      model->diagnose({outcome, static_cast<double>(step) * step_size, step, seen});
  SimulationLog::log_failure(scenario, error.what());
  throw error;
}

}  // namespace spoke
