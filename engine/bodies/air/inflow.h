#pragma once

// How induced velocity follows its steady value (Oye), and how it varies with azimuth in a skewed
// wake. docs/aerodynamics.md, sections 3 and 4.

namespace spoke::air {

/// The share of the steady induced velocity that the first filter lets through at once.
inline constexpr double kDirectShare = 0.6;

/// A component of induced velocity: states of the two filters [m/s]. With u the steady value,
/// rate the first filter's, ratio the second time constant by the first:
///   d(own)/dt = rate ((1 - k) u - own),   d(induced)/dt = rate / ratio (k u + own - induced).
/// `own` is the intermediate velocity of Oye less k u.
struct InflowState {
  double own, induced;
};

/// Returns the states of equilibrium.
InflowState rest_inflow(double steady) noexcept;

/// Returns the states after a time, by the exact solution for a steady value that goes linearly
/// from `begin` to `end`. turns: the time times the rate, 0 or more; ratio: less than 1.
InflowState advance_inflow(InflowState state, double begin, double end, double turns,
                           double ratio) noexcept;

/// Returns the rate of the first filter [1/s]: the inverse of 1.1 R / (U (1 - 1.3 a)), with a of at
/// most 0.5, written so that it holds without axial flow. axial: U; steady, induced: axial induced
/// velocity; in_plane: flow in the rotor's plane [m/s]; radius [m].
double calc_inflow_rate(double axial, double in_plane, double steady, double induced,
                        double radius) noexcept;

/// Returns the second time constant by the first at a radius by the tip's, from 0 to 1.
inline double calc_inflow_ratio(double span_ratio) noexcept {
  return 0.39 - 0.26 * span_ratio * span_ratio;
}

/// Returns by what axial induced velocity is multiplied at a place of a disc whose wake is skewed
/// (Glauert's linear form, Pitt & Peters' gain): 1 + 15 pi / 32 tan(chi / 2) r/R cos(psi), psi from
/// the place farthest downstream. through: axial flow through the disc; in_plane: flow in the
/// rotor's plane; downstream: its component in the direction of the station's radius [m/s].
double calc_skew_factor(double through, double in_plane, double downstream,
                        double span_ratio) noexcept;

/// Returns the value after a time of a filter dy/dt = rate (u - y), by the exact solution for u
/// that goes linearly from `begin` to `end`. turns: the time times the rate; may be infinite.
double advance_filter(double state, double begin, double end, double turns) noexcept;

}  // namespace spoke::air
