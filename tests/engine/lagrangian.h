#pragma once

// A rotor's Lagrangian, written independently of the engine: position fields of all bodies from
// poses, shape functions and coordinates, velocities by dual numbers, energies by quadrature along
// the blades. No integral, joint equation or mass matrix of the engine is used.

#include <Eigen/Core>
#include <span>

#include "engine/step/step_context.h"

namespace spoke::test {

/// Place and motion of a section in the inertial frame: x, y [m], angle [rad] and their rates.
struct SectionMotion {
  Twist place = Twist::Zero();
  Twist rate = Twist::Zero();
};

/// Generalised coordinates y: hub x, y, angle, then all deformation coordinates, body by body.
class Lagrangian {
 public:
  /// `blades`: those of which the system was made, if they are not uniform. Must outlive this.
  explicit Lagrangian(const System<Plane>& system, std::span<const Blade> blades = {})
      : system_(system), blades_(blades) {}

  int size() const { return kTwist + system_.deformation_count(); }

  /// Returns T(y, v), with the second-order term of geometric stiffening [J].
  double kinetic_energy(const Eigen::VectorXd& y, const Eigen::VectorXd& v) const;
  /// Returns elastic energy and that of gravity [J].
  double potential_energy(const Eigen::VectorXd& y) const;
  /// Returns dT/dv: exact, since T is quadratic in v.
  Eigen::VectorXd momenta(const Eigen::VectorXd& y, const Eigen::VectorXd& v) const;
  /// Returns only the components of the hub of dT/dv.
  Twist hub_momenta(const Eigen::VectorXd& y, const Eigen::VectorXd& v) const;
  /// Returns d2T/dv2, the mass matrix of the independent coordinates: exact.
  Eigen::MatrixXd mass(const Eigen::VectorXd& y) const;
  /// Returns d/dt dT/dv - dT/dy + dV/dy along accelerations a, by central differences: the
  /// generalised forces without those of the potential.
  Eigen::VectorXd residual(const Eigen::VectorXd& y, const Eigen::VectorXd& v,
                           const Eigen::VectorXd& a) const;
  /// Returns the section at x [m] of a body.
  SectionMotion section(const Eigen::VectorXd& y, const Eigen::VectorXd& v, int blade, int body,
                        double x) const;
  /// Returns the distance by which bending draws that section inward along the undeformed blade, in
  /// the inertial frame [m], where bodies have geometric stiffening. A force does work on it. Where
  /// the hub flies, the mean of all masses is subtracted, since the mass centre keeps its place.
  Position drawn(const Eigen::VectorXd& y, int blade, int body, double x) const;
  /// Returns that mean; zero for a hub that does not fly.
  Position drawn_centre(const Eigen::VectorXd& y) const;

 private:
  /// Returns drawn() relative to the hub.
  Position drawn_on_hub(const Eigen::VectorXd& y, int blade, int body, double x) const;
  /// Returns component i of dT/dv.
  double momentum(const Eigen::VectorXd& y, const Eigen::VectorXd& v, int i) const;

  const System<Plane>& system_;
  std::span<const Blade> blades_;
};

/// Returns y, v and a of the state of a context.
Eigen::VectorXd independent_coordinates(const SystemContext<Plane>& context);
Eigen::VectorXd independent_velocities(const SystemContext<Plane>& context);
Eigen::VectorXd independent_accelerations(const SystemContext<Plane>& context);

}  // namespace spoke::test
