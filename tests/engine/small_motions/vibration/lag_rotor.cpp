// Writes the equations of hinged blades out.

#include "tests/engine/small_motions/vibration/lag_rotor.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace spoke::test {

using Eigen::MatrixXd;

LagRotor make_lag_rotor(int blades, double speed) {
  const LagBlade blade;
  LagRotor rotor;
  steady::LinearModel& model = rotor.linear;
  MatrixXd J(2, 2);
  J << 0.0, -1.0, 1.0, 0.0;
  const MatrixXd mass = blades * blade.mass * MatrixXd::Identity(2, 2);
  model.M = mass;
  model.C = 2.0 * speed * mass * J;
  model.K = -speed * speed * mass;
  model.round_off = {Eigen::VectorXd::Zero(2), Eigen::VectorXd::Ones(2)};
  const auto one = [](double value) { return MatrixXd::Constant(1, 1, value); };
  for (int b = 0; b < blades; ++b) {
    const double azimuth = 0.4 + 2.0 * std::numbers::pi * b / blades;
    const MatrixXd ahead = blade.moment * Eigen::Vector2d(-std::sin(azimuth), std::cos(azimuth));
    model.couplings.push_back({ahead.transpose(),
                               2.0 * speed * ahead.transpose() * J,
                               -speed * speed * ahead.transpose(),
                               ahead,
                               2.0 * speed * J * ahead,
                               -speed * speed * ahead,
                               {}});
    model.alike.push_back(0);
    model.subsystems.emplace_back();
    rotor.azimuths.push_back(azimuth);
    rotor.names.push_back("blade " + std::to_string(b + 1));
  }
  steady::LinearSubsystem& own = model.subsystems[0];
  own.M = one(blade.inertia);
  own.C = one(blade.damping);
  own.K = one(blade.stiffness + speed * speed * blade.offset * blade.moment);
  own.round_off = {Eigen::VectorXd::Zero(1), Eigen::VectorXd::Ones(1)};
  rotor.axes = vibration::make_standing_axes({0, 1}, true, speed);
  return rotor;
}

MatrixXd in_plane() { return MatrixXd::Identity(2, 2); }

vibration::SecondOrder matrices_of(const HubSprings& springs) {
  const auto diagonal = [](double x, double y) {
    return MatrixXd(Eigen::Vector2d(x, y).asDiagonal());
  };
  return {diagonal(springs.mx, springs.my), diagonal(springs.cx, springs.cy),
          diagonal(springs.kx, springs.ky)};
}

std::vector<std::complex<double>> solve_coleman(int blades, double w, const HubSprings& springs) {
  const LagBlade b;
  const double half = 0.5 * blades * b.moment, k = b.stiffness + w * w * b.offset * b.moment;
  Eigen::Matrix4d M, C, K;                                // of p, q, x, y
  M << b.inertia, 0.0, 0.0, half,                         //
      0.0, b.inertia, -half, 0.0,                         //
      0.0, -b.moment, springs.mx + blades * b.mass, 0.0,  //
      b.moment, 0.0, 0.0, springs.my + blades * b.mass;
  C << b.damping, 2.0 * w * b.inertia, 0.0, 0.0,  //
      -2.0 * w * b.inertia, b.damping, 0.0, 0.0,  //
      0.0, 0.0, springs.cx, 0.0,                  //
      0.0, 0.0, 0.0, springs.cy;
  const double stiff = k - w * w * b.inertia;
  K << stiff, w * b.damping, 0.0, 0.0,  //
      -w * b.damping, stiff, 0.0, 0.0,  //
      0.0, 0.0, springs.kx, 0.0,        //
      0.0, 0.0, 0.0, springs.ky;
  Eigen::Matrix<double, 8, 8> A = Eigen::Matrix<double, 8, 8>::Zero();
  A.topRightCorner<4, 4>().setIdentity();
  A.bottomLeftCorner<4, 4>() = -M.inverse() * K;
  A.bottomRightCorner<4, 4>() = -M.inverse() * C;
  std::vector<std::complex<double>> roots;
  for (const std::complex<double> s : A.eigenvalues())
    if (s.imag() >= 0.0) roots.push_back(s);
  return roots;
}

}  // namespace spoke::test
