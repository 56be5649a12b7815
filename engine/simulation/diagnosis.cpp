// Puts the place of a failure and its likely cause into words.

#include "engine/simulation/diagnosis.h"

#include <sstream>
#include <string>
#include <string_view>

#include "engine/simulation/failure_cause.h"
#include "engine/step/stages.h"
#include "models/count_text.h"

namespace spoke {
namespace {

/// Words for the indices of the table.
struct SiteNames {
  std::string subsystem, body;
  std::string node;  ///< node of the step graph at which the failure showed

  std::string whole() const { return subsystem + " / " + body; }
};

template <class World>
SiteNames name_site(const SystemContext<World>& context,
                    const std::vector<SubsystemNames>& subsystems, StepOutcome outcome,
                    const FailureSite& site) {
  if (!site.is_known()) {
    const bool is_hub = outcome == StepOutcome::left_limits;
    const bool has_one_solve = context.formulation == Formulation::augmented;
    return {"", "",
            (!is_hub         ? stages::kFinish
             : has_one_solve ? stages::kSolve
                             : stages::kHubSolve)
                .name};
  }
  const SubsystemNames& subsystem = subsystems[static_cast<std::size_t>(site.subsystem)];
  SiteNames names{subsystem.name, subsystem.bodies[static_cast<std::size_t>(site.body)], ""};
  const bool is_of_subsystem = std::string_view(site.stage) == stages::kSensors.name;
  names.node = (is_of_subsystem ? names.subsystem : names.whole()) + " / " + site.stage;
  return names;
}

/// Returns the failed quantity in a word or two.
std::string name_quantity(StepOutcome outcome, const FailureSite& site) {
  if (outcome == StepOutcome::energy_grew) return "energy";
  if (site.is_loop) return site.quantity;
  if (outcome == StepOutcome::not_converged) return "change of a coordinate";
  return site.is_known() ? site.quantity : "the acceleration of the hub";
}

/// Returns what the last change of an iteration was not within.
std::string name_unmet(const IterationLimits& limits, const StepProgress& progress) {
  std::ostringstream text;
  if (progress.change > progress.tolerance)
    text << "tolerance " << progress.tolerance;
  else
    text << "within its tolerance, " << progress.tolerance << ", but not within the "
         << limits.closing << " to which closed loops need it";
  return text.str();
}

template <class World>
std::string describe_finding(const Scenario& scenario, const SystemContext<World>& context,
                             const FailedStep& failed, const FailureSite& site,
                             const SiteNames& names) {
  std::ostringstream text;
  if (failed.outcome == StepOutcome::energy_grew) {
    text << describe_growth(scenario, failed.seen);
    if (site.is_known()) text << "; " << names.whole() << " is strained most";
  } else if (site.is_loop) {
    text << names.whole() << ": " << site.quantity << site.finding;
  } else if (failed.outcome == StepOutcome::not_converged) {
    const StepProgress& progress = failed_progress(context.data);
    text << "the iteration still changes a coordinate by " << progress.change << " ("
         << name_unmet(context.integrator.limits, progress) << ") after "
         << counted(context.integrator.limits.most, "iteration");
    if (site.is_known()) text << ", most in " << names.whole();
  } else if (site.is_known()) {
    text << names.whole() << ": " << site.quantity << site.finding;
  } else {
    text << name_quantity(failed.outcome, site) << " is not finite";
  }
  text << " (node \"" << names.node << "\")";
  return text.str();
}

}  // namespace

template <class World>
DivergenceError diagnose(const Scenario& scenario, const SystemContext<World>& context,
                         const std::vector<SubsystemNames>& subsystems, const FailedStep& failed) {
  const FailureSite site = find_site(context, failed.outcome);
  const SiteNames names = name_site(context, subsystems, failed.outcome, site);
  std::ostringstream text;
  text << "diverged at t = " << failed.time << " s, step " << failed.step << ": "
       << describe_finding(scenario, context, failed, site, names) << "; "
       << find_cause(scenario, context, failed, site);
  Divergence at{.time = failed.time, .step = failed.step, .node = names.node};
  at.subsystem = names.subsystem;
  at.body = names.body;
  at.quantity = name_quantity(failed.outcome, site);
  return DivergenceError(text.str(), at);
}

template DivergenceError diagnose(const Scenario&, const SystemContext<Plane>&,
                                  const std::vector<SubsystemNames>&, const FailedStep&);
template DivergenceError diagnose(const Scenario&, const SystemContext<Space>&,
                                  const std::vector<SubsystemNames>&, const FailedStep&);

}  // namespace spoke
