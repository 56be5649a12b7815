#include "engine/diagnosis.h"

#include <cmath>
#include <sstream>

#include "engine/natural_frequencies.h"
#include "engine/pass_ends.h"

namespace spoke {
namespace {

struct Place {
  int subsystem = -1;
  int body = -1;
  Excess excess;
};

/// The first body with a coordinate that is not finite, or else the one farthest beyond its limit.
Place find_worst(const StepData& data) {
  Place worst;
  const auto severity = [](const Excess& e) {
    return std::isfinite(e.value) ? std::abs(e.value) / e.limit : HUGE_VAL;
  };
  for (std::size_t i = 0; i < data.subsystems.size(); ++i)
    for (std::size_t j = 0; j < data.subsystems[i].bodies.size(); ++j) {
      const Excess excess = find_excess(data.subsystems[i].bodies[j]);
      if (excess.coordinate < 0) continue;
      if (worst.subsystem >= 0 && severity(excess) <= severity(worst.excess)) continue;
      worst = {static_cast<int>(i), static_cast<int>(j), excess};
    }
  return worst;
}

/// The first body that reported a failure (its accelerations, if its coordinates are fine).
Place find_reported(const StepData& data) {
  for (std::size_t i = 0; i < data.subsystems.size(); ++i)
    for (std::size_t j = 0; j < data.subsystems[i].bodies.size(); ++j)
      if (data.subsystems[i].bodies[j].report.failed != 0.0)
        return {static_cast<int>(i), static_cast<int>(j), {}};
  return {};
}

/// "axial displacement u of node 3", "deflection v of node 4", "rotation psi of node 0".
std::string name_coordinate(const FlexibleBody& body, int coordinate) {
  static constexpr const char* kNames[] = {"axial displacement u", "deflection v", "rotation psi"};
  for (int node = 0; node <= body.elements; ++node)
    for (int c = 0; c < kTwist; ++c)
      if (body.coordinate(node, c) == coordinate)
        return std::string(kNames[c]) + " of node " + std::to_string(node);
  return "coordinate " + std::to_string(coordinate);
}

void describe_place(const StepData& data, std::ostream& text) {
  Place place = find_worst(data);
  if (place.subsystem < 0) place = find_reported(data);
  if (place.subsystem < 0) {
    text << "the acceleration of the hub is not finite (node \"hub solve\")";
    return;
  }
  const auto body = [&] {
    std::ostringstream name;
    name << "blade " << place.subsystem + 1 << " / body " << place.body + 1;
    return name.str();
  }();
  const Excess& excess = place.excess;
  const FlexibleBody& model = *data.subsystems[place.subsystem].bodies[place.body].model->body;
  text << body << ": ";
  if (excess.coordinate < 0)
    text << "an acceleration is not finite";
  else if (!std::isfinite(excess.value))
    text << name_coordinate(model, excess.coordinate) << " is not finite";
  else
    text << name_coordinate(model, excess.coordinate) << " = " << excess.value
         << " is beyond what its linear model can mean (limit " << excess.limit << ")";
  text << " (node \"" << body << " / recovery\")";
}

/// The clock whose iteration has not converged.
const Clock& find_unconverged(const StepData& data) {
  for (const Clock& clock : data.clocks)
    if (clock.ended() == StepOutcome::not_converged) return clock;
  return data.clocks.front();
}

/// The likely cause, and what to try.
std::string advise(const Scenario& scenario, const StepContext& context, const FailedStep& failed) {
  const FrequencyRange range = calc_frequency_range(scenario.rotor);
  std::ostringstream text;
  const double limit = calc_rk4_largest_step(range);
  const auto* rk4 = std::get_if<Rk4>(&context.integrator.method);
  if (rk4 && rk4->step > limit) {
    text << "the step of " << rk4->step << " s is above the stability limit of rk4, " << limit
         << " s: take a smaller integration.step, or generalized_alpha";
    return text.str();
  }
  bool all_stiffened = true;
  for (const Blade& blade : scenario.rotor.blades) all_stiffened &= blade.geometric_stiffening;
  const double speed = std::abs(context.data.hub_coordinates.v[kRotation]);
  if (!all_stiffened && speed > 0.5 * range.lowest) {
    text << "without geometric stiffening a body does not feel that rotation stiffens it, and the "
            "hub "
            "turns at "
         << speed << " rad/s against a lowest natural frequency of " << range.lowest
         << " rad/s: set geometric_stiffening = true, or cut the blade into more bodies";
    return text.str();
  }
  if (failed.outcome == StepOutcome::not_converged)
    return "take a smaller integration.step, or a larger integration.max_iterations";
  return "take a smaller integration.step, more bodies per blade, or smaller loads";
}

}  // namespace

std::string describe_failure(const Scenario& scenario, const StepContext& context,
                             const FailedStep& failed) {
  std::ostringstream text;
  text << "diverged at t = " << failed.time << " s, step " << failed.step << ": ";
  if (failed.outcome == StepOutcome::not_converged)
    text << "the iteration still changes a coordinate by " << find_unconverged(context.data).change
         << " (tolerance " << scenario.integration.tolerance << ") after "
         << scenario.integration.max_iterations << " iterations (node \"finish\")";
  else
    describe_place(context.data, text);
  text << "; " << advise(scenario, context, failed);
  return text.str();
}

}  // namespace spoke
