#pragma once

// Natural frequencies of a rotor at rest, and the step that they allow rk4.

#include <complex>

#include "models/system/system.h"

namespace spoke::plane {

/// Natural frequencies of a system at rest, undeformed [rad/s].
struct FrequencyRange {
  double lowest =
      0.0;  ///< lowest frequency of the vibrations; rigid-body motions of a free hub do not count
  double highest = 0.0;
};

/// Finds the range by bisection. At rest the bodies of a straight blade together are one
/// finite-element beam, so K - w^2 M is block tridiagonal along each blade; the number of its
/// negative pivots, eliminated from the tips to the hub, is the number of frequencies below w
/// (Sylvester's law of inertia). Cost: O(elements) per bisection.
FrequencyRange calc_frequency_range(const Rotor& rotor);

/// Returns the lowest natural frequency of a blade clamped at its root, at rest [rad/s].
double calc_first_frequency(const Blade& blade);

/// Returns the number of natural frequencies below `frequency` [rad/s], zero ones of rigid-body
/// motions included.
int count_frequencies_below(const Rotor& rotor, double frequency);

/// Returns the rotor's damping, with the most that linear drag can add to mass_factor: in every
/// element that it acts on the ratio of its matrix c N^T N to the mass matrix, for bounds of the
/// sums over elements. That is c / rhoA for drag per length (all of it, where both are uniform),
/// and 16 c / (rhoA l) for drag at a point of an element of length l, the largest of N M^-1 N^T.
/// Quadratic drag vanishes at rest.
Damping calc_total_damping(const Rotor& rotor);

/// Returns the largest step at which rk4 is stable for a root s [1/s] that does not grow: the
/// largest h for which |R(h s)| <= 1, R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24 [s]. Precondition: s is
/// not 0.
double calc_rk4_limit(std::complex<double> root);

/// Returns the largest step at which rk4 is stable for the vibrations of the range [s]: undamped 2
/// sqrt(2) / highest frequency; damped, the least of calc_rk4_limit() at both roots of s^2 +
/// (mass_factor + stiffness_factor w^2) s + w^2 = 0 for both ends w.
double calc_rk4_largest_step(const FrequencyRange& range, const Damping& damping);

/// Returns that step for a rotor with linear drag, which damps some vibrations by all that it can
/// add, others by a part or not at all: the least of shares in eighths. Damping by direction or by
/// modes is that of the highest frequencies in each direction; of the modes that have ratios of
/// their own, less than 1, none limits the step.
double calc_rk4_step_with_drag(const FrequencyRange& range, const Rotor& rotor);

}  // namespace spoke::plane
