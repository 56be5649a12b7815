#pragma once

// The generalized-alpha method (Chung & Hulbert 1993) in the form of Arnold & Bruls 2007, linearly
// implicit in the elastic and damping forces: with true accelerations A and algorithmic ones al,
//   al_{n+1} = carry + k A_{n+1},    carry = (af A_n - am al_n) / (1 - am),  k = (1-af)/(1-am)
//   q_{n+1} = qp + beta' h^2 A_{n+1},  qp = q_n + h v_n + h^2 ((1/2 - beta) al_n + beta carry)
//   v_{n+1} = vp + gamma' h A_{n+1},   vp = v_n + h ((1 - gamma) al_n + gamma carry)
// The equations of motion hold at t_{n+1}; their elastic and damping forces are -K qp - D vp plus a
// share of the unknown A, which joins the constant block: Mhat = Mff + beta' h^2 K + gamma' h D.
// In space tension by rotation joins it, too (engine/bodies/space/implicit_tension.h). What is left
// is a fixed-point iteration that converges in one to three passes.

#include "engine/bodies/coordinate_block.h"

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
  double error_share = 0.0;  ///< error of a step by beta' h^2 (A_{n+1} - A_n), see step_error.h

  /// Names for the history vectors of a CoordinateBlock.
  enum History { predicted_q, predicted_v, carry_over, last_a, last_but_one_a, count };
};

/// Returns coefficients for spectral radius `radius` at infinite frequency, 0 <= radius <= 1, and
/// step [s].
GeneralizedAlpha make_generalized_alpha(double radius, double step);

/// Takes the coordinates as the point about which the next pass is linearised.
void hold(CoordinateBlock& block);

// A start, and a restart where forces may have jumped between two steps, takes accelerations that a
// step of this length can make use of: of modes that it does not resolve, true ones are (w h)^2
// times that, and would overshoot by as much. They solve the implicit equations at the present
// state,
//   Mhat A = Q - K (q - beta' h^2 A_old) - D (v - gamma' h A_old) + (other forces),
// and both accelerations, the true and the algorithmic one, change by A - A_old. Where no force has
// jumped, that is nothing.

/// Sets the accelerations at the start: A_old = 0.
void clear_accelerations(CoordinateBlock& block);
/// Takes q - beta' h^2 A_old and v - gamma' h A_old as the point of linearisation.
void begin_restart(const GeneralizedAlpha& method, CoordinateBlock& block);
/// Takes the accelerations `a` that the pass has found.
void complete_restart(const GeneralizedAlpha& method, const double* a,
                      CoordinateBlock& block) noexcept;

/// Begins the first iteration of a step: predicts, and starts from accelerations that go on from
/// those of as many steps as `order` says: 3 on a parabola, 2 on a straight line, 1 as they are.
/// Those of the last become history.
void predict(const GeneralizedAlpha& method, int order, CoordinateBlock& block) noexcept;

/// Results of a correction.
struct Correction {
  double change = 0.0;   ///< largest change of a coordinate since the last iterate [m, rad]
  double squares = 0.0;  ///< sum of the squares of the coordinates [m^2, rad^2]
};
/// Corrects the coordinates with accelerations `a`, which become the block's.
Correction correct(const GeneralizedAlpha& method, const double* a,
                   CoordinateBlock& block) noexcept;
/// Returns beta' h^2 max |a - A_n| at accelerations `a` [m, rad].
double calc_step_change(const GeneralizedAlpha& method, const double* a,
                        const CoordinateBlock& block) noexcept;

}  // namespace spoke
