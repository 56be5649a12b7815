#pragma once

// The coordinates of a joint are eliminated one after another: each is a division and a square
// taken off the joint's stiffness against relative acceleration, and no matrix of the joint is
// factorised.

#include <Eigen/Core>
#include <array>
#include <cassert>
#include <cstddef>

#include "engine/bodies/tree/multi_port.h"

namespace spoke::tree {

// A joint with n coordinates transmits the wrench f, by its relative acceleration without them, r:
//   f = Pi_0 (r - H q''),     -H^T f = tau - share q''     (f acts on the parent)
// With coordinates k + 1 ... n - 1 still to come, in r_k = r - sum of their H_j q_j'',
//   f = Pi_k r_k + s_k,       y_k = Pi_(k-1) H_k,          d_k = 1 / (H_k^T y_k + share_k)
//   Pi_k = Pi_(k-1) - d_k y_k y_k^T,                       t_k = d_k (tau_k + H_k^T s_(k-1))
//   s_k = s_(k-1) - t_k y_k,                               q_k'' = t_k + d_k y_k^T r_k

/// Quantities that the elimination of a joint's coordinates leaves besides Pi. Those of coordinates
/// that it does not have are not set.
template <class World>
struct JointResponse {
  static constexpr int kMost = World::kMostJointCoordinates;
  using Columns = Eigen::Matrix<double, World::kTwist, kMost, Eigen::DontAlign>;

  Columns H;                        ///< by coordinate, where and as r is given
  Columns gain;                     ///< d_k y_k
  std::array<double, kMost> given;  ///< t_k
  std::array<double, kMost> yield;  ///< d_k
  typename World::Twist wrench;     ///< s: transmitted at r = 0
};

/// Eliminates `joint.coordinates` coordinates, whose columns are `response.H`, with forces
/// joint.tau and joint.share, from Pi = Pi_0 and s_0 = `wrench`.
template <class World, class Joint>
void eliminate_coordinates(const Joint& joint, typename World::SymmetricTwistMatrix& Pi,
                           JointResponse<World>& response,
                           const typename World::Twist& wrench = World::Twist::Zero()) noexcept {
  assert(joint.coordinates >= 0 && joint.coordinates <= World::kMostJointCoordinates);
  using Twist = typename World::Twist;
  response.wrench = wrench;
  for (int c = 0; c < joint.coordinates; ++c) {
    const auto k = static_cast<std::size_t>(c);
    const Twist H = response.H.col(c);
    const Twist y = Pi * H;
    const double d = 1.0 / (H.dot(y) + joint.share[k]);
    const double given = d * (joint.tau[k] + H.dot(response.wrench));
    Pi = subtract_square(Pi, y, d);
    response.wrench -= given * y;
    response.gain.col(c) = d * y;
    response.given[k] = given;
    response.yield[k] = d;
  }
}

/// Calculates the accelerations q'' of n coordinates at the relative acceleration r.
template <class World>
void recover_coordinates(const JointResponse<World>& response, typename World::Twist r, int n,
                         double* a) noexcept {
  assert(n >= 0 && n <= World::kMostJointCoordinates && (n == 0 || a));
  for (int c = n; c-- > 0;) {
    a[c] = response.given[static_cast<std::size_t>(c)] + response.gain.col(c).dot(r);
    r -= a[c] * response.H.col(c);
  }
}

/// What unit efforts on the coordinates of a joint that is eliminated add to the response.
template <class World>
struct EffortResponse {
  std::array<double, World::kMostJointCoordinates> given{};         ///< t_k
  std::array<double, World::kMostJointCoordinates> acceleration{};  ///< q'' at r = 0
  typename World::Twist wrench = World::Twist::Zero();              ///< s
};

/// Returns it for efforts on n coordinates: forces tau alone.
template <class World>
EffortResponse<World> respond_to_efforts(
    const JointResponse<World>& response,
    const std::array<double, World::kMostJointCoordinates>& efforts, int n) noexcept {
  EffortResponse<World> to;
  for (int c = 0; c < n; ++c) {
    const auto k = static_cast<std::size_t>(c);
    const double force = efforts[k] + response.H.col(c).dot(to.wrench);
    to.given[k] = response.yield[k] * force;
    to.wrench -= force * response.gain.col(c);
  }
  typename World::Twist r = World::Twist::Zero();
  for (int c = n; c-- > 0;) {
    double& a = to.acceleration[static_cast<std::size_t>(c)];
    a = to.given[static_cast<std::size_t>(c)] + response.gain.col(c).dot(r);
    r -= a * response.H.col(c);
  }
  return to;
}

}  // namespace spoke::tree
