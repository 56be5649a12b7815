#pragma once

// Coefficients of a section by angle of attack and Reynolds or Mach number, made for fast
// evaluation.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "models/air.h"

namespace spoke::air {

/// Coefficients at an angle of attack. Lift with a separation point f that lags is
/// lift + (f - separation) recovery.
struct PolarValues {
  double lift, drag, moment;
  double separation;  ///< steady separation point, 0: the flow is separated; 1: attached
  double recovery;    ///< lift of attached less that of separated flow
};

/// What chooses between the polars of an aerofoil.
enum class ChosenBy { nothing, reynolds, mach };
/// Returns that of an aerofoil: with one polar nothing.
ChosenBy find_choice(const spatial::Airfoil& airfoil);

/// Coefficients of a section: of an aerofoil, or blended of two by a share. Linear in the angle
/// between the given points, at which they are exact, and in the logarithm of the Reynolds number,
/// or in the Mach number; beyond the first and last one they are constant.
class SectionPolar {
 public:
  /// Two neighbouring Reynolds or Mach numbers and the share of the upper one.
  struct Level {
    const PolarValues *lower, *upper;
    double share;
  };

  /// Makes coefficients (1 - share) inner + share outer. Both aerofoils have passed
  /// check_airfoil(); if either has several polars, both are chosen by the same.
  SectionPolar(const spatial::Airfoil& inner, const spatial::Airfoil& outer, double share);

  /// Returns the level at a Reynolds number, or at the Mach number where polars are chosen by it.
  Level level(double reynolds, double mach = 0.0) const noexcept;
  /// Returns the steady lift at an angle from -3 pi to 3 pi [rad].
  double lift(const Level& level, double angle) const noexcept {
    const Place at = find(angle);
    const auto between = [&](const PolarValues* rows) {
      const double low = rows[at.row].lift;
      return low + at.share * (rows[at.row + 1].lift - low);
    };
    const double lower = between(level.lower);
    if (level.share == 0.0) return lower;
    return lower + level.share * (between(level.upper) - lower);
  }
  /// Returns all coefficients there.
  PolarValues values(const Level& level, double angle) const noexcept;
  /// Returns the angle of zero lift [rad] of the first level, 0 if there is none.
  double zero_lift() const { return zero_lift_; }

 private:
  /// Equal parts of the circle, each of which knows its first row.
  static constexpr int kBins = 720;
  struct Place {
    int row;
    double share;  ///< of the next row
  };

  /// Finds the rows around an angle; any that is no number is 0.
  Place find(double angle) const noexcept {
    constexpr double pi = std::numbers::pi;
    if (angle > pi) angle -= 2.0 * pi;
    if (angle < -pi) angle += 2.0 * pi;
    if (!(std::abs(angle) <= pi)) angle = 0.0;
    const int bin = std::min(static_cast<int>((angle + pi) * (kBins / (2.0 * pi))), kBins - 1);
    const auto last = static_cast<std::int32_t>(angles_.size()) - 2;
    std::int32_t row = first_[bin];
    while (row < last && angles_[row + 1] <= angle) ++row;
    const double low = angles_[row];
    return {row, (angle - low) / (angles_[row + 1] - low)};
  }

  std::vector<double> angles_;               ///< from -pi to pi, ascending
  std::array<std::int32_t, kBins> first_{};  ///< last row at or before the bin's begin
  ChosenBy by_ = ChosenBy::nothing;
  std::vector<double> levels_;  ///< logarithms of Reynolds numbers, or Mach numbers, ascending
  std::vector<std::vector<PolarValues>> tables_;  ///< rows of each level
  double zero_lift_ = 0.0;
};

}  // namespace spoke::air
