// Counts the frequencies below a given one, and bisects (docs/formulation.md, section 6).

#include "engine/bodies/kernels/plane/natural_frequencies.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <complex>
#include <vector>

#include "models/plane/beam_elements.h"

namespace spoke::plane {
namespace {

/// Negative pivots of an elimination so far, and the dynamic stiffness left at its end.
struct Elimination {
  int negative = 0;
  TwistMatrix rest = TwistMatrix::Zero();
};

int count_negative(const TwistMatrix& symmetric) {
  const Eigen::SelfAdjointEigenSolver<TwistMatrix> solver(symmetric, Eigen::EigenvaluesOnly);
  return static_cast<int>((solver.eigenvalues().array() < 0.0).count());
}

/// The coordinates of nodes (u, v, psi) that take part in a motion.
using Moving = std::array<bool, kTwist>;
constexpr Moving kAll{true, true, true}, kOnlyAxial{true, false, false},
    kOnlyBending{false, true, true};

/// Holds the coordinates that do not move, as springs of their own would: none of them counts.
void hold_others(const Moving& moving, BeamElement::Matrix& A) {
  for (int i = 0; i < A.rows(); ++i) {
    if (moving[static_cast<std::size_t>(i % kTwist)]) continue;
    A.row(i).setZero();
    A.col(i).setZero();
    A(i, i) = 1.0;
  }
}

/// Eliminates a blade's nodes from the tip; `rest` is its dynamic stiffness at the root node.
Elimination eliminate(const Blade& blade, double frequency, const Moving& moving = kAll) {
  constexpr int d = kTwist;
  const bool is_equal = is_uniform(blade);
  std::vector<BeamElement> elements;
  Elimination sum;
  for (int j = blade.bodies - 1; j >= 0; --j) {
    if (elements.empty() || !is_equal)
      elements = make_beam_elements(make_beam_properties(blade, j));
    for (int e = blade.elements; e > 0; --e) {
      const BeamElement& element = elements[std::min<std::size_t>(e, elements.size()) - 1];
      BeamElement::Matrix A = element.stiffness - frequency * frequency * element.mass;
      if (moving != kAll) hold_others(moving, A);
      const TwistMatrix pivot = sum.rest + A.bottomRightCorner<d, d>();
      sum.negative += count_negative(pivot);
      sum.rest = A.topLeftCorner<d, d>() -
                 A.topRightCorner<d, d>() * pivot.inverse() * A.bottomLeftCorner<d, d>();
    }
  }
  return sum;
}

bool have_equal_dynamics(const Blade& a, const Blade& b) {
  return a.bodies == b.bodies && a.elements == b.elements && a.length == b.length &&
         make_beam_properties(a, 0) == make_beam_properties(b, 0) && a.sections == b.sections &&
         a.point_masses == b.point_masses;
}

/// Returns the components of the hub's motion that are not prescribed.
std::vector<int> free_components(const Hub& hub) {
  std::vector<int> free;
  for (int c = 0; c < kTwist; ++c)
    if (!is_prescribed(hub, c)) free.push_back(c);
  return free;
}

int count_coordinates(const Rotor& rotor) {
  int count = static_cast<int>(free_components(rotor.hub).size());
  for (const Blade& blade : rotor.blades) count += kTwist * blade.bodies * blade.elements;
  return count;
}

/// Returns the smallest frequency below which at least `count` others lie, by bisection to
/// round-off; count_below(frequency) counts them.
template <class CountBelow>
double bisect(int count, const CountBelow& count_below) {
  double high = 1.0;
  while (count_below(high) < count) high *= 2.0;
  double low = high;
  while (low > 1e-6 && count_below(low) >= count) low /= 2.0;
  for (int k = 0; k < 50 && high - low > 1e-13 * high; ++k) {
    const double middle = 0.5 * (low + high);
    (count_below(middle) >= count ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

double find_frequency(const Rotor& rotor, int count) {
  assert(count > 0 && count <= count_coordinates(rotor));
  return bisect(count, [&](double frequency) { return count_frequencies_below(rotor, frequency); });
}

/// Returns the highest frequency of a blade that is held at its root, at rest [rad/s].
double find_highest_frequency(const Blade& blade, const Moving& moving) {
  const auto per_node = static_cast<int>(std::count(moving.begin(), moving.end(), true));
  return bisect(per_node * blade.bodies * blade.elements,
                [&](double frequency) { return eliminate(blade, frequency, moving).negative; });
}

using Complex = std::complex<double>;

/// Returns the roots of a damped vibration [1/s].
std::array<Complex, 2> find_roots(double frequency, const Damping& damping) {
  const double square = frequency * frequency;
  const Complex half = 0.5 * (damping.mass_factor + damping.stiffness_factor * square);
  const Complex larger = -half - std::sqrt(half * half - square);  // no cancellation
  return {larger, square / larger};
}

/// Returns the smallest mass per length of a blade [kg/m].
double least_mass_per_length(const Blade& blade) {
  const std::vector<double>& masses = blade.sections.mass_per_length;
  if (masses.empty()) return blade.density * blade.area;
  return *std::min_element(masses.begin(), masses.end());
}

/// Returns the most that linear drag can add to the mass factor of a blade's damping [1/s].
double calc_drag_factor(const Drag& drag, const Blade& blade) {
  assert(!drag.factor.values().empty() && blade.bodies > 0 && blade.elements > 0);
  constexpr double kAtPoint = 16.0;  // for cubic shape functions, at the ends of an element
  const std::vector<double>& factors = drag.factor.values();
  const double share = std::max(0.0, *std::max_element(factors.begin(), factors.end()));
  const double element = blade.length / blade.bodies / blade.elements;
  return share * (drag.linear_per_length + kAtPoint * drag.linear / element) /
         least_mass_per_length(blade);
}

}  // namespace

int count_frequencies_below(const Rotor& rotor, double frequency) {
  assert(frequency > 0.0);
  const Hub& hub = rotor.hub;
  TwistMatrix at_hub = TwistMatrix::Zero();
  at_hub.diagonal() = -frequency * frequency * Twist(hub.mass, hub.mass, hub.inertia);
  int negative = 0;
  Elimination blade_sum;
  for (std::size_t i = 0; i < rotor.blades.size(); ++i) {
    const Blade& blade = rotor.blades[i];
    if (i == 0 || !have_equal_dynamics(blade, rotor.blades[i - 1]))
      blade_sum = eliminate(blade, frequency);
    negative += blade_sum.negative;
    const Rotation R = Rotation::from_angle(blade.azimuth);
    TwistMatrix T = TwistMatrix::Identity();
    T.col(kRotation).head<kPosition>() = quarter_turn(R * Position{hub.radius, 0.0});
    const TwistMatrix M = R.matrix();
    at_hub += T.transpose() * M * blade_sum.rest * M.transpose() * T;
  }
  // A prescribed component counts for nothing: like one held by a spring of its own.
  for (int c = 0; c < kTwist; ++c)
    if (is_prescribed(hub, c)) {
      at_hub.row(c).setZero();
      at_hub.col(c).setZero();
      at_hub(c, c) = 1.0;
    }
  return negative + count_negative(at_hub);
}

FrequencyRange calc_frequency_range(const Rotor& rotor) {
  if (rotor.blades.empty()) return {0.0, 0.0};  // there are none on a hub alone
  const int rigid = static_cast<int>(free_components(rotor.hub).size());
  return {find_frequency(rotor, rigid + 1), find_frequency(rotor, count_coordinates(rotor))};
}

double calc_first_frequency(const Blade& blade) {
  Rotor rotor;
  rotor.blades = {blade};
  return find_frequency(rotor, 1);
}

Damping calc_total_damping(const Rotor& rotor) {
  double largest = 0.0;
  for (std::size_t i = 0; i < rotor.blades.size(); ++i) {
    double sum = 0.0;
    for (const Drag& drag : rotor.drags)
      if (drag.blade.holds(i)) sum += calc_drag_factor(drag, rotor.blades[i]);
    largest = std::max(largest, sum);
  }
  return {rotor.damping.mass_factor + largest, rotor.damping.stiffness_factor};
}

double calc_rk4_limit(Complex root) {
  assert(std::abs(root) > 0.0);
  const auto is_stable = [root](double step) {
    const Complex z = step * root;
    return std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)))) <= 1.0;
  };
  double low = 0.0, high = 4.0 / std::abs(root);  // rk4 is stable nowhere so far from 0
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (is_stable(middle) ? low : high) = middle;
  }
  return low;
}

double calc_rk4_largest_step(const FrequencyRange& range, const Damping& damping) {
  assert(range.lowest <= range.highest && damping.mass_factor >= 0.0 &&
         damping.stiffness_factor >= 0.0);
  if (range.highest == 0.0) return HUGE_VAL;
  if (damping.mass_factor == 0.0 && damping.stiffness_factor == 0.0)
    return 2.0 * std::sqrt(2.0) / range.highest;
  double largest = HUGE_VAL;
  for (const double frequency : {range.lowest, range.highest})
    for (const Complex root : find_roots(frequency, damping))
      largest = std::min(largest, calc_rk4_limit(root));
  return largest;
}

double calc_rk4_step_with_drag(const FrequencyRange& range, const Rotor& rotor) {
  constexpr int kShares = 8;
  const Damping& damping = rotor.damping;
  const double drag = calc_total_damping(rotor).mass_factor - damping.mass_factor;
  const auto find_limit = [&](const FrequencyRange& part, double stiffness_factor) {
    double largest = calc_rk4_largest_step(part, {damping.mass_factor, stiffness_factor});
    for (int k = 1; drag > 0.0 && k <= kShares; ++k) {
      const double factor = damping.mass_factor + drag * k / kShares;
      largest = std::min(largest, calc_rk4_largest_step(part, {factor, stiffness_factor}));
    }
    return largest;
  };
  double largest = find_limit(range, damping.stiffness_factor);
  for (std::size_t i = 0; i < rotor.blades.size(); ++i) {
    const Blade& blade = rotor.blades[i];
    if (i > 0 && have_equal_dynamics(blade, rotor.blades[i - 1])) continue;
    const StrainDamping strains = find_strain_damping(blade, damping);
    const auto limit = [&](double own, const Moving& moving) {
      if (own == 0.0) return;
      const double highest = find_highest_frequency(blade, moving);
      largest = std::min(largest, find_limit({highest, highest}, damping.stiffness_factor + own));
    };
    limit(strains.axial, kOnlyAxial);
    limit(strains.bending, kOnlyBending);
  }
  return largest;
}

}  // namespace spoke::plane
