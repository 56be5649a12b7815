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
#include "engine/table/state_values.h"
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
    context_.loads_tie_blades = ties_blades(loads_);
    require_memory(context_.system, formulation);
  }

  StepContext& context() override { return context_; }

  double ring_bytes() const override {
    std::size_t values = 0;
    for (const Subsystem<Space>& subsystem : context_.system.subsystems)
      values += static_cast<std::size_t>(count_joint_values(subsystem));
    values += count_readings(scenario_.sensors, scenario_.space->blades.size(), trees_);
    return spoke::ring_bytes(context_.system, values);
  }
  void allocate(int records) override {
    spoke::allocate(context_, records);
    place_loads(loads_, context_.data);
    std::vector<SubsystemData<Space>>& subsystems = context_.data.subsystems;
    for (std::size_t i = 0; i < subsystems.size(); ++i)
      subsystems[i].reading_count =
          static_cast<std::size_t>(count_joint_values(context_.system.subsystems[i]));
    std::vector<SensorColumn> asked = place_sensors(
        scenario_.sensors, scenario_.space->blades.size(), trees_, context_.system, context_.data);
    make_reading_rings(context_.data);
    sensors_.emplace(context_.system, trees_, std::move(asked));
  }

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
      prescribe_joints(context_.system, t, subsystem, data);
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
  const StepRecord& record(std::int64_t step) const override {
    return of_step(context_.data.records, step).step;
  }

  void calc_shape(int tree, double t, TreeShape& shape) override {
    const auto i = static_cast<std::size_t>(tree);
    const Subsystem<Space>& subsystem = context_.system.subsystems[i];
    SubsystemData<Space>& data = context_.data.subsystems[i];
    prescribe_joints(context_.system, t, subsystem, data);
    spoke::calc_shape(subsystem, data, rotor_placement(scenario_.space->hub).rotation, shape);
  }
  HubPose hub_pose() const override {
    const HubState<Space> hub = calc_hub_state(context_.data);
    return {hub.p, hub.R.axes * rotor_placement(scenario_.space->hub).rotation.transpose()};
  }

  std::string describe_failure(const FailedStep& failed) const override {
    std::ostringstream text;
    text << "diverged at t = " << failed.time << " s, step " << failed.step << ": "
         << describe_finding(failed) << "; take a smaller integration.step, more bodies per beam, "
         << "geometric_stiffening where a body turns fast, or smaller loads";
    return text.str();
  }
  std::string describe_failed_load(const std::string& at) const override {
    std::vector<std::string> names;
    for (const spatial::Tree& tree : trees_) names.push_back(tree.name);
    return spoke::describe_failed_load(context_.data, names, at);
  }

 private:
  std::string name_body(std::size_t i, std::size_t j) const {
    return trees_[i].name + " / " + trees_[i].bodies[j].name;
  }

  std::string describe_finding(const FailedStep& failed) const {
    if (failed.outcome == StepOutcome::energy_grew) return describe_growth(scenario_, failed.seen);
    if (failed.outcome == StepOutcome::not_converged) {
      std::ostringstream text;
      text << "the iteration does not converge to " << context_.integrator.limits.tolerance
           << " within " << counted(context_.integrator.limits.most, "iteration")
           << " (node \"finish\")";
      return text.str();
    }
    for (std::size_t i = 0; i < trees_.size(); ++i)
      for (std::size_t j = 0; j < trees_[i].bodies.size(); ++j) {
        const std::string finding = describe_body(i, j);
        if (!finding.empty()) return finding;
      }
    return "the acceleration of the hub is not finite (node \"hub solve\")";
  }

  /// What is wrong with a body; nothing if it is fine.
  std::string describe_body(std::size_t i, std::size_t j) const {
    const BodyData<Space>& body = context_.data.subsystems[i].bodies[j];
    std::ostringstream text;
    const std::string node = " (node \"" + name_body(i, j) + " / recovery\")";
    if (const space::FlexibleBody* flexible = body.model->body->flexible()) {
      const auto at = space::find_limit_violation(*flexible, body.coordinates.q);
      if (at.node >= 0) {
        text << name_body(i, j) << ": " << name_coordinate(at);
        if (std::isfinite(at.value))
          text << " = " << at.value << " is beyond what its linear model can mean (limit "
               << at.limit << ")";
        else
          text << " is not finite";
        return text.str() + node;
      }
    }
    if (!std::isfinite(body.X.sum()))
      return name_body(i, j) + ": the acceleration of its frame is not finite" + node;
    return {};
  }

  const Scenario& scenario_;
  std::vector<spatial::Tree> trees_;
  std::vector<AskedLoad> loads_;
  SystemContext<Space> context_;
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
