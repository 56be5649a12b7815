// Finds the sense in which patterns go round.

#include "engine/small_motions/vibration/pattern_motion.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "engine/small_motions/vibration/shaft_names.h"

namespace spoke::vibration {
namespace {

using Eigen::VectorXcd;

constexpr std::complex<double> kTurned(0.0, 1.0);

/// Returns the independent coordinates of the first blade of a pattern.
std::vector<steady::SubsystemCoordinate> list_of_blade(std::size_t pattern,
                                                       const SeenFromOutside& fixed) {
  std::vector<steady::SubsystemCoordinate> all =
      list_independent(fixed.first_of(pattern), fixed.all.linear, fixed.all.model);
  const BladeRing& ring = fixed.family_of(pattern).ring;
  if (!ring.is_tied) return all;
  const auto first = all.begin() + ring.starts[0];
  return {first, first + ring.size};
}

/// Names a pattern that goes round, or at rest may stand. Of n > 0 the pattern moves against the
/// rotation in the blades' frame, which takes n times the speed from its frequency.
std::string name_round(const PatternMotion& motion, int multiple, double speed, bool is_cosine) {
  const std::string order = multiple > 1 ? " order " + std::to_string(multiple) : "";
  if (motion.sense == 0) return (is_cosine ? "cosine" : "sine") + order;
  const bool is_regressive = (motion.sense > 0) == (speed >= 0.0);
  return (is_regressive ? "regressive" : "progressive") + order;
}

/// Returns the motion of a pattern that has a cosine and a sine part: of its two senses that with
/// more mass.
PatternMotion describe_pair(const VectorXcd& cosine, const VectorXcd& sine, double frequency,
                            int multiple, double speed, const Eigen::MatrixXd& M) {
  constexpr double kStanding = 0.8;  // least ratio of the amplitudes of both senses
  const VectorXcd plus = (cosine - kTurned * sine) / std::sqrt(2.0);
  const VectorXcd minus = (cosine + kTurned * sine) / std::sqrt(2.0);
  const double of_plus = calc_mass(plus, M), of_minus = calc_mass(minus, M);
  PatternMotion motion;
  motion.mass = of_plus + of_minus;
  const double ratio = std::min(of_plus, of_minus) / std::max(of_plus, of_minus);
  const bool is_cosine = calc_mass(cosine, M) >= calc_mass(sine, M);
  if (speed == 0.0 && ratio > kStanding * kStanding) {
    motion.y = is_cosine ? cosine : sine;
    motion.rate = frequency;
  } else {
    motion.sense = of_plus > of_minus ? 1 : -1;
    motion.y = motion.sense > 0 ? plus : minus;
    const double rate = frequency + motion.sense * multiple * speed;
    motion.is_conjugate = rate < 0.0;
    motion.rate = std::abs(rate);
    if (motion.is_conjugate) {
      motion.y = motion.y.conjugate().eval();
      motion.sense = -motion.sense;
    }
  }
  motion.name = name_round(motion, multiple, speed, is_cosine);
  return motion;
}

}  // namespace

SubsystemShape SeenFromOutside::shape_of(std::size_t pattern, const VectorXcd& y) const {
  const std::size_t i = first_of(pattern);
  const VectorXcd own = family_of(pattern).put_first(y);
  const VectorXcd hub = VectorXcd::Zero(all.linear.M.rows());
  return calc_subsystem_shape(i, all.equilibrium.q[i], all.linear.motion_of(i, own, hub),
                              all.model);
}

PatternMotion describe_pattern(std::size_t k, const Root& root, const SeenFromOutside& fixed) {
  const BladePattern& pattern = fixed.frame.patterns[k];
  const Eigen::MatrixXd M = fixed.mass_of(k);
  const VectorXcd first = root.x.segment(fixed.frame.start(k), pattern.size);
  const double frequency = std::abs(root.s.imag());
  if (pattern.is_pair)
    return describe_pair(first, root.x.segment(fixed.frame.start(k) + pattern.size, pattern.size),
                         frequency, pattern.multiple, fixed.speed(k), M);
  if (fixed.is_shaft(k)) {
    const VectorXcd z = root.s.imag() < 0.0 ? VectorXcd(first.conjugate()) : first;
    const SubsystemShape shape = fixed.shape_of(k, z);
    return {z, calc_mass(z, M), frequency, 0, false, describe_shaft(shape, fixed.speed(k)).sense};
  }
  return {first,     calc_mass(first, M),
          frequency, 0,
          false,     pattern.is_differential ? "differential" : "collective"};
}

std::string name_kind(std::size_t pattern, const PatternMotion& motion,
                      const SeenFromOutside& fixed, KindNames& kinds) {
  const SubsystemShape shape = fixed.shape_of(pattern, motion.y);
  if (fixed.is_shaft(pattern)) return describe_shaft(shape, fixed.speed(pattern)).kind;
  return kinds.name(list_of_blade(pattern, fixed), motion.y, fixed.mass_of(pattern), shape);
}

}  // namespace spoke::vibration
