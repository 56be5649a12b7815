#include "engine/simulation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <utility>

#include "engine/diagnosis.h"
#include "engine/kinematics.h"
#include "engine/load_terms.h"
#include "engine/marker_motion.h"
#include "engine/memory.h"
#include "engine/model_identity.h"
#include "engine/natural_frequencies.h"
#include "engine/observations.h"
#include "engine/pass_ends.h"
#include "engine/sensors.h"
#include "engine/simulation_log.h"
#include "engine/state_values.h"
#include "engine/step_runner.h"
#include "graph/declaration_check.h"
#include "graph/measuring_executor.h"
#include "models/error.h"
#include "models/nearest_name.h"
#include "models/scenario_check.h"

namespace spoke {
namespace {

/// Steps of at most integration.step that divide the duration; a relative slack of 1e-9 keeps round
/// values from gaining one.
std::int64_t count_steps(const Integration& integration) {
  return static_cast<std::int64_t>(
      std::ceil(integration.duration / integration.step * (1.0 - 1e-9)));
}

Method make_method(const Integration& integration, double step) {
  if (integration.method == IntegrationMethod::rk4) return Rk4{step};
  return make_generalized_alpha(integration.spectral_radius, step);
}

/// Memory of the step graph while it is built [bytes]: some 2 kB a node, and a bit for each pair of
/// nodes, by which edges implied by others are found.
double estimate_graph_memory(const System& system) {
  const double nodes = 3.0 + 5.0 * static_cast<double>(system.subsystems.size()) +
                       3.0 * static_cast<double>(system.body_count());
  return 2000.0 * nodes + nodes * nodes / 8.0;
}

void demand_memory(const System& system, Formulation formulation) {
  const double needed = estimate_memory(system, formulation) + estimate_graph_memory(system);
  const double most = 0.8 * available_memory();
  if (needed < most) return;
  const auto gigabytes = [](double bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f GB", bytes / 1e9);
    return std::string(text);
  };
  const bool is_dense = formulation != Formulation::structured;
  throw InputError("the model in the formulation " + std::string(name_of(formulation)) + " needs " +
                   gigabytes(needed) + " of memory, expected at most " + gigabytes(most) +
                   " on this machine: use fewer blades, bodies or elements" +
                   (is_dense ? ", or the formulation structured" : ""));
}

std::uint64_t hash(std::uint64_t value, const double* first, int count) {
  constexpr std::uint64_t kPrime = 1099511628211u;
  const auto* bytes = reinterpret_cast<const unsigned char*>(first);
  for (std::size_t k = 0; k < count * sizeof(double); ++k) value = (value ^ bytes[k]) * kPrime;
  return value;
}

std::vector<double> unpadded(const double* flex, const FlexLayout& layout) {
  std::vector<double> values(flex + layout.u(), flex + layout.u() + layout.axial);
  values.insert(values.end(), flex + layout.v(), flex + layout.v() + layout.bending);
  return values;
}

Wrench wrench_in_space(const Twist& wrench) {
  return {{wrench[0], wrench[1], 0.0}, {0.0, 0.0, wrench[kRotation]}};
}

[[noreturn]] void throw_no_sensor(std::string_view name, const std::vector<std::string>& names) {
  const std::vector<std::string_view> known(names.begin(), names.end());
  const auto nearest = nearest_name(name, known);
  throw InputError("no sensor is named \"" + std::string(name) + "\"" +
                   (nearest ? ", did you mean \"" + std::string(*nearest) + "\"?"
                            : ", expected one of sensor_names()"));
}

/// Throws InputError unless least <= value <= greatest.
void demand_range(const char* what, std::int64_t value, std::int64_t least, std::int64_t greatest) {
  if (value < least || value > greatest)
    throw InputError(std::string(what) + " is " + std::to_string(value) + ", expected " +
                     std::to_string(least) + " to " + std::to_string(greatest));
}

const Scenario& checked(const Scenario& scenario) {
  check_scenario(scenario);
  return scenario;
}

const SimulationOptions& checked(const SimulationOptions& options) {
  demand_range("SimulationOptions::window", options.window, 0, kMostWindow);
  graph::check_threads(options.executor, options.threads);
  return options;
}

/// Throws InputError unless a drive can take over from another at time t [s].
void demand_continuation(const Drive& before, const Drive& after, double t) {
  if (prescribes_motion(before) != prescribes_motion(after))
    throw InputError("a drive " + std::string(name_of(after)) + " cannot take over from " +
                     std::string(name_of(before)) +
                     ": expected one that prescribes the hub's rotation as well, or one that does "
                     "not as well");
  if (!prescribes_motion(after)) return;
  const DriveMotion old = calc_motion(before, t), next = calc_motion(after, t);
  constexpr double slack = 1e-9;
  if (std::abs(old.angle - next.angle) <= slack && std::abs(old.speed - next.speed) <= slack)
    return;
  std::ostringstream text;
  text << "the drive " << name_of(after) << " does not go on from where the hub is at t = " << t
       << " s: it begins at " << next.angle << " rad and " << next.speed << " rad/s, expected "
       << old.angle << " rad and " << old.speed << " rad/s";
  throw InputError(text.str());
}

/// Ends a run at a step whose energy has grown, if the scenario says so. Leaves no function of the
/// simulation.
struct EnergyHasGrown {};

}  // namespace

struct Simulation::Impl {
  Impl(const Scenario& given, const SimulationOptions& chosen, const Loads& loads);

  void step();
  void run_to(std::int64_t target, const StepObserver& observe);
  StepTrace trace(std::int64_t target, const StepObserver& observe,
                  const TraceOptions& trace_options);
  void measure(std::int64_t target, graph::Executor& executor);
  SavedState save();
  std::vector<double> take_values(std::int64_t steps);
  void restore(const SavedState& state);
  void demand_state(const char* use) const;
  void evaluate();
  void renew();
  PlacedMarker place(const Marker& marker) const;
  const BodyData& find_body(int blade, int body) const;

  Scenario scenario;
  SimulationOptions options;
  std::int64_t planned_steps;
  double step_size;
  std::shared_ptr<const std::string> identity;
  StepContext context;
  std::unique_ptr<StepRunner> runner;
  std::int64_t evaluations = 0;
  WorkDone work;
  Observations seen;
  SimulationLog told;
  Sensors sensors;
  /// Sensors are measured when first read after a step.
  std::vector<double> sensor_values;
  std::int64_t measured_step = -1;
  /// The step at whose end accelerations and wrenches were evaluated, and its record.
  std::int64_t evaluated_step = -1;
  SystemRecord evaluated;

 private:
  void prepare(const Loads& loads);
  void demand_kept_declarations();
  bool stops_on_growth() const;
  void count_step(std::int64_t step);
  void complete_step(std::int64_t step, const StepObserver& observe);
  void tell_news();
  template <class Advance>
  void demand_done(const Advance& advance);
  [[noreturn]] void throw_failure(StepOutcome outcome, std::int64_t step);
};

Simulation::Impl::Impl(const Scenario& given, const SimulationOptions& chosen, const Loads& loads)
    : scenario(checked(given)),
      options(checked(chosen)),
      planned_steps(count_steps(given.integration)),
      step_size(given.integration.duration / static_cast<double>(planned_steps)),
      identity(std::make_shared<const std::string>(
          make_identity(scenario, options.formulation, step_size))),
      sensors((prepare(loads), context.system)) {
  const StepOutcome outcome = runner->start();
  if (outcome != StepOutcome::done) throw_failure(outcome, 0);
  sensors.start(context.system, context.data);
  observe_start(sensors.initial_energy(), seen);
  complete_step(0, {});
}

void Simulation::Impl::prepare(const Loads& loads) {
  if (scenario.limits.deflection > 0.0) context.linear_range = scenario.limits.deflection;
  context.system = make_system(scenario.rotor);
  context.formulation = options.formulation;
  context.integrator = {make_method(scenario.integration, step_size),
                        {scenario.integration.tolerance, scenario.integration.iterations,
                         scenario.integration.max_iterations}};
  demand_memory(context.system, context.formulation);
  const RunnerOptions how{options.executor, options.threads, options.window, planned_steps};
  allocate(context, window_records(how, context.system));
  place_loads(loads, context.data);
  runner = std::make_unique<StepRunner>(context, how);
#ifndef NDEBUG
  demand_kept_declarations();
#endif
}

/// Debug builds run every node once on its declared data alone.
[[maybe_unused]] void Simulation::Impl::demand_kept_declarations() {
  constexpr int kLargest = 500;  // nodes: the check costs their number times the memory
  if (runner->step_graph().node_count() > kLargest) return;
  for (const graph::DeclarationFault& fault : graph::check_declarations(runner->step_graph()))
    throw Error(ErrorCode::internal, fault.message);
  clear_load_failures(context.data);
}

void Simulation::Impl::step() {
  if (runner->steps() >= planned_steps) return;
  demand_done([this] {
    return runner->advance_one([this](std::int64_t step) {
      if (stops_on_growth()) Sensors::sample(context.system, step, context.data);
      complete_step(step, {});
    });
  });
}

void Simulation::Impl::run_to(std::int64_t target, const StepObserver& observe) {
  const auto completed = [this, &observe](std::int64_t step) { complete_step(step, observe); };
  const bool observed = observe || stops_on_growth();
  demand_done(
      [&] { return runner->advance_to(std::min(target, planned_steps), observed, completed); });
}

StepTrace Simulation::Impl::trace(std::int64_t target, const StepObserver& observe,
                                  const TraceOptions& trace_options) {
  const auto completed = [this, &observe](std::int64_t step) { complete_step(step, observe); };
  const bool observed = observe || stops_on_growth();
  // The start counts as a step.
  const double passes_per_step =
      std::max(static_cast<double>(usual_passes(context.integrator)),
               static_cast<double>(evaluations) / static_cast<double>(runner->steps() + 1));
  StepTrace trace;
  demand_done([&] {
    return runner->advance_traced(std::min(target, planned_steps), observed, completed,
                                  passes_per_step, trace_options, trace);
  });
  return trace;
}

void Simulation::Impl::measure(std::int64_t target, graph::Executor& executor) {
  demand_done([&] {
    return runner->advance_by(executor, std::min(target, planned_steps),
                              [this](std::int64_t step) { complete_step(step, {}); });
  });
}

void Simulation::Impl::demand_state(const char* use) const {
  const StepData& data = context.data;
  if (!are_together(data) || last_complete_step(data) != runner->steps())
    throw StateError(std::string("there is no state to ") + use +
                     ": a step failed or was not brought to its end");
}

/// Brings accelerations and wrenches to the state at the last step's end.
void Simulation::Impl::evaluate() {
  demand_state("evaluate");
  if (evaluated_step == runner->steps()) return;
  const StepOutcome outcome = runner->evaluate(false, evaluated);
  if (outcome != StepOutcome::done) throw_failure(outcome, runner->steps());
  evaluated_step = runner->steps();
}

/// The same, after a force has changed: the next step starts from it.
void Simulation::Impl::renew() {
  evaluated_step = -1;
  const StepOutcome outcome = runner->evaluate(true, evaluated);
  if (outcome != StepOutcome::done) throw_failure(outcome, runner->steps());
}

PlacedMarker Simulation::Impl::place(const Marker& marker) const {
  return place_marker("the marker", marker, context.data);
}

const BodyData& Simulation::Impl::find_body(int blade, int body) const {
  const auto& blades = context.data.subsystems;
  demand_range("the index of the blade", blade, 0, static_cast<std::int64_t>(blades.size()) - 1);
  const auto& bodies = blades[static_cast<std::size_t>(blade)].bodies;
  demand_range("the index of the body", body, 0, static_cast<std::int64_t>(bodies.size()) - 1);
  return bodies[static_cast<std::size_t>(body)];
}

SavedState Simulation::Impl::save() {
  demand_state("save");
  const std::int64_t steps = runner->steps();
  return {identity,
          static_cast<double>(steps) * step_size,
          steps,
          evaluations,
          work.by_drive_and_loads,
          work.dissipated,
          take_values(steps)};
}

/// The values of the table, then what was observed.
std::vector<double> Simulation::Impl::take_values(std::int64_t steps) {
  std::vector<double> values = take_state_values(steps, context.data);
  const std::span<const double> observed = doubles(seen);
  values.insert(values.end(), observed.begin(), observed.end());
  return values;
}

void Simulation::Impl::restore(const SavedState& state) {
  StepData& data = context.data;
  constexpr std::int64_t most_steps = std::int64_t{1} << 53;  // clocks count in doubles
  if (!state.model) throw InputError("the saved state is empty");
  if (state.steps < 0 || state.steps > most_steps)
    throw InputError("the saved state has made " + std::to_string(state.steps) +
                     " steps, expected 0 to 2^53");
  if (state.model != identity) {
    const std::string difference = find_difference(*state.model, *identity);
    if (!difference.empty()) throw InputError("the saved state is of another model: " + difference);
  }
  const std::size_t count = count_state_values(data) + doubles(seen).size();
  if (state.values.size() != count)
    throw InputError("the saved state has " + std::to_string(state.values.size()) +
                     " values, expected " + std::to_string(count));
  Observations before;
  const std::span<double> observed = doubles(before);
  std::copy(state.values.end() - static_cast<std::ptrdiff_t>(observed.size()), state.values.end(),
            observed.begin());
  if (!is_possible(before, scenario.rotor))
    throw InputError("the saved state names a body that there is not");
  seen = before;
  put_state_values(state.values, state.steps, data);
  runner->continue_from(state.steps);
  evaluations = state.evaluations;
  work = {state.work, state.dissipated};
  measured_step = evaluated_step = -1;
  SimulationLog::tell_restored(scenario, static_cast<double>(state.steps) * step_size, state.steps);
}

/// Whether the energies of every step are looked at.
bool Simulation::Impl::stops_on_growth() const {
  return scenario.limits.energy_growth > 0.0 &&
         scenario.limits.on_energy_growth == EnergyGrowth::stop;
}

template <class Advance>
void Simulation::Impl::demand_done(const Advance& advance) {
  try {
    const StepOutcome outcome = advance();
    if (outcome != StepOutcome::done) throw_failure(outcome, runner->steps() + 1);
  } catch (const EnergyHasGrown&) {
    throw_failure(StepOutcome::energy_grew, runner->steps());
  }
}

void Simulation::Impl::count_step(std::int64_t step) {
  const StepRecord& record = of_step(context.data.records, step).step;
  evaluations += static_cast<std::int64_t>(record.passes);
  work.add(record);
  observe_step(static_cast<double>(step), record, seen);
}

/// The samples of the step must be in the table if it is observed, or growth of the energy stops.
void Simulation::Impl::complete_step(std::int64_t step, const StepObserver& observe) {
  count_step(step);
  tell_news();
  if (!observe && !stops_on_growth()) return;
  const std::vector<double>& values = sensors.measure(context.system, work, step, context.data);
  const bool has_grown = observe_energy(static_cast<double>(step), sensors.balance(),
                                        scenario.limits.energy_growth, seen);
  if (has_grown) tell_news();
  if (observe) observe(static_cast<double>(step) * step_size, values);
  if (has_grown && stops_on_growth()) throw EnergyHasGrown();
}

/// Tells the log what a complete step has brought. No more than some comparisons if there is
/// nothing.
void Simulation::Impl::tell_news() {
  if (told.has_warnings(seen)) told.tell_warnings(scenario, step_size, seen);
  if (!told.has_told_choice() && runner->steps() > 0 && runner->has_chosen())
    told.tell_choice(scenario, runner->describe());
}

void Simulation::Impl::throw_failure(StepOutcome outcome, std::int64_t step) {
  evaluated_step = -1;
  if (outcome == StepOutcome::load_failed) {
    const FailedLoad load = find_failed_load(context.data);
    std::ostringstream text;
    text << "the load \"" << load.name << "\" of blade " << load.blade + 1
         << " failed at t = " << static_cast<double>(step) * step_size << " s, step " << step
         << ": " << load.reason;
    SimulationLog::tell_failure(scenario, text.str());
    throw LoadError(text.str());
  }
  const std::string text = describe_failure(
      scenario, context, {outcome, static_cast<double>(step) * step_size, step, seen});
  SimulationLog::tell_failure(scenario, text);
  throw DivergenceError(text);
}

Simulation::Simulation(const Scenario& scenario, const SimulationOptions& options,
                       const Loads& loads)
    : impl_(std::make_unique<Impl>(scenario, options, loads)) {
  SimulationLog::tell_built(*this);
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

const Scenario& Simulation::scenario() const { return impl_->scenario; }
const SimulationOptions& Simulation::options() const { return impl_->options; }

ModelSize Simulation::size() const {
  const System& system = impl_->context.system;
  ModelSize size;
  size.subsystems = static_cast<int>(system.subsystems.size());
  size.bodies = system.body_count();
  size.coordinates = system.deformation_count();
  for (int c = 0; c < kTwist; ++c) size.coordinates += !is_prescribed(system.hub, c);
  size.joints = size.bodies;
  size.graph_nodes = impl_->runner->step_graph().node_count();
  size.graph_edges = impl_->runner->step_graph().edge_count();
  size.memory_bytes = static_cast<std::size_t>(estimate_memory(system, impl_->context.formulation));
  return size;
}

const graph::StepGraph& Simulation::step_graph() const { return impl_->runner->step_graph(); }

const graph::StepGraph& Simulation::run_graph() const { return impl_->runner->run_graph(); }

LinearProperties Simulation::linear_properties() const {
  const FrequencyRange range = calc_frequency_range(impl_->scenario.rotor);
  return {range.lowest, range.highest, calc_rk4_largest_step(range)};
}

std::string_view Simulation::executor_name() const { return name_of(impl_->options.executor); }
std::string Simulation::executor_description() const { return impl_->runner->describe(); }
graph::Threads Simulation::threads() const { return impl_->runner->threads(); }
double Simulation::time() const { return static_cast<double>(steps()) * impl_->step_size; }
double Simulation::step_size() const { return impl_->step_size; }
std::int64_t Simulation::steps() const { return impl_->runner->steps(); }
std::int64_t Simulation::planned_steps() const { return impl_->planned_steps; }
std::int64_t Simulation::evaluations() const { return impl_->evaluations; }

void Simulation::step() { impl_->step(); }

void Simulation::run_until(double t, const StepObserver& observe) {
  const double steps_to_t = std::ceil(t / impl_->step_size - 0.5);
  if (!(steps_to_t > 0.0)) return;
  impl_->run_to(
      static_cast<std::int64_t>(std::min(steps_to_t, static_cast<double>(impl_->planned_steps))),
      observe);
}

void Simulation::stop() { impl_->runner->stop(); }

SavedState Simulation::save() const { return impl_->save(); }
void Simulation::restore(const SavedState& state) { impl_->restore(state); }
StepTrace Simulation::trace(std::int64_t step_count, const StepObserver& observe,
                            const TraceOptions& options) {
  demand_range("the number of steps to trace", step_count, 1, planned_steps() - steps());
  return impl_->trace(steps() + step_count, observe, options);
}

NodeMeasurement Simulation::measure_nodes(std::int64_t step_count, graph::NodeOrder order) {
  demand_range("the number of steps to measure", step_count, 1, planned_steps() - steps());
  graph::MeasuringExecutor executor(run_graph(), order);
  impl_->measure(steps() + step_count, executor);
  return {executor.node_costs(), executor.run_times(), executor.between_runs(),
          static_cast<double>(executor.runs()) / static_cast<double>(step_count)};
}

const std::vector<std::string>& Simulation::sensor_names() const { return impl_->sensors.names(); }
const std::vector<std::string>& Simulation::sensor_units() const { return impl_->sensors.units(); }

std::span<const double> Simulation::sensor_values() const {
  if (impl_->measured_step != steps()) {
    Sensors::sample(impl_->context.system, steps(), impl_->context.data);
    impl_->sensor_values =
        impl_->sensors.measure(impl_->context.system, impl_->work, steps(), impl_->context.data);
    impl_->measured_step = steps();
  }
  return impl_->sensor_values;
}

std::size_t Simulation::sensor_index(std::string_view name) const {
  const auto& names = sensor_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw_no_sensor(name, names);
  return static_cast<std::size_t>(found - names.begin());
}

double Simulation::sensor(std::string_view name) const {
  return sensor_values()[sensor_index(name)];
}

std::vector<Warning> Simulation::warnings() const {
  return make_warnings(impl_->scenario, impl_->step_size, impl_->seen);
}

HubMotion Simulation::hub() const {
  const CoordinateBlock& hub = impl_->context.data.hub_coordinates;
  return {Twist(hub.q[0], hub.q[1], hub.q[2]), Twist(hub.v[0], hub.v[1], hub.v[2]),
          Twist(hub.a[0], hub.a[1], hub.a[2])};
}

BodyState Simulation::body(int blade, int body) const {
  const BodyData& data = impl_->find_body(blade, body);
  return {unpadded(data.coordinates.q, data.layout), unpadded(data.coordinates.v, data.layout),
          unpadded(data.coordinates.a, data.layout)};
}

void Simulation::calc_shape(int blade, BladeShape& shape) const {
  impl_->find_body(blade, 0);
  StepContext& context = impl_->context;
  const auto index = static_cast<std::size_t>(blade);
  spoke::calc_shape(impl_->scenario.rotor.blades[index], context.system.subsystems[index],
                    context.data.subsystems[index], shape);
}

MarkerState Simulation::marker(const Marker& marker) const {
  const PlacedMarker placed = impl_->place(marker);
  impl_->evaluate();
  const System& system = impl_->context.system;
  const auto blade = static_cast<std::size_t>(marker.blade);
  const Subsystem& subsystem = system.subsystems[blade];
  const SubsystemData& data = impl_->context.data.subsystems[blade];
  MarkerState state{calc_marker_motion(subsystem, data, placed)};
  const Twist acceleration = calc_marker_acceleration(system, data, placed);
  state.acceleration = in_space(Position(acceleration.head<kPosition>()));
  state.angular_acceleration.z() = acceleration[kRotation];
  const double x = (marker.body + marker.station) *
                   data.bodies[static_cast<std::size_t>(marker.body)].model->body->length;
  const Eigen::Vector3d in_hub =
      in_space(data.hub->R).transpose() * (state.position - in_space(data.hub->p));
  state.deflection = in_hub - in_space(subsystem.root.p + subsystem.root.R * Position{x, 0.0});
  state.foreshortening =
      in_space(calc_marker_foreshortening(subsystem, data, marker.body, marker.station));
  return state;
}

Wrench Simulation::joint_reaction(int blade, int joint) const {
  impl_->place({blade, joint, 0.0});
  impl_->evaluate();
  const SubsystemData& data = impl_->context.data.subsystems[static_cast<std::size_t>(blade)];
  const Twist& wrench = data.wrenches[static_cast<std::size_t>(joint)].inboard;
  return wrench_in_space(data.hub->R * calc_rotation_to_hub(data, joint) * wrench);
}

Wrench Simulation::hub_reaction() const {
  impl_->evaluate();
  Twist wrench = impl_->evaluated.step.reaction;
  wrench[kRotation] += impl_->evaluated.applied_torque;
  return wrench_in_space(impl_->context.data.subsystems.front().hub->R * wrench);
}

Wrench Simulation::section_force(const Marker& marker) const {
  const PlacedMarker placed = impl_->place(marker);
  impl_->evaluate();
  const auto blade = static_cast<std::size_t>(marker.blade);
  return wrench_in_space(calc_section_force(
      impl_->scenario.rotor.blades[blade], impl_->context.system.damping,
      impl_->context.data.subsystems[blade].bodies[static_cast<std::size_t>(marker.body)],
      placed.section));
}

const Drive& Simulation::drive() const { return impl_->context.system.hub.drive; }

void Simulation::set_drive(const Drive& drive) {
  impl_->demand_state("go on from with another drive");
  check_drive(drive);
  Drive& in_force = impl_->context.system.hub.drive;
  demand_continuation(in_force, drive, time());
  const Drive before = std::exchange(in_force, drive);
  try {
    impl_->renew();
  } catch (...) {
    in_force = before;
    throw;
  }
}

void Simulation::set_load(int index, std::shared_ptr<const Load> load) {
  impl_->demand_state("go on from with another load");
  LoadData& data = find_load(index, impl_->context.data);
  demand_same_markers(load, data);
  data.load.swap(load);
  try {
    impl_->renew();
  } catch (...) {
    data.load.swap(load);
    throw;
  }
}

std::uint64_t Simulation::state_hash() const {
  const StepData& data = impl_->context.data;
  std::uint64_t value = 14695981039346656037u;
  value = hash(value, data.hub_coordinates.q, kTwist);
  value = hash(value, data.hub_coordinates.v, kTwist);
  for (const SubsystemData& subsystem : data.subsystems)
    for (const BodyData& body : subsystem.bodies)
      for (const double* flex : {body.coordinates.q, body.coordinates.v}) {
        value = hash(value, flex + body.layout.u(), body.layout.axial);
        value = hash(value, flex + body.layout.v(), body.layout.bending);
      }
  return value;
}

}  // namespace spoke
