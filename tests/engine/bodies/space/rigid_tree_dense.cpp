// Finds the accelerations of a tree as the solution of one system, with the equations of every body
// and joint as they stand.

#include <Eigen/LU>

#include "tests/engine/bodies/space/rigid_tree.h"

namespace spoke::space::testing {
namespace {

/// Places of the unknowns of body j, X, F and q'', behind Y'' of the hub.
struct Places {
  explicit Places(const std::vector<TreeBody>& models) {
    int next = kTwist;
    for (const TreeBody& model : models) {
      X.push_back(next);
      F.push_back(next + kTwist);
      q.push_back(next + 2 * kTwist);
      next += 2 * kTwist + model.joint.coordinates;
    }
    size = next;
  }
  std::vector<int> X, F, q;
  int size = 0;
};

/// Returns J = [1, -s~; 0, 1], or T of a joint.
TwistMatrix leads_to(const Position& s) {
  TwistMatrix J = TwistMatrix::Identity();
  J.topRightCorner<3, 3>() = -skew(s);
  return J;
}

}  // namespace

TreeAccelerations RigidTree::solve_dense() const {
  const Places places(models);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(places.size, places.size);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(places.size);
  HubTable table;
  place_hub(table);
  set_applied(table.system, table.data);
  const HubEquation<Space> hub_alone = sum_hub_equation(table.system, table.data);
  A.topLeftCorner<kTwist, kTwist>() = hub_alone.mass;
  b.head<kTwist>() = hub_alone.force;
  for (std::size_t j = 0; j < bodies.size(); ++j) {
    const BodyState& body = bodies[j];
    const JointMotion& motion = body.motion;
    const int n = models[j].joint.coordinates, X = places.X[j], F = places.F[j], q = places.q[j];
    // Equation of the body: M X - F + (terms that its children add below) = Q.
    A.block<kTwist, kTwist>(X, X) += body.port.mass.matrix();
    A.block<kTwist, kTwist>(X, F) -= TwistMatrix::Identity();
    b.segment<kTwist>(X) += body.Q;
    // Equation of the joint: R X - T (acceleration of the handle) - columns q'' = bias. Its parent
    // feels -(R^T T)^T F.
    const bool is_root = models[j].parent < 0;
    const auto p = static_cast<std::size_t>(is_root ? 0 : models[j].parent);
    const int of_parent = is_root ? 0 : places.X[p];
    TwistMatrix T = leads_to(motion.p);
    Twist handle_bias = Twist::Zero();
    if (!is_root) {
      const Position& s = bodies[p].port.handles[static_cast<std::size_t>(models[j].handle)];
      const Angular w = angular(bodies[p].twist);
      linear(handle_bias) = cross(w, cross(w, s));
      handle_bias = T * handle_bias;
      T = T * leads_to(s);
    }
    const TwistMatrix R = motion.R.matrix();
    A.block<kTwist, kTwist>(F, X) += R;
    A.block<kTwist, kTwist>(F, of_parent) -= T;
    b.segment<kTwist>(F) += motion.bias + handle_bias;
    A.block<kTwist, kTwist>(of_parent, F) += T.transpose() * R;
    // Equation of its coordinates: columns^T R F + share q'' = tau.
    for (int c = 0; c < n; ++c) {
      const auto k = static_cast<std::size_t>(c);
      A.block<kTwist, 1>(F, q + c) -= motion.columns.col(c);
      A.block<1, kTwist>(q + c, F) += motion.columns.col(c).transpose() * R;
      A(q + c, q + c) += body.forces.share[k];
      b[q + c] += body.forces.tau[k];
    }
  }
  const Twist given = calc_prescribed_acceleration(table.system, 0.0, table.data.hub,
                                                   table.data.hub_coordinates.a[Space::kAxial]);
  const Eigen::MatrixXd hub_rows = A.topRows<kTwist>();
  const Twist hub_right = b.head<kTwist>();
  for (int c = 0; c < kTwist; ++c) {
    if (!is_prescribed(table.system.hub, c)) continue;
    A.row(c).setZero();
    A(c, c) = 1.0;
    b[c] = given[c];
  }
  const Eigen::VectorXd x = A.fullPivLu().solve(b);

  TreeAccelerations found;
  found.hub.acceleration = x.head<kTwist>();
  found.hub.reaction = hub_rows * x - hub_right;
  for (std::size_t j = 0; j < bodies.size(); ++j) {
    found.bodies.emplace_back(x.segment<kTwist>(places.X[j]));
    found.wrenches.emplace_back(x.segment<kTwist>(places.F[j]));
    std::array<double, Joint::kMost> joint{};
    for (int c = 0; c < models[j].joint.coordinates; ++c)
      joint[static_cast<std::size_t>(c)] = x[places.q[j] + c];
    found.joints.push_back(joint);
  }
  return found;
}

}  // namespace spoke::space::testing
