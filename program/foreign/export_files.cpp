// What all formats need.

#include "program/foreign/export_files.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "models/error.h"

namespace spoke::foreign {

double turned_degrees_of(double angle) {
  const double degrees = angle == 0.0 ? 0.0 : -angle * 180.0 / std::numbers::pi;
  const double few = std::strtod(fmt::format("{:.15g}", degrees).c_str(), nullptr);
  for (const double candidate :
       {few, degrees, std::nextafter(degrees, 1e9), std::nextafter(degrees, -1e9)})
    if (-candidate * std::numbers::pi / 180.0 == angle) return candidate;
  return degrees;
}

const spatial::Blade& choose_blade(const Scenario& scenario, std::size_t blade) {
  const std::size_t count = scenario.space ? scenario.space->blades.size() : 0;
  if (count == 0)
    throw InputError(
        "world: the scenario has no blade in space, expected one with [blade] and "
        "world = \"space\"");
  if (blade < 1 || blade > count)
    throw InputError(fmt::format("--blade {}: expected a number from 1 to {}", blade, count));
  return scenario.space->blades[blade - 1];
}

}  // namespace spoke::foreign
