// Multiplies trigonometric matrices.

#include "engine/small_motions/vibration/periodic_system.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Adds a block of first degree.
void add(const Turning& block, Index row, Index column, Periodic& sum) {
  const MatrixXd* parts[] = {&block.mean, &block.cosine, &block.sine};
  for (std::size_t k = 0; k < 3; ++k)
    sum.parts[k].block(row, column, parts[k]->rows(), parts[k]->cols()) += *parts[k];
}

Turning transpose(const Turning& T) {
  return {T.mean.transpose(), T.cosine.transpose(), T.sine.transpose()};
}
Turning operator*(const MatrixXd& A, const Turning& T) {
  return {A * T.mean, A * T.cosine, A * T.sine};
}
Turning operator*(const Turning& T, const MatrixXd& A) {
  return {T.mean * A, T.cosine * A, T.sine * A};
}

/// Adds T A T^T for the hub.
void add_turned(const MatrixXd& A, const Turning& T, Periodic& sum) {
  const Turning left = T * A, right = transpose(T);
  const Index h = A.rows();
  const auto part = [&](std::size_t k) { return sum.parts[k].topLeftCorner(h, h); };
  const MatrixXd cc = left.cosine * right.cosine, ss = left.sine * right.sine;
  const MatrixXd cs = left.cosine * right.sine + left.sine * right.cosine;
  part(0) += left.mean * right.mean + 0.5 * (cc + ss);
  part(1) += left.mean * right.cosine + left.cosine * right.mean;
  part(2) += left.mean * right.sine + left.sine * right.mean;
  part(3) += 0.5 * (cc - ss);
  part(4) += 0.5 * cs;
}

}  // namespace

MatrixXd Periodic::at(double psi) const {
  MatrixXd sum = parts[0];
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const std::size_t multiple = (k + 1) / 2;
    const double angle = psi * static_cast<double>(multiple);
    sum += (k % 2 == 1 ? std::cos(angle) : std::sin(angle)) * parts[k];
  }
  return sum;
}

Periodic make_zero_periodic(Index size, Index degree) {
  const auto count = static_cast<std::size_t>(2 * degree + 1);
  return {std::vector<MatrixXd>(count, MatrixXd::Zero(size, size))};
}

PeriodicSystem make_periodic(const steady::LinearModel& turning, const StandingAxes& axes) {
  PeriodicSystem system;
  system.speed = axes.speed;
  system.hub = turning.M.rows();
  Index size = system.hub;
  for (std::size_t i = 0; i < turning.subsystems.size(); ++i) {
    system.starts.push_back(size);
    size += turning.subsystem(i).M.rows();
  }
  system.M = system.C = system.K = make_zero_periodic(size, 2);
  if (turning.is_coupled()) {
    const SecondOrder own = stand_columns({turning.M, turning.C, turning.K}, axes);
    add_turned(own.M, axes.T, system.M);
    add_turned(own.C, axes.T, system.C);
    add_turned(own.K, axes.T, system.K);
  }
  for (std::size_t i = 0; i < turning.subsystems.size(); ++i) {
    const steady::LinearSubsystem& own = turning.subsystem(i);
    const Index at = system.starts[i], n = own.M.rows();
    system.M.parts[0].block(at, at, n, n) = own.M;
    system.C.parts[0].block(at, at, n, n) = own.C;
    system.K.parts[0].block(at, at, n, n) = own.K;
    if (!turning.is_coupled()) continue;
    const steady::HubCoupling& both = turning.couplings[i];
    const SecondOrder by_hub = stand_columns({both.M_bh, both.C_bh, both.K_bh}, axes);
    const Turning back = transpose(axes.T);
    add(by_hub.M * back, at, 0, system.M);
    add(by_hub.C * back, at, 0, system.C);
    add(by_hub.K * back, at, 0, system.K);
    add(axes.T * both.M_hb, 0, at, system.M);
    add(axes.T * both.C_hb, 0, at, system.C);
    add(axes.T * both.K_hb, 0, at, system.K);
  }
  return system;
}

Periodic interpolate(const std::vector<MatrixXd>& values) {
  assert(values.size() % 2 == 1);
  const double count = static_cast<double>(values.size());
  Periodic sum{
      std::vector<MatrixXd>(values.size(), MatrixXd::Zero(values[0].rows(), values[0].cols()))};
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double psi = 2.0 * std::numbers::pi * static_cast<double>(k) / count;
    sum.parts[0] += values[k] / count;
    for (std::size_t p = 1; p < values.size(); ++p) {
      const std::size_t multiple = (p + 1) / 2;
      const double angle = psi * static_cast<double>(multiple);
      sum.parts[p] += 2.0 / count * (p % 2 == 1 ? std::cos(angle) : std::sin(angle)) * values[k];
    }
  }
  return sum;
}

PeriodicSystem stand_on(const PeriodicSystem& rotor, const MatrixXd& J,
                        const SecondOrder& support) {
  assert(J.rows() == rotor.hub && support.M.rows() == J.cols());
  const Index z = J.cols(), blades = rotor.size() - rotor.hub;
  MatrixXd whole = MatrixXd::Zero(rotor.size(), z + blades);
  whole.topLeftCorner(J.rows(), z) = J;
  whole.bottomRightCorner(blades, blades).setIdentity();
  PeriodicSystem system = rotor;
  for (Periodic* matrix : {&system.M, &system.C, &system.K})
    for (MatrixXd& part : matrix->parts) part = (whole.transpose() * part * whole).eval();
  system.M.parts[0].topLeftCorner(z, z) += support.M;
  system.C.parts[0].topLeftCorner(z, z) += support.C;
  system.K.parts[0].topLeftCorner(z, z) += support.K;
  system.hub = z;
  for (Index& start : system.starts) start += z - rotor.hub;
  return system;
}

}  // namespace spoke::vibration
