#include "engine/simulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/formulation/work.h"
#include "engine/load_terms.h"
#include "engine/natural_frequencies.h"
#include "engine/simulation_impl.h"
#include "graph/measuring_executor.h"
#include "models/error.h"
#include "models/nearest_name.h"
#include "models/scenario_check.h"

namespace spoke {
namespace {

[[noreturn]] void throw_no_sensor(std::string_view name, const std::vector<std::string>& names) {
  const std::vector<std::string_view> known(names.begin(), names.end());
  const auto nearest = nearest_name(name, known);
  throw InputError("no sensor is named \"" + std::string(name) + "\"" +
                   (nearest ? ", did you mean \"" + std::string(*nearest) + "\"?"
                            : ", expected one of sensor_names()"));
}

}  // namespace

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

int Simulation::open_window() {
  impl_->open_window();
  return impl_->runner->run_steps();
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

const Drive& Simulation::drive() const { return impl_->context.system.hub.drive; }

void Simulation::set_drive(const Drive& drive) {
  impl_->demand_state("go on from with another drive");
  check_drive(drive);
  Drive& in_force = impl_->context.system.hub.drive;
  check_continuation(in_force, drive, time());
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

}  // namespace spoke
