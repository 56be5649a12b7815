#pragma once

// Axes of charts: from values to positions, with ticks at round numbers.

#include <optional>
#include <string>
#include <vector>

namespace spoke::report {

enum class ScaleKind { linear, log };

/// An axis as the chart's author describes it.
struct Axis {
  std::string title = {};
  std::string unit = {};  ///< appended to the title in brackets
  ScaleKind kind = ScaleKind::linear;
  std::optional<double> low = {};  ///< lower end of the axis; none: a round number below all values
  /// Upper end of the axis; none: a round number above all values.
  std::optional<double> high = {};
  std::vector<double> ticks = {};  ///< places of ticks; empty: round numbers
};

/// Returns "title [unit]".
std::string title_of(const Axis& axis);

/// Returns a caption for bars along the axis: that their ends count, where it is logarithmic;
/// otherwise empty.
std::string caption_of(const Axis& axis);

struct Tick {
  double value = 0.0;
  std::string label = {};
};

/// The smallest range of values added to it. Ignores values that are not finite.
struct Range {
  std::optional<double> low = {};
  std::optional<double> high = {};
  void add(double value);
};

/// Returns logarithmic where the largest value is so many times the smallest that a linear axis
/// would flatten most of them; all of them positive.
ScaleKind scale_for(const Range& values);

/// Returns the multiples of 1, 2 or 5 times a power of ten that lie in [low, high], `most` at most,
/// 2 <= most. Precondition: low < high, finite.
std::vector<double> round_ticks(double low, double high, int most);
/// Returns 1, 2 and 5 times powers of ten in [low, high], thinned to powers if they are many.
/// Precondition: 0 < low < high, finite.
std::vector<double> log_ticks(double low, double high, int most);

/// Maps the values of an axis to positions between `first` (at the low end) and `last`. Nearly
/// constant values are shown as such: a linear axis spans a ten-thousandth of them at the least.
class Scale {
 public:
  /// `values`: range that the chart shows; may be empty. `most_ticks`: number of ticks that there
  /// is room for.
  Scale(const Axis& axis, const Range& values, double first, double last, int most_ticks = 7);

  /// Returns the position of a value; that of the nearer end for values beyond it.
  double position(double value) const;
  /// Returns whether the axis can show a value: finite, and positive if it is logarithmic.
  bool shows(double value) const;
  const std::vector<Tick>& ticks() const { return ticks_; }
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  double share(double value) const;
  void widen();
  void extend_to_ticks(const Axis& axis, int most_ticks);

  ScaleKind kind_;
  double low_ = 0.0, high_ = 1.0;
  double first_, last_;
  std::vector<Tick> ticks_;
};

}  // namespace spoke::report
