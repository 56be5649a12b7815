// Finds extremes, integrals, crossings and periods.

#include "program/study/measurement.h"

#include <cmath>

namespace spoke::study {
namespace {

/// Returns the time at which a line between two values crosses the level [s].
double crossing_time(double t0, double v0, double t1, double v1, double level) {
  return t0 + (t1 - t0) * ((level - v0) / (v1 - v0));
}

bool goes_up(double v0, double v1, double level) { return v0 < level && v1 >= level; }
bool goes_down(double v0, double v1, double level) { return v0 > level && v1 <= level; }

}  // namespace

Measurement::Measurement(const Response& response, double output_interval) : response_(&response) {
  if (response.kind == ResponseKind::history)
    due_.emplace(response.every.value_or(output_interval));
}

void Measurement::add(double t, double value) {
  if (t < response_->from || t > response_->to) return;
  switch (response_->kind) {
    case ResponseKind::min:
    case ResponseKind::max:
      add_extreme(value);
      break;
    case ResponseKind::mean:
      add_to_integral(t, value);
      break;
    case ResponseKind::rms:
      add_to_integral(t, value * value);
      break;
    case ResponseKind::final:
      result_ = value;
      break;
    case ResponseKind::at:
    case ResponseKind::first_crossing:
      note_crossing(t, value);
      break;
    case ResponseKind::history:
      if (!due_->is_due(t)) break;
      [[fallthrough]];
    case ResponseKind::period:
      history_.times.push_back(t);
      history_.values.push_back(value);
      break;
    case ResponseKind::frequency:
      break;
  }
}

void Measurement::add_extreme(double value) {
  const bool is_beyond = response_->kind == ResponseKind::min ? value < result_ : value > result_;
  if (std::isnan(result_) || is_beyond) result_ = value;
}

void Measurement::add_to_integral(double t, double value) {
  if (has_values_)
    integral_ += 0.5 * (t - last_time_) * (value + last_value_);
  else
    begin_ = t;
  last_time_ = t;
  last_value_ = value;
  has_values_ = true;
}

/// Notes the value at a time, or the time at a level.
void Measurement::note_crossing(double t, double value) {
  const bool is_open = std::isnan(result_);
  if (response_->kind == ResponseKind::at) {
    const double at = response_->time;
    if (is_open && t >= at)
      result_ = has_values_ && t > at
                    ? last_value_ + (value - last_value_) * ((at - last_time_) / (t - last_time_))
                    : value;
  } else if (is_open && has_values_) {
    const double level = *response_->level;
    const bool up = response_->direction != Direction::down && goes_up(last_value_, value, level);
    const bool down = response_->direction != Direction::up && goes_down(last_value_, value, level);
    if (up || down) result_ = crossing_time(last_time_, last_value_, t, value, level);
  }
  last_time_ = t;
  last_value_ = value;
  has_values_ = true;
}

double Measurement::result() const {
  if (response_->kind == ResponseKind::mean) return mean();
  if (response_->kind == ResponseKind::rms) return std::sqrt(mean());
  if (response_->kind == ResponseKind::period) return period();
  return result_;
}

double Measurement::mean() const {
  if (!has_values_) return std::numeric_limits<double>::quiet_NaN();
  return last_time_ > begin_ ? integral_ / (last_time_ - begin_) : last_value_;
}

double Measurement::period() const {
  const auto& [t, v] = history_;
  double level = response_->level.value_or(0.0);
  if (!response_->level) {
    Response of_mean;
    of_mean.kind = ResponseKind::mean;
    of_mean.to = std::numeric_limits<double>::infinity();
    Measurement measurement(of_mean, 0.0);
    for (std::size_t i = 0; i < t.size(); ++i) measurement.add(t[i], v[i]);
    level = measurement.mean();
  }
  double first = 0.0, last = 0.0;
  int crossings = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (!goes_up(v[i - 1], v[i], level)) continue;
    last = crossing_time(t[i - 1], v[i - 1], t[i], v[i], level);
    if (crossings++ == 0) first = last;
  }
  return crossings < 2 ? std::numeric_limits<double>::quiet_NaN()
                       : (last - first) / (crossings - 1);
}

}  // namespace spoke::study
