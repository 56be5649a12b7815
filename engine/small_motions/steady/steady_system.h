#pragma once

// A system in steady rotation on the table of a simulation, whose nodes it runs subsystem by
// subsystem.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/bodies/columns/sensor_columns.h"
#include "engine/small_motions/steady/steady_loads.h"
#include "engine/small_motions/steady/steady_model.h"
#include "engine/small_motions/steady/steady_wind.h"
#include "engine/small_motions/steady/subsystem_forces.h"
#include "engine/small_motions/steady/subsystem_names.h"
#include "engine/step/step_context.h"
#include "graph/step_graph.h"

namespace spoke::steady {

/// Makes the system of a world, and places the scenario's sensors in its table. The wind of a
/// system in air is the same at every time.
template <class World>
struct SystemMaker {
  std::function<void(System<World>&)> fill;
  std::function<std::vector<SensorColumn>(const System<World>&, StepData<World>&)> place_sensors;
  LoopLimits loops{};
};

/// Returns the subsystems in the groups that are tied, by loops between them or as one carries the
/// hub of another, in the order of their first ones; those that nothing ties are groups of their
/// own.
template <class World>
std::vector<std::vector<std::size_t>> group_subsystems(const System<World>& system);

template <class World>
class SteadySystem final : public SteadyModel {
 public:
  /// Takes the system that `maker` makes, and holds it in steady rotation.
  SteadySystem(const SystemMaker<World>& maker, std::vector<SubsystemNames> names,
               const SteadyOptions& options);

  std::size_t subsystems() const override { return names_.size(); }
  const std::string& name_of(std::size_t subsystem) const override {
    return names_[subsystem].name;
  }
  const std::vector<std::string>& body_names(std::size_t subsystem) const override {
    return names_[subsystem].bodies;
  }
  const std::vector<SubsystemCoordinate>& coordinates(std::size_t subsystem) const override {
    return coordinates_[subsystem];
  }
  std::vector<SolidDeformation> solids(std::size_t subsystem) const override;
  double azimuth(std::size_t subsystem) const override { return names_[subsystem].azimuth; }
  Eigen::Matrix3d root_axes(std::size_t subsystem, int body) const override;
  bool is_spatial() const override { return World::kTwist > kTwist; }
  int twist_size() const override { return World::kTwist; }
  const std::vector<int>& free_components() const override { return free_; }
  bool is_hub_free() const override { return hub_.support == HubSupport::free; }
  bool has_torque_drive() const override;
  void set_share(double share) override;
  void hold_states(std::size_t subsystem, bool holds) override;
  void hold_states_at(std::size_t subsystem, std::span<const double> states) override;
  std::vector<double> advance_states(std::size_t subsystem, double elapsed) override;
  std::vector<ForceState> force_states(std::size_t subsystem) const override;
  void move_hub(double turn, double rate, double acceleration) override;
  Eigen::VectorXd initial(std::size_t subsystem) const override;
  void settle(std::size_t subsystem, Eigen::VectorXd& q) override;
  void settle_at(std::size_t subsystem, const Eigen::VectorXd& absolute) override;
  void evaluate(std::size_t subsystem, const SubsystemState& state, const HubOffset& hub,
                SubsystemResponse& response) override;
  /// Returns the number of the states of advance_states().
  std::size_t count_states(std::size_t subsystem) const;
  /// As evaluate(), for all subsystems of a group at once: `states` and `responses` by member. Of a
  /// loop between them the rows of its own subsystem count, and those of its shares follow. Hubs
  /// follow what carries them, to which `responses` hand up their forces; they are forces on the
  /// system's hub only of what this carries.
  void evaluate_tied(const std::vector<std::size_t>& group,
                     const std::vector<SubsystemState>& states, const HubOffset& hub,
                     std::vector<SubsystemResponse>& responses);
  /// As accelerations(), of all subsystems at once. Precondition: evaluate_tied() was called.
  std::vector<Eigen::VectorXd> accelerations_tied(const std::vector<std::size_t>& group);
  const System<World>& system() const { return context_.system; }
  const StepData<World>& table() const { return context_.data; }
  const Eigen::MatrixXd& stiffness(std::size_t subsystem) override;
  Eigen::VectorXd accelerations(std::size_t subsystem) override;
  SubsystemMatrices matrices(std::size_t subsystem) override;
  Eigen::MatrixXd twists(std::size_t subsystem, int body) override;
  Eigen::VectorXd momenta(std::size_t subsystem, const Eigen::VectorXd& v) override;
  const std::vector<ClosureRow>& closure_rows(std::size_t subsystem) const override {
    return rows_[subsystem];
  }
  const std::string& standing_springs(std::size_t subsystem) const override {
    return standing_springs_[subsystem];
  }
  std::string loop_words(std::size_t subsystem, std::size_t loop) const override {
    const LoopModel& model = context_.system.subsystems[subsystem].loops[loop];
    return std::string(model.word()) + " \"" + model.name + '"';
  }
  Eigen::MatrixXd closures(std::size_t subsystem) override;
  std::vector<LoopLoad> loop_loads(std::size_t subsystem,
                                   const Eigen::VectorXd& multipliers) const override;
  HubVector hub_force(const HubOffset& hub) const override;
  Eigen::MatrixXd hub_mass() const override;
  std::vector<NodePlace> places(std::size_t subsystem) override;
  TipMotion tip(std::size_t subsystem) override;
  std::optional<SubsystemAir> air(std::size_t subsystem) const override;
  std::vector<RootLoad> root_loads(std::size_t subsystem) const override;
  std::vector<double> bending(std::size_t subsystem) const override;
  Eigen::VectorXd absolute(std::size_t subsystem, const Eigen::VectorXd& q) const override;
  const std::vector<LinearSignal>& outputs(std::size_t subsystem) const override {
    return outputs_[subsystem];
  }
  const std::vector<std::string>& other_sensors() const override { return other_sensors_; }
  Eigen::MatrixXd turn_outputs(std::size_t subsystem, double angle) const override;
  Eigen::VectorXd measure(std::size_t subsystem) override;

 private:
  using Twist = TwistOf<World>;

  void hold_hub();
  void blow(bool is_axial, bool is_whole);
  void place(std::size_t subsystem, const SubsystemState& state);
  void calc_terms(std::size_t subsystem, const SubsystemState& state, const HubOffset& hub);
  void set_hub(std::size_t subsystem, const HubOffset& hub);
  void sum_response(std::size_t subsystem, const std::vector<CarriedWrench<World>>& carried,
                    SubsystemResponse& response);
  Eigen::VectorXd take_accelerations(std::size_t subsystem) const;
  /// Lets hubs of rotors be bodies as others, whose mass is their own: see evaluate_tied().
  void hold_rotors();
  void put_bodies(std::size_t subsystem, const Eigen::VectorXd& q, const Eigen::VectorXd& v);
  Eigen::VectorXd take_bodies(std::size_t subsystem) const;
  PrescribedHub<World> hub_motion(const HubOffset& offset) const;
  Eigen::Index find_coordinate(std::size_t subsystem, int body, int coordinate) const;
  void find_nodes();
  Eigen::MatrixXd calc_twists(std::size_t subsystem);
  void set_undeformed();
  bool is_steady(const SensorColumn& column) const;
  void set_outputs(std::vector<SensorColumn> columns);
  Eigen::MatrixXd assemble_stiffness(std::size_t subsystem) const;
  SubsystemData<World>& data(std::size_t subsystem) { return context_.data.subsystems[subsystem]; }
  const SubsystemData<World>& data(std::size_t subsystem) const {
    return context_.data.subsystems[subsystem];
  }

  SystemContext<World> context_;
  std::vector<SubsystemNames> names_;
  typename World::Hub hub_;  ///< as in the scenario
  std::vector<int> free_;
  bool is_support_ = false, holds_forces_ = false;  ///< see SteadyOptions
  double share_ = 1.0;
  std::optional<HubOffset> moved_;  ///< by move_hub()
  std::optional<SteadyLoads<World>> loads_;
  std::shared_ptr<SteadyWind> wind_;  ///< null: no air acts
  std::optional<graph::StepGraph> graph_;
  /// By subsystem, in the order of a pass: nodes of kinematics and terms, and the nodes behind
  /// them.
  std::vector<std::vector<graph::NodeId>> terms_, solution_;
  std::vector<graph::NodeId> pass_;  ///< all but those that set the state and end the pass
  std::vector<std::vector<SubsystemCoordinate>> coordinates_;
  std::vector<std::vector<ClosureRow>> rows_;
  std::vector<std::string> standing_springs_;  ///< names of loops by subsystem, if the hub turns
  std::vector<std::vector<Eigen::VectorXd>> q_elastic_, v_elastic_;  ///< flex vectors by body
  std::vector<Eigen::MatrixXd> stiffness_;
  std::vector<Eigen::Matrix3d> tip_axes_;  ///< undeformed, by subsystem
  // By subsystem: the sensors that turn with the hub, and names of all outputs.
  std::vector<std::vector<SensorColumn>> columns_;
  std::vector<std::vector<LinearSignal>> outputs_;
  std::vector<std::string> other_sensors_;
};

}  // namespace spoke::steady
