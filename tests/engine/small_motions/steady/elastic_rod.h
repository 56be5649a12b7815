#pragma once

// A cantilever under a force at its tip as a boundary-value problem: a rod that bends in two planes
// and twists by any angle, integrated along its axis. Independent of the engine.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace spoke::test {

/// A straight uniform rod along x, clamped at x = 0.
struct ElasticRod {
  double length = 1.0;        ///< [m]
  double axial = 1.0;         ///< EA [N]
  Eigen::Vector3d stiffness;  /// about x (GJ), y and z (EI) [N m^2]
};

/// Place of the tip.
struct RodTip {
  Eigen::Vector3d displacement;  ///< [m]
  Eigen::Quaterniond rotation;
};

/// Solves p' = (1 + n.t/EA) t, R' = R kappa~, m' = -p' x n, p(0) = 0, R(0) = 1, m(length) = 0, with
/// n = force, t the tangent, kappa = diag(stiffness)^-1 R^T m. Newton's method on m(0), the force
/// [N] rising in steps; Runge-Kutta of order 4 along the rod.
RodTip solve_rod(const ElasticRod& rod, const Eigen::Vector3d& force);

}  // namespace spoke::test
