// Looks for drag below zero, which the rules for polars tolerate where it is small.

#include "models/reader/spatial/air_hints.h"

#include <algorithm>
#include <numbers>
#include <sstream>

namespace spoke {

std::vector<std::string> find_air_hints(const Scenario& scenario) {
  std::vector<std::string> hints;
  if (!scenario.space || !scenario.space->air) return hints;
  for (const spatial::Airfoil& airfoil : scenario.space->air->airfoils)
    for (const spatial::Polar& polar : airfoil.polars) {
      const auto least = std::min_element(polar.drag.begin(), polar.drag.end());
      if (least == polar.drag.end() || *least >= 0.0) continue;
      const double angle = polar.angle[static_cast<std::size_t>(least - polar.drag.begin())];
      std::ostringstream text;  // six digits, since angles are computed
      text << "aerofoil \"" << airfoil.name << "\": drag is " << *least << " at "
           << angle * (180.0 / std::numbers::pi) << " degrees, expected 0 or more";
      hints.push_back(text.str());
      break;
    }
  return hints;
}

}  // namespace spoke
