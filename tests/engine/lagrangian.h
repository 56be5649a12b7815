#pragma once

// A rotor's Lagrangian, written independently of the engine: position fields of all bodies from
// poses, shape functions and coordinates, velocities by dual numbers, energies by quadrature along
// the blades. No integral, joint equation or mass matrix of the engine is used.

#include <Eigen/Core>
#include <span>

#include "engine/step/step_context.h"

namespace spoke::test {

/// Generalised coordinates y: hub x, y, angle, then all deformation coordinates, body by body.
class Lagrangian {
 public:
  /// `blades`: of which the system was made, if they are not uniform. Must outlive this.
  explicit Lagrangian(const System& system, std::span<const Blade> blades = {})
      : system_(system), blades_(blades) {}

  int size() const { return kTwist + system_.deformation_count(); }

  /// T(y, v), with the second-order term of geometric stiffening [J].
  double kinetic_energy(const Eigen::VectorXd& y, const Eigen::VectorXd& v) const;
  /// Elastic energy and that of gravity [J].
  double potential_energy(const Eigen::VectorXd& y) const;
  /// dT/dv: exact, for T is quadratic in v.
  Eigen::VectorXd momenta(const Eigen::VectorXd& y, const Eigen::VectorXd& v) const;
  /// d2T/dv2, the mass matrix of the independent coordinates: exact.
  Eigen::MatrixXd mass(const Eigen::VectorXd& y) const;
  /// d/dt dT/dv - dT/dy + dV/dy along accelerations a, by central differences: the generalised
  /// forces that are not of the potential.
  Eigen::VectorXd residual(const Eigen::VectorXd& y, const Eigen::VectorXd& v,
                           const Eigen::VectorXd& a) const;
  /// Position of a node of a body in the inertial frame [m].
  Position node_position(const Eigen::VectorXd& y, int blade, int body, int node) const;

 private:
  const System& system_;
  std::span<const Blade> blades_;
};

/// y, v and a of a context's state.
Eigen::VectorXd independent_coordinates(const StepContext& context);
Eigen::VectorXd independent_velocities(const StepContext& context);
Eigen::VectorXd independent_accelerations(const StepContext& context);

}  // namespace spoke::test
