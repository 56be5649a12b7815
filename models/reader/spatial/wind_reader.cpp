// Reads the keys of [wind], then its file.

#include "models/reader/spatial/wind_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "models/air/wind_kept.h"
#include "models/air/wind_rules.h"
#include "models/reader/curve_reader.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/vector_reader.h"
#include "spoke/error.h"

namespace spoke::spatial {
namespace {

/// Reads the numbers of points of a grid: of both sides, or [across, upwards].
std::array<int, 2> read_points(const TomlSection& section) {
  if (!section.is_array("points")) {
    const int points = section.integer("points", air::kBoxPoints);
    return {points, points};
  }
  const std::vector<double> numbers = section.numbers("points", Quantity::any(""), 2);
  for (std::size_t i = 0; i < 2; ++i)
    if (numbers[i] != std::floor(numbers[i]) || numbers[i] < air::kBoxPoints.least ||
        numbers[i] > air::kBoxPoints.greatest)
      section.fail_at("points." + std::to_string(i + 1),
                      "is " + describe(numbers[i]) + ", expected " + air::kBoxPoints.expectation());
  return {static_cast<int>(numbers[0]), static_cast<int>(numbers[1])};
}

WindTurbulence read_turbulence(const TomlSection& section) {
  WindTurbulence turbulence;
  keys::read(section, keys::kTurbulenceRows, &turbulence);
  if (section.has("deviation_ratio")) {
    const std::vector<double> ratios = section.numbers("deviation_ratio", air::kDeviationRatio, 3);
    std::copy(ratios.begin(), ratios.end(), turbulence.deviation_ratio.begin());
  }
  if (section.has("points")) turbulence.points = read_points(section);
  return turbulence;
}

std::string read_file(const TomlSection& section, const std::string& folder) {
  constexpr const char* kExpected = "a file of TurbSim (.bts) or a table of wind";
  const std::string name = section.text("file", "");
  const std::filesystem::path file = std::filesystem::path(folder) / name;
  std::error_code ignored;
  if (name.empty() || !std::filesystem::exists(file, ignored))
    section.fail("file", "is \"" + name + "\", but there is no file " + file.string() +
                             ", expected " + kExpected);
  return file.string();
}

void read_speed(const TomlSection& section, Wind& wind) {
  if (section.has("velocity")) wind.velocity = read_vector(section, "velocity", air::kWindSpeed);
  if (section.has("time") || section.has("speed"))
    wind.speed = read_curve(section, "time", air::kWindTime, "speed", air::kWindSpeed);
  if (section.has("shear_exponent"))
    wind.shear_exponent = section.number("shear_exponent", air::kShearExponent);
  if (section.has("reference_height"))
    wind.reference_height = section.number("reference_height", air::kReferenceHeight);
  if (section.has("up")) wind.up = read_vector(section, "up", air::kUp);
  if (section.has("ground")) wind.ground = section.number("ground", air::kGround);
}

/// Reads the file, once all else is known to be right.
void keep(const TomlSection& section, Wind& wind) {
  try {
    air::keep_wind(wind);
  } catch (const InputError& error) {
    if (air::is_of_wind_file(error)) throw;
    section.fail_at(error.place().key, error.what());
  }
}

}  // namespace

TomlSection::Keys wind_keys() { return keys::keys_of(keys::kWindRows); }

Wind read_wind(const TomlSection& section, const std::string& folder) {
  Wind wind;
  if (section.has("by")) {
    keys::read_word(section, keys::kWindRows, "by");
    wind.by_program = true;
  }
  read_speed(section, wind);
  if (section.has("file")) wind.file = read_file(section, folder);
  if (section.has("gust"))
    keys::read(section.section("gust", keys::keys_of(keys::kGustRows)), keys::kGustRows,
               &wind.gust.emplace());
  if (section.has("turbulence"))
    wind.turbulence =
        read_turbulence(section.section("turbulence", keys::keys_of(keys::kTurbulenceRows)));
  keep(section, wind);
  return wind;
}

Fault find_fault(const Wind& wind) {
  const air::WindFault fault = air::find_wind_fault(wind);
  return {fault.key, fault.text};
}

Fault find_end_fault(const Scenario& scenario) {
  if (!scenario.space || !scenario.space->air) return {};
  const Wind& wind = scenario.space->air->wind;
  const air::WindFault fault = air::find_end_fault(wind, scenario.integration.duration);
  return Fault{fault.key, fault.text}.within("wind");
}

}  // namespace spoke::spatial
