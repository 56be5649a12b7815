// Builds, steps and saves a simulation; queries of its bodies are in simulation_queries.cpp.

#include "engine/simulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/simulation/require_range.h"
#include "engine/simulation/simulation_core.h"
#include "models/error.h"
#include "models/reader/scenario_check.h"
#include "models/support/nearest_name.h"

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
    : core_(std::make_unique<SimulationCore>(scenario, options, loads)) {
  SimulationLog::log_built(scenario, options.formulation, size(), planned_steps(), step_size(),
                           executor_name(), threads());
  core_->log.log_warnings(scenario, core_->seen, core_->make_warnings());
}
Simulation::Simulation(std::unique_ptr<SimulationCore> core) : core_(std::move(core)) {}
Simulation Simulation::clone() const { return Simulation(core_->clone()); }
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

const Scenario& Simulation::scenario() const { return core_->given; }
const SimulationOptions& Simulation::options() const { return core_->options; }

ModelSize Simulation::size() const {
  const ModelExtent extent = core_->model->extent();
  ModelSize size;
  size.subsystems = extent.subsystems;
  size.bodies = extent.bodies;
  size.coordinates = extent.coordinates;
  size.joints = size.bodies;
  size.loops = extent.loops;
  size.couplings = extent.couplings;
  size.freedoms = extent.coordinates - extent.independent_rows;
  size.graph_nodes = core_->runner->step_graph().node_count();
  size.graph_edges = core_->runner->step_graph().edge_count();
  size.memory_bytes = static_cast<std::size_t>(core_->model->memory_bytes());
  return size;
}

const graph::StepGraph& Simulation::step_graph() const { return core_->runner->step_graph(); }

const graph::StepGraph& Simulation::run_graph() const { return core_->runner->run_graph(); }

std::string_view Simulation::executor_name() const { return core_->runner->executor_name(); }
std::string Simulation::executor_description() const { return core_->runner->describe(); }
graph::Threads Simulation::threads() const { return core_->runner->threads(); }
double Simulation::time() const { return static_cast<double>(steps()) * core_->step_size; }
double Simulation::step_size() const { return core_->step_size; }
std::int64_t Simulation::steps() const { return core_->runner->steps(); }
std::int64_t Simulation::planned_steps() const { return core_->planned_steps; }
std::int64_t Simulation::evaluations() const { return core_->evaluations; }

void Simulation::step() { core_->step(); }

void Simulation::run_until(double t, const StepObserver& observe) {
  if (std::isnan(t)) throw InputError("run_until(): the time is not a number");
  const double steps_to_t = std::ceil(t / core_->step_size - 0.5);
  if (!(steps_to_t > 0.0)) return;
  core_->run_to(
      static_cast<std::int64_t>(std::min(steps_to_t, static_cast<double>(core_->planned_steps))),
      observe);
}

void Simulation::stop() { core_->runner->stop(); }

SavedState Simulation::save() const { return core_->save(); }
void Simulation::restore(const SavedState& state) { core_->restore(state); }
StepTrace Simulation::trace(std::int64_t step_count, const StepObserver& observe,
                            const TraceOptions& options) {
  require_range("the number of steps to trace", step_count, 1, planned_steps() - steps());
  return core_->trace(steps() + step_count, observe, options);
}

SimulationCore& core_of(Simulation& simulation) { return *simulation.core_; }

const std::vector<std::string>& Simulation::sensor_names() const {
  return core_->model->sensor_names();
}
const std::vector<std::string>& Simulation::sensor_units() const {
  return core_->model->sensor_units();
}

std::span<const double> Simulation::sensor_values() const { return core_->values(); }

std::size_t Simulation::sensor_index(std::string_view name) const {
  const auto& names = sensor_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw_no_sensor(name, names);
  return static_cast<std::size_t>(found - names.begin());
}

double Simulation::sensor(std::string_view name) const {
  return sensor_values()[sensor_index(name)];
}

std::vector<Warning> Simulation::warnings() const { return core_->make_warnings(); }
StepAccuracy Simulation::step_accuracy() const {
  return make_accuracy(core_->scenario, core_->step_size, core_->seen);
}

const Drive& Simulation::drive(std::string_view rotor) const {
  return core_->model->drive(core_->find_rotor(rotor));
}

void Simulation::set_drive(const Drive& drive, std::string_view rotor) {
  const int number = core_->find_rotor(rotor);
  core_->require_state("go on from with another drive");
  check_drive(drive);
  check_continuation(core_->model->drive(number), drive, time());
  core_->set_drive(drive, number);
}

int Simulation::joint_index(int tree, std::string_view name) const {
  return core_->joints("the name of a joint").find(tree, name);
}

CoordinateMotion Simulation::joint_motion(int tree, int joint, int coordinate) const {
  const space::PrescribedMotion motion =
      core_->joints("the motion of a joint").motion({tree, joint, coordinate}, time());
  return {motion.value, motion.rate, motion.acceleration};
}

void Simulation::set_joint_motion(int tree, int joint, int coordinate,
                                  const CoordinateMotion& motion) {
  core_->set_joint_motion(
      {tree, joint, coordinate}, {motion.value, motion.velocity, motion.acceleration},
      space::SaidMotion{time(), motion.value, motion.velocity, motion.acceleration});
}

void Simulation::set_joint_course(int tree, int joint, int coordinate, const Curve& course) {
  const double t = time();
  core_->set_joint_motion({tree, joint, coordinate},
                          {course.value(t), course.derivative(t), course.second_derivative(t)},
                          spatial::MotionTable{course});
}

AnchorMotion Simulation::anchor_motion(std::string_view anchor) const {
  return vectors_of<AnchorMotion>(core_->model->anchors().motion(anchor, time()));
}

void Simulation::set_anchor_motion(std::string_view anchor, const AnchorMotion& motion) {
  const SaidAnchorMotion said = motion_since(time(), motion);
  core_->set_anchor_motion(anchor, said, said);
}

void Simulation::set_anchor_course(std::string_view anchor, const spatial::MountMotion& course) {
  const double t = time();
  const AnchorModel model{std::string(anchor), Anchor::Frame::mount, false, course, {}, 0};
  core_->set_anchor_motion(anchor, motion_of(model, t), course);
}

void Simulation::set_load(int index, std::shared_ptr<const Load> load) {
  core_->require_state("go on from with another load");
  core_->replace(core_->model->replaceable_load(index, load), load);
}

}  // namespace spoke
