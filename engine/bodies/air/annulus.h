#pragma once

// Momentum balance of an annulus of the rotor's disc, in one unknown. docs/aerodynamics.md,
// section 2.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/bodies/air/find_zero.h"

namespace spoke::air {

/// An annulus of a rotor's disc and the blades in it.
struct Annulus {
  double solidity;  ///< number of blades times chord by the circumference
  double tip;       ///< Prandtl's exponent times |sin(flow angle)|: B (R - r) / (2 r); infinite:
                    ///< no loss
  double root;      ///< likewise: B (r - R_hub) / (2 R_hub)
  double inflow_factor = 1.0;  ///< induced velocity by that of momentum theory
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

/// Returns by what an induced velocity is multiplied for the thrust of the disc by its area and by
/// rho / 2 [m/s]: 4 F times the velocity with which air passes the disc (Glauert), and not less
/// than by Buhl's curve for high thrust, that is for an induced velocity of more than 0.4 of the
/// axial flow, which it opposes. induced: axial part; loss: F.
inline double calc_mass_flow(double axial, double in_plane, double induced, double loss) noexcept {
  constexpr double high_thrust = 0.4;
  const double through = axial - induced;
  const double momentum = 4.0 * loss * std::sqrt(in_plane * in_plane + through * through);
  const double size = std::abs(axial);
  const double opposing = axial >= 0.0 ? induced : -induced;
  if (!(opposing > high_thrust * size) || size == 0.0) return momentum;
  if (opposing <= size) {  // a = opposing / size; thrust coefficient by a, times size
    const double a = opposing / size;
    const double thrust = 8.0 / 9.0 + a * (4.0 * loss - 40.0 / 9.0 + a * (50.0 / 9.0 - 4.0 * loss));
    return std::max(momentum, size * thrust / a);
  }
  // In the vortex ring state the tangent goes on until momentum theory for descent overtakes it.
  const double slope = 60.0 / 9.0 - 4.0 * loss;
  return std::max(momentum, size * (2.0 * size + slope * (opposing - size)) / opposing);
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
    const double mass_flow = calc_mass_flow(sine_, in_plane_, by_momentum * flow_cosine, loss);
    return mass_flow * by_momentum - annulus_.solidity * cosine * cosine * lift_(angle_ - b);
  }
  /// Returns the size of an angle b at which the balance may be zero, for a lift curve of slope
  /// 2 pi and a mass flow that grows by 4 F times the induced velocity.
  double guess(double first_lift) const noexcept {
    const double loss = calc_loss_factor(annulus_, sine_);
    const double square = 4.0 * loss * std::abs(cosine_);
    const double linear =
        calc_mass_flow(sine_, in_plane_, 0.0, loss) + 2.0 * std::numbers::pi * annulus_.solidity;
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
