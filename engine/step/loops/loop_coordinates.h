#pragma once

// The coordinates that the loops of subsystems depend on, and the Jacobian of their rows by them,
// as the start of a run needs them: found by unit speeds.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/step/step_context.h"

namespace spoke {

/// A coordinate of a joint or of a deformation, of a body that carries a loop.
struct LoopCoordinate {
  std::size_t subsystem = 0;
  int body = 0;
  bool is_joint = false;
  int at = 0;            ///< its place in the block of coordinates
  double scale = 1.0;    ///< of displacements the model's length: coordinates are angles then [m]
  int spherical = -1;    ///< first coordinate of the orientation that it belongs to; -1: none
  bool is_held = false;  ///< stays as it is given
};

/// Subsystems whose loops are to be closed together, by index: one, or those that loops between
/// them tie. What carries a rotor stands before the subsystems of that.
using LoopGroup = std::vector<std::size_t>;
/// Returns all groups of subsystems with loops, each by its least index.
template <class World>
std::vector<LoopGroup> find_loop_groups(const System<World>& system);

/// A row of the loops of a subsystem.
struct SubsystemRow {
  std::size_t subsystem = 0;
  int row = 0;
};

/// The loops of a group while their start is found. Lengths are by the model's.
template <class World>
class LoopKinematics {
 public:
  /// Puts the hub where it is at t = 0, and prescribed motions as well.
  LoopKinematics(SystemContext<World>& context, const LoopGroup& group);

  const std::vector<LoopCoordinate>& coordinates() const { return coordinates_; }
  /// Returns how many of them, the first ones, are of joints.
  int joint_count() const { return joint_count_; }
  /// Returns the rows that are rigid, of all loops of the group.
  const std::vector<SubsystemRow>& rigid_rows() const { return rigid_rows_; }

  /// Evaluates the rows at the present state.
  void evaluate();
  Eigen::VectorXd openings() const;
  Eigen::VectorXd rates() const;
  Eigen::VectorXd given_rates() const;
  /// Returns d(rates)/d(speeds) of the first `count` coordinates, by row.
  Eigen::MatrixXd calc_jacobian(int count);
  /// Returns that without the columns of coordinates that are held, which are zero.
  Eigen::MatrixXd calc_free_jacobian(int count);
  /// Returns the names of the joints that are held, each once.
  std::vector<std::string> held_joints() const;
  /// Returns d(rates)/d(speed) of the driven component `c` of the joint of a body.
  Eigen::VectorXd calc_driven_column(std::size_t subsystem, int body, int c);
  /// Returns d(rates)/d(speed) of the hub about its axle.
  Eigen::VectorXd calc_hub_column();

  /// Moves coordinates, the first ones, by so much.
  void move(const Eigen::VectorXd& by);
  void add_speeds(const Eigen::VectorXd& by);

 private:
  double* speed_of(const LoopCoordinate& coordinate);
  void list_coordinates();
  void list_rows();
  void turn_hub(double by);
  Eigen::VectorXd by_row(double LoopRowState<World>::*value) const;

  const Subsystem<World>& subsystem(std::size_t i) const { return context_.system.subsystems[i]; }
  SubsystemData<World>& data(std::size_t i) const { return context_.data.subsystems[i]; }

  SystemContext<World>& context_;
  const LoopGroup& group_;
  std::vector<const SharedLoop*> shared_;  ///< loops between subsystems of the group
  std::vector<LoopCoordinate> coordinates_;
  int joint_count_ = 0;
  std::vector<SubsystemRow> rigid_rows_;
  Eigen::VectorXd row_scale_;  ///< of rigid rows
};

/// Calls `visit(body)` with the bodies that carry a loop, in their order.
template <class World, class Visit>
void for_loop_bodies(const Subsystem<World>& subsystem, const LoopData<World>& loops,
                     Visit&& visit) {
  std::vector<bool> carries(subsystem.bodies.size(), false);
  for (const LoopPath& path : loops.paths)
    for (const int body : path.bodies) carries[static_cast<std::size_t>(body)] = true;
  for (std::size_t j = 0; j < carries.size(); ++j)
    if (carries[j]) visit(j);
}

}  // namespace spoke
