#pragma once

// Curves over time, for drives and loads; curves of a torque run over speed.

#include <cstddef>
#include <vector>

#include "spoke/export.h"

namespace spoke {

/// A smooth function of time through given points: monotone piecewise cubic Hermite interpolation
/// (Fritsch & Carlson 1980, slopes of Fritsch & Butland 1984). Continuous with its first derivative
/// from the first point to the last, never overshoots the points; constant before and after.
class SPOKE_EXPORT Curve {
 public:
  /// Makes the curve that is zero.
  Curve() : Curve(0.0) {}
  /// Makes a constant curve.
  explicit Curve(double value) : Curve({0.0}, {value}) {}
  /// Makes a curve through points. times: strictly increasing [s]; values: as many, in any unit.
  /// Throws InputError unless the sizes are equal and not zero, times increase, and all is finite.
  Curve(std::vector<double> times, std::vector<double> values);

  // At a time that is not a number, these three functions return none: nodes of a graph call them
  // so where a motion has diverged.

  /// Returns the value at time t [s], in the unit of the values.
  double value(double t) const;
  /// Returns the derivative [unit/s]: at the first and the last point the one-sided one inside; 0
  /// before and after.
  double derivative(double t) const;
  /// Returns the second derivative [unit/s^2] within the segment that holds t; 0 before and after
  /// the points.
  double second_derivative(double t) const;
  /// Returns the integral from 0 to t [unit of values * s].
  double integral(double t) const;

  /// Returns the times of its points [s].
  const std::vector<double>& times() const { return times_; }
  /// Returns the values at its points.
  const std::vector<double>& values() const { return values_; }

 private:
  /// a + b x + c x^2 + d x^3 with x the time since the segment's first point.
  struct Cubic {
    double a, b, c, d;
    double value(double x) const { return a + x * (b + x * (c + x * d)); }
    double derivative(double x) const { return b + x * (2.0 * c + x * 3.0 * d); }
    double second_derivative(double x) const { return 2.0 * c + 6.0 * d * x; }
    double integral(double x) const {
      return x * (a + x * (b / 2.0 + x * (c / 3.0 + x * d / 4.0)));
    }
  };

  /// Returns the segment that holds t. Precondition: first time <= t < last time.
  std::size_t segment(double t) const;
  Cubic cubic(std::size_t segment) const;
  /// Returns the integral from the first point to t.
  double primitive(double t) const;

  std::vector<double> times_;
  std::vector<double> values_;
  std::vector<double> slopes_;     ///< derivative at each point
  std::vector<double> integrals_;  ///< integral from the first point to each point
};

/// Returns the smooth rise of drives, loads and gravity from 0 at t = 0 to 1 at t = duration [s]:
/// t/T - sin(2 pi t/T)/(2 pi); 1 at all times if the duration is 0.
SPOKE_EXPORT double calc_rise(double t, double duration);

}  // namespace spoke
