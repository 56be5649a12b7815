// Writes the lines of the log.

#include "engine/simulation/simulation_log.h"

#include <sstream>

#include "engine/support/log.h"
#include "models/count_text.h"

namespace spoke {
namespace {

/// Returns the beginning of a message, the name of the scenario: several simulations may share a
/// logger.
std::string begin(const Scenario& scenario) {
  return scenario.name.empty() ? "" : scenario.name + ": ";
}

}  // namespace

void SimulationLog::log_built(const Scenario& scenario, Formulation formulation,
                              const ModelSize& size, std::int64_t steps, double step_size,
                              std::string_view executor, const graph::Threads& threads) {
  if (!is_heard(LogLevel::info)) return;
  std::ostringstream text;
  text << begin(scenario) << "built: " << counted(size.subsystems, "blade") << ", "
       << counted(size.bodies, "body") << ", " << counted(size.coordinates, "coordinate")
       << ", step graph of " << counted(size.graph_nodes, "node") << " and "
       << counted(size.graph_edges, "edge") << ", " << static_cast<double>(size.memory_bytes) / 1e6
       << " MB; " << name_of(formulation) << ", " << name_of(scenario.integration.method) << ", "
       << counted(steps, "step") << " of " << step_size << " s, " << executor
       << ", threads: " << name_of(threads);
  log(LogLevel::info, text.str());
}

void SimulationLog::log_restored(const Scenario& scenario, double t, std::int64_t steps) {
  if (!is_heard(LogLevel::debug)) return;
  std::ostringstream text;
  text << begin(scenario) << "restored a state: t = " << t << " s, step " << steps;
  log(LogLevel::debug, text.str());
}

void SimulationLog::log_failure(const Scenario& scenario, const std::string& text) {
  if (is_heard(LogLevel::error)) log(LogLevel::error, begin(scenario) + text);
}

void SimulationLog::log_choice(const Scenario& scenario, int choices,
                               const std::string& description) {
  logged_choices_ = choices;
  if (is_heard(LogLevel::info))
    log(LogLevel::info, begin(scenario) + "executor auto: " + description);
}

void SimulationLog::log_warnings(const Scenario& scenario, const Observations& seen,
                                 const std::vector<Warning>& warnings) {
  const auto was_logged = is_logged_;
  is_logged(WarningKind::linear_range) |= seen.first_deflection.step >= 0.0;
  is_logged(WarningKind::energy_growth) |= seen.growth.step >= 0.0;
  is_logged(WarningKind::step_error) |= seen.error.first_step >= 0.0;
  is_logged(WarningKind::momentum) |= seen.momentum.first_step >= 0.0;
  is_logged(WarningKind::singular_loop) |= seen.loop.first_step >= 0.0;
  for (const Warning& warning : warnings) {
    is_logged(warning.kind) = true;
    if (is_heard(LogLevel::warning) && !was_logged[static_cast<std::size_t>(warning.kind)])
      log(LogLevel::warning, begin(scenario) + warning.text);
  }
}

}  // namespace spoke
