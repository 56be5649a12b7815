#pragma once

// When a machine is asked what other threads are worth on it.

#include <string>

namespace spoke::graph {

/// Of the time that runs take or are expected to take, what tuning may cost.
inline constexpr double kTuningShare = 0.02;

/// Asks what other threads are worth, and if they are worth nothing, again after pauses that become
/// longer each time; more than twice only as far as kTuningShare allows.
class CapacityProbes {
 public:
  /// `seconds`: that all runs are expected to take; 0: not known. Precondition: threads >= 1.
  CapacityProbes(int threads, double seconds);

  /// Measures (measure_capacity(), 1 ms), after runs of `elapsed` seconds; whether other threads
  /// are worth waking. If not, a pause begins.
  bool find_worth(double elapsed);
  /// Begins a pause; as short a one as the first, if there was only a passing disturbance.
  void begin_pause(double elapsed, bool is_passing);
  /// How long runs have to go on until the next probe [s]; not positive: it is due.
  double pause_left(double elapsed) const { return resume_at_ - elapsed; }
  /// "2 threads do 1.1 times the work of one here". Precondition: measured once.
  std::string describe() const;

 private:
  int threads_;
  double expected_;         // s
  double capacity_ = 0.0;   // as measured last
  int count_ = 0;           // of probes ...
  double spent_ = 0.0;      // ... and what they took [s]
  double pause_;            // s, the next one
  double resume_at_ = 0.0;  // in `elapsed` [s]
};

}  // namespace spoke::graph
