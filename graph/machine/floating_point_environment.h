#pragma once

// One floating-point environment for all threads, so that bits are equal.

#include <cfenv>

namespace spoke::graph {

/// The floating-point environment (rounding, flushing of small numbers) of the thread that makes
/// it, to be applied on others: a thread keeps the environment that held when it was started, which
/// may be long ago, and equal bits need equal control words.
class FloatingPointEnvironment {
 public:
  FloatingPointEnvironment() { std::fegetenv(&environment_); }
  void apply() const { std::fesetenv(&environment_); }

 private:
  std::fenv_t environment_;
};

}  // namespace spoke::graph
