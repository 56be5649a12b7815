#pragma once

// The curves of report.html, in bounded memory.

#include <cstddef>
#include <span>
#include <vector>

namespace spoke::run_report {

struct Sample {
  double t = 0.0;  ///< [s]
  double value = 0.0;
};

/// Values over time in little memory: the lowest and highest value of each curve, with their times,
/// in each of at most `kMostBuckets` stretches of time (fewer, if there are many curves). No
/// extreme is lost.
class Curves {
 public:
  static constexpr std::size_t kMostBuckets = 1000;
  static constexpr std::size_t kMostInAll = 40000;  ///< number of buckets of all curves together

  explicit Curves(std::size_t curves);

  /// Adds a value for each curve at time t [s]; times must not decrease. Values that are not finite
  /// leave a gap.
  void add(double t, std::span<const double> values);
  /// Returns the values kept of a curve, in order of time, the last value included.
  std::vector<Sample> curve(std::size_t index) const;
  /// Returns the rows added for each bucket: 1 if none was left out.
  std::size_t rows_per_bucket() const { return rows_per_bucket_; }
  std::size_t most_buckets() const { return most_buckets_; }

 private:
  struct Extremes {
    Sample low, high;
    bool is_empty = true;
    void add(Sample sample);
    void add(const Extremes& other);
  };

  void merge_pairs();

  std::size_t curves_;
  std::size_t most_buckets_;
  std::size_t rows_per_bucket_ = 1;
  std::size_t rows_in_last_ = 0;
  std::vector<Extremes> buckets_;  ///< extremes by bucket and curve
  std::vector<Sample> last_;       ///< last value by curve
};

}  // namespace spoke::run_report
