// Reads the keys of [wind], then its file.

#include "models/reader/spatial/wind_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "models/air/wind_field.h"
#include "models/air/wind_kept.h"
#include "models/air/wind_rules.h"
#include "models/reader/curve_reader.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/vector_reader.h"
#include "models/spatial_model.h"
#include "models/tree/hub_place.h"
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

/// Reads turbulence; with `standard`, what is missing is as it has it.
WindTurbulence read_turbulence(const TomlSection& section,
                               const std::optional<WindTurbulence>& standard) {
  WindTurbulence turbulence = standard.value_or(WindTurbulence{});
  keys::read(section, keys::kTurbulenceRows, &turbulence);
  if (section.has("deviation_ratio")) {
    const std::vector<double> ratios = section.numbers("deviation_ratio", air::kDeviationRatio, 3);
    std::copy(ratios.begin(), ratios.end(), turbulence.deviation_ratio.begin());
  }
  if (section.has("points")) turbulence.points = read_points(section);
  return turbulence;
}

/// Reads the gust, or an array of them.
/// Whether a table is there and not empty: an empty one is none, so that an override can take it
/// away.
bool has_table(const TomlSection& section, std::string_view key, const TomlSection::Keys& known) {
  if (!section.is_table(key)) return section.has(key);
  const TomlSection own = section.section(key, known);
  return std::any_of(known.begin(), known.end(),
                     [&own](std::string_view name) { return own.has(name); });
}

TomlSection::Keys turbulence_keys() { return keys::keys_of(keys::kTurbulenceRows); }
bool has_gust(const TomlSection& section) {
  return has_table(section, "gust", keys::keys_of(keys::kGustRows));
}
bool has_turbulence_table(const TomlSection& section) {
  return has_table(section, "turbulence", turbulence_keys());
}

void read_gusts(const TomlSection& section, std::vector<WindGust>& gusts) {
  if (!has_gust(section)) return;
  const TomlSection::Keys known = keys::keys_of(keys::kGustRows);
  if (section.is_array("gust"))
    for (const TomlSection& gust : section.sections("gust", known))
      keys::read(gust, keys::kGustRows, &gusts.emplace_back());
  else
    keys::read(section.section("gust", known), keys::kGustRows, &gusts.emplace_back());
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
  if (section.has("vertical_shear"))
    wind.vertical_shear = section.number("vertical_shear", air::kLinearShear);
  if (section.has("horizontal_shear"))
    wind.horizontal_shear = section.number("horizontal_shear", air::kLinearShear);
  if (section.has("reference_height"))
    wind.reference_height = section.number("reference_height", air::kReferenceHeight);
  if (section.has("up")) wind.up = read_vector(section, "up", air::kUp);
  if (section.has("ground")) wind.ground = section.number("ground", air::kGround);
}

/// Refuses keys of [wind.iec] that its case does not have.
void require_iec_keys(const TomlSection& section, const IecWind& iec) {
  using enum IecCase;
  struct Belonging {
    const char* key;
    std::vector<IecCase> to;
  };
  const Belonging all[] = {{"start", {eog, edc, ecd, ews}},
                           {"sign", {edc, ecd, ews}},
                           {"direction", {ews}},
                           {"period", {ewm}},
                           {"turbulent", {ewm}},
                           {"seed", {ntm, etm, ewm}}};
  for (const Belonging& of : all) {
    if (!section.has(of.key)) continue;
    if (std::find(of.to.begin(), of.to.end(), iec.condition) != of.to.end()) continue;
    TomlSection::Keys names;
    for (const IecCase one : of.to) names.push_back(name_of(one));
    section.fail(of.key, "does not belong to case \"" + std::string(name_of(iec.condition)) +
                             "\", expected only with case " + join_names(names));
  }
}

/// Returns the diameter of the first rotor by its blades; none if it has none.
std::optional<double> find_diameter(const Model& model) {
  double most = 0.0;
  for (const Blade& blade : model.blades)
    if (blade.rotor == 0)
      most = std::max(most, model.hub.radius + blade.beam.length * std::cos(blade.precone));
  return most > 0.0 ? std::optional<double>(2.0 * most) : std::nullopt;
}

/// Reads [wind.iec] into the wind, whose direction and heights have been read.
void read_iec(const TomlSection& section, const Model& model, Wind& wind) {
  for (const char* key : {"by", "time", "speed", "file", "gust"})
    if (std::string_view(key) == "gust" ? has_gust(section) : section.has(key))
      section.fail(key, "given along with iec, which gives the wind; expected only one of them");
  if (const air::WindFault fault =
          air::find_wind_fault(Wind{.velocity = wind.velocity, .up = wind.up}))
    section.fail_at(fault.key, fault.text);
  const TomlSection own = section.section("iec", keys::keys_of(keys::kIecRows));
  IecWind iec;
  keys::read(own, keys::kIecRows, &iec);
  require_iec_keys(own, iec);
  if (!iec.rotor_diameter) iec.rotor_diameter = find_diameter(model);
  if (!wind.reference_height) {
    const double height = air::WindAxes(wind).height(find_hub_place(model));
    if (height > 0.0) wind.reference_height = height;
  }
  try {
    const double exponent = wind.shear_exponent;
    wind = make_iec_wind(iec, wind);
    if (section.has("shear_exponent")) wind.shear_exponent = exponent;
  } catch (const InputError& error) {
    section.fail_at(error.place().key, error.what());
  }
  if (has_turbulence_table(section) && !wind.turbulence)
    section.fail("turbulence", "given along with case \"" + std::string(name_of(iec.condition)) +
                                   "\" of iec, which has none; expected none");
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

Wind read_wind(const TomlSection& section, const std::string& folder, const Model& model) {
  Wind wind;
  if (section.has("by")) {
    keys::read_word(section, keys::kWindRows, "by");
    wind.by_program = true;
  }
  read_speed(section, wind);
  if (section.has("file")) wind.file = read_file(section, folder);
  read_gusts(section, wind.gusts);
  if (section.has("iec")) read_iec(section, model, wind);
  if (has_turbulence_table(section))
    wind.turbulence =
        read_turbulence(section.section("turbulence", turbulence_keys()), wind.turbulence);
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
