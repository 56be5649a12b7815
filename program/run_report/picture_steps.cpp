// Chooses every k-th output time.

#include "program/run_report/picture_steps.h"

#include <algorithm>
#include <cmath>

namespace spoke::run_report {

PictureSteps::PictureSteps(const Simulation& simulation, std::size_t most)
    : planned_(simulation.planned_steps()), step_size_(simulation.step_size()) {
  const double output = std::max(simulation.scenario().output.interval, step_size_);
  double every = 1.0;
  if (most > 0) {
    const double outputs = simulation.scenario().integration.duration / output;
    const double window = simulation.options().window * step_size_;
    every = std::max({1.0, std::ceil(outputs / static_cast<double>(most) * (1.0 - 1e-9)),
                      std::ceil(window / output * (1.0 - 1e-9))});
  }
  interval_ = every * output;
}

/// Returns how many intervals have passed; allows for the round-off of times as OutputTimes does.
double PictureSteps::multiples_at(std::int64_t step) const {
  return std::floor(static_cast<double>(step) * step_size_ * (1.0 + 1e-9) / interval_);
}

std::int64_t PictureSteps::next(std::int64_t step) const {
  const double multiple = multiples_at(step) + 1.0;
  auto next = static_cast<std::int64_t>(std::min(
      std::floor(multiple * interval_ / step_size_ * (1.0 - 2e-9)), static_cast<double>(planned_)));
  next = std::max(next, step + 1);
  while (next < planned_ && multiples_at(next) < multiple) ++next;
  return std::min(next, planned_);
}

}  // namespace spoke::run_report
