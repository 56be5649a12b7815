#pragma once

// A simulation that notices if two Python threads use it at once.

#include <pybind11/pybind11.h>

#include <atomic>
#include <utility>

#include "engine/simulation.h"
#include "models/error.h"

namespace spoke::python {

/// A Simulation for Python. The interpreter lock, which is released while steps are made, does not
/// keep threads apart.
class UsedSimulation : public Simulation {
 public:
  using Simulation::Simulation;
  explicit UsedSimulation(Simulation&& made) : Simulation(std::move(made)) {}

 private:
  friend class Use;
  std::atomic_flag is_used_ = ATOMIC_FLAG_INIT;
};

/// Uses a simulation alone, as long as it lives. Throws StateError if it is in use: by another
/// thread, or by a caller of this one, as when a load queries the simulation it acts on.
class Use {
 public:
  explicit Use(UsedSimulation& simulation) : simulation_(simulation) {
    if (simulation_.is_used_.test_and_set(std::memory_order_acquire))
      throw StateError("the simulation is in use, by another thread or by a run that called this");
  }
  ~Use() { simulation_.is_used_.clear(std::memory_order_release); }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

 private:
  UsedSimulation& simulation_;
};

// Wraps a member function for Python: it uses the simulation alone, and without the interpreter
// lock.

template <class R, class... A>
auto alone(R (Simulation::*member)(A...)) {
  return [member](UsedSimulation& simulation, A... arguments) -> R {
    const Use use(simulation);
    const pybind11::gil_scoped_release unlocked;
    return (simulation.*member)(std::forward<A>(arguments)...);
  };
}
template <class R, class... A>
auto alone(R (Simulation::*member)(A...) const) {
  return [member](UsedSimulation& simulation, A... arguments) -> R {
    const Use use(simulation);
    const pybind11::gil_scoped_release unlocked;
    return (simulation.*member)(std::forward<A>(arguments)...);
  };
}

}  // namespace spoke::python
