// Integrates a turn, and takes the modes of its matrix apart into harmonics.

#include "engine/small_motions/vibration/turn_modes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/support/dense.h"
#include "models/error.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

constexpr double kCircle = 2.0 * std::numbers::pi;

constexpr Index kStages = 7;
using StageMatrix = Eigen::Matrix<double, kStages, kStages>;
using StageVector = Eigen::Matrix<double, kStages, 1>;

/// Stages of the Radau IIA method of order 13 (Hairer and Wanner, Solving Ordinary Differential
/// Equations II, section IV.5): collocation at the zeros of P_7 - P_6, Legendre's polynomials over
/// a step.
struct Radau {
  StageMatrix A;
  StageVector c;
};
Radau make_radau() {
  Radau method;
  method.c << 0.029316427159784892, 0.148078599668484292, 0.336984690281154299,
      0.558671518771550132, 0.769233862030054501, 0.926945671319741115, 1.0;
  // Legendre's polynomials at the stages, and their integrals from the start.
  Eigen::Matrix<double, kStages, kStages + 1> P;
  for (Index i = 0; i < kStages; ++i) {
    const double u = 2.0 * method.c[i] - 1.0;
    P(i, 0) = 1.0;
    P(i, 1) = u;
    for (Index k = 1; k < kStages; ++k) {
      const auto n = static_cast<double>(k);
      P(i, k + 1) = ((2.0 * n + 1.0) * u * P(i, k) - n * P(i, k - 1)) / (n + 1.0);
    }
  }
  StageMatrix integrals;
  integrals.col(0) = method.c;
  for (Index k = 1; k < kStages; ++k)
    integrals.col(k) = (P.col(k + 1) - P.col(k - 1)) / (4.0 * static_cast<double>(k) + 2.0);
  const MatrixXd values = P.leftCols<kStages>().transpose();
  method.A = LuFactors(values).solve(integrals.transpose()).transpose();
  return method;
}

/// Takes columns of states (x, x') from azimuth psi over a step of h seconds: with accelerations
/// a_i at the stages, x'_i = x' + h sum A_ij a_j and x_i = x + h c_i x' + h^2 sum (A A)_ij a_j. The
/// last stage is the end.
void step(const PeriodicSystem& system, const Radau& method, double psi, double h,
          MatrixXd& states) {
  const Index n = system.size();
  const StageMatrix twice = method.A * method.A;
  constexpr Index kLast = kStages - 1;
  MatrixXd left(kStages * n, kStages * n), right(kStages * n, states.cols());
  const auto x = states.topRows(n), v = states.bottomRows(n);
  for (Index i = 0; i < kStages; ++i) {
    const double at = psi + system.speed * h * method.c[i];
    const MatrixXd C = system.C.at(at), K = system.K.at(at);
    for (Index j = 0; j < kStages; ++j)
      left.block(i * n, j * n, n, n) = h * method.A(i, j) * C + h * h * twice(i, j) * K;
    left.block(i * n, i * n, n, n) += system.M.at(at);
    right.middleRows(i * n, n) = -C * v - K * (x + h * method.c[i] * v);
  }
  const MatrixXd a = LuFactors(left).solve(right);
  states.topRows(n) += h * states.bottomRows(n);
  for (Index j = 0; j < kStages; ++j) {
    states.topRows(n) += h * h * twice(kLast, j) * a.middleRows(j * n, n);
    states.bottomRows(n) += h * method.A(kLast, j) * a.middleRows(j * n, n);
  }
}

/// The states that begin as the identity, at equal parts of a turn.
struct Turn {
  std::vector<MatrixXd> states;  ///< the last after the whole turn
  GeneralEigen eigen;            ///< of the whole turn
};
Turn integrate(const PeriodicSystem& system, Index samples, Index steps_between) {
  static const Radau method = make_radau();
  const double period = kCircle / std::abs(system.speed);
  const auto steps = static_cast<double>(samples * steps_between);
  Turn turn;
  MatrixXd states = MatrixXd::Identity(2 * system.size(), 2 * system.size());
  for (Index k = 0; k < samples; ++k) {
    turn.states.push_back(states);
    for (Index l = 0; l < steps_between; ++l) {
      const double t = period * static_cast<double>(k * steps_between + l) / steps;
      step(system, method, system.speed * t, period / steps, states);
    }
  }
  turn.states.push_back(states);
  turn.eigen = solve_general(states);
  return turn;
}

/// Returns the harmonics of the periodic part of an eigenvector, from -samples/2 on.
std::vector<Harmonic> list_harmonics(const Turn& turn, Index column, Complex exponent,
                                     const PeriodicSystem& system) {
  const Index samples = std::ssize(turn.states) - 1, n = system.size();
  const double period = kCircle / std::abs(system.speed);
  const VectorXcd start = turn.eigen.vectors.col(column);
  MatrixXcd periodic(n, samples);
  for (Index k = 0; k < samples; ++k) {
    const double t = period * static_cast<double>(k) / static_cast<double>(samples);
    periodic.col(k) = std::exp(-exponent * t) *
                      (turn.states[static_cast<std::size_t>(k)].topRows(n).cast<Complex>() * start);
  }
  std::vector<Harmonic> harmonics;
  double all = 0.0;
  for (Index m = -samples / 2 + 1; m < samples / 2; ++m) {
    Harmonic& harmonic = harmonics.emplace_back();
    harmonic.multiple = static_cast<int>(m);
    VectorXcd waves(samples);
    for (Index k = 0; k < samples; ++k)
      waves[k] = std::polar(
          1.0 / static_cast<double>(samples),
          -kCircle * static_cast<double>(m * k % samples) / static_cast<double>(samples));
    harmonic.amplitude = periodic * waves;
    const VectorXd real = harmonic.amplitude.real(), imag = harmonic.amplitude.imag();
    harmonic.share = real.dot(system.M.parts[0] * real) + imag.dot(system.M.parts[0] * imag);
    all += harmonic.share;
  }
  for (Harmonic& harmonic : harmonics) harmonic.share /= all;
  return harmonics;
}

/// Whether the samples resolve a motion: otherwise its rates are faster than those of its
/// harmonics, which then are those of a slower motion.
bool is_resolved(const Turn& turn, Index column, Complex exponent,
                 const std::vector<Harmonic>& harmonics, const PeriodicSystem& system) {
  const Index n = system.size();
  const VectorXcd start = turn.eigen.vectors.col(column);
  const auto mass_of = [&](const VectorXcd& x) {
    return x.real().dot(system.M.parts[0] * x.real()) + x.imag().dot(system.M.parts[0] * x.imag());
  };
  double of_place = 0.0, of_rate = 0.0;
  for (Index k = 0; k + 1 < std::ssize(turn.states); ++k) {
    const VectorXcd state = turn.states[static_cast<std::size_t>(k)].cast<Complex>() * start;
    const double grown =
        std::exp(-2.0 * exponent.real() * kCircle / std::abs(system.speed) *
                 static_cast<double>(k) / static_cast<double>(std::ssize(turn.states) - 1));
    of_place += grown * mass_of(state.head(n));
    of_rate += grown * mass_of(state.tail(n));
  }
  double expected = 0.0;
  for (const Harmonic& harmonic : harmonics)
    expected += harmonic.share *
                std::norm(exponent + Complex(0.0, harmonic.multiple * std::abs(system.speed)));
  const double least = 1e-6 * system.speed * system.speed;  // of what stands
  return of_rate <= 2.0 * (expected + least) * of_place;
}

/// Returns the mode of a multiplier; none if the conjugate one stands for it, or if it is too fast.
/// Of the two multipliers of a motion that goes on both have a mode: round-off may make them
/// conjugate.
std::vector<PeriodicMode> describe(const Turn& turn, Index column, const PeriodicSystem& system) {
  constexpr double kEqual = 1e-6, kReal = 1e-10, kLeast = 1e-14, kHalf = 1e-4;
  const double w = std::abs(system.speed), period = kCircle / w;
  Complex multiplier = turn.eigen.values[column];
  if (std::abs(multiplier) < kLeast) return {};  // too stiff
  if (std::abs(multiplier.imag()) < kReal * std::abs(multiplier)) multiplier.imag(0.0);
  const Complex exponent = std::log(multiplier) / period;
  PeriodicMode mode{exponent, multiplier, list_harmonics(turn, column, exponent, system)};
  if (!is_resolved(turn, column, exponent, mode.harmonics, system)) return {};
  const auto frequency = [&](const Harmonic& h) { return exponent.imag() + h.multiple * w; };
  const Harmonic* strongest = &mode.harmonics[0];
  for (const Harmonic& harmonic : mode.harmonics) {
    const double more = harmonic.share - strongest->share;
    // Real motions have pairs of equal harmonics.
    if (more > kEqual || (more > -kEqual && frequency(harmonic) > frequency(*strongest)))
      strongest = &harmonic;
  }
  const int shift = strongest->multiple;
  mode.s.imag(frequency(*strongest));
  const bool goes_on = std::abs(multiplier - 1.0) < kHalf && std::abs(mode.s) < kHalf * w;
  if (mode.s.imag() < 0.0 && !goes_on) return {};
  mode.s.imag(std::abs(mode.s.imag()));
  for (Harmonic& harmonic : mode.harmonics) harmonic.multiple -= shift;
  return {mode};
}

std::vector<PeriodicMode> list_modes(const Turn& turn, const PeriodicSystem& system, Index count) {
  std::vector<PeriodicMode> modes;
  for (Index k = 0; k < turn.eigen.values.size(); ++k)
    for (PeriodicMode& mode : describe(turn, k, system)) modes.push_back(std::move(mode));
  std::stable_sort(modes.begin(), modes.end(), [](const PeriodicMode& a, const PeriodicMode& b) {
    return std::abs(a.s) < std::abs(b.s);
  });
  if (std::ssize(modes) > count) modes.resize(static_cast<std::size_t>(count));
  return modes;
}

/// Whether each mode's multiplier is known by one of the turn with half as many steps: halving is
/// taken to gain a factor of 1000, an eighth of what the method's order promises for short steps.
/// Of multipliers that meet, as those of a rigid motion, half of the digits are known.
bool are_known(const std::vector<PeriodicMode>& modes, const Turn& turn, const Turn& rough) {
  constexpr double kGain = 1000.0, kTolerance = 1e-9, kMeet = 1e-3, kHalf = 1e-4;
  return std::all_of(modes.begin(), modes.end(), [&](const PeriodicMode& mode) {
    const double size = std::abs(mode.multiplier);
    const auto near = ((turn.eigen.values.array() - mode.multiplier).abs() < kMeet * size).count();
    const double error = (rough.eigen.values.array() - mode.multiplier).abs().minCoeff() / kGain;
    return error <= std::max(size, kTolerance) * (near > 1 ? kHalf : kTolerance);
  });
}

}  // namespace

double find_reach(const PeriodicSystem& system, Index count) {
  const Index n = system.size();
  MatrixXd first = MatrixXd::Zero(2 * n, 2 * n);
  first.topRightCorner(n, n).setIdentity();
  const LuFactors mass(system.M.parts[0]);
  first.bottomLeftCorner(n, n) = -mass.solve(system.K.parts[0]);
  first.bottomRightCorner(n, n) = -mass.solve(system.C.parts[0]);
  VectorXd sizes = find_eigenvalues(first).cwiseAbs();
  std::sort(sizes.begin(), sizes.end());
  return sizes[std::min(2 * count, 2 * n) - 1] / std::abs(system.speed);
}

std::vector<PeriodicMode> find_modes_over_turn(const PeriodicSystem& system, Index count) {
  constexpr Index kMostSteps = 1 << 13, kGroup = 8;
  // Four steps for each round of the fastest, which the matrices and their products modulate.
  const std::size_t degree = system.K.parts.size() / 2;
  const double reach = find_reach(system, count) + static_cast<double>(degree) + 4.0;
  if (4.0 * reach > kMostSteps)
    throw InputError("the frame \"floquet\" would take more than " + std::to_string(kMostSteps) +
                     " steps over a turn for " + std::to_string(count) +
                     " modes: expected fewer modes, or a faster hub");
  const Index samples = kGroup * static_cast<Index>(std::ceil(4.0 * reach / kGroup));
  Turn rough = integrate(system, samples / 2, 1);
  std::vector<PeriodicMode> modes;
  for (Index between = 1; between == 1 || samples * between <= kMostSteps; between *= 2) {
    Turn turn = integrate(system, samples, between);
    modes = list_modes(turn, system, count);
    if (are_known(modes, turn, rough)) break;
    rough = std::move(turn);
  }
  return modes;
}

}  // namespace spoke::vibration
