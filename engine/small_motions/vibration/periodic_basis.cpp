// Lets the forces that modes leave without balance deform the mean system.

#include "engine/small_motions/vibration/periodic_basis.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "engine/small_motions/vibration/turn_modes.h"
#include "engine/support/dense.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

/// Motion of a mode without its growth and phase: displacements, velocities and accelerations.
struct State {
  VectorXcd x, v, a;
};
State state_of(const PeriodicMode& mode, double psi, double speed) {
  const Index n = mode.harmonics[0].amplitude.size();
  State state{VectorXcd::Zero(n), VectorXcd::Zero(n), VectorXcd::Zero(n)};
  for (const Harmonic& harmonic : mode.harmonics) {
    const double k = harmonic.multiple;
    const Complex s = mode.s + Complex(0.0, k * std::abs(speed));
    const VectorXcd part = std::polar(1.0, k * (speed < 0.0 ? -psi : psi)) * harmonic.amplitude;
    state.x += part;
    state.v += s * part;
    state.a += s * s * part;
  }
  return state;
}

/// Returns the square root of the mode's mass.
double size_of(const PeriodicMode& mode, const MatrixXd& M) {
  double sum = 0.0;
  for (const Harmonic& harmonic : mode.harmonics) {
    const VectorXd real = harmonic.amplitude.real(), imag = harmonic.amplitude.imag();
    sum += real.dot(M * real) + imag.dot(M * imag);
  }
  return std::sqrt(sum);
}

/// Returns the number of equal parts of a turn that tell the harmonics of the modes apart.
Index count_parts(const PeriodicSystem& system, const std::vector<PeriodicMode>& modes) {
  constexpr double kShare = 1e-12;
  int highest = 0;
  for (const PeriodicMode& mode : modes)
    for (const Harmonic& harmonic : mode.harmonics)
      if (harmonic.share > kShare) highest = std::max(highest, std::abs(harmonic.multiple));
  return 2 * (highest + static_cast<Index>(system.K.parts.size() / 2)) + 2;
}

/// Returns the forces that modes of unit mass leave without balance over a turn: columns of real
/// and imaginary parts.
MatrixXd list_forces(const PeriodicSystem& system, const std::vector<PeriodicMode>& modes) {
  const Index parts = count_parts(system, modes);
  std::vector<double> sizes;
  for (const PeriodicMode& mode : modes) sizes.push_back(size_of(mode, system.M.parts[0]));
  MatrixXd forces(system.size(), 2 * parts * std::ssize(modes));
  Index column = 0;
  for (Index l = 0; l < parts; ++l) {
    const double psi = 2.0 * std::numbers::pi * static_cast<double>(l) / static_cast<double>(parts);
    const MatrixXd M = system.M.at(psi), C = system.C.at(psi), K = system.K.at(psi);
    for (std::size_t k = 0; k < modes.size(); ++k) {
      const State state = state_of(modes[k], psi, system.speed);
      for (const bool is_real : {true, false}) {
        const auto part = [&](const VectorXcd& of) {
          return is_real ? VectorXd(of.real()) : VectorXd(of.imag());
        };
        forces.col(column++) =
            (M * part(state.a) + C * part(state.v) + K * part(state.x)) / sizes[k];
      }
    }
  }
  return forces;
}

/// Takes away what columns have in common with the basis V, by the mass matrix M.
void part_from(const MatrixXd& V, const MatrixXd& M, MatrixXd& columns) {
  const MatrixXd shared = V.transpose() * (M * columns);
  columns -= V * shared;
}

/// Returns columns that span these but for what is less than `least`, of unit mass and without
/// common mass: the largest first, of the others what is beyond it. They have no part in V.
MatrixXd choose_basis(const MatrixXd& V, const MatrixXd& M, MatrixXd columns, double least) {
  MatrixXd momenta = M * columns, basis(V.rows(), 0);
  while (V.cols() + basis.cols() < V.rows()) {
    Index k = 0;
    const double mass = columns.cwiseProduct(momenta).colwise().sum().maxCoeff(&k);
    if (!(mass > least * least)) break;
    MatrixXd next = columns.col(k);
    part_from(V, M, next);
    part_from(basis, M, next);
    next /= std::sqrt((next.transpose() * M * next).value());
    const MatrixXd momentum = M * next, shares = momentum.transpose() * columns;
    columns -= next * shares;
    momenta -= momentum * shares;
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols(1) = next;
  }
  return basis;
}

}  // namespace

PeriodicSystem project(const PeriodicSystem& system, const MatrixXd& V) {
  PeriodicSystem reduced = system;
  for (Periodic* matrix : {&reduced.M, &reduced.C, &reduced.K})
    for (MatrixXd& part : matrix->parts) part = (V.transpose() * part * V).eval();
  return reduced;
}

MatrixXd find_low_motions(const PeriodicSystem& system, Index count) {
  constexpr double kBeyond = 3.0;
  const Index n = system.size();
  const MatrixXd& K = system.K.parts[0];
  const CholeskyFactor mass(system.M.parts[0]);
  SymmetricEigen modes =
      solve_symmetric(mass.solve_upper_on_the_right(mass.solve_lower(0.5 * (K + K.transpose()))));
  for (Index k = 0; k < n; ++k) modes.vectors.col(k) = mass.solve_upper(modes.vectors.col(k));
  const Index least = std::min(n, count + 4);
  const MatrixXd some = modes.vectors.leftCols(std::min(n, 2 * least));
  const double reach = find_reach(project(system, some), count) * std::abs(system.speed);
  const auto low = (modes.values.array() <= std::pow(kBeyond * reach, 2)).count();
  return modes.vectors.leftCols(std::max<Index>(low, least));
}

MatrixXd find_missing_motions(const PeriodicSystem& system, const MatrixXd& V,
                              const std::vector<PeriodicMode>& modes) {
  constexpr double kLeast = 1e-7;
  double fastest = 0.0;
  for (const PeriodicMode& mode : modes) fastest = std::max(fastest, std::abs(mode.s));
  const double shift = std::pow(fastest + std::abs(system.speed), 2);
  const MatrixXd& M = system.M.parts[0];
  const LuFactors stiffness(system.K.parts[0] + shift * M);
  // Twice: the second motions are what the inertia of the first adds.
  MatrixXd once = stiffness.solve(list_forces(system, modes));
  part_from(V, M, once);
  MatrixXd twice = shift * stiffness.solve(M * once);
  part_from(V, M, twice);
  MatrixXd both(once.rows(), 2 * once.cols());
  both << once, twice;
  return choose_basis(V, M, std::move(both), kLeast);
}

}  // namespace spoke::vibration
