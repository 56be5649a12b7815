#pragma once

// Decides when to measure what other threads are worth on the machine.

#include <string>

namespace spoke::graph {

/// The share of the time that runs take, or are expected to take, that tuning may cost.
inline constexpr double kTuningShare = 0.02;

/// Measures what other threads are worth, and if they are worth nothing, measures again after
/// pauses that become longer each time; more than twice only as far as kTuningShare allows.
class CapacityProbes {
 public:
  /// `seconds`: time that all runs are expected to take; 0: not known. Precondition: threads >= 1.
  CapacityProbes(int threads, double seconds);

  /// Measures by measure_capacity() (1 ms), after runs of `elapsed` seconds, whether other threads
  /// are worth waking. If not, a pause begins.
  bool find_worth(double elapsed);
  /// Begins a pause; one as short as the first if there was only a passing disturbance.
  void begin_pause(double elapsed, bool is_passing);
  /// Returns how long runs have to go on until the next probe [s]; not positive: it is due.
  double pause_left(double elapsed) const { return resume_at_ - elapsed; }
  /// Returns "2 threads do 1.1 times the work of one here". Precondition: find_worth() was called.
  std::string describe() const;

 private:
  int threads_;
  double expected_;         // s
  double capacity_ = 0.0;   // latest measurement
  int count_ = 0;           // number of probes ...
  double spent_ = 0.0;      // ... and the time they took [s]
  double pause_;            // length of the next pause [s]
  double resume_at_ = 0.0;  // value of `elapsed` at which runs resume probes [s]
};

}  // namespace spoke::graph
