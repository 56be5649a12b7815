// A model in space, as a simulation sees it.

#include "engine/simulation/spatial_model.h"

#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include "engine/columns/spatial_columns.h"
#include "engine/kernels/hub_motion.h"
#include "engine/kernels/joint_values.h"
#include "engine/kernels/kinematics.h"
#include "engine/kernels/load_terms.h"
#include "engine/kernels/readings.h"
#include "engine/kernels/spatial_samples.h"
#include "engine/simulation/spatial_sensors.h"
#include "engine/simulation/spatial_views.h"
#include "engine/space/deformation_limits.h"
#include "engine/step/model_memory.h"
#include "engine/step/put_bodies.h"
#include "engine/step/share_subsystems.h"
#include "engine/table/state_values.h"
#include "engine/vibration/frequency_limits.h"
#include "models/count_text.h"
#include "models/error.h"
#include "models/system/spatial_system.h"

namespace spoke {
namespace {

/// "rotation ty of node 3".
std::string name_coordinate(const space::LimitViolation& at) {
  static constexpr const char* kNames[] = {"displacement u", "displacement v", "displacement w",
                                           "rotation tx",    "rotation ty",    "rotation tz"};
  return std::string(kNames[at.component]) + " of node " + std::to_string(at.node);
}

class SpatialModel final : public SimulatedModel {
 public:
  SpatialModel(const Scenario& scenario, Formulation formulation, const Integrator& integrator,
               const Loads& loads)
      : scenario_(scenario), trees_(build_trees(*scenario.space)), loads_(ask_loads(loads)) {
    if (scenario.limits.deflection > 0.0) context_.linear_range = scenario.limits.deflection;
    context_.system = make_system(*scenario.space, trees_);
    context_.formulation = formulation;
    context_.integrator = integrator;
    require_azimuth_motion();
    context_.loads_tie_blades = ties_blades(loads_);
    require_memory(context_.system, formulation);
    keeps_momentum_ = loads.empty() && keeps_momentum(scenario);
  }

  StepContext& context() override { return context_; }
  SystemContext<Space>* space() override { return &context_; }
  SpatialJoints* joints() override { return &joints_; }

  double ring_bytes() const override {
    std::size_t values = 0;
    for (const Subsystem<Space>& subsystem : context_.system.subsystems)
      values += static_cast<std::size_t>(count_joint_values(subsystem));
    values += count_readings(with_momentum(scenario_, keeps_momentum_),
                             scenario_.space->blades.size(), trees_);
    return spoke::ring_bytes(context_.system, values);
  }
  void allocate(int records) override {
    spoke::allocate(context_, records);
    place_loads(loads_, context_.data);
    std::vector<SubsystemData<Space>>& subsystems = context_.data.subsystems;
    for (std::size_t i = 0; i < subsystems.size(); ++i)
      subsystems[i].reading_count =
          static_cast<std::size_t>(count_joint_values(context_.system.subsystems[i]));
    std::vector<SensorColumn> asked =
        place_sensors(with_momentum(scenario_, keeps_momentum_), scenario_.space->blades.size(),
                      trees_, context_.system, context_.data);
    make_reading_rings(context_.data);
    std::vector<SensorColumn> momentum = take_momentum(scenario_, keeps_momentum_, asked);
    sensors_.emplace(context_.system, trees_, std::move(asked), std::move(momentum));
  }

  void share_out(Exchange& exchange) override { spoke::share_out(exchange, context_); }
  std::vector<double> weights() const override { return weights_of(context_.data); }

  void put_bodies(const std::vector<Eigen::VectorXd>& q) override {
    spoke::put_bodies(q, context_);
  }

  ModelExtent extent() const override {
    const System<Space>& system = context_.system;
    ModelExtent extent{static_cast<int>(system.subsystems.size()), system.body_count(),
                       system.deformation_count()};
    for (const Subsystem<Space>& subsystem : system.subsystems)
      for (const TreeBody<Space>& body : subsystem.bodies)
        extent.coordinates += body.joint.joint.coordinates;
    for (int c = 0; c < Space::kTwist; ++c) extent.coordinates += !is_prescribed(system.hub, c);
    return extent;
  }
  double memory_bytes() const override {
    return estimate_model_memory(context_.system, context_.formulation) +
           static_cast<double>(count_reading_bytes(context_.data));
  }
  std::size_t count_state() override { return count_state_values(context_.data); }
  std::uint64_t hash() const override { return hash_state(context_.data); }
  bool has_body(std::int64_t blade, std::int64_t body) const override {
    const auto& trees = context_.system.subsystems;
    return blade >= 0 && blade < std::ssize(trees) && body >= 0 &&
           body < std::ssize(trees[static_cast<std::size_t>(blade)].bodies);
  }
  Drive& drive() override { return context_.system.hub.drive; }
  void begin_drive(const Drive& drive) override {
    context_.system.hub.drive = drive;
    put_hub_at_start(context_);
  }
  std::shared_ptr<const Load>& replaceable_load(int index,
                                                const std::shared_ptr<const Load>& other) override {
    LoadData<Space>& load = find_load(index, context_.data);
    require_same_markers(other, load);
    return load.load;
  }

  void require_place(const Marker& marker) const override {
    place_marker("the marker", marker, context_.data);
  }
  MarkerState marker(const Marker& marker, double t) const override {
    return calc_marker_state(context_, marker, t);
  }
  Wrench joint_reaction(int blade, int joint) const override {
    return calc_joint_reaction(context_, blade, joint);
  }
  Wrench hub_reaction() const override { return calc_hub_reaction(context_.data); }
  Wrench section_force(const Marker& marker) const override {
    return calc_section_force(context_, marker);
  }

  const std::vector<std::string>& sensor_names() const override { return sensors_->names(); }
  const std::vector<std::string>& sensor_units() const override { return sensors_->units(); }
  double start_sensors() override {
    sample(0, 0.0);
    sensors_->start(context_.system, context_.data);
    return sensors_->initial_energy();
  }
  double energy_resolution() const override {
    const double tolerance = scenario_.integration.tolerance;
    double stiffness = 0.0;
    for (const Subsystem<Space>& subsystem : context_.system.subsystems)
      for (const TreeBody<Space>& body : subsystem.bodies)
        if (const space::FlexibleBody* flexible = body.body->flexible())
          for (const space::TwistMatrix& block : flexible->K.diagonal) stiffness += block.trace();
    return 0.5 * stiffness * tolerance * tolerance;
  }
  void sample(std::int64_t step, double t) override {
    for (std::size_t i = 0; i < context_.data.subsystems.size(); ++i) {
      const Subsystem<Space>& subsystem = context_.system.subsystems[i];
      SubsystemData<Space>& data = context_.data.subsystems[i];
      prescribe_joints(context_.system, t, i, context_.data);
      update_kinematics(subsystem, data);
      of_step(data.samples, step) = calc_sample(context_.system, i, data);
      keep_joint_values(subsystem, step, data);
      if (!data.readings.empty()) calc_readings(context_.system, i, step, t, context_.data);
    }
  }
  const std::vector<double>& measure(const WorkDone& work, std::int64_t step) override {
    return sensors_->measure(context_.system, work, step, context_.data);
  }
  const EnergyBalance& balance() const override { return sensors_->balance(); }
  const MomentumBalance* momentum() const override { return sensors_->momentum(); }
  const StepRecord& record(std::int64_t step) const override {
    return of_step(context_.data.records, step).step;
  }

  void calc_shape(int tree, double t, TreeShape& shape) override {
    const auto i = static_cast<std::size_t>(tree);
    const Subsystem<Space>& subsystem = context_.system.subsystems[i];
    SubsystemData<Space>& data = context_.data.subsystems[i];
    prescribe_joints(context_.system, t, i, context_.data);
    spoke::calc_shape(subsystem, data, rotor_placement(scenario_.space->hub).rotation, shape);
  }
  HubPose hub_pose() const override {
    const HubState<Space> hub = calc_hub_state(context_.data);
    return {hub.p, hub.R.axes * rotor_placement(scenario_.space->hub).rotation.transpose()};
  }

  MarkerState hub_frame(double t) const override { return calc_hub_frame(context_, t); }

  DivergenceError diagnose(const FailedStep& failed) const override {
    Divergence at{.time = failed.time, .step = failed.step};
    const std::string finding = find(failed, at);
    std::ostringstream text;
    text << "diverged at t = " << failed.time << " s, step " << failed.step << ": " << finding
         << "; ";
    const double h = step_size(context_.integrator);
    const std::string jump = blame_jump(find_jumps(scenario_, h), failed.time, h);
    if (const std::string cause = jump.empty() ? blame_rk4() : jump; !cause.empty())
      text << cause;
    else if (failed.outcome == StepOutcome::energy_grew)
      text << advise_on_growth(scenario_, h, failed.seen);
    else
      text << "take a smaller integration.step, more bodies per beam, "
           << "geometric_stiffening where a body turns fast, or smaller loads";
    return DivergenceError(text.str(), std::move(at));
  }
  std::string describe_failed_load(const std::string& at) const override {
    std::vector<std::string> names;
    for (const spatial::Tree& tree : trees_) names.push_back(tree.name);
    return spoke::describe_failed_load(context_.data, names, at);
  }

 private:
  /// Whether the step is above the limit of rk4, in words; empty if it is not, or that is not
  /// known.
  std::string blame_rk4() const try {
    constexpr double kNotable = 0.01;  // damping ratio
    const auto* rk4 = std::get_if<Rk4>(&context_.integrator.method);
    if (!rk4) return {};
    const vibration::Rk4Limit limit = vibration::find_rk4_limit(scenario_);
    if (rk4->step <= limit.step) return {};
    const double size = std::abs(limit.root), ratio = -limit.root.real() / size;
    std::ostringstream text;
    text << "the step of " << rk4->step << " s is above the stability limit of rk4, " << limit.step
         << " s (the fastest small motion";
    if (limit.speed != 0.0) text << " at " << limit.speed << " rad/s";
    text << " has a root of " << size << " rad/s";
    if (ratio > kNotable) text << " and a damping ratio of " << ratio;
    text << "): take a smaller integration.step, or generalized_alpha";
    return text.str();
  } catch (const InputError&) {
    return {};
  }

  /// Accelerations of the hub that a stage of rk4 finds come too late for its joints.
  void require_azimuth_motion() const {
    if (!std::holds_alternative<Rk4>(context_.integrator.method)) return;
    for (const Subsystem<Space>& subsystem : context_.system.subsystems)
      if (follows_free_hub(context_.system, subsystem))
        throw InputError(
            "integration.method: is \"rk4\" where a joint's motion follows the azimuth of a hub "
            "that no drive prescribes the rotation of, expected \"generalized_alpha\"");
  }

  std::string name_body(std::size_t i, std::size_t j) const {
    return trees_[i].name + " / " + trees_[i].bodies[j].name;
  }

  /// Puts what has failed, and where, into `at`. Both as a part of the sentence.
  std::string find(const FailedStep& failed, Divergence& at) const {
    if (failed.outcome == StepOutcome::energy_grew) {
      at.quantity = "energy";
      return describe_growth(scenario_, failed.seen);
    }
    if (failed.outcome == StepOutcome::not_converged) {
      at.node = "finish";
      at.quantity = "change of a coordinate";
      std::ostringstream text;
      text << "the iteration does not converge to " << failed_progress(context_.data).tolerance
           << " within " << counted(context_.integrator.limits.most, "iteration")
           << " (node \"finish\")";
      return text.str();
    }
    for (std::size_t i = 0; i < trees_.size(); ++i)
      for (std::size_t j = 0; j < trees_[i].bodies.size(); ++j) {
        const std::string finding = find_in_body(i, j, at.quantity);
        if (finding.empty()) continue;
        at.subsystem = trees_[i].name;
        at.body = trees_[i].bodies[j].name;
        at.node = name_body(i, j) + " / recovery";
        return name_body(i, j) + ": " + at.quantity + finding + " (node \"" + at.node + "\")";
      }
    at.node = context_.formulation == Formulation::augmented ? "solve" : "hub solve";
    at.quantity = "the acceleration of the hub";
    return at.quantity + " is not finite (node \"" + at.node + "\")";
  }

  /// What is wrong with a quantity of a body; nothing if all are fine.
  std::string find_in_body(std::size_t i, std::size_t j, std::string& quantity) const {
    const BodyData<Space>& body = context_.data.subsystems[i].bodies[j];
    if (const space::FlexibleBody* flexible = body.model->body->flexible()) {
      const auto at = space::find_limit_violation(*flexible, body.coordinates.q);
      if (at.node >= 0) {
        quantity = name_coordinate(at);
        if (!std::isfinite(at.value)) return " is not finite";
        std::ostringstream text;
        text << " = " << at.value << " is beyond what its linear model can mean (limit " << at.limit
             << ")";
        return text.str();
      }
    }
    if (std::isfinite(body.X.sum())) return {};
    quantity = "the acceleration of its frame";
    return " is not finite";
  }

  const Scenario& scenario_;
  std::vector<spatial::Tree> trees_;
  std::vector<AskedLoad> loads_;
  bool keeps_momentum_ = false;  ///< free, and nothing acts on it
  SystemContext<Space> context_;
  SpatialJoints joints_{trees_, context_};
  std::optional<SpatialSensors> sensors_;  // once there is a table
};

}  // namespace

std::unique_ptr<SimulatedModel> make_spatial_model(const Scenario& scenario,
                                                   Formulation formulation,
                                                   const Integrator& integrator,
                                                   const Loads& loads) {
  return std::make_unique<SpatialModel>(scenario, formulation, integrator, loads);
}

}  // namespace spoke
