#pragma once

// The machine that results and measurements come from.

#include <cstdint>
#include <string>

namespace spoke {

/// The machine that a result was computed on.
struct Machine {
  std::string cpu;          ///< model name of the processor
  int cores = 0;            ///< available to this process
  std::int64_t memory = 0;  ///< [bytes]
  std::string os;           ///< distribution and kernel
  std::string compiler;     ///< that built this program
};

/// What is not known is empty or 0.
Machine this_machine();

/// Runnable processes, mean over the last minute; -1 if not known.
double load_average();

/// How much work threads on all processors did at once, by what one did alone, before and after a
/// measurement; 0: not measured (graph/calibrate/capacity.h).
struct Capacity {
  int threads = 1;
  double before = 0.0, after = 0.0;

  bool is_known() const { return threads > 1 && before > 0.0; }
  /// max(T1 / P, Tinf) where P threads do so much work only [s]: no schedule of a graph with this
  /// work and span [s] takes less time. Precondition: is_known().
  double bound(double work, double span, int threads_used) const;
  /// "2 threads do 1.93 times the work of one here". Precondition: is_known().
  std::string text() const;
};
/// The capacity now, before and after alike; takes some 20 ms.
Capacity measure_capacity();

/// Whether a load average says that other programs take so much of the processors available that
/// times mean little: more than half of them. Not if it is not known.
bool is_busy(double load, int processors);

}  // namespace spoke
