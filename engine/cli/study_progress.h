#pragma once

// The line on the terminal that says how far a study is.

#include <chrono>
#include <cstdint>

namespace spoke::cli {

/// Shows runs done, runs a second, and the time that is left, a few times a second; nothing where
/// stderr is not a terminal.
class StudyProgress {
 public:
  /// done: runs before; planned: in all.
  StudyProgress(std::int64_t done, std::int64_t planned);
  /// Clears the line.
  ~StudyProgress();
  StudyProgress(const StudyProgress&) = delete;
  StudyProgress& operator=(const StudyProgress&) = delete;

  void update(std::int64_t done);
  /// Since it began [s].
  double seconds() const;

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kPause{200};  ///< between drawings

  std::int64_t before_, planned_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_;
};

}  // namespace spoke::cli
