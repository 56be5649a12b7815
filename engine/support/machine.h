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
  std::string compiler;     ///< compiler that built this program
};

/// Describes this machine; unknown values are empty or 0.
Machine this_machine();

/// Returns the mean number of runnable processes over the last minute; -1 if not known.
double load_average();

/// Work of threads on all processors at once, by that of one alone, before and after a measurement;
/// 0: not measured (graph/calibrate/capacity.h).
struct Capacity {
  int threads = 1;
  double before = 0.0, after = 0.0;

  bool is_known() const { return threads > 1 && before > 0.0; }
  /// Returns max(T1 / P, Tinf) where P threads do so much work only [s]: no schedule of a graph
  /// with this work and span [s] takes less time. Precondition: is_known().
  double bound(double work, double span, int threads_used) const;
  /// Returns "2 threads do 1.93 times the work of one here". Precondition: is_known().
  std::string text() const;
};
/// Measures the capacity now, before and after alike; takes some 20 ms.
Capacity measure_capacity();

/// Whether a load average says that other programs take so much of the processors available that
/// times mean little: more than half of them; false if it is not known.
bool is_busy(double load, int processors);

}  // namespace spoke
