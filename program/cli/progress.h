#pragma once

// Progress of a command, shown on the terminal.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace spoke::cli {

/// Shows on a line of the terminal (stderr) what is being done; an empty text clears it. Does
/// nothing where stderr is not a terminal.
void show_progress(const std::string& text);

/// Shows how many of so many are done, "3 of 21 speeds", and clears the line at the end, after an
/// error as well.
class CountProgress {
 public:
  CountProgress(std::size_t all, std::string what) : all_(all), what_(std::move(what)) {}
  ~CountProgress() { show_progress(""); }
  CountProgress(const CountProgress&) = delete;
  CountProgress& operator=(const CountProgress&) = delete;

  void show(std::size_t done) const;

 private:
  std::size_t all_;
  std::string what_;
};

/// A line on the terminal (stderr) that shows how far a simulation is and how fast it runs. It
/// stays empty where stderr is not a terminal.
class ProgressBar {
 public:
  /// `start`, `duration`: simulated time at the start and the end [s]. A bar that is not `wanted`
  /// shows nothing.
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

/// Shows runs done, runs a second, and the time that is left, a few times a second. Shows nothing
/// where stderr is not a terminal.
class StudyProgress {
 public:
  /// `done`: runs that were made before. `planned`: runs in all.
  StudyProgress(std::int64_t done, std::int64_t planned);
  /// Clears the line.
  ~StudyProgress();
  StudyProgress(const StudyProgress&) = delete;
  StudyProgress& operator=(const StudyProgress&) = delete;

  void update(std::int64_t done);
  /// Returns the time since the start [s].
  double seconds() const;

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kPause{200};  ///< between drawings

  std::int64_t before_, planned_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_;
};

}  // namespace spoke::cli
