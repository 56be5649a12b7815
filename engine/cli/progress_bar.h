#pragma once

// The bar that shows on a terminal how far a run is.

#include <chrono>

namespace spoke::cli {

/// A line on a terminal (stderr) that shows how far a simulation is and how fast it runs; nothing
/// where stderr is not a terminal.
class ProgressBar {
 public:
  /// start, duration: simulated time at the start and the end [s]; a bar that is not wanted shows
  /// nothing.
  ProgressBar(double start, double duration, bool wanted);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Shows the simulated time t [s], at most ten times a second. Cheap enough for every step.
  void update(double t);

 private:
  using Clock = std::chrono::steady_clock;

  static constexpr std::chrono::milliseconds kPause{100};  ///< between drawings

  void draw(double t, Clock::time_point now) const;

  double from_;
  double duration_;
  bool shown_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + kPause;
};

}  // namespace spoke::cli
