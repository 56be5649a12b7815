// Rules that concern several numbers at once: steps, elements, points of loads.

#include "models/reader/scenario_fields.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace spoke {
namespace {

std::string count_numbers(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " number" : " numbers");
}

}  // namespace

std::string find_step_fault(const Integration& integration) {
  constexpr double most_steps = 1e10;
  if (integration.step > integration.duration)
    return "the step is " + describe(integration.step) + " s, expected at most the duration, " +
           describe(integration.duration) + " s";
  const double steps = integration.duration / integration.step;
  if (steps <= most_steps) return {};
  return "makes " + describe(steps) + " steps, expected at most " + describe(most_steps);
}

SectionsFault find_sections_fault(const Blade& blade) {
  const std::vector<double>& station = blade.sections.station;
  if (station.size() < 2)
    return {"station", "has " + count_numbers(station.size()) + ", expected 2 or more"};
  SectionsFault fault;
  visit_properties(blade.sections, [&](std::string_view key, const std::vector<double>& values,
                                       const Quantity&) {
    if (fault.key.empty() && values.size() != station.size())
      fault = {std::string(key), "has " + count_numbers(values.size()) + ", expected " +
                                     std::to_string(station.size()) + ", one for each station"};
  });
  if (!fault.key.empty()) return fault;
  for (std::size_t i = 1; i < station.size(); ++i)
    if (!(station[i] > station[i - 1]))
      return {"station." + std::to_string(i + 1), "is " + describe(station[i]) +
                                                      ", expected more than the value before it, " +
                                                      describe(station[i - 1])};
  if (station.front() != 0.0)
    return {"station", "begins at " + describe(station.front()) + ", expected 0 (m, the root)"};
  if (std::abs(station.back() - blade.length) > 1e-9 * blade.length)
    return {"station", "ends at " + describe(station.back()) + ", expected " +
                           describe(blade.length) + " (m, the blade's length)"};
  return {};
}

std::size_t count_stations(const Blade& blade) {
  return blade.sections.station.size() + blade.point_masses.size();
}

std::string find_station_fault(std::size_t count) {
  constexpr std::size_t most = 2'000'000;
  if (count <= most) return {};
  return "makes " + std::to_string(count) +
         " stations and point masses on all blades, expected at most " + std::to_string(most);
}

std::string find_mass_factor_fault(const Damping& damping, const std::vector<Blade>& blades) {
  const bool is_cut = std::any_of(blades.begin(), blades.end(),
                                  [](const Blade& blade) { return blade.bodies > 1; });
  if (damping.mass_factor == 0.0 || !is_cut) return {};
  return "damps motion relative to each body's own frame, next to none of a blade of several "
         "bodies; "
         "expected 0, or bodies = 1: stiffness_factor damps any number of bodies alike, [[drag]] "
         "relative to the hub the motion in the hub's frame";
}

const char* find_strain_fault(BeamStrain strain, bool geometric_stiffening) {
  if (strain != BeamStrain::nonlinear || geometric_stiffening) return nullptr;
  return "is false, expected true, or strain = \"linear\": strains of second order make the "
         "tension that stiffens";
}

std::string find_element_fault(const std::vector<Blade>& blades) {
  constexpr std::int64_t most_elements = 20'000'000;
  std::int64_t elements = 0;
  for (const Blade& blade : blades) elements += std::int64_t{blade.bodies} * blade.elements;
  if (elements <= most_elements) return {};
  return "makes " + std::to_string(elements) + " elements (blades x bodies x elements), " +
         "expected at most " + std::to_string(most_elements);
}

std::string find_point_fault(std::size_t points) {
  constexpr std::size_t most_points = 2'000'000;
  if (points <= most_points) return {};
  return "makes " + std::to_string(points) +
         " points (loads x blades x times) with those before it, expected at most " +
         std::to_string(most_points);
}

const Blade& shortest_loaded(BladeChoice loaded, const std::vector<Blade>& blades) {
  assert(!blades.empty() && loaded.number() <= static_cast<int>(blades.size()));
  if (!loaded.is_all()) return blades[static_cast<std::size_t>(loaded.number() - 1)];
  return *std::min_element(blades.begin(), blades.end(),
                           [](const Blade& a, const Blade& b) { return a.length < b.length; });
}

Quantity place_on(const Blade& blade) {
  return {"m, from root to tip of the blade", 0.0, blade.length};
}

Quantity end_on(const Blade& blade, double from) {
  return {"m, beyond from, up to the blade's tip", from, blade.length, false};
}

std::size_t count_points(BladeChoice loaded, bool is_distributed, const Curve& factor,
                         const std::vector<Blade>& blades) {
  const std::size_t times = factor.times().size();
  std::size_t points = 0;
  for (std::size_t i = 0; i < blades.size(); ++i) {
    if (!loaded.holds(i)) continue;
    points += times;
    if (is_distributed)
      points += std::size_t{4} * static_cast<std::size_t>(blades[i].bodies) *
                static_cast<std::size_t>(blades[i].elements);
  }
  return points;
}

}  // namespace spoke
