// Counts ranges with a stack of turning points.

#include "engine/support/rainflow.h"

#include <cmath>

namespace spoke {

void Rainflow::add(double value, const Count& count) {
  if (open_.empty()) {
    open_.push_back(value);
    return;
  }
  const double turned = open_.back();
  if (value == last_.value_or(turned)) return;
  if (last_ && (value > *last_) != (*last_ > turned)) turn(*last_, count);
  last_ = value;
}

void Rainflow::count_oldest(const Count& count) {
  count(std::abs(open_[1] - open_[0]), 0.5);
  open_.erase(open_.begin());
}

/// Adds a turning point, and counts the ranges that it closes.
void Rainflow::turn(double point, const Count& count) {
  open_.push_back(point);
  while (open_.size() >= 3) {
    const auto end = open_.end();
    const double newest = std::abs(end[-1] - end[-2]), before = std::abs(end[-2] - end[-3]);
    if (newest < before) break;
    if (open_.size() == 3) {  // it contains the starting point
      count_oldest(count);
    } else {
      count(before, 1.0);
      open_.erase(end - 3, end - 1);
    }
  }
  if (open_.size() > kMostOpen) count_oldest(count);
}

void Rainflow::finish(const Count& count) {
  if (last_) turn(*last_, count);
  while (open_.size() > 1) count_oldest(count);
  open_.clear();
  last_.reset();
}

void EquivalentRange::add(double value) {
  rainflow_.add(value, [this](double range, double cycles) { count(range, cycles); });
}

void EquivalentRange::count(double range, double cycles) {
  if (range > largest_) {
    sum_ *= std::pow(largest_ / range, exponent_);
    largest_ = range;
  }
  if (largest_ > 0.0) sum_ += cycles * std::pow(range / largest_, exponent_);
}

double EquivalentRange::calc(double cycles) const {
  EquivalentRange all = *this;
  all.rainflow_.finish([&all](double range, double n) { all.count(range, n); });
  return all.largest_ * std::pow(all.sum_ / cycles, 1.0 / exponent_);
}

}  // namespace spoke
