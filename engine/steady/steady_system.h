#pragma once

// A system in steady rotation on the table of a simulation, whose nodes it runs tree by tree.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/columns/sensor_columns.h"
#include "engine/steady/steady_loads.h"
#include "engine/steady/steady_model.h"
#include "engine/steady/tree_names.h"
#include "engine/step/step_context.h"
#include "graph/step_graph.h"

namespace spoke::steady {

/// Makes the system of a world, and places the scenario's sensors in its table.
template <class World>
struct SystemMaker {
  std::function<void(System<World>&)> fill;
  std::function<std::vector<SensorColumn>(const System<World>&, StepData<World>&)> place_sensors;
};

template <class World>
class SteadySystem final : public SteadyModel {
 public:
  /// Of the system that `maker` makes, which is then held in steady rotation.
  SteadySystem(const SystemMaker<World>& maker, std::vector<TreeNames> names,
               const SteadyOptions& options);

  std::size_t trees() const override { return names_.size(); }
  const std::string& name_of(std::size_t tree) const override { return names_[tree].tree; }
  const std::vector<TreeCoordinate>& coordinates(std::size_t tree) const override {
    return coordinates_[tree];
  }
  double azimuth(std::size_t tree) const override { return names_[tree].azimuth; }
  Eigen::Matrix3d root_axes(std::size_t tree, int body) const override;
  bool is_spatial() const override { return World::kTwist > kTwist; }
  int twist_size() const override { return World::kTwist; }
  const std::vector<int>& free_components() const override { return free_; }
  bool is_hub_free() const override { return hub_.support == HubSupport::free; }
  bool has_torque_drive() const override;
  void set_share(double share) override;
  Eigen::VectorXd initial(std::size_t tree) const override;
  void settle(std::size_t tree, Eigen::VectorXd& q) override;
  void settle_at(std::size_t tree, const Eigen::VectorXd& absolute) override;
  void evaluate(std::size_t tree, const TreeState& state, const HubOffset& hub,
                TreeResponse& response) override;
  const Eigen::MatrixXd& stiffness(std::size_t tree) const override { return stiffness_[tree]; }
  Eigen::VectorXd accelerations(std::size_t tree) override;
  TreeMatrices matrices(std::size_t tree) override;
  HubVector hub_force(const HubOffset& hub) const override;
  Eigen::MatrixXd hub_mass() const override;
  std::vector<NodePlace> places(std::size_t tree) override;
  TipMotion tip(std::size_t tree) override;
  std::vector<RootLoad> root_loads(std::size_t tree) const override;
  std::vector<double> bending(std::size_t tree) const override;
  Eigen::VectorXd absolute(std::size_t tree, const Eigen::VectorXd& q) const override;
  const std::vector<LinearSignal>& outputs(std::size_t tree) const override {
    return outputs_[tree];
  }
  const std::vector<std::string>& other_sensors() const override { return other_sensors_; }
  Eigen::VectorXd measure(std::size_t tree) override;

 private:
  using Twist = TwistOf<World>;

  void hold_hub();
  void place(std::size_t tree, const TreeState& state);
  void put_bodies(std::size_t tree, const Eigen::VectorXd& q, const Eigen::VectorXd& v);
  Eigen::VectorXd take_bodies(std::size_t tree) const;
  PrescribedHub<World> hub_motion(const HubOffset& offset) const;
  void find_nodes();
  Eigen::MatrixXd calc_twists(std::size_t tree);
  void set_undeformed();
  bool is_steady(const SensorColumn& column) const;
  void set_outputs(std::vector<SensorColumn> columns);
  Eigen::MatrixXd assemble_stiffness(std::size_t tree) const;
  SubsystemData<World>& data(std::size_t tree) { return context_.data.subsystems[tree]; }
  const SubsystemData<World>& data(std::size_t tree) const {
    return context_.data.subsystems[tree];
  }

  SystemContext<World> context_;
  std::vector<TreeNames> names_;
  typename World::Hub hub_;  ///< as the scenario has it
  std::vector<int> free_;
  double share_ = 1.0;
  std::optional<SteadyLoads<World>> loads_;
  std::optional<graph::StepGraph> graph_;
  /// By tree, in the order of a pass: nodes of kinematics and terms, and those behind them.
  std::vector<std::vector<graph::NodeId>> terms_, solution_;
  std::vector<std::vector<TreeCoordinate>> coordinates_;
  std::vector<std::vector<Eigen::VectorXd>> q_elastic_, v_elastic_;  ///< flex vectors by body
  std::vector<Eigen::MatrixXd> stiffness_;
  std::vector<Eigen::Matrix3d> tip_axes_;  ///< undeformed, by tree
  // By tree: the sensors that turn with the hub, and names of all outputs.
  std::vector<std::vector<SensorColumn>> columns_;
  std::vector<std::vector<LinearSignal>> outputs_;
  std::vector<std::string> other_sensors_;
};

}  // namespace spoke::steady
