#pragma once

// The generalized-alpha method (Chung & Hulbert 1993) in the form of Arnold & Bruls 2007, linearly
// implicit in the elastic and damping forces: with true accelerations A and algorithmic ones al,
//   al_{n+1} = carry + k A_{n+1},    carry = (af A_n - am al_n) / (1 - am),  k = (1-af)/(1-am)
//   q_{n+1} = qp + beta' h^2 A_{n+1},  qp = q_n + h v_n + h^2 ((1/2 - beta) al_n + beta carry)
//   v_{n+1} = vp + gamma' h A_{n+1},   vp = v_n + h ((1 - gamma) al_n + gamma carry)
// The equations of motion hold at t_{n+1}; their elastic and damping forces are -K qp - D vp plus a
// share of the unknown A, which joins the constant block: Mhat = Mff + beta' h^2 K + gamma' h D.
// What is left is a fixed-point iteration that converges in one to three passes.

#include <span>

#include "engine/table/step_data.h"

namespace spoke {

struct GeneralizedAlpha {
  double step = 0.0;           ///< h [s]
  double k = 0.0;              ///< (1 - af) / (1 - am)
  double af_share = 0.0;       ///< af / (1 - am)
  double am_share = 0.0;       ///< am / (1 - am)
  double position_gain = 0.0;  ///< beta' h^2 [s^2]
  double velocity_gain = 0.0;  ///< gamma' h [s]
  double beta = 0.0;
  double gamma = 0.0;

  /// Names for the history vectors of a CoordinateBlock.
  enum History { predicted_q, predicted_v, carry, count };
};

/// Coefficients for spectral radius `radius` at infinite frequency, 0 <= radius <= 1, and step [s].
GeneralizedAlpha make_generalized_alpha(double radius, double step);

/// Before the first step, once the accelerations at t = 0 are known.
void start(const GeneralizedAlpha& method, CoordinateBlock& block);
/// Takes the coordinates as the point about which the next pass is linearised.
void hold(CoordinateBlock& block);
/// First iteration of a step: predicts, and starts from the last accelerations.
void predict(const GeneralizedAlpha& method, CoordinateBlock& block) noexcept;
/// The same for the coordinates of bodies.
void predict(const GeneralizedAlpha& method, std::span<BodyData> bodies) noexcept;

/// What a correction did.
struct Correction {
  double change = 0.0;   ///< largest change of a coordinate since the last iterate [m, rad]
  double squares = 0.0;  ///< sum of the squares of the coordinates [m^2, rad^2]
};
/// Corrects the coordinates with accelerations `a`, which become the block's.
Correction correct(const GeneralizedAlpha& method, const double* a,
                   CoordinateBlock& block) noexcept;

}  // namespace spoke
