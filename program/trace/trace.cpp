// Collects settings, machine and remarks of a trace.

#include "program/trace/trace.h"

#include <spdlog/fmt/fmt.h>

#include <array>
#include <cassert>
#include <cstdint>
#include <ctime>
#include <utility>

#include "models/count_text.h"

namespace spoke::trace {
namespace {

std::string now() {
  const std::time_t seconds = std::time(nullptr);
  std::tm parts{};
  std::array<char, 32> text{};
  if (gmtime_r(&seconds, &parts) == nullptr) return {};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

/// Returns the threads given to the executor, or the number it ran the steps on if that is smaller.
std::string name_threads(const Simulation& simulation, const StepTrace& steps) {
  const graph::Threads given = simulation.threads();
  return given.total() == steps.threads ? name_of(given) : std::to_string(steps.threads);
}

std::string explain_no_window(const StepTrace& steps, std::int64_t most_steps) {
  const bool is_one = steps.asked_steps == 1;
  std::string text =
      fmt::format("{} {} less than half a window of {}, so {} traced without windows",
                  counted(steps.asked_steps, "step"), is_one ? "is" : "are",
                  counted(steps.unused_window, "step"), is_one ? "it was" : "they were");
  if (steps.unused_window <= most_steps)
    text += fmt::format("; spoke trace --steps {} shows the windows", steps.unused_window);
  return text;
}

/// Makes notes on a trace that begins at step `first`, counted from 1.
std::vector<std::string> make_notes(const Simulation& simulation, const StepTrace& steps,
                                    std::int64_t first) {
  std::vector<std::string> notes;
  if (steps.choice == ChoiceState::none)
    notes.emplace_back(
        "auto has chosen nothing yet and ran these steps serially; "
        "spoke trace --from TIME lets it choose before");
  if (steps.choice == ChoiceState::tuning)
    notes.emplace_back(
        "auto is still tuning and ran these steps serially; "
        "spoke trace with a later --from TIME lets it choose before");
  if (steps.unused_window > 0)
    notes.push_back(explain_no_window(steps, simulation.planned_steps() - first + 1));
  const std::int64_t made = static_cast<std::int64_t>(steps.steps.size()) + steps.dropped_steps;
  if (made < steps.asked_steps)
    notes.push_back(
        fmt::format("the recording ends after {} of {}: the simulation ended or was interrupted",
                    made, counted(steps.asked_steps, "step")));
  return notes;
}

}  // namespace

Trace describe(const Simulation& simulation, StepTrace steps) {
  const Scenario& scenario = simulation.scenario();
  const std::int64_t first = steps.steps.empty() ? 1 : steps.steps.front().step;
  std::string threads = name_threads(simulation, steps);
  std::vector<std::string> notes = make_notes(simulation, steps, first);
  return {std::move(steps),
          scenario.name,
          scenario.title,
          simulation.options(),
          std::move(threads),
          scenario.integration.method,
          simulation.step_size(),
          this_machine(),
          load_average(),
          measure_capacity(),
          now(),
          std::move(notes),
          {}};
}

const TracedStep& middle_step(const StepTrace& steps) {
  assert(!steps.steps.empty());
  return steps.steps[steps.steps.size() / 2];
}

std::string name_of_thread(int thread) {
  return thread == 0 ? "main" : "worker " + std::to_string(thread);
}

}  // namespace spoke::trace
