#include "engine/simulation_log.h"

#include <sstream>

#include "engine/log.h"

namespace spoke {
namespace {

/// Several simulations may share a logger: messages begin with the scenario's name.
std::string begin(const Scenario& scenario) {
  return scenario.name.empty() ? "" : scenario.name + ": ";
}

}  // namespace

void SimulationLog::tell_built(const Simulation& simulation) {
  if (!is_heard(LogLevel::info)) return;
  const ModelSize size = simulation.size();
  std::ostringstream text;
  text << begin(simulation.scenario()) << "built: " << size.subsystems << " blades, " << size.bodies
       << " bodies, " << size.coordinates << " coordinates, step graph of " << size.graph_nodes
       << " nodes and " << size.graph_edges << " edges, "
       << static_cast<double>(size.memory_bytes) / 1e6 << " MB; "
       << name_of(simulation.options().formulation) << ", "
       << name_of(simulation.scenario().integration.method) << ", " << simulation.planned_steps()
       << " steps of " << simulation.step_size() << " s, " << simulation.executor_name()
       << ", threads: " << name_of(simulation.threads());
  log(LogLevel::info, text.str());
}

void SimulationLog::tell_restored(const Scenario& scenario, double t, std::int64_t steps) {
  if (!is_heard(LogLevel::debug)) return;
  std::ostringstream text;
  text << begin(scenario) << "restored a state: t = " << t << " s, step " << steps;
  log(LogLevel::debug, text.str());
}

void SimulationLog::tell_failure(const Scenario& scenario, const std::string& text) {
  if (is_heard(LogLevel::error)) log(LogLevel::error, begin(scenario) + text);
}

void SimulationLog::tell_choice(const Scenario& scenario, int choices,
                                const std::string& description) {
  told_choices_ = choices;
  if (is_heard(LogLevel::info))
    log(LogLevel::info, begin(scenario) + "executor auto: " + description);
}

void SimulationLog::tell_warnings(const Scenario& scenario, double step_size,
                                  const Observations& seen) {
  const bool has_told[] = {has_told_bend_, has_told_growth_};
  has_told_bend_ = has_told_bend_ || seen.first_bend.step >= 0.0;
  has_told_growth_ = has_told_growth_ || seen.growth.step >= 0.0;
  if (!is_heard(LogLevel::warning)) return;
  for (const Warning& warning : make_warnings(scenario, step_size, seen))
    if (!has_told[warning.kind == WarningKind::energy_growth])
      log(LogLevel::warning, begin(scenario) + warning.text);
}

}  // namespace spoke
