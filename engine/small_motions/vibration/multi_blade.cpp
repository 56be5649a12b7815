// Sums blades over their azimuths.

#include "engine/small_motions/vibration/multi_blade.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "engine/small_motions/steady/joined_rotors.h"
#include "engine/small_motions/steady/linear_support.h"
#include "engine/small_motions/vibration/shaft_turn.h"
#include "models/error.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using steady::HubCoupling;
using steady::LinearModel;
using steady::LinearSubsystem;

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr const char* kElse = ": of modes the frame \"floquet\" takes any blades";

double wrap(double angle) {
  const double within = std::fmod(angle, kTurn);
  return within < 0.0 ? within + kTurn : within;
}

std::string list_names(const std::vector<std::size_t>& subsystems,
                       const std::vector<std::string>& names) {
  std::string list;
  for (const std::size_t i : subsystems) list += (list.empty() ? "" : ", ") + names[i];
  return list;
}

/// Throws InputError unless the blades of a family are three or more at equal angles.
void require_even(const BladeFamily& family, const std::vector<std::string>& names) {
  constexpr double kSame = 1e-9;
  const std::size_t count = family.blades.size();
  if (count < 3)
    throw InputError("the frame \"fixed\" expects three or more equal blades, got " +
                     std::to_string(count) + " of the kind of " + list_names(family.blades, names) +
                     kElse);
  for (std::size_t k = 0; k < count; ++k) {
    const double gap = wrap(family.azimuths[(k + 1) % count] - family.azimuths[k]);
    if (std::abs(gap - kTurn / static_cast<double>(count)) <= kSame) continue;
    throw InputError("the frame \"fixed\" expects equal angles between " +
                     list_names(family.blades, names) + kElse);
  }
}

/// Returns the family of a ring of blades.
BladeFamily make_ring(std::size_t subsystem, const BladeRing& ring, double speed,
                      const std::vector<std::string>& names) {
  if (!ring.is_even())
    throw InputError(
        "the frame \"fixed\" expects loops between blades to tie them alike all "
        "around, as those of " +
        names[subsystem] + " do not" + kElse);
  BladeFamily family{{subsystem}, ring.azimuths};
  family.speed = speed;
  family.ring = ring;
  return family;
}

std::vector<BladeFamily> find_families(const LinearModel& model,
                                       const std::vector<double>& azimuths,
                                       const std::vector<std::string>& names, double speed,
                                       const std::vector<MatrixXd>& turns,
                                       const std::vector<BladeRing>& rings) {
  std::vector<BladeFamily> families;
  const auto is_shaft = [&](std::size_t i) { return !turns.empty() && turns[i].size() > 0; };
  for (std::size_t first = 0; first < model.alike.size(); ++first) {
    if (is_shaft(first)) families.push_back({{first}, {azimuths[first]}, turns[first], speed});
    if (!rings.empty() && rings[first].is_tied) {
      families.push_back(make_ring(first, rings[first], speed, names));
      continue;
    }
    if (model.alike[first] != first || model.subsystem(first).M.rows() == 0 || is_shaft(first))
      continue;
    BladeFamily& family = families.emplace_back();
    family.speed = speed;
    for (std::size_t i = first; i < model.alike.size(); ++i)
      if (model.alike[i] == first) family.blades.push_back(i);
    std::stable_sort(family.blades.begin(), family.blades.end(), [&](std::size_t a, std::size_t b) {
      return wrap(azimuths[a]) < wrap(azimuths[b]);
    });
    for (const std::size_t i : family.blades) family.azimuths.push_back(azimuths[i]);
    require_even(family, names);
  }
  return families;
}

/// Returns [A -B; B A], which multiplies cosine and sine parts.
MatrixXd make_pair(const MatrixXd& A, const MatrixXd& B) {
  MatrixXd pair(2 * A.rows(), 2 * A.cols());
  pair << A, -B, B, A;
  return pair;
}

/// The matrices of a pattern of blades: of each alone, and of a ring with those of all others,
/// which move by the cosine of n times the angle between them (`one`), and by its sine (`skew`).
struct PatternMatrices {
  LinearSubsystem one;
  SecondOrder skew;
};

/// Returns those of a family at its multiple n.
PatternMatrices sum_blades(const LinearSubsystem& all, const BladeRing& ring, int multiple) {
  const Index n = ring.is_tied ? ring.size : all.M.rows();
  const MatrixXd zero = MatrixXd::Zero(n, n);
  PatternMatrices sum{all, {zero, zero, zero}};
  if (!ring.is_tied) return sum;
  const auto add = [&](MatrixXd LinearSubsystem::*matrix, MatrixXd* skew) {
    const MatrixXd& whole = all.*matrix;
    MatrixXd& even = sum.one.*matrix;
    if (whole.size() == 0) return;
    even = zero;
    for (std::size_t k = 0; k < ring.starts.size(); ++k) {
      const double angle =
          multiple * kTurn * static_cast<double>(k) / static_cast<double>(ring.starts.size());
      const auto block = whole.block(ring.starts[0], ring.starts[k], n, n);
      even += (skew ? std::cos(angle) : 1.0) * block;
      if (skew) *skew += std::sin(angle) * block;
    }
  };
  add(&LinearSubsystem::M, &sum.skew.M);
  add(&LinearSubsystem::C, &sum.skew.C);
  add(&LinearSubsystem::K, &sum.skew.K);
  add(&LinearSubsystem::K_terms, nullptr);
  sum.one.round_off.force = all.round_off.force.segment(ring.starts[0], n);
  sum.one.round_off.step = all.round_off.step.segment(ring.starts[0], n);
  return sum;
}

/// Returns a pair's matrices: as y = a_c cos(n psi) + a_s sin(n psi), whose derivatives add
/// n w (a_s cos - a_c sin) with the speed w of the hub, M y'' has 2 n w M (a_s', -a_c') and
/// -(n w)^2 M a, and C y' has n w C (a_s, -a_c) besides. So has the skew part, which takes (a_c,
/// a_s) to (a_s, -a_c) already.
LinearSubsystem make_pair(const PatternMatrices& of, double rate) {
  const LinearSubsystem& one = of.one;
  const SecondOrder& skew = of.skew;
  LinearSubsystem pair;
  pair.M = make_pair(one.M, -skew.M);
  pair.C = make_pair(one.C - 2.0 * rate * skew.M, -skew.C - 2.0 * rate * one.M);
  pair.K = make_pair(one.K - rate * rate * one.M - rate * skew.C,
                     rate * rate * skew.M - skew.K - rate * one.C);
  const MatrixXd terms = one.K_terms.size() > 0 ? one.K_terms : MatrixXd(one.K.cwiseAbs());
  pair.K_terms =
      make_pair(terms + rate * rate * one.M.cwiseAbs(), std::abs(rate) * one.C.cwiseAbs())
          .cwiseAbs();
  pair.round_off.force = one.round_off.force.replicate(2, 1);
  pair.round_off.step = one.round_off.step.replicate(2, 1);
  return pair;
}

/// A blade's coupling with the hub along axes that turn with the blade's azimuth.
struct AlongBlade {
  SecondOrder bh, hb;
};
AlongBlade turn_to_blade(const HubCoupling& coupling, const BladeFamily& family,
                         const StandingAxes& axes) {
  const MatrixXd T = axes.T.at(family.azimuths[0]);
  const BladeRing& ring = family.ring;
  const Index first = ring.is_tied ? ring.starts[0] : 0;
  const Index n = ring.is_tied ? ring.size : coupling.M_bh.rows();
  const auto rows = [&](const MatrixXd& m) { return MatrixXd(m.middleRows(first, n)); };
  const auto columns = [&](const MatrixXd& m) {
    return MatrixXd(T.transpose() * m.middleCols(first, n));
  };
  const SecondOrder standing =
      stand_columns({rows(coupling.M_bh), rows(coupling.C_bh), rows(coupling.K_bh)}, axes);
  return {{standing.M * T, standing.C * T, standing.K * T},
          {columns(coupling.M_hb), columns(coupling.C_hb), columns(coupling.K_hb)}};
}

HubCoupling make_coupling(const SecondOrder& bh, const SecondOrder& hb) {
  return {bh.M, bh.C, bh.K, hb.M, hb.C, hb.K, {}};
}

/// Returns the coupling of a_0: the sum over N blades by 1/sqrt(N).
HubCoupling couple_all(const AlongBlade& blade, double count, const StandingAxes& axes) {
  const MatrixXd share = std::sqrt(count) * axes.T.mean;
  return make_coupling({blade.bh.M * share, blade.bh.C * share, blade.bh.K * share},
                       {share * blade.hb.M, share * blade.hb.C, share * blade.hb.K});
}

/// Returns the coupling of a_1c and a_1s: sums by sqrt(2/N) cos psi and sqrt(2/N) sin psi.
HubCoupling couple_pair(const AlongBlade& blade, double count, const StandingAxes& axes) {
  const double w = axes.speed, size = std::sqrt(0.5 * count);
  const MatrixXd c = size * axes.T.cosine, s = size * axes.T.sine;
  const auto below = [](const MatrixXd& a, const MatrixXd& b) {
    MatrixXd both(a.rows() + b.rows(), a.cols());
    both << a, b;
    return both;
  };
  const auto beside = [](const MatrixXd& a, const MatrixXd& b) {
    MatrixXd both(a.rows(), a.cols() + b.cols());
    both << a, b;
    return both;
  };
  const auto rows = [&](const MatrixXd& m) { return below(m * c, m * s.transpose()); };
  const SecondOrder& hb = blade.hb;
  const MatrixXd K = hb.K - w * w * hb.M;
  return make_coupling({rows(blade.bh.M), rows(blade.bh.C), rows(blade.bh.K)},
                       {beside(c * hb.M, s * hb.M),
                        beside(c * hb.C - 2.0 * w * s * hb.M, s * hb.C + 2.0 * w * c * hb.M),
                        beside(c * K - w * s * hb.C, s * K + w * c * hb.C)});
}

HubCoupling couple_none(const AlongBlade& blade, Index parts) {
  const MatrixXd bh = MatrixXd::Zero(parts * blade.bh.M.rows(), blade.bh.M.cols());
  const MatrixXd hb = bh.transpose();
  return make_coupling({bh, bh, bh}, {hb, hb, hb});
}

/// Returns the mean of T A T^T over the azimuth. Throws InputError if it depends on the azimuth by
/// more than `tolerance`, entries being scaled by masses.
MatrixXd require_round(const MatrixXd& A, const MatrixXd& mass, double tolerance,
                       const StandingAxes& axes) {
  constexpr int kSamples = 8;  // the second harmonic is the highest
  std::vector<MatrixXd> samples;
  MatrixXd mean = MatrixXd::Zero(A.rows(), A.cols());
  for (int k = 0; k < kSamples; ++k) {
    const MatrixXd T = axes.T.at(kTurn * k / kSamples);
    samples.push_back(T * A * T.transpose());
    mean += samples.back() / kSamples;
  }
  const Eigen::VectorXd scale = mass.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  for (const MatrixXd& sample : samples) {
    const MatrixXd left = scale.asDiagonal() * (sample - mean) * scale.asDiagonal();
    if (!(left.lpNorm<Eigen::Infinity>() > tolerance)) continue;
    throw InputError(
        "the frame \"fixed\" expects a hub whose mass and forces are alike in all "
        "directions across its axis" +
        std::string(kElse));
  }
  return mean;
}

/// Takes the hub's own matrices to standing axes.
void add_hub(const LinearModel& turning, const StandingAxes& axes, LinearModel& fixed) {
  constexpr double kAlike = 1e-6;
  const SecondOrder hub = stand_columns({turning.M, turning.C, turning.K}, axes);
  const Eigen::VectorXd scale = hub.M.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  const double rate = std::max(1.0, std::abs(axes.speed));
  const auto size_of = [&](const MatrixXd& m) {
    return (scale.asDiagonal() * m * scale.asDiagonal()).cwiseAbs().maxCoeff();
  };
  fixed.M = require_round(hub.M, hub.M, kAlike, axes);
  fixed.C = require_round(hub.C, hub.M, kAlike * (rate + size_of(hub.C)), axes);
  fixed.K = require_round(hub.K, hub.M, kAlike * (rate * rate + size_of(hub.K)), axes);
  fixed.round_off = turning.round_off;
}

/// Adds the pattern of a shaft, which couples with the hub alike at every azimuth, as it is round.
void add_shaft(std::size_t number, const LinearModel& turning, const StandingAxes& axes,
               FixedFrame& frame) {
  const BladeFamily& family = frame.families[number];
  const std::size_t i = family.blades[0];
  const LinearSubsystem& one = turning.subsystem(i);
  LinearModel& model = frame.model;
  model.alike.push_back(model.subsystems.size());
  model.subsystems.push_back(stand_shaft(one, family.turn, axes.speed));
  frame.patterns.push_back({number, 0, false, false, one.M.rows()});
  if (!turning.is_coupled()) return;
  const HubCoupling& both = turning.couplings[i];
  model.couplings.push_back(make_coupling(
      stand_columns({both.M_bh, both.C_bh, both.K_bh}, axes),
      stand_columns({both.M_hb, both.C_hb, both.K_hb}, MatrixXd(axes.speed * family.turn))));
}

/// Adds the patterns of a family of blades.
void add_family(std::size_t number, const LinearModel& turning, const StandingAxes& axes,
                FixedFrame& frame) {
  const BladeFamily& family = frame.families[number];
  const int count = static_cast<int>(family.azimuths.size());
  const std::size_t first = family.blades[0];
  const bool is_coupled = turning.is_coupled(), is_ring = family.ring.is_tied;
  AlongBlade blade;
  if (is_coupled) blade = turn_to_blade(turning.couplings[first], family, axes);
  LinearModel& model = frame.model;
  const std::size_t collective = model.subsystems.size();
  for (int n = 0; 2 * n <= count; ++n) {
    const bool is_differential = n > 0 && 2 * n == count, is_pair = n > 0 && !is_differential;
    const PatternMatrices of = sum_blades(turning.subsystem(first), family.ring, n);
    const bool is_like = is_differential && !is_ring;  // the collective pattern
    model.alike.push_back(is_like ? collective : model.subsystems.size());
    model.subsystems.push_back(is_pair   ? make_pair(of, n * axes.speed)
                               : is_like ? LinearSubsystem{}
                                         : of.one);
    frame.patterns.push_back({number, n, is_pair, is_differential, of.one.M.rows()});
    if (!is_coupled) continue;
    model.couplings.push_back(n == 0   ? couple_all(blade, count, axes)
                              : n == 1 ? couple_pair(blade, count, axes)
                                       : couple_none(blade, is_pair ? 2 : 1));
  }
}

}  // namespace

Eigen::VectorXcd BladeFamily::put_first(const Eigen::VectorXcd& y) const {
  if (!ring.is_tied) return y;
  Eigen::VectorXcd all = Eigen::VectorXcd::Zero(ring.size * std::ssize(ring.starts));
  all.segment(ring.starts[0], ring.size) = y;
  return all;
}

MatrixXd BladeFamily::take_first(const MatrixXd& matrix) const {
  if (!ring.is_tied) return matrix;
  return matrix.block(ring.starts[0], ring.starts[0], ring.size, ring.size);
}

Index FixedFrame::start(std::size_t pattern) const {
  Index at = model.M.rows();
  for (std::size_t k = 0; k < pattern; ++k) at += (patterns[k].is_pair ? 2 : 1) * patterns[k].size;
  return at;
}

Eigen::Vector2d FixedFrame::shares(std::size_t pattern, std::size_t place, double psi) const {
  const BladePattern& own = patterns[pattern];
  const BladeFamily& family = families[own.family];
  const double count = static_cast<double>(family.azimuths.size());
  if (own.is_differential) return {(place % 2 == 0 ? 1.0 : -1.0) / std::sqrt(count), 0.0};
  if (!own.is_pair) return {1.0 / std::sqrt(count), 0.0};
  const double angle = own.multiple * (family.azimuths[place] + psi);
  return std::sqrt(2.0 / count) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

Eigen::VectorXcd FixedFrame::motion_of(std::size_t subsystem, const Eigen::VectorXcd& x,
                                       double psi) const {
  Eigen::VectorXcd y;
  const auto add = [&](std::size_t k, std::size_t place, auto&& of_blade) {
    const BladePattern& pattern = patterns[k];
    const Eigen::Vector2d share = shares(k, place, psi);
    of_blade += share[0] * x.segment(start(k), pattern.size);
    if (pattern.is_pair) of_blade += share[1] * x.segment(start(k) + pattern.size, pattern.size);
  };
  for (std::size_t k = 0; k < patterns.size(); ++k) {
    const BladePattern& pattern = patterns[k];
    const BladeFamily& family = families[pattern.family];
    const auto found = std::find(family.blades.begin(), family.blades.end(), subsystem);
    if (found == family.blades.end()) continue;
    if (family.is_shaft()) return turn_by(family.turn, -psi) * x.segment(start(k), pattern.size);
    const BladeRing& ring = family.ring;
    const Index blades = ring.is_tied ? std::ssize(ring.starts) : 1;
    if (y.size() == 0) y = Eigen::VectorXcd::Zero(blades * pattern.size);
    for (std::size_t place = 0; place < ring.starts.size(); ++place)
      add(k, place, y.segment(ring.starts[place], ring.size));
    if (!ring.is_tied) add(k, static_cast<std::size_t>(found - family.blades.begin()), y);
  }
  return y;
}

FixedFrame make_fixed_frame(const LinearModel& turning, const std::vector<double>& azimuths,
                            const std::vector<std::string>& names, const StandingAxes& axes,
                            const std::vector<MatrixXd>& turns,
                            const std::vector<BladeRing>& rings) {
  assert(rings.empty() || rings.size() == turning.alike.size());
  assert(turns.empty() || turns.size() == turning.alike.size());
  assert(azimuths.size() == turning.alike.size() && names.size() == turning.alike.size());
  FixedFrame frame;
  frame.fastest = std::abs(axes.speed);
  frame.families = find_families(turning, azimuths, names, axes.speed, turns, rings);
  frame.model.rate = turning.rate;
  if (turning.is_coupled()) add_hub(turning, axes, frame.model);
  for (std::size_t k = 0; k < frame.families.size(); ++k)
    frame.families[k].is_shaft() ? add_shaft(k, turning, axes, frame)
                                 : add_family(k, turning, axes, frame);
  return frame;
}

FixedFrame join(const std::vector<FixedFrame>& rotors,
                const std::vector<std::vector<std::size_t>>& subsystems) {
  assert(subsystems.size() == rotors.size());
  FixedFrame all;
  std::vector<LinearModel> models;
  std::vector<std::vector<std::size_t>> numbers;  // of patterns
  for (std::size_t r = 0; r < rotors.size(); ++r) {
    const FixedFrame& rotor = rotors[r];
    models.push_back(rotor.model);
    numbers.emplace_back();
    const std::size_t families = all.families.size();
    for (BladeFamily family : rotor.families) {
      family.rotor = r;
      for (std::size_t& blade : family.blades) blade = subsystems[r][blade];
      all.families.push_back(std::move(family));
    }
    for (BladePattern pattern : rotor.patterns) {
      pattern.family += families;
      numbers.back().push_back(all.patterns.size());
      all.patterns.push_back(pattern);
    }
    all.fastest = std::max(all.fastest, rotor.fastest);
  }
  all.model = steady::join_rotors(models, numbers);
  return all;
}

FixedFrame stand_on(const FixedFrame& rotor, const MatrixXd& J, const SecondOrder& support) {
  const double step = rotor.model.round_off.step.minCoeff();
  FixedFrame frame = rotor;
  frame.model.support = steady::LinearSupport{.J = J,
                                              .M = support.M,
                                              .C = support.C,
                                              .K = support.K,
                                              .step = Eigen::VectorXd::Constant(J.cols(), step)};
  steady::stand_on(*frame.model.support, frame.model);
  return frame;
}

}  // namespace spoke::vibration
