#pragma once

// Subsystems that loops or couplings between them tie to one another, or of which one carries the
// hub of another: each group of them is one subsystem to equilibria and linear models, whose
// coordinates are those of its members in their order, and whose loops are those of its members and
// between these. With V the twist of the system's hub and v the velocities of all coordinates of a
// group, the hub of a member has the twist J [V; v], J = [1 0] if that is the system's hub; by J a
// member's matrices are those of the group.

#include <memory>
#include <string>
#include <vector>

#include "engine/small_motions/steady/steady_system.h"
#include "models/space/space.h"

namespace spoke::steady {

class TiedModel final : public SteadyModel {
 public:
  /// `rotors`: names of those on what the base moves.
  explicit TiedModel(std::unique_ptr<SteadySystem<Space>> base,
                     std::vector<std::string> rotors = {});

  std::size_t subsystems() const override { return groups_.size(); }
  const std::string& name_of(std::size_t g) const override { return groups_[g].name; }
  std::string full_name(std::size_t g, const std::string& inner) const override;
  bool is_standing_machine() const override { return !base_->system().rotors.empty(); }
  std::vector<SubsystemPart> members(std::size_t g) override;
  std::vector<CarriedHub> carried_hubs(const std::vector<HubVector>& wrenches) const override;
  const std::vector<std::string>& body_names(std::size_t g) const override {
    return groups_[g].bodies;
  }
  const std::vector<SubsystemCoordinate>& coordinates(std::size_t g) const override {
    return groups_[g].coordinates;
  }
  std::vector<SolidDeformation> solids(std::size_t g) const override;
  double azimuth(std::size_t g) const override;
  Eigen::Matrix3d root_axes(std::size_t g, int body) const override;
  bool is_spatial() const override { return true; }
  int twist_size() const override { return base_->twist_size(); }
  const std::vector<int>& free_components() const override { return base_->free_components(); }
  bool is_hub_free() const override { return base_->is_hub_free(); }
  bool has_torque_drive() const override { return base_->has_torque_drive(); }
  void set_share(double share) override { base_->set_share(share); }
  void hold_states(std::size_t g, bool holds) override;
  void hold_states_at(std::size_t g, std::span<const double> states) override;
  std::vector<double> advance_states(std::size_t g, double elapsed) override;
  std::vector<ForceState> force_states(std::size_t g) const override;
  void move_hub(double turn, double rate, double acceleration) override {
    base_->move_hub(turn, rate, acceleration);
  }
  Eigen::VectorXd initial(std::size_t g) const override;
  void settle(std::size_t g, Eigen::VectorXd& q) override;
  void settle_at(std::size_t g, const Eigen::VectorXd& absolute) override;
  void evaluate(std::size_t g, const SubsystemState& state, const HubOffset& hub,
                SubsystemResponse& response) override;
  const Eigen::MatrixXd& stiffness(std::size_t g) override;
  Eigen::VectorXd accelerations(std::size_t g) override;
  SubsystemMatrices matrices(std::size_t g) override;
  Eigen::MatrixXd twists(std::size_t g, int body) override;
  Eigen::VectorXd momenta(std::size_t g, const Eigen::VectorXd& v) override;
  const std::vector<ClosureRow>& closure_rows(std::size_t g) const override {
    return groups_[g].closure_rows;
  }
  const std::string& standing_springs(std::size_t g) const override;
  std::string loop_words(std::size_t g, std::size_t loop) const override;
  Eigen::MatrixXd closures(std::size_t g) override;
  std::vector<LoopLoad> loop_loads(std::size_t g,
                                   const Eigen::VectorXd& multipliers) const override;
  HubVector hub_force(const HubOffset& hub) const override { return base_->hub_force(hub); }
  Eigen::MatrixXd hub_mass() const override { return base_->hub_mass(); }
  std::vector<NodePlace> places(std::size_t g) override;
  /// That of the first member.
  TipMotion tip(std::size_t g) override { return base_->tip(groups_[g].subsystems[0]); }
  std::optional<SubsystemAir> air(std::size_t g) const override;
  std::vector<RootLoad> root_loads(std::size_t g) const override;
  std::vector<double> bending(std::size_t g) const override;
  Eigen::VectorXd absolute(std::size_t g, const Eigen::VectorXd& q) const override;
  const std::vector<LinearSignal>& outputs(std::size_t g) const override {
    return groups_[g].outputs;
  }
  const std::vector<std::string>& other_sensors() const override { return base_->other_sensors(); }
  Eigen::MatrixXd turn_outputs(std::size_t g, double angle) const override;
  Eigen::VectorXd measure(std::size_t g) override;

 private:
  /// A row of a loop of a member.
  struct RowAt {
    std::size_t member = 0;
    Eigen::Index row = 0;
  };
  struct Group {
    std::vector<std::size_t> subsystems;  ///< of the base: the members
    std::string name;
    // By member, and behind these their number.
    std::vector<Eigen::Index> starts;      ///< first coordinate
    std::vector<std::size_t> body_starts;  ///< first body
    std::vector<std::string> bodies;
    std::vector<SubsystemCoordinate> coordinates;
    std::vector<LinearSignal> outputs;
    /// The rows by what is one row to the members: of a loop between them that of its own
    /// subsystem, then those of its shares.
    std::vector<std::vector<RowAt>> rows;
    std::vector<ClosureRow> closure_rows;
    std::vector<RowAt> loops;   ///< `row`: number of the loop of the member
    Eigen::MatrixXd stiffness;  ///< at the state that was evaluated last
  };

  Eigen::Index size(const Group& group, std::size_t member) const {
    return group.starts[member + 1] - group.starts[member];
  }
  /// Returns J of all members.
  std::vector<Eigen::MatrixXd> hub_motions(const Group& group);
  /// Return where the hub of a rotor, or of a subsystem, is in the frame of the system's hub.
  space::Pose pose_of_rotor(std::size_t rotor) const;
  space::Pose pose_of_hub(std::size_t subsystem) const;
  template <class Vector>
  auto part(const Group& group, std::size_t member, Vector& vector) const {
    return vector.segment(group.starts[member], size(group, member));
  }
  /// Returns the member that a body belongs to.
  std::size_t member_of(const Group& group, int body) const;
  Group make_group(const std::vector<std::size_t>& subsystems) const;
  void add_rows(std::size_t member, Group& group) const;
  void take_rows(Group& group) const;
  Eigen::VectorXd forces_of(const Group& group, std::size_t member,
                            const Eigen::VectorXd& multipliers) const;
  std::vector<SubsystemState> split(const Group& group, const SubsystemState& state) const;

  std::unique_ptr<SteadySystem<Space>> base_;
  std::vector<std::string> rotors_;
  std::vector<Group> groups_;
};

}  // namespace spoke::steady
