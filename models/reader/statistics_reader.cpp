// Exponents of Woehler's curves by the names that sensors have.

#include "models/reader/statistics_reader.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "models/error.h"
#include "models/reader/keys/quantities.h"
#include "models/reader/keys/simulation_keys.h"
#include "models/reader/row_reader.h"
#include "models/support/nearest_name.h"

namespace spoke {
namespace {

constexpr const char* kBlades = "blades";

bool is_support(const Scenario& scenario, const std::string& name) {
  return scenario.space && scenario.space->support && name == spatial::kSupportName;
}

bool is_subsystem(const Scenario& scenario, const std::string& name) {
  if (!scenario.space) return false;
  const std::vector<spatial::Subsystem>& all = scenario.space->subsystems;
  return std::any_of(all.begin(), all.end(), [&](const auto& own) { return own.name == name; });
}

/// Returns the names that exponents may have.
std::vector<std::string> list_names(const Scenario& scenario) {
  std::vector<std::string> names{kBlades};
  const std::size_t blades =
      scenario.space ? scenario.space->blades.size() : scenario.rotor.blades.size();
  for (std::size_t i = 1; i <= blades; ++i) names.push_back("blade" + std::to_string(i));
  if (scenario.space)
    for (const spatial::Subsystem& subsystem : scenario.space->subsystems)
      names.push_back(subsystem.name);
  return names;
}

}  // namespace

double find_wohler_exponent(const Scenario& scenario, const std::string& name) {
  constexpr double composite = 10.0, welded_steel = 4.0;
  const auto& exponents = scenario.statistics.exponents;
  if (const auto own = exponents.find(name); own != exponents.end()) return own->second;
  if (is_support(scenario, name)) return welded_steel;
  const auto blades = exponents.find(kBlades);
  return blades == exponents.end() || is_subsystem(scenario, name) ? composite : blades->second;
}

Statistics read_statistics(const TomlSection& root, const Scenario& scenario) {
  const std::vector<std::string> names = list_names(scenario);
  const TomlSection section =
      root.section("statistics", keys::keys_of(keys::kStatisticsRows))
          .section("exponents", TomlSection::Keys(names.begin(), names.end()));
  Statistics statistics;
  for (const std::string& name : names)
    if (section.has(name)) statistics.exponents[name] = section.number(name, kExponent);
  return statistics;
}

void check_statistics(const Scenario& scenario) {
  const std::vector<std::string> names = list_names(scenario);
  for (const auto& [name, exponent] : scenario.statistics.exponents) {
    const std::string key = "statistics.exponents." + name;
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw InputError(
          key + ": " +
              describe_unknown(name, std::vector<std::string_view>(names.begin(), names.end())),
          {.key = key});
    const std::string expected = kExponent.expectation_instead_of(exponent);
    if (!expected.empty())
      throw InputError(key + ": is " + describe(exponent) + ", expected " + expected, {.key = key});
  }
}

}  // namespace spoke
