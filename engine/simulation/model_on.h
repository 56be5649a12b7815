#pragma once

// A model of one world on the table: the common part of both worlds.

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/bodies/act/user_load/user_loads.h"
#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/table/state_values.h"
#include "engine/simulation/describe_loops.h"
#include "engine/simulation/planar_model.h"
#include "engine/simulation/require_range.h"
#include "engine/simulation/simulated_model.h"
#include "engine/simulation/spatial_model.h"
#include "engine/simulation/views.h"
#include "engine/step/copy_context.h"
#include "engine/step/formulation/tree_joints.h"
#include "engine/step/loops/loop_start.h"
#include "engine/step/model_memory.h"
#include "engine/step/put_bodies.h"
#include "engine/step/share_subsystems.h"
#include "models/system/spatial_system.h"

namespace spoke {

template <class World>
class ModelOn final : public SimulatedModel {
 public:
  ModelOn(const Scenario& scenario, Formulation formulation, const Integrator& integrator,
          const Loads& loads)
      : scenario_(scenario),
        context_(make_context(scenario, formulation, integrator)),
        own_(scenario, *context_),
        loads_(ask_loads(loads)),
        keeps_momentum_(loads.empty() && keeps_momentum(scenario)) {
    context_->loads_tie_subsystems = ties_subsystems(loads_);
    name_nodes();
    require_memory(system(), formulation);
  }

  /// Begins a copy, see copy().
  ModelOn(const ModelOn& original, const Scenario& scenario)
      : scenario_(scenario),
        context_(std::make_unique<SystemContext<World>>()),
        own_(scenario, *context_, original.own_),
        loads_(original.loads_in_force()),
        keeps_momentum_(original.keeps_momentum_) {
    begin_copy(*original.context_, *context_);
    require_memory(system(), context_->formulation);
  }

  StepContext& context() override { return *context_; }
  SystemContext<Plane>* plane() override { return this->template context_of<Plane>(); }
  SystemContext<Space>* space() override { return this->template context_of<Space>(); }
  SpatialJoints* joints() override { return own_.joints(); }
  Anchors anchors() override { return {scenario_, context_->system.anchors}; }

  double ring_bytes() const override {
    return spoke::ring_bytes(system(), own_.count_readings(asked_sensors()));
  }
  void allocate(int records) override {
    spoke::allocate(*context_, records);
    placed_loads_ = &place_loads(loads_, system(), data());
    std::vector<SensorColumn> asked = own_.place_sensors(asked_sensors());
    std::vector<SensorColumn> momentum = take_momentum(scenario_, keeps_momentum_, asked);
    sensors_.emplace(own_.make_sensors(std::move(asked), std::move(momentum)));
  }
  std::unique_ptr<SimulatedModel> copy(const Scenario& scenario, int records,
                                       std::int64_t steps) override {
    auto made = std::make_unique<ModelOn>(*this, scenario);
    spoke::allocate(*made->context_, records);
    made->placed_loads_ = &place_loads(made->loads_, made->system(), made->data());
    copy_readings(*context_, *made->context_);
    made->sensors_.emplace(*sensors_);  // with what they compare with
    end_copy(*context_, steps, *made->context_);
    return made;
  }
  void share_out(Exchange& exchange) override { spoke::share_out(exchange, *context_); }
  void put_bodies(const std::vector<Eigen::VectorXd>& q) override {
    spoke::put_bodies(q, *context_);
    close_loops(*context_);
  }

  ModelExtent extent() const override {
    ModelExtent extent{static_cast<int>(system().subsystems.size()), system().body_count(),
                       system().deformation_count()};
    for (const Subsystem<World>& subsystem : system().subsystems)
      for (const TreeBody<World>& body : subsystem.bodies)
        extent.coordinates += joint_coordinates(body);
    for (int c = 0; c < World::kTwist; ++c) extent.coordinates += !is_prescribed(system().hub, c);
    for (const Subsystem<World>& subsystem : system().subsystems)
      for (const LoopModel& loop : subsystem.loops)
        if (!loop.is_share) ++(loop.is_coupling() ? extent.couplings : extent.loops);
    for (const SubsystemData<World>& subsystem : data().subsystems)
      for (std::size_t r = 0; r < subsystem.loops.use.size(); ++r)
        extent.independent_rows += subsystem.loops.use[r] == LoopRowUse::solved &&
                                   subsystem.loops.level[r] != LoopRowLevel::share;
    return extent;
  }
  double memory_bytes() const override {
    const double wind = system().wind ? system().wind->memory() : 0.0;
    return estimate_model_memory(system(), context_->formulation) + own_.reading_bytes() + wind;
  }
  std::size_t count_state() override { return count_state_values(data()); }
  std::uint64_t hash() const override { return hash_state(data()); }
  bool has_body(std::int64_t subsystem, std::int64_t body) const override {
    const auto& subsystems = system().subsystems;
    return subsystem >= 0 && subsystem < std::ssize(subsystems) && body >= 0 &&
           body < std::ssize(subsystems[static_cast<std::size_t>(subsystem)].bodies);
  }
  bool has_loop_row(std::int64_t subsystem, std::int64_t row) const override {
    const auto& subsystems = system().subsystems;
    return subsystem >= 0 && subsystem < std::ssize(subsystems) && row >= 0 &&
           row < subsystems[static_cast<std::size_t>(subsystem)].loop_rows();
  }
  Drive& drive(int rotor) override { return drive_of(context_->system, rotor); }
  void begin_drive(const Drive& other) override {
    drive(0) = other;
    put_hub_at_start(*context_);
  }
  std::shared_ptr<const Load>& replaceable_load(int index,
                                                const std::shared_ptr<const Load>& other) override {
    LoadData<World>& load = placed_loads_->find(index);
    require_same_markers(other, load.given);
    return load.load;
  }

  void require_place(const Marker& marker) const override {
    place_marker("the marker", marker, data());
  }
  MarkerState marker(const Marker& marker, double t) const override {
    return calc_marker_state(*context_, marker, t);
  }
  Wrench joint_reaction(int subsystem, int joint) const override {
    return calc_joint_reaction(*context_, subsystem, joint);
  }
  void require_loop(int subsystem, std::string_view loop) const override {
    require_range("the index of the blade or subsystem", subsystem, 0,
                  std::ssize(system().subsystems) - 1);
    const auto i = static_cast<std::size_t>(subsystem);
    find_loop(system().subsystems[i].loops, own_.names()[i].name, loop);
  }
  Wrench loop_reaction(int subsystem, std::string_view loop, double t) const override {
    const auto i = static_cast<std::size_t>(subsystem);
    const std::size_t k = find_loop(system().subsystems[i].loops, own_.names()[i].name, loop);
    return calc_loop_wrench(*context_, i, k, t);
  }
  Wrench hub_reaction() const override { return calc_hub_reaction(data()); }
  Wrench section_force(const Marker& marker) const override { return own_.section_force(marker); }

  const std::vector<std::string>& sensor_names() const override { return sensors_->names(); }
  const std::vector<std::string>& sensor_units() const override { return sensors_->units(); }
  double start_sensors() override {
    own_.start(*sensors_);
    return sensors_->initial_energy();
  }
  double energy_resolution() const override { return own_.energy_resolution(); }
  void sample(std::int64_t step, double t) override { own_.sample(step, t); }
  const std::vector<double>& measure(const WorkDone& work, std::int64_t step) override {
    return sensors_->measure(system(), work, step, data());
  }
  const EnergyBalance& balance() const override { return sensors_->balance(); }
  const MomentumBalance* momentum() const override { return sensors_->momentum(); }
  const StepRecord& record(std::int64_t step) const override {
    return of_step(data().records, step).step;
  }

  void calc_shape(int subsystem, double t, TreeShape& shape) override {
    own_.calc_shape(subsystem, t, shape);
  }
  HubPose hub_pose() const override { return own_.hub_pose(); }
  MarkerMotion base_frame(double t) const override { return own_.base_frame(t); }
  MarkerState hub_frame(double t) const override { return calc_hub_frame(*context_, t); }
  LoopsAtStart loops_at_start() const override { return describe_loops(*context_, own_.names()); }
  MarkerMotion carrier_frame(int anchor, double t) const override {
    return own_.carrier_frame(anchor, t);
  }

  DivergenceError diagnose(const FailedStep& failed) const override {
    return spoke::diagnose(scenario_, *context_, own_.names(), failed);
  }
  FailedLoad find_failed_load(const std::string& at) const override {
    return placed_loads_->find_failed(data().names->subsystems, at);
  }

 private:
  /// Calls subsystems and bodies as the scenario does in the names of nodes and parts.
  void name_nodes() {
    graph::NodeNames names{"blade", {}, {}};
    for (const SubsystemNames& own : own_.names()) {
      names.subsystems.push_back(own.name);
      names.bodies.push_back(own.bodies);
    }
    data().names = std::make_shared<const graph::NodeNames>(std::move(names));
  }

  using Own = std::conditional_t<std::is_same_v<World, Plane>, PlanarModel, SpatialModel>;
  using OwnSensors = std::conditional_t<std::is_same_v<World, Plane>, Sensors, SpatialSensors>;

  static std::unique_ptr<SystemContext<World>> make_context(const Scenario& scenario,
                                                            Formulation formulation,
                                                            const Integrator& integrator) {
    auto context = std::make_unique<SystemContext<World>>();
    if (scenario.limits.deflection > 0.0) context->linear_range = scenario.limits.deflection;
    context->formulation = formulation;
    context->integrator = integrator;
    context->loop_limits = make_loop_limits(scenario.integration);
    return context;
  }

  /// Returns the loads of the user's, in place of those that were replaced what replaced them.
  std::vector<AskedLoad> loads_in_force() const {
    std::vector<AskedLoad> loads = loads_;
    for (std::size_t k = 0; k < loads.size(); ++k)
      loads[k].load = placed_loads_->find(static_cast<int>(k)).load;
    return loads;
  }

  template <class Asked>
  SystemContext<Asked>* context_of() {
    if constexpr (std::is_same_v<Asked, World>)
      return context_.get();
    else
      return nullptr;
  }
  const System<World>& system() const { return context_->system; }
  StepData<World>& data() { return context_->data; }
  const StepData<World>& data() const { return context_->data; }
  std::vector<Sensor> asked_sensors() const { return with_momentum(scenario_, keeps_momentum_); }

  const Scenario& scenario_;
  std::unique_ptr<SystemContext<World>> context_;
  Own own_;  ///< the part that differs between the worlds
  std::vector<AskedLoad> loads_;
  UserLoads<World>* placed_loads_ = nullptr;  ///< actor of the table, once that is allocated
  bool keeps_momentum_ = false;               ///< whether it is free, and nothing acts on it
  std::optional<OwnSensors> sensors_;         // none before allocate()
};

}  // namespace spoke
