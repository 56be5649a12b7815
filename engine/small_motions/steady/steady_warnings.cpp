// Words warnings as engine/simulation/observations.cpp does, for one state in place of many.

#include "engine/small_motions/steady/steady_warnings.h"

#include <sstream>

#include "engine/bodies/kernels/plane/suggested_bodies.h"
#include "engine/small_motions/steady/deflection_words.h"

namespace spoke::steady {

LargestBending find_largest_bending(const EquilibriumResult& result) {
  LargestBending largest;
  for (std::size_t i = 0; i < result.blades.size(); ++i)
    for (std::size_t j = 0; j < result.blades[i].bending.size(); ++j)
      // Subsystems that are alike differ by round-off: the first one is named.
      if (result.blades[i].bending[j] > largest.ratio * (1.0 + 1e-9))
        largest = {i, j, result.blades[i].bending[j]};
  return largest;
}

std::string name_body(const EquilibriumResult& result, const LargestBending& bending) {
  const BladeEquilibrium& bent = result.blades.at(bending.subsystem);
  const std::string body = bent.loads.size() > bending.body
                               ? bent.loads[bending.body].body
                               : "body " + std::to_string(bending.body + 1);
  return bent.name + " / " + body;
}

void add_warnings(const Scenario& scenario, EquilibriumResult& result) {
  const double limit = scenario.limits.deflection;
  const LargestBending largest = find_largest_bending(result);
  if (limit <= 0.0 || largest.ratio <= limit) return;
  std::ostringstream text;
  if (scenario.space) {
    const DeflectionWords words = word_deflection(*scenario.space, largest.subsystem, largest.body);
    text << words.name << ' ' << words.verb << ' ' << 100.0 * largest.ratio << " %" << words.measure
         << ", more than " << 100.0 * limit
         << " %, up to which its linear elasticity holds: " << words.advice;
  } else {
    const Blade& blade = scenario.rotor.blades.at(largest.subsystem);
    const double length = blade.length / blade.bodies;
    text << name_body(result, largest) << " bends by " << largest.ratio * length << " m, "
         << 100.0 * largest.ratio << " %, more than " << 100.0 * limit << " % of its length of "
         << length << " m, up to which its linear elasticity holds: cut the blade into about "
         << plane::suggest_bodies(blade.bodies, largest.ratio, limit) << " bodies instead of "
         << blade.bodies;
  }
  result.warnings.push_back({WarningKind::linear_range, 0.0, text.str()});
}

}  // namespace spoke::steady
