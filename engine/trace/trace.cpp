#include "engine/trace/trace.h"

#include <array>
#include <ctime>
#include <utility>

namespace spoke::trace {
namespace {

std::string now() {
  const std::time_t seconds = std::time(nullptr);
  std::tm parts{};
  std::array<char, 32> text{};
  if (gmtime_r(&seconds, &parts) == nullptr) return {};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

}  // namespace

Trace describe(const Simulation& simulation, StepTrace steps) {
  const Scenario& scenario = simulation.scenario();
  return {std::move(steps),
          scenario.name,
          scenario.title,
          simulation.options(),
          name_of(simulation.threads()),
          scenario.integration.method,
          simulation.step_size(),
          this_machine(),
          load_average(),
          now()};
}

const TracedStep& middle_step(const StepTrace& steps) {
  return steps.steps[steps.steps.size() / 2];
}

std::string name_of_thread(int thread) {
  return thread == 0 ? "main" : "worker " + std::to_string(thread);
}

}  // namespace spoke::trace
