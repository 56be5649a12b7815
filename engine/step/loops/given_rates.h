#pragma once

// What is prescribed and makes rates of closed loops: driven joints, the hub's
// rotation, anchors and the mount.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/step/loops/loop_coordinates.h"

namespace spoke {

/// Rates of the rigid rows, as LoopKinematics has them, by what is prescribed: columns, and what
/// each is due to.
struct GivenRates {
  Eigen::MatrixXd columns;
  std::vector<std::string> names;

  void add(const Eigen::VectorXd& column, const std::string& name);
};

/// Finds what moves within the run, of `duration` [s].
template <class World>
GivenRates find_given_rates(SystemContext<World>& context, const LoopGroup& group, double duration,
                            LoopKinematics<World>& kinematics);

/// Whether hub and mount are held at rest during the run.
template <class World>
bool is_at_rest(const System<World>& system, double duration);

/// Whether an anchor of the loops moves, however seldom, or the program may move one of them or a
/// joint.
template <class World>
bool may_be_moved(const System<World>& system, const Subsystem<World>& subsystem);

}  // namespace spoke
