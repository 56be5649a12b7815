#pragma once

// Axes of charts: from values to positions, with ticks at round numbers.

#include <optional>
#include <string>
#include <vector>

namespace spoke::report {

enum class ScaleKind { linear, log };

/// What a chart's author says of an axis.
struct Axis {
  std::string title = {};
  std::string unit = {};  ///< appended to the title in brackets
  ScaleKind kind = ScaleKind::linear;
  std::optional<double> low = {};  ///< end of the axis; unless set: a round number below all values
  std::optional<double> high = {};  ///< likewise, above
  std::vector<double> ticks = {};   ///< unless empty: these, instead of round numbers
};

/// "title [unit]".
std::string title_of(const Axis& axis);

/// What to say of bars along it: where the axis is logarithmic, that their ends count; else
/// nothing.
std::string caption_of(const Axis& axis);

struct Tick {
  double value = 0.0;
  std::string label = {};
};

/// The smallest range of values added to it. Ignores what is not finite.
struct Range {
  std::optional<double> low = {};
  std::optional<double> high = {};
  void add(double value);
};

/// Logarithmic where the largest value is so many times the smallest that a linear axis would
/// flatten most of them; all of them positive.
ScaleKind scale_for(const Range& values);

/// Multiples of 1, 2 or 5 times a power of ten that lie in [low, high], `most` at most, 2 <= most.
/// Precondition: low < high, finite.
std::vector<double> round_ticks(double low, double high, int most);
/// 1, 2 and 5 times powers of ten in [low, high], thinned to powers if they are many.
/// Precondition: 0 < low < high, finite.
std::vector<double> log_ticks(double low, double high, int most);

/// Maps the values of an axis to positions between `first` (at the low end) and `last`. Nearly
/// constant values are shown as such: a linear axis spans a ten-thousandth of them at the least.
class Scale {
 public:
  /// `values`: what the chart shows; may be empty. `most_ticks`: that there is room for.
  Scale(const Axis& axis, const Range& values, double first, double last, int most_ticks = 7);

  /// The position of a value; of one beyond an end, that end.
  double position(double value) const;
  /// Whether the axis can show it at all: finite, and positive if it is logarithmic.
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
