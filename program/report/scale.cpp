// Round ticks, linear and logarithmic, and their labels.

#include "program/report/scale.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>

namespace spoke::report {
namespace {

/// The multiples 1, 2, 5 and 10 of a power of ten `e`.
constexpr std::array kRound{1.0, 2.0, 5.0, 10.0};

/// The least length of a linear axis, by its largest value: values that vary less are shown as
/// flat, and labels need few digits to differ.
constexpr double kLeastSpread = 1e-4;

double power_of_ten(double exponent) { return std::pow(10.0, exponent); }

/// Returns the least round step that needs at most `most` ticks for the length.
double round_step(double length, int most) {
  const double raw = length / std::max(1, most - 1);
  const double power = power_of_ten(std::floor(std::log10(raw)));
  for (const double factor : kRound)
    if (raw <= factor * power * (1.0 + 1e-9)) return factor * power;
  return 10.0 * power;
}

std::vector<double> multiples(double low, double high, double step) {
  std::vector<double> values;
  const double first = std::ceil(low / step - 1e-9);
  for (int k = 0; (first + k) * step <= high + 1e-9 * step; ++k)
    values.push_back((first + k) * step);
  return values;
}

/// Returns the number in the decimals that tell it from its neighbours at a distance of `step`.
std::string label_of(double value, double step) {
  std::array<char, 400> text;
  const double size = std::max(std::abs(value), step);
  if (size >= 1e7 || size < 1e-4) {
    std::snprintf(text.data(), text.size(), "%.6g", value);
  } else {
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    std::snprintf(text.data(), text.size(), "%.*f", std::min(decimals, 12), value);
  }
  return text.data();
}

std::string short_label(double value) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.*g", std::abs(value) < 1e7 ? 8 : 6, value);
  return text.data();
}

/// Returns the greatest (direction < 0) or least round number of a logarithmic axis beyond a value.
double round_beyond(double value, int direction) {
  const double power = power_of_ten(std::floor(std::log10(value)));
  if (direction > 0) {
    for (const double factor : kRound)
      if (factor * power >= value * (1.0 - 1e-9)) return factor * power;
    return 10.0 * power;
  }
  for (const double factor : {5.0, 2.0})
    if (factor * power <= value * (1.0 + 1e-9)) return factor * power;
  return power;
}

}  // namespace

std::string title_of(const Axis& axis) {
  return axis.unit.empty() ? axis.title : axis.title + " [" + axis.unit + ']';
}

std::string caption_of(const Axis& axis) {
  if (axis.kind == ScaleKind::linear) return "";
  return "The axis is logarithmic: compare ends, not lengths.";
}

void Range::add(double value) {
  if (!std::isfinite(value)) return;
  low = low ? std::min(*low, value) : value;
  high = high ? std::max(*high, value) : value;
}

ScaleKind scale_for(const Range& values) {
  constexpr double kMost = 12.0;  // ratio up to which a linear axis tells the small values apart
  const bool is_wide = values.low && *values.low > 0.0 && *values.high > kMost * *values.low;
  return is_wide ? ScaleKind::log : ScaleKind::linear;
}

std::vector<double> round_ticks(double low, double high, int most) {
  assert(low < high && std::isfinite(low) && std::isfinite(high));
  return multiples(low, high, round_step(high - low, most));
}

std::vector<double> log_ticks(double low, double high, int most) {
  assert(0.0 < low && low < high && std::isfinite(high));
  const double first = std::floor(std::log10(low) + 1e-12);
  const double decades = std::ceil(std::log10(high) - 1e-12) - first;
  const bool only_powers = 3.0 * std::log10(high / low) > most;
  const double stride = only_powers ? std::max(1.0, std::ceil(decades / std::max(1, most - 1))) : 1;
  std::vector<double> ticks;
  for (double exponent = first; exponent <= first + decades; exponent += stride)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double tick = factor * power_of_ten(exponent);
      if (only_powers && factor != 1.0) continue;
      if (tick >= low * (1.0 - 1e-9) && tick <= high * (1.0 + 1e-9)) ticks.push_back(tick);
    }
  return ticks;
}

Scale::Scale(const Axis& axis, const Range& values, double first, double last, int most_ticks)
    : kind_(axis.kind), first_(first), last_(last) {
  const bool is_log = kind_ == ScaleKind::log;
  low_ = axis.low.value_or(values.low.value_or(is_log ? 1.0 : 0.0));
  high_ = axis.high.value_or(values.high.value_or(is_log ? 10.0 : 1.0));
  if (is_log && !(low_ > 0.0)) low_ = high_ > 0.0 ? 1e-3 * high_ : 1.0;
  if (!is_log && !axis.low && !axis.high) widen();
  if (!(high_ > low_)) {
    high_ = low_ + (low_ == 0.0 ? 1.0 : std::abs(low_));
  }
  extend_to_ticks(axis, most_ticks);
}

void Scale::widen() {
  const double lacking = kLeastSpread * std::max(std::abs(low_), std::abs(high_)) - (high_ - low_);
  if (!(lacking > 0.0)) return;
  low_ -= 0.5 * lacking;
  high_ += 0.5 * lacking;
}

void Scale::extend_to_ticks(const Axis& axis, int most_ticks) {
  const bool is_log = kind_ == ScaleKind::log;
  const double step = round_step(high_ - low_, most_ticks);
  if (!axis.low) low_ = is_log ? round_beyond(low_, -1) : std::floor(low_ / step + 1e-9) * step;
  if (!axis.high) high_ = is_log ? round_beyond(high_, 1) : std::ceil(high_ / step - 1e-9) * step;
  if (!axis.ticks.empty()) {
    for (const double value : axis.ticks)
      if (value >= low_ && value <= high_) ticks_.push_back({value, short_label(value)});
  } else if (is_log) {
    for (const double value : log_ticks(low_, high_, most_ticks))
      ticks_.push_back({value, short_label(value)});
  } else {
    for (const double value : multiples(low_, high_, step))
      // 0.0 is added so that there is no "-0".
      ticks_.push_back({value, label_of(value == 0.0 ? 0.0 : value, step)});
  }
}

bool Scale::shows(double value) const {
  return std::isfinite(value) && (kind_ == ScaleKind::linear || value > 0.0);
}

double Scale::share(double value) const {
  return kind_ == ScaleKind::linear ? (value - low_) / (high_ - low_)
                                    : std::log(value / low_) / std::log(high_ / low_);
}

double Scale::position(double value) const {
  return std::lerp(first_, last_, std::clamp(share(std::clamp(value, low_, high_)), 0.0, 1.0));
}

}  // namespace spoke::report
