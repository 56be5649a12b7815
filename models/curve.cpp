// Slopes, values, derivatives and integrals of the pieces.

#include "models/curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "models/count_text.h"
#include "models/support/quantity.h"
#include "spoke/error.h"

namespace spoke {
namespace {

bool same_sign(double a, double b) { return (a > 0.0 && b > 0.0) || (a < 0.0 && b < 0.0); }

/// Returns the slope at a point between two chords: their weighted harmonic mean (Fritsch & Butland
/// 1984), 0 at an extreme of the points. h: lengths [s], m: slopes of the chords before and after.
double inner_slope(double h0, double h1, double m0, double m1) {
  if (!same_sign(m0, m1)) return 0.0;
  const double w0 = 2.0 * h1 + h0;
  const double w1 = h1 + 2.0 * h0;
  return (w0 + w1) / (w0 / m0 + w1 / m1);
}

/// Returns the slope at an end: that of the parabola through the first three points, limited so
/// that the curve stays monotone. h0, m0: the chord at the end, h1, m1: its neighbour.
double end_slope(double h0, double h1, double m0, double m1) {
  const double slope = ((2.0 * h0 + h1) * m0 - h0 * m1) / (h0 + h1);
  if (!same_sign(slope, m0)) return 0.0;
  if (!same_sign(m0, m1) && std::abs(slope) > 3.0 * std::abs(m0)) return 3.0 * m0;
  return slope;
}

std::vector<double> calc_slopes(const std::vector<double>& times,
                                const std::vector<double>& values) {
  const std::size_t n = times.size();
  std::vector<double> slopes(n, 0.0);
  if (n == 1) return slopes;
  const auto h = [&](std::size_t k) { return times[k + 1] - times[k]; };
  const auto m = [&](std::size_t k) { return (values[k + 1] - values[k]) / h(k); };
  if (n == 2) {
    slopes[0] = slopes[1] = m(0);
    return slopes;
  }
  for (std::size_t k = 1; k + 1 < n; ++k) {
    slopes[k] = inner_slope(h(k - 1), h(k), m(k - 1), m(k));
  }
  slopes[0] = end_slope(h(0), h(1), m(0), m(1));
  slopes[n - 1] = end_slope(h(n - 2), h(n - 3), m(n - 2), m(n - 3));
  return slopes;
}

void check_points(const std::vector<double>& times, const std::vector<double>& values) {
  if (times.empty() || times.size() != values.size())
    throw InputError("a curve has " + counted(std::ssize(times), "time") + " and " +
                     counted(std::ssize(values), "value") +
                     ", expected as many of each, at least one");
  for (std::size_t k = 0; k < times.size(); ++k) {
    const bool is_time = !std::isfinite(times[k]);
    if (is_time || !std::isfinite(values[k]))
      throw InputError(std::string(is_time ? "time " : "value ") + std::to_string(k + 1) +
                       " of a curve is " + describe(is_time ? times[k] : values[k]) +
                       ", expected a finite number");
    if (k > 0 && times[k] <= times[k - 1])
      throw InputError("time " + std::to_string(k + 1) + " of a curve is " + describe(times[k]) +
                       ", expected more than the one before it, " + describe(times[k - 1]));
  }
}

}  // namespace

Curve::Curve(std::vector<double> times, std::vector<double> values)
    : times_(std::move(times)), values_(std::move(values)) {
  check_points(times_, values_);
  slopes_ = calc_slopes(times_, values_);
  integrals_.assign(times_.size(), 0.0);
  for (std::size_t k = 0; k + 1 < times_.size(); ++k) {
    integrals_[k + 1] = integrals_[k] + cubic(k).integral(times_[k + 1] - times_[k]);
  }
}

std::size_t Curve::segment(double t) const {
  assert(times_.front() <= t && t < times_.back());
  const auto next = std::upper_bound(times_.begin(), times_.end(), t);
  return static_cast<std::size_t>(next - times_.begin()) - 1;
}

Curve::Cubic Curve::cubic(std::size_t k) const {
  const double h = times_[k + 1] - times_[k];
  const double m = (values_[k + 1] - values_[k]) / h;
  return {values_[k], slopes_[k], (3.0 * m - 2.0 * slopes_[k] - slopes_[k + 1]) / h,
          (slopes_[k] + slopes_[k + 1] - 2.0 * m) / (h * h)};
}

double Curve::value(double t) const {
  if (std::isnan(t)) return t;
  if (t <= times_.front()) return values_.front();
  if (t >= times_.back()) return values_.back();
  const std::size_t k = segment(t);
  return cubic(k).value(t - times_[k]);
}

double Curve::derivative(double t) const {
  if (std::isnan(t)) return t;
  if (t < times_.front() || t > times_.back()) return 0.0;
  if (t == times_.back()) return slopes_.back();
  const std::size_t k = segment(t);
  return cubic(k).derivative(t - times_[k]);
}

double Curve::second_derivative(double t) const {
  if (std::isnan(t)) return t;
  if (t < times_.front() || t >= times_.back()) return 0.0;
  const std::size_t k = segment(t);
  return cubic(k).second_derivative(t - times_[k]);
}

double Curve::integral(double t) const { return primitive(t) - primitive(0.0); }

double Curve::primitive(double t) const {
  if (std::isnan(t)) return t;
  if (t <= times_.front()) return values_.front() * (t - times_.front());
  if (t >= times_.back()) return integrals_.back() + values_.back() * (t - times_.back());
  const std::size_t k = segment(t);
  return integrals_[k] + cubic(k).integral(t - times_[k]);
}

double calc_rise(double t, double duration) {
  using std::numbers::pi;
  if (t >= duration || duration <= 0.0) return 1.0;
  if (t <= 0.0) return 0.0;
  const double tau = t / duration;
  return tau - std::sin(2.0 * pi * tau) / (2.0 * pi);
}

}  // namespace spoke
