// Keeps extremes of stretches of rows, which become longer as more rows come.

#include "program/run_report/curves.h"

#include <algorithm>
#include <cmath>

namespace spoke::run_report {

void Curves::Extremes::add(Sample sample) {
  if (is_empty || sample.value < low.value) low = sample;
  if (is_empty || sample.value > high.value) high = sample;
  is_empty = false;
}

void Curves::Extremes::add(const Extremes& other) {
  if (other.is_empty) return;
  add(other.low);
  add(other.high);
}

Curves::Curves(std::size_t curves)
    : curves_(curves),
      most_buckets_(
          std::clamp<std::size_t>(kMostInAll / std::max<std::size_t>(1, curves), 50, kMostBuckets)),
      last_(curves) {}

void Curves::add(double t, std::span<const double> values) {
  if (buckets_.empty() || rows_in_last_ == rows_per_bucket_) {
    if (buckets_.size() == most_buckets_ * curves_) merge_pairs();
    buckets_.resize(buckets_.size() + curves_);
    rows_in_last_ = 0;
  }
  ++rows_in_last_;
  for (std::size_t i = 0; i < curves_; ++i) {
    if (!std::isfinite(values[i])) continue;
    last_[i] = {t, values[i]};
    buckets_[buckets_.size() - curves_ + i].add(last_[i]);
  }
}

void Curves::merge_pairs() {
  const std::size_t buckets = most_buckets_ / 2;
  for (std::size_t b = 0; b < buckets; ++b)
    for (std::size_t i = 0; i < curves_; ++i) {
      Extremes both = buckets_[2 * b * curves_ + i];
      both.add(buckets_[(2 * b + 1) * curves_ + i]);
      buckets_[b * curves_ + i] = both;
    }
  // The last one of an odd number stays by itself.
  for (std::size_t i = 0; i < most_buckets_ % 2 * curves_; ++i)
    buckets_[buckets * curves_ + i] = buckets_[2 * buckets * curves_ + i];
  buckets_.resize((buckets + most_buckets_ % 2) * curves_);
  rows_per_bucket_ *= 2;
}

std::vector<Sample> Curves::curve(std::size_t index) const {
  std::vector<Sample> samples;
  for (std::size_t at = index; at < buckets_.size(); at += curves_) {
    const Extremes& bucket = buckets_[at];
    if (bucket.is_empty) continue;
    const bool is_rising = bucket.low.t <= bucket.high.t;
    samples.push_back(is_rising ? bucket.low : bucket.high);
    if (bucket.low.t != bucket.high.t) samples.push_back(is_rising ? bucket.high : bucket.low);
  }
  if (!samples.empty() && samples.back().t < last_[index].t) samples.push_back(last_[index]);
  return samples;
}

}  // namespace spoke::run_report
