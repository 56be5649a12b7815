// Takes derivatives at equal parts of a turn, and their Fourier series.

#include <cassert>
#include <cmath>
#include <vector>

#include "engine/small_motions/steady/derivatives.h"
#include "engine/small_motions/vibration/periodic_orbit.h"
#include "engine/small_motions/vibration/rotation_rates.h"
#include "engine/small_motions/vibration/turn_motion.h"
#include "engine/small_motions/vibration/turn_series.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using steady::SteadyModel;

/// Returns the derivative of the inertia forces of accelerations `a`, on the hub and, below, on
/// coordinates, by the coordinates: the mass matrix depends on them.
MatrixXd differ_inertia(std::size_t i, const steady::SubsystemState& state, const VectorXd& a,
                        SteadyModel& whole) {
  constexpr double kStep = 1e-4;  // by the scale of a coordinate; of second order
  const Index n = a.size();
  MatrixXd slope(whole.twist_size() + n, n);
  steady::SubsystemState moved = state;
  steady::SubsystemResponse response;
  const auto inertia = [&](Index k, double q) {
    moved.q[k] = q;
    whole.evaluate(i, moved, whole.no_offset(), response);
    return whole.momenta(i, a);
  };
  for (Index k = 0; k < n; ++k) {
    const double h = kStep * whole.coordinates(i)[static_cast<std::size_t>(k)].scale;
    slope.col(k) = (inertia(k, state.q[k] + h) - inertia(k, state.q[k] - h)) / (2.0 * h);
    moved.q[k] = state.q[k];
  }
  return slope;
}

/// Matrices of the hub's angle, if it is free, and of one subsystem.
struct Matrices {
  MatrixXd M, C, K;
};

/// Takes matrices for accelerations, velocities and coordinates, and equations by velocities, to
/// those for coordinates and their rates.
void take_rates(const RateMaps& maps, Matrices& of) {
  const MatrixXd back = maps.v_by_rate.transpose();
  of.K = back * (of.K + of.C * maps.v_by_x + of.M * maps.a_by_x);
  of.C = back * (of.C * maps.v_by_rate + of.M * maps.a_by_rate);
  of.M = back * of.M * maps.v_by_rate;
}

Matrices linearise_subsystem(std::size_t i, Index at, const VectorXd& q, const TurnMotion& motion,
                             Index l, Index hub, SteadyModel& whole) {
  const Index n = q.size(), axial = whole.twist_size() - 1;
  const VectorXd moved = q + motion.x.col(l).segment(at, n), v = motion.v.col(l).segment(at, n);
  const steady::SubsystemState state{moved, v, moved, v};
  const MatrixXd slope = differ_inertia(i, state, motion.a.col(l).segment(at, n), whole);
  const steady::SubsystemDerivatives by = steady::calc_derivatives(i, state, hub > 0, whole);
  const steady::SubsystemMatrices own = whole.matrices(i);
  Matrices result;
  result.M = result.C = result.K = MatrixXd::Zero(hub + n, hub + n);
  result.M.bottomRightCorner(n, n) = own.mass.bottomRightCorner(n, n);
  result.C.bottomRightCorner(n, n) = own.damping - by.by_v.topRows(n);
  result.K.bottomRightCorner(n, n) = whole.stiffness(i) - by.by_q.topRows(n) + slope.bottomRows(n);
  if (hub == 0) return result;
  // Of the rows on the hub that of its axis is left, which is below the subsystem's.
  result.M(0, 0) = own.mass(axial, axial);
  result.C(0, 0) = -by.by_twist(n + axial, axial);
  result.K(0, 0) = -by.by_turn(n + axial, axial);
  result.M.col(0).tail(n) = own.mass.col(axial).tail(n);
  result.C.col(0).tail(n) = -by.by_twist.col(axial).head(n);
  result.K.col(0).tail(n) = -by.by_turn.col(axial).head(n);
  result.M.row(0).tail(n) = own.mass.row(axial).tail(n);
  result.C.row(0).tail(n) = -by.by_v.row(n + axial);
  result.K.row(0).tail(n) = -by.by_q.row(n + axial) + slope.row(axial);
  return result;
}

/// Returns the matrices of the hub's own angle.
Matrices linearise_hub(SteadyModel& whole) {
  constexpr double kStep = 1e-4;
  const Index axial = whole.twist_size() - 1;
  const auto differ = [&](steady::HubVector steady::HubOffset::*member) {
    steady::HubOffset plus = whole.no_offset(), minus = plus;
    (plus.*member)[axial] = kStep;
    (minus.*member)[axial] = -kStep;
    return (whole.hub_force(plus)[axial] - whole.hub_force(minus)[axial]) / (2.0 * kStep);
  };
  const auto one = [](double value) { return MatrixXd::Constant(1, 1, value); };
  return {one(whole.hub_mass()(axial, axial)), one(-differ(&steady::HubOffset::twist)),
          one(-differ(&steady::HubOffset::turn))};
}

/// Fourier series of matrices of one size.
struct Series {
  MatrixXcd M, C, K;  ///< entries in rows, harmonics in columns
};

template <class At>
Series sample(Index entries, Index parts, const At& at) {
  MatrixXd M(entries, parts), C = M, K = M;
  for (Index l = 0; l < parts; ++l) {
    const Matrices now = at(l);
    M.col(l) = now.M.reshaped();
    C.col(l) = now.C.reshaped();
    K.col(l) = now.K.reshaped();
  }
  return {find_harmonics(M), find_harmonics(C), find_harmonics(K)};
}

/// Adds a block of the first `hub` coordinates and of those from `at` on.
void add_block(const MatrixXcd& series, Index hub, Index at, Periodic& sum) {
  const auto size = static_cast<Index>(std::lround(std::sqrt(series.rows())));
  const Index n = size - hub;
  const auto add = [&](const MatrixXd& block, MatrixXd& to) {
    to.topLeftCorner(hub, hub) += block.topLeftCorner(hub, hub);
    to.block(at, 0, n, hub) += block.bottomLeftCorner(n, hub);
    to.block(0, at, hub, n) += block.topRightCorner(hub, n);
    to.block(at, at, n, n) += block.bottomRightCorner(n, n);
  };
  for (Index k = 0; k < series.cols(); ++k) {
    const MatrixXcd block = series.col(k).reshaped(size, size);
    const auto part = static_cast<std::size_t>(2 * k);
    if (k == 0) {
      add(block.real(), sum.parts[0]);
      continue;
    }
    add(2.0 * block.real(), sum.parts[part - 1]);
    add(-2.0 * block.imag(), sum.parts[part]);
  }
}

void add_series(const Series& series, double angle, Index hub, Index at, PeriodicSystem& sum) {
  add_block(shift_azimuth(series.M, angle), hub, at, sum.M);
  add_block(shift_azimuth(series.C, angle), hub, at, sum.C);
  add_block(shift_azimuth(series.K, angle), hub, at, sum.K);
}

/// Whether subsystem `i` moves as `first` does when it passes the same place.
bool moves_alike(std::size_t i, std::size_t first, const PeriodicOrbit& orbit,
                 const Linearised& all, const PeriodicSystem& mean) {
  constexpr double kRoundOff = 1e-8;
  const Index n = all.equilibrium.q[i].size();
  const double angle = all.model.azimuth(i) - all.model.azimuth(first);
  const MatrixXcd expected =
      shift_azimuth(orbit.harmonics.middleRows(mean.starts[first], n), angle);
  const MatrixXcd own = orbit.harmonics.middleRows(mean.starts[i], n);
  return (own - expected).norm() <= kRoundOff * orbit.harmonics.norm();
}

/// Leaves away the highest harmonics that are round-off in all matrices of a kind.
void trim(Periodic& matrix) {
  constexpr double kRoundOff = 1e-14;
  const double least = kRoundOff * matrix.parts[0].lpNorm<Eigen::Infinity>();
  while (matrix.parts.size() > 1 && matrix.parts.back().lpNorm<Eigen::Infinity>() <= least &&
         matrix.parts[matrix.parts.size() - 2].lpNorm<Eigen::Infinity>() <= least)
    matrix.parts.resize(matrix.parts.size() - 2);
}

}  // namespace

PeriodicSystem linearise_along(const PeriodicOrbit& orbit, const Linearised& all,
                               const PeriodicSystem& mean, SteadyModel& whole) {
  const Index hub = mean.hub, parts = orbit.parts();
  assert(hub <= 1);
  const std::vector<RotationAt> rotations = list_rotations(mean, whole);
  const TurnMotion rates = make_turn_motion(orbit.harmonics, mean.speed);
  const TurnMotion motion = find_velocities(rates, rotations);
  PeriodicSystem result = mean;
  result.M = result.C = result.K = make_zero_periodic(mean.size(), orbit.harmonics.cols() - 1);
  if (hub > 0)
    add_series(sample(1, parts,
                      [&](Index l) {
                        place_hub(motion, l, hub, whole);
                        return linearise_hub(whole);
                      }),
               0.0, hub, hub, result);
  std::vector<Series> found(all.model.subsystems());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Index at = mean.starts[i], n = all.equilibrium.q[i].size();
    std::size_t& first = result.alike[i];
    if (first != i && !moves_alike(i, first, orbit, all, mean)) first = i;
    if (first == i)
      found[i] = sample((hub + n) * (hub + n), parts, [&](Index l) {
        place_hub(motion, l, hub, whole);
        orbit.wake.hold(i, l, whole);
        Matrices own = linearise_subsystem(i, at, all.equilibrium.q[i], motion, l, hub, whole);
        if (!rotations.empty()) take_rates(find_rate_maps(rates, l, rotations, hub, at, n), own);
        return own;
      });
    add_series(found[first], all.model.azimuth(i) - all.model.azimuth(first), hub, at, result);
  }
  for (Periodic* matrix : {&result.M, &result.C, &result.K}) trim(*matrix);
  return result;
}

}  // namespace spoke::vibration
