// Messages of the first process to the others: which simulation it has, and how far to step.

#include "program/cli/shared_run.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "models/error.h"
#include "models/support/instructions.h"
#include "program/cli/build_simulation.h"
#include "program/cli/checkpoints.h"
#include "program/cli/commands.h"
#include "program/cli/interruption.h"

namespace spoke::cli {
namespace {

constexpr std::uint64_t kNone = 0;  // sent in place of a fingerprint or a step when there is none

/// Returns a hash of everything that determines the steps, including the instructions on which bits
/// depend.
std::uint64_t fingerprint(const Simulation& simulation) {
  const SavedState state = simulation.save();
  const std::string text =
      fmt::format("{} {} {} {} {} {}\n{}", SPOKE_VERSION, instructions_in_use(), state.steps,
                  simulation.planned_steps(), simulation.options().window, simulation.state_hash(),
                  *state.model);
  return std::hash<std::string>{}(text) | 1U;
}

Simulation build_follower(const Arguments& arguments, Exchange* exchange) {
  Simulation simulation = build_run(arguments, read_run(arguments), exchange);
  if (!arguments.resume.empty()) resume(arguments.resume, simulation);
  return simulation;
}

/// Makes the steps that the first process asks for, until it lets this one go.
void make_steps(Simulation& simulation, const ranks::Launch& launch) {
  const StepObserver observe = [](double, std::span<const double>) {};  // the first one records
  try {
    while (const std::uint64_t step = launch.broadcast(kNone))
      simulation.run_until(static_cast<double>(step) * simulation.step_size(), observe);
  } catch (const DivergenceError&) {  // the first process has seen it as well, and reports it
  }
}

}  // namespace

Scenario read_run(const Arguments& arguments) {
  Scenario scenario = read_scenario(arguments.scenario, arguments.overrides);
  if (arguments.integrator) scenario.integration.method = *arguments.integrator;
  require_enough(scenario);
  return scenario;
}

Simulation build_run(const Arguments& arguments, const Scenario& scenario, Exchange* exchange) {
  SimulationOptions options = arguments.options;
  options.exchange = exchange;
  return build_simulation(arguments.scenario, scenario, options, !arguments.quiet);
}

void require_same(const Arguments& arguments, const Simulation& simulation, ranks::Launch& launch) {
  if (launch.count() == 1) return;
  const std::vector<std::uint64_t> all = launch.gather(fingerprint(simulation));
  const auto other =
      std::find_if(all.begin(), all.end(), [&](std::uint64_t one) { return one != all[0]; });
  if (other == all.end()) return;
  launch.release();
  throw InputError(fmt::format(
      "{}: process {} of {} has not the simulation of the first one; expected that all read the "
      "same files on processors of one kind (--instructions baseline: of any kind)",
      arguments.scenario, other - all.begin() + 1, all.size()));
}

void give_up(ranks::Launch& launch) {
  launch.gather(kNone);
  launch.release();
}

void let_advance(std::int64_t step, const ranks::Launch& launch) {
  launch.broadcast(static_cast<std::uint64_t>(step));
}

void let_go(ranks::Launch& launch) {
  launch.broadcast(kNone);
  launch.release();
}

int follow(const Arguments& arguments, ranks::Launch& launch) {
  spdlog::set_level(spdlog::level::off);
  const Interruption interruption;  // the first process ends the run in order
  const std::unique_ptr<Exchange> exchange = launch.make_exchange();
  std::optional<Simulation> simulation;
  std::exception_ptr failure;
  try {
    simulation.emplace(build_follower(arguments, exchange.get()));
  } catch (...) {
    failure = std::current_exception();
  }
  const std::uint64_t own = failure ? kNone : fingerprint(*simulation);
  const std::vector<std::uint64_t> all = launch.gather(own);
  const bool is_same =
      std::all_of(all.begin(), all.end(), [&](std::uint64_t one) { return one == all[0]; });
  if (is_same && !failure) {
    make_steps(*simulation, launch);
  } else {
    launch.release();
    if (failure && all[0] != kNone) std::rethrow_exception(failure);
  }
  return 0;  // the first process reports the failure
}

}  // namespace spoke::cli
