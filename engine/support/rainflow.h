#pragma once

// Ranges of a signal by rainflow counting, ASTM E1049-85 (2017), section 5.4.4, and the range of a
// sine that does the damage of all of them.

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "spoke/export.h"

namespace spoke {

/// Counts the cycles of values that come one after the other. Keeps no more of them than turning
/// points whose ranges are still open, at most some thousand: should there be more, as of an
/// oscillation that decays for so many cycles, the oldest range counts as half a cycle.
class SPOKE_EXPORT Rainflow {
 public:
  /// Called with each range that is counted, and 1 or 0.5 cycles.
  using Count = std::function<void(double range, double cycles)>;

  /// Adds a value. Precondition: it is finite.
  void add(double value, const Count& count);
  /// Counts every range that is still open as half a cycle, and begins anew.
  void finish(const Count& count);

 private:
  void turn(double point, const Count& count);
  void count_oldest(const Count& count);

  static constexpr std::size_t kMostOpen = 4096;
  std::vector<double> open_;    ///< turning points, from the starting point of the standard on
  std::optional<double> last_;  ///< value behind the last of them, unless it is equal
};

/// Finds the range that, as often as asked for, does the damage of all ranges of a signal, where a
/// cycle of range R does a damage proportional to R^m (Palmgren and Miner; Basquin).
class SPOKE_EXPORT EquivalentRange {
 public:
  /// `exponent`: m, of Woehler's curve, above 0.
  explicit EquivalentRange(double exponent) : exponent_(exponent) {}

  /// Adds a value. Precondition: it is finite.
  void add(double value);
  /// Returns the range [unit of the values]: (sum n R^m / cycles)^(1/m) over all values so far,
  /// open ranges being half cycles. Precondition: cycles > 0.
  double calc(double cycles) const;

 private:
  void count(double range, double cycles);

  double exponent_;
  Rainflow rainflow_;
  double largest_ = 0.0;  ///< range
  double sum_ = 0.0;  ///< of n R^m, in units of that of the largest range, so that none overflows
};

}  // namespace spoke
