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

/// Whether a load average says that other programs take so much of the processors available that
/// times mean little: more than half of them. Not if it is not known.
bool is_busy(double load, int processors);

}  // namespace spoke
