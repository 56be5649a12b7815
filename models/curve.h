#pragma once

// Curves over time, for drives and loads; of a torque, over speed.

#include <cstddef>
#include <vector>

#include "spoke/export.h"

namespace spoke {

/// A smooth function of time through given points: monotone piecewise cubic Hermite interpolation
/// (Fritsch & Carlson 1980, slopes of Fritsch & Butland 1984). Continuous with its first derivative
/// from the first point to the last, never overshoots the points; constant before and after.
class SPOKE_EXPORT Curve {
 public:
  /// Zero.
  Curve() : Curve(0.0) {}
  /// A constant.
  explicit Curve(double value) : Curve({0.0}, {value}) {}
  /// times: strictly increasing [s]; values: as many, in any unit. Throws InputError unless the
  /// sizes are equal and not zero, times increase, and all is finite.
  Curve(std::vector<double> times, std::vector<double> values);

  // At a time that is not a number all three are none: nodes of a graph ask for it where a motion
  // has diverged.

  /// At time t [s].
  double value(double t) const;
  /// At the first and the last point the one-sided derivative inside; 0 before and after.
  double derivative(double t) const;
  /// Within the segment that holds t; 0 before and after the points.
  double second_derivative(double t) const;
  /// Integral from 0 to t [unit of values * s].
  double integral(double t) const;

  /// Of its points [s].
  const std::vector<double>& times() const { return times_; }
  /// At its points.
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

  /// The segment that holds t. Precondition: first time <= t < last time.
  std::size_t segment(double t) const;
  Cubic cubic(std::size_t segment) const;
  /// Integral from the first point to t.
  double primitive(double t) const;

  std::vector<double> times_;
  std::vector<double> values_;
  std::vector<double> slopes_;     ///< derivative at each point
  std::vector<double> integrals_;  ///< integral from the first point to each point
};

/// The smooth rise of drives, loads and gravity from 0 at t = 0 to 1 at t = duration [s]:
/// t/T - sin(2 pi t/T)/(2 pi); 1 at all times if the duration is 0.
SPOKE_EXPORT double calc_rise(double t, double duration);

}  // namespace spoke
