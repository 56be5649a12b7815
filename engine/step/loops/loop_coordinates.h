#pragma once

// The coordinates that the loops of a subsystem depend on, and the Jacobian of their rows by them,
// as the start of a run needs them: found by unit speeds.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/step/step_context.h"

namespace spoke {

/// A coordinate of a joint or of a deformation, of a body that carries a loop.
struct LoopCoordinate {
  int body = 0;
  bool is_joint = false;
  int at = 0;            ///< its place in the block of coordinates
  double scale = 1.0;    ///< of displacements the model's length: coordinates are angles then [m]
  int spherical = -1;    ///< first coordinate of the orientation that it belongs to; -1: none
  bool is_held = false;  ///< stays as it is given
};

/// The loops of one subsystem while their start is found. Lengths are by the model's.
template <class World>
class LoopKinematics {
 public:
  /// Puts the hub where it is at t = 0, and prescribed motions as well.
  LoopKinematics(SystemContext<World>& context, std::size_t subsystem);

  const std::vector<LoopCoordinate>& coordinates() const { return coordinates_; }
  /// Returns how many of them, the first ones, are of joints.
  int joint_count() const { return joint_count_; }
  /// Returns the rows that are rigid, of all loops of the subsystem.
  const std::vector<int>& rigid_rows() const { return rigid_rows_; }

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
  Eigen::VectorXd calc_driven_column(int body, int c);
  /// Returns d(rates)/d(speed) of the hub about its axle.
  Eigen::VectorXd calc_hub_column();

  /// Moves coordinates, the first ones, by so much.
  void move(const Eigen::VectorXd& by);
  void add_speeds(const Eigen::VectorXd& by);

 private:
  double* speed_of(const LoopCoordinate& coordinate);
  void list_coordinates();
  Eigen::VectorXd by_row(double LoopRowState<World>::*value) const;

  SystemContext<World>& context_;
  std::size_t index_;
  const Subsystem<World>& subsystem_;
  SubsystemData<World>& data_;
  std::vector<LoopCoordinate> coordinates_;
  int joint_count_ = 0;
  std::vector<int> rigid_rows_;
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
