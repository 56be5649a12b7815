#pragma once

// Momentum balance of an annulus of the rotor's disc, in one unknown. docs/aerodynamics.md,
// section 2.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/bodies/air/find_zero.h"
#include "models/air.h"

namespace spoke::air {

/// An annulus of a rotor's disc and the blades in it.
struct Annulus {
  double solidity;  ///< number of blades times chord by the circumference
  double tip;       ///< Prandtl's exponent times |sin(flow angle)|: B (R - r) / (2 r); infinite:
                    ///< no loss
  double root;      ///< likewise: B (r - R_hub) / (2 R_hub)
  double inflow_factor = 1.0;  ///< induced velocity by that of momentum theory
  spatial::HighThrust high_thrust = spatial::HighThrust::buhl;
  spatial::MassFlow mass_flow = spatial::MassFlow::glauert;
};

/// Flow against a section that the rotor does not disturb, in the section's plane [m/s].
struct SectionFlow {
  double axial;     ///< along the rotor's axis
  double ahead;     ///< against the turn: positive if the section meets it with its leading edge
  double in_plane;  ///< size of the wind against the hub in the rotor's plane; 0 or more
};

/// Velocity that a rotor induces [m/s]: the axial flow becomes axial - its axial part, the flow
/// from ahead grows by its tangential part. Both are positive where lift pushes blades along the
/// axis and drives them.
struct InducedFlow {
  double axial = 0.0;
  double tangential = 0.0;
};

/// Returns Prandtl's factor of tip and root loss, at least 1e-4. sine: of the flow angle.
inline double calc_loss_factor(const Annulus& annulus, double sine) noexcept {
  constexpr double least = 1e-4;
  constexpr double least_sine = 1e-9;
  constexpr double none = 36.0;  // the factor differs from 1 by less than its rounding
  const double size = std::max(std::abs(sine), least_sine);
  double factor = 1.0;
  for (const double exponent : {annulus.tip, annulus.root})
    if (exponent < none * size)
      factor *= 2.0 / std::numbers::pi * std::acos(std::exp(-exponent / size));
  return std::max(factor, least);
}

/// An empirical thrust coefficient of a disc by a, its induced velocity by the axial flow, which it
/// opposes: c_0 + c_1 a + c_2 a^2 + c_3 a^3 up to a = 1, with c = constant + F by_loss.
struct ThrustCurve {
  double from;  ///< a from which it is that of the disc
  double constant[4];
  double by_loss[4];
};

/// Of Buhl (2005), which meets momentum theory with equal slope for any F; and of Glauert.
inline constexpr ThrustCurve kBuhl{
    0.4, {8.0 / 9.0, -40.0 / 9.0, 50.0 / 9.0, 0.0}, {0.0, 4.0, -4.0, 0.0}};
inline constexpr ThrustCurve kGlauert{1.0 / 3.0, {0.0, 0.0, 0.0, 0.0}, {0.0, 4.0, -5.0, 3.0}};

/// Returns the thrust coefficient of a curve; in the vortex ring state, a > 1, its tangent goes on.
inline double calc_thrust(const ThrustCurve& curve, double a, double loss) noexcept {
  const auto c = [&](int k) { return curve.constant[k] + loss * curve.by_loss[k]; };
  const double at = std::min(a, 1.0);
  const double thrust = c(0) + at * (c(1) + at * (c(2) + at * c(3)));
  return a > 1.0 ? thrust + (c(1) + 2.0 * c(2) + 3.0 * c(3)) * (a - 1.0) : thrust;
}

/// Returns the thrust coefficient C of a disc without losses by its a > 0, the inverse of
/// a = 0.2460 C + 0.0586 C^2 + 0.0883 C^3 (Madsen et al. 2020), which is real for any a.
inline double calc_madsen_thrust(double a) noexcept {
  constexpr double k1 = 0.2460, k2 = 0.0586, k3 = 0.0883;
  // By C = x - k2 / (3 k3): x^3 + 3 p x = 2 q, with p > 0, so that there is one solution.
  constexpr double shift = k2 / (3.0 * k3);
  constexpr double p = k1 / (3.0 * k3) - shift * shift;
  const double q = 0.5 * (a / k3 + shift * (k1 / k3 - 2.0 * shift * shift));
  const double root = std::cbrt(q + std::sqrt(q * q + p * p * p));
  const double c = root - p / root - shift;
  // What was lost to cancellation, by a step of Newton's method.
  return c + (a - c * (k1 + c * (k2 + c * k3))) / (k1 + c * (2.0 * k2 + c * 3.0 * k3));
}

/// Returns by what an induced velocity is multiplied for the thrust of the disc by its area and by
/// rho / 2 [m/s]: 4 F times the velocity with which air passes the disc (Glauert), and for a high
/// thrust not less than by a curve. Beyond a = 1, in the vortex ring state, momentum theory for
/// descent overtakes it. induced: axial part; loss: F.
inline double calc_mass_flow(const Annulus& annulus, double axial, double in_plane, double induced,
                             double loss) noexcept {
  const double across = annulus.mass_flow == spatial::MassFlow::glauert ? in_plane : 0.0;
  const double through = axial - induced;
  const double momentum = 4.0 * loss * std::sqrt(across * across + through * through);
  const double size = std::abs(axial);
  const double opposing = axial >= 0.0 ? induced : -induced;
  if (!(opposing > 0.0) || size == 0.0) return momentum;
  const double a = opposing / size;
  if (annulus.high_thrust == spatial::HighThrust::hawc2) {
    constexpr double overtaken = 2.0;  // by momentum theory, for any flow in the plane
    if (a > overtaken) return momentum;
    const double normal = size * calc_madsen_thrust(a) / (4.0 * a);
    const double empirical = 4.0 * loss * std::sqrt(across * across + normal * normal);
    return a > 1.0 ? std::max(momentum, empirical) : empirical;
  }
  const ThrustCurve& curve = annulus.high_thrust == spatial::HighThrust::buhl ? kBuhl : kGlauert;
  if (!(a > curve.from)) return momentum;
  return std::max(momentum, size * calc_thrust(curve, a, loss) / a);
}

/// Momentum of an annulus less lift of its blades, as a function of the angle by which induction
/// turns the flow. Induced velocity lies along lift, that is at right angles to the flow that
/// results; so the undisturbed flow Q, turned by an angle b and shortened to |Q| cos b, is that
/// flow, and |Q| sin b is induced. Everything by |Q| = 1.
template <class Lift>
class AnnulusBalance {
 public:
  /// lift: coefficient as a function of the flow angle [rad], atan2(axial, ahead), which stays
  /// within half a turn of that of the undisturbed flow. speed: |Q|, more than 0.
  AnnulusBalance(const Annulus& annulus, const SectionFlow& flow, double speed, const Lift& lift)
      : annulus_(annulus),
        sine_(flow.axial / speed),
        cosine_(flow.ahead / speed),
        in_plane_(flow.in_plane / speed),
        angle_(std::atan2(flow.axial, flow.ahead)),
        lift_(lift) {}

  /// Returns the lift of the undisturbed flow.
  double first_lift() const noexcept { return lift_(angle_); }
  /// Returns the balance at an angle b from -pi/2 to pi/2.
  double operator()(double b) const noexcept {
    const double sine = std::sin(b), cosine = std::cos(b);
    const double flow_sine = sine_ * cosine - cosine_ * sine;
    const double flow_cosine = cosine_ * cosine + sine_ * sine;
    const double loss = calc_loss_factor(annulus_, flow_sine);
    const double by_momentum = sine / annulus_.inflow_factor;
    const double mass_flow =
        calc_mass_flow(annulus_, sine_, in_plane_, by_momentum * flow_cosine, loss);
    return mass_flow * by_momentum - annulus_.solidity * cosine * cosine * lift_(angle_ - b);
  }
  /// Returns the size of an angle b at which the balance may be zero, for a lift curve of slope
  /// 2 pi and a mass flow that grows by 4 F times the induced velocity.
  double guess(double first_lift) const noexcept {
    const double loss = calc_loss_factor(annulus_, sine_);
    const double square = 4.0 * loss * std::abs(cosine_);
    const double linear = calc_mass_flow(annulus_, sine_, in_plane_, 0.0, loss) +
                          2.0 * std::numbers::pi * annulus_.solidity;
    const double load = annulus_.solidity * std::abs(first_lift);
    return 2.0 * load / (linear + std::sqrt(linear * linear + 4.0 * square * load));
  }
  /// Returns the induced flow at b, by |Q|.
  InducedFlow induced(double b) const noexcept {
    const double sine = std::sin(b), cosine = std::cos(b);
    return {sine * (cosine_ * cosine + sine_ * sine), sine * (sine_ * cosine - cosine_ * sine)};
  }

 private:
  const Annulus& annulus_;
  double sine_, cosine_;  // of the undisturbed flow's angle
  double in_plane_;
  double angle_;
  const Lift& lift_;
};

/// Returns the flow that the blades of an annulus induce [m/s], such that its change of momentum is
/// their lift (drag stays in the thin wakes of the sections). It exists for any continuous lift:
/// the balance is below zero on one side and above on the other. Of several solutions that which
/// turns the flow least is sought: none is between it and the last place tried before.
template <class Lift>
InducedFlow solve_annulus(const Annulus& annulus, const SectionFlow& flow,
                          const Lift& lift) noexcept {
  constexpr double quarter = 0.5 * std::numbers::pi;
  const double speed = std::hypot(flow.axial, flow.ahead);
  if (!(speed > 0.0) || !(annulus.solidity > 0.0)) return {};
  const AnnulusBalance<Lift> balance(annulus, flow, speed, lift);
  const double first_lift = balance.first_lift();
  if (first_lift == 0.0) return {};
  const double side = first_lift > 0.0 ? 1.0 : -1.0;
  const auto on_side = [&](double b) { return side * balance(side * b); };
  double low = 0.0, value_low = -annulus.solidity * std::abs(first_lift);
  double high = std::min(balance.guess(first_lift), quarter);
  double value_high = on_side(high);
  while (value_high < 0.0 && high < quarter) {
    low = high;
    value_low = value_high;
    high = std::min(1.5 * high, quarter);
    value_high = on_side(high);
  }
  double b = high;  // at a quarter turn no flow is left, nor lift: value_high < 0 is rounding
  if (value_high > 0.0) b = find_zero(on_side, low, value_low, high, value_high);
  const InducedFlow unit = balance.induced(side * b);
  return {speed * unit.axial, speed * unit.tangential};
}

}  // namespace spoke::air
