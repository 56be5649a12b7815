// Balances the harmonics of a motion.

#include "engine/small_motions/vibration/periodic_orbit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <deque>
#include <iomanip>
#include <limits>
#include <sstream>
#include <vector>

#include "engine/small_motions/vibration/rotation_rates.h"
#include "engine/small_motions/vibration/turn_series.h"
#include "engine/support/dense.h"
#include "models/error.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using steady::SteadyModel;
using Complex = std::complex<double>;

constexpr Index kLeastHarmonics = 8, kMostHarmonics = 32;
// Shares of the highest harmonics that may be left away. In air coefficients are linear between the
// angles of their tables: at each that a section passes the forces have a kink, and the harmonics
// of the motion fall with the fourth power of their number. Motions as the first are sought up to
// 16 harmonics; more are taken as they are up to the second.
constexpr double kTail = 1e-10, kTailInAir = 1e-7, kMostInAir = 1e-5;

/// The forces that a motion leaves without balance.
class Balance {
 public:
  Balance(const Linearised& all, const PeriodicSystem& mean, SteadyModel& whole)
      : all_(all), mean_(mean), whole_(whole), rotations_(list_rotations(mean, whole)) {}

  /// Returns them on all coordinates at an azimuth; none beyond the limits of the model. `part`:
  /// which part of a turn that is, with the wake there; none: with one of equilibrium.
  std::optional<VectorXd> at(double psi, const VectorXd& x, const VectorXd& v, const VectorXd& a,
                             std::optional<Index> part = std::nullopt) {
    const Index h = mean_.hub, axial = whole_.twist_size() - 1;
    whole_.move_hub(psi + x.head(h).sum(), v.head(h).sum(), a.head(h).sum());
    VectorXd left = VectorXd::Zero(x.size());
    if (h > 0) left[0] = whole_.hub_force(whole_.no_offset())[axial];
    for (std::size_t i = 0; i < whole_.subsystems(); ++i) {
      const Index at = mean_.starts[i], n = all_.equilibrium.q[i].size();
      const VectorXd q = all_.equilibrium.q[i] + x.segment(at, n), rate = v.segment(at, n);
      if (part) wake_.hold(i, *part, whole_);
      steady::SubsystemResponse response;
      whole_.evaluate(i, {q, rate, q, rate}, whole_.no_offset(), response);
      if (!response.is_valid) return std::nullopt;
      const VectorXd inertia = whole_.momenta(i, a.segment(at, n));
      left.segment(at, n) = response.force - inertia.tail(n);
      if (h > 0) left[0] += response.hub_force[axial] - inertia[axial];
    }
    return left;
  }

  /// Returns their harmonics for a motion; none beyond the limits of the model.
  std::optional<MatrixXcd> of(const MatrixXcd& harmonics) {
    const TurnMotion motion = find_velocities(make_turn_motion(harmonics, mean_.speed), rotations_);
    if (!wake_.follow(motion, mean_, all_.equilibrium.q, whole_)) return std::nullopt;
    MatrixXd left(motion.x.rows(), motion.parts());
    for (Index l = 0; l < motion.parts(); ++l) {
      const std::optional<VectorXd> now =
          at(motion.azimuth(l), motion.x.col(l), motion.v.col(l), motion.a.col(l), l);
      if (!now) return std::nullopt;
      left.col(l) = *now;
    }
    return find_harmonics(left);
  }

  /// Returns the wake of the motion that was balanced last.
  const PeriodicWake& wake() const { return wake_; }

 private:
  const Linearised& all_;
  const PeriodicSystem& mean_;
  SteadyModel& whole_;
  std::vector<RotationAt> rotations_;
  PeriodicWake wake_;
};

/// Returns the forces on all coordinates where the model is in its equilibrium, at an azimuth, the
/// torque on a hub that turns freely last [N, N m]; none beyond its limits.
std::optional<VectorXd> calc_forces_at(double psi, const Linearised& all, SteadyModel& whole) {
  whole.move_hub(psi, 0.0, 0.0);
  const Index axial = whole.twist_size() - 1;
  double torque = whole.hub_force(whole.no_offset())[axial];
  std::vector<double> forces;
  for (std::size_t i = 0; i < whole.subsystems(); ++i) {
    steady::SubsystemResponse response;
    whole.evaluate(i, steady::make_state(all.equilibrium, i), whole.no_offset(), response);
    if (!response.is_valid) return std::nullopt;
    forces.insert(forces.end(), response.force.begin(), response.force.end());
    torque += response.hub_force[axial];
  }
  if (!all.model.free_components().empty()) forces.push_back(torque);
  return Eigen::Map<const VectorXd>(forces.data(), std::ssize(forces));
}

/// Answers of the mean system to the harmonics of forces.
class MeanResponse {
 public:
  MeanResponse(const PeriodicSystem& mean, Index highest) : size_(mean.size()) {
    const MatrixXd &M = mean.M.parts[0], &C = mean.C.parts[0], &K = mean.K.parts[0];
    for (Index k = 0; k <= highest; ++k) {
      const double w = mean.speed * static_cast<double>(k);
      MatrixXd real = K - w * w * M, imag = w * C;
      if (k == 0 && mean.hub > 0) {  // what drives the hub holds its mean angle
        real.row(0).setZero();
        real.col(0).setZero();
        real(0, 0) = 1.0;
      }
      MatrixXd both(2 * size_, 2 * size_);
      both << real, -imag, imag, real;
      factors_.emplace_back(both);
    }
    holds_hub_ = mean.hub > 0;
  }

  MatrixXcd to(const MatrixXcd& forces) const {
    MatrixXcd motion(size_, forces.cols());
    for (Index k = 0; k < forces.cols(); ++k) {
      VectorXd right(2 * size_), solution(2 * size_);
      right << forces.col(k).real(), forces.col(k).imag();
      if (k == 0 && holds_hub_) right[0] = right[size_] = 0.0;
      factors_[static_cast<std::size_t>(k)].solve(right, solution);
      motion.col(k).real() = solution.head(size_);
      motion.col(k).imag() = solution.tail(size_);
    }
    return motion;
  }

 private:
  Index size_;
  bool holds_hub_ = false;
  std::vector<LuFactors> factors_;
};

/// Anderson's acceleration of y <- y + f(y).
class Acceleration {
 public:
  VectorXd next(const VectorXd& y, const VectorXd& f) {
    constexpr std::size_t kDepth = 8;
    if (last_y_.size() == y.size()) {
      dy_.push_back(y - last_y_);
      df_.push_back(f - last_f_);
      if (dy_.size() > kDepth) {
        dy_.pop_front();
        df_.pop_front();
      }
    }
    last_y_ = y;
    last_f_ = f;
    VectorXd result = y + f;
    if (df_.empty()) return result;
    MatrixXd changes(f.size(), std::ssize(df_));
    for (std::size_t k = 0; k < df_.size(); ++k) changes.col(static_cast<Index>(k)) = df_[k];
    LeastSquares least;
    least.compute(changes);
    const VectorXd shares = least.solve(f);
    for (std::size_t k = 0; k < df_.size(); ++k)
      result -= shares[static_cast<Index>(k)] * (dy_[k] + df_[k]);
    return result;
  }

 private:
  std::deque<VectorXd> dy_, df_;
  VectorXd last_y_, last_f_;
};

/// Returns large values of the coordinates.
VectorXd find_scale(const PeriodicSystem& mean, const SteadyModel& model) {
  VectorXd scale = VectorXd::Ones(mean.size());
  for (std::size_t i = 0; i < model.subsystems(); ++i)
    for (std::size_t k = 0; k < model.coordinates(i).size(); ++k)
      scale[mean.starts[i] + static_cast<Index>(k)] = model.coordinates(i)[k].scale;
  return scale;
}

VectorXd pack(const MatrixXcd& harmonics, const VectorXd& scale) {
  const MatrixXcd scaled = scale.cwiseInverse().asDiagonal() * harmonics;
  VectorXd list(2 * scaled.size());
  list << scaled.real().reshaped(), scaled.imag().reshaped();
  return list;
}
MatrixXcd unpack(const VectorXd& list, const VectorXd& scale) {
  const Index half = list.size() / 2, columns = half / scale.size();
  MatrixXcd harmonics(scale.size(), columns);
  harmonics.real() = list.head(half).reshaped(scale.size(), columns);
  harmonics.imag() = list.tail(half).reshaped(scale.size(), columns);
  return scale.asDiagonal() * harmonics;
}

/// `why`: what a coordinate does.
[[noreturn]] void give_up(const PeriodicSystem& mean, const VectorXd& scale,
                          const MatrixXcd& correction, const SteadyModel& model,
                          const std::string& why) {
  Index worst = 0;
  (scale.cwiseInverse().asDiagonal() * correction).rowwise().norm().maxCoeff(&worst);
  std::string name = "the hub's angle";
  std::string subsystem = "hub";
  for (std::size_t i = 0; i < model.subsystems(); ++i) {
    const Index k = worst - mean.starts[i];
    if (k < 0 || k >= std::ssize(model.coordinates(i))) continue;
    subsystem = model.name_of(i);
    name = subsystem + " / " + model.coordinates(i)[static_cast<std::size_t>(k)].name;
  }
  std::ostringstream text;
  text << "no periodic motion found at " << mean.speed
       << " rad/s under gravity, loads and wind across the axis: " << name << ' ' << why
       << "; take another speed, which is in no resonance, or none of these";
  throw DivergenceError(text.str(), {.subsystem = subsystem, .quantity = name});
}

/// Finds the motion with so many harmonics, from one that is near.
MatrixXcd settle(const MatrixXcd& start, const VectorXd& scale, const PeriodicSystem& mean,
                 Balance& balance, const SteadyModel& model) {
  constexpr int kMostIterations = 100, kPatience = 6;
  constexpr double kSettled = 1e-13, kEnough = 1e-9;
  const MeanResponse response(mean, start.cols() - 1);
  Acceleration acceleration;
  VectorXd y = pack(start, scale), best = y;
  MatrixXcd correction = MatrixXcd::Zero(start.rows(), start.cols());
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0, worse = 0; i < kMostIterations && worse < kPatience; ++i) {
    const std::optional<MatrixXcd> left = balance.of(unpack(y, scale));
    if (!left) break;
    correction = response.to(*left);
    if (!correction.allFinite()) break;
    const VectorXd f = pack(correction, scale);
    const double size = f.lpNorm<Eigen::Infinity>();
    const double all = std::max(size, y.lpNorm<Eigen::Infinity>());
    const double relative = all > 0.0 ? size / all : 0.0;
    worse = relative < 0.5 * least ? 0 : worse + 1;
    if (relative > kEnough) worse = 0;  // it may still take long
    if (relative < least) {
      least = relative;
      best = y;
    }
    if (relative <= kSettled) break;
    y = acceleration.next(y, f);
  }
  if (!(least <= kEnough)) {
    std::ostringstream why;
    why << std::setprecision(2) << "does not settle, and changes by " << least
        << " of the motion at the least";
    give_up(mean, scale, correction, model, why.str());
  }
  return unpack(best, scale);
}

/// Whether a motion is known by so many harmonics, of which the last two have a share of it.
bool is_enough(double tail, Index highest, bool is_in_air) {
  if (!is_in_air) return tail <= kTail;
  return tail <= (2 * highest > kMostHarmonics ? kMostInAir : kTailInAir);
}

}  // namespace

bool can_have_orbit(const Linearised& all) {
  const std::vector<int>& free = all.model.free_components();
  if (free.size() > 1 || (free.size() == 1 && free[0] != all.model.twist_size() - 1)) return false;
  if (steady::has_forces(all.linear)) return false;
  for (std::size_t i = 0; i < all.model.subsystems(); ++i) {
    for (const steady::ClosureRow& row : all.model.closure_rows(i))
      if (row.is_rigid() || row.is_dropped) return false;
  }
  return true;
}

bool is_turned_against(const Linearised& all, SteadyModel& whole) {
  constexpr double kRoundOff = 1e-11;
  for (std::size_t i = 0; i < whole.subsystems(); ++i)
    whole.settle_at(i, all.model.absolute(i, all.equilibrium.q[i]));
  double scale = all.equilibrium.force_scale, change = 0.0;
  const std::optional<VectorXd> first = calc_forces_at(0.0, all, whole);
  for (const double psi : {1.0, 2.0, 3.0, 4.0, 5.0}) {
    const std::optional<VectorXd> now = calc_forces_at(psi, all, whole);
    if (!first || !now) return true;
    if (now->size() == 0) return false;
    scale = std::max(scale, now->lpNorm<Eigen::Infinity>());
    change = std::max(change, (*now - *first).lpNorm<Eigen::Infinity>());
  }
  return change > kRoundOff * scale;
}

std::optional<PeriodicOrbit> find_periodic_orbit(const Linearised& all, const PeriodicSystem& mean,
                                                 SteadyModel& whole) {
  assert(can_have_orbit(all));
  if (!is_turned_against(all, whole)) return std::nullopt;
  const VectorXd scale = find_scale(mean, whole);
  Balance balance(all, mean, whole);
  MatrixXcd harmonics = MatrixXcd::Zero(mean.size(), kLeastHarmonics + 1);
  for (;;) {
    harmonics = settle(harmonics, scale, mean, balance, whole);
    const MatrixXd size = (scale.cwiseInverse().asDiagonal() * harmonics).cwiseAbs();
    const Index highest = harmonics.cols() - 1;
    if (is_enough(size.rightCols(2).maxCoeff() / size.maxCoeff(), highest, balance.wake().acts()))
      return PeriodicOrbit{harmonics, balance.wake()};
    if (2 * highest > kMostHarmonics) {
      std::ostringstream why;
      why << std::setprecision(2) << "has harmonics beyond " << highest << ", those up to it being "
          << size.rightCols(2).maxCoeff() / size.maxCoeff() << " of the motion";
      give_up(mean, scale, harmonics.rightCols(2), whole, why.str());
    }
    const MatrixXcd found = harmonics;
    harmonics = MatrixXcd::Zero(found.rows(), 2 * highest + 1);
    harmonics.leftCols(found.cols()) = found;
  }
}

}  // namespace spoke::vibration
