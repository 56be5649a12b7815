// The hints of all kinds, one after the other.

#include "models/hints.h"

#include <iterator>

#include "models/reader/angle_hints.h"
#include "models/reader/material_hints.h"
#include "models/reader/spatial/air_hints.h"
#include "models/reader/spatial/light_body_hints.h"
#include "models/reader/spatial/section_hints.h"
#include "models/reader/spatial/solid_hints.h"
#include "models/reader/spatial/tension_hints.h"

namespace spoke {

std::vector<std::string> find_hints(const Scenario& scenario) {
  std::vector<std::string> hints;
  for (const auto find :
       {find_angle_hints, find_air_hints, find_light_body_hints, find_material_hints,
        find_section_hints, find_solid_hints, find_tension_hints}) {
    std::vector<std::string> found = find(scenario);
    hints.insert(hints.end(), std::move_iterator(found.begin()), std::move_iterator(found.end()));
  }
  return hints;
}

}  // namespace spoke
