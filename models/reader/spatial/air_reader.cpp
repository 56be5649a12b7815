// Reads the air of a scenario; polars come from the scenario or from files that it names.

#include "models/reader/spatial/air_reader.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "models/air/airfoil_reader.h"
#include "models/reader/keys/air_keys.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/fault.h"
#include "models/reader/spatial/wind_reader.h"
#include "models/spatial_model.h"

namespace spoke::spatial {
namespace {

std::vector<std::string> read_names(const TomlSection& section, std::size_t stations) {
  const std::string expected = "an array of names of aerofoils, or one name";
  if (!section.has("airfoil")) section.fail("airfoil", "is missing, expected " + expected);
  if (section.is_text("airfoil"))
    return std::vector<std::string>(stations, section.text("airfoil", ""));
  std::vector<std::string> names;
  for (const TomlValue& value : section.values("airfoil")) {
    const std::string* name = value.as_text();
    if (!name) section.fail_expected("airfoil", expected);
    names.push_back(*name);
  }
  return names;
}

Polar read_polar(const TomlSection& section) {
  Polar polar;
  polar.reynolds = section.number("reynolds", kReynolds, 0.0);
  if (section.has("mach")) polar.mach = section.number("mach", kMach);
  polar.angle = section.numbers("angle", kAngle);
  polar.lift = section.numbers("lift", kCoefficient);
  polar.drag = section.numbers("drag", kCoefficient);
  if (section.has("moment")) polar.moment = section.numbers("moment", kCoefficient);
  return polar;
}

/// Reads an aerofoil's polars: one in its own table, several in tables "polar", or from a file.
Airfoil read_airfoil(const TomlSection& section, const std::string& folder) {
  Airfoil airfoil;
  airfoil.name = section.text("name", "");
  if (airfoil.name.empty()) section.fail("name", "is missing, expected a name");
  const int sources = static_cast<int>(section.has("file")) +
                      static_cast<int>(section.has("angle")) +
                      static_cast<int>(section.has("polar"));
  if (sources != 1)
    section.fail("", std::string(sources == 0 ? "has no polar" : "has polars more than once") +
                         ", expected one of file, polar, or angle with lift and drag");
  if (section.has("file")) {
    const std::filesystem::path file = std::filesystem::path(folder) / section.text("file", "");
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored))
      section.fail("file", "is \"" + section.text("file", "") + "\", but there is no file " +
                               file.string() + ", expected a file of polars");
    airfoil = spoke::air::read_airfoil(file, airfoil.name);
  } else if (section.has("angle")) {
    airfoil.polars.push_back(read_polar(section));
  } else {
    for (const TomlSection& table : section.sections("polar", keys::keys_of(keys::kPolarRows)))
      airfoil.polars.push_back(read_polar(table));
  }
  if (const Fault fault = find_fault(airfoil)) {
    // A single polar stands in the aerofoil's own table.
    constexpr std::string_view kOwn = "polar.1.";
    const bool is_own = section.has("angle") && fault.path.starts_with(kOwn);
    section.fail_at(is_own ? fault.path.substr(kOwn.size()) : fault.path, fault.text);
  }
  return airfoil;
}

/// Returns the place of the table that names aerofoil `name` first: path of its element.
std::string find_use(const TomlSection& root, const Model& model, const std::string& name) {
  for (std::size_t i = 0; i < model.blades.size(); ++i) {
    if (!model.blades[i].aerodynamics) continue;
    const std::vector<std::string>& names = model.blades[i].aerodynamics->airfoil;
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end()) continue;
    const std::string key = ".aerodynamics.airfoil";
    const std::string number = '.' + std::to_string(at - names.begin() + 1);
    return (root.has("blade") ? "blade" : "blades." + std::to_string(i + 1)) + key + number;
  }
  return {};
}

/// Adds the files that blades name and no [[airfoil]] does.
void add_files(const TomlSection& root, const std::string& folder, const Model& model, Air& air) {
  for (const Blade& blade : model.blades) {
    if (!blade.aerodynamics) continue;
    for (const std::string& name : blade.aerodynamics->airfoil) {
      if (std::any_of(air.airfoils.begin(), air.airfoils.end(),
                      [&](const Airfoil& airfoil) { return airfoil.name == name; }))
        continue;
      const std::filesystem::path file = std::filesystem::path(folder) / name;
      std::error_code ignored;
      if (name.empty() || !std::filesystem::is_regular_file(file, ignored))
        root.fail_at(find_use(root, model, name),
                     "is \"" + name + "\", but there is no [[airfoil]] of that name and no file " +
                         file.string());
      air.airfoils.push_back(spoke::air::read_airfoil(file, name));
    }
  }
}

}  // namespace

void read_stations(const TomlSection& section, std::string_view key, const Quantity& quantity,
                   std::size_t stations, std::vector<double>& values) {
  if (!section.has(key)) return;
  if (section.is_array(key))
    values = section.numbers(key, quantity);
  else
    values.assign(stations, section.number(key, quantity));
}

TomlSection::Keys aerodynamics_keys() { return keys::keys_of(keys::kBladeAerodynamicsRows); }

BladeAerodynamics read_aerodynamics(const TomlSection& section, double length) {
  BladeAerodynamics read;
  read.station = section.increasing_numbers("station", kStation);
  const std::size_t stations = read.station.size();
  if (!section.has("chord"))
    section.fail("chord", "is missing, expected one number for each station");
  visit_stations(read,
                 [&](std::string_view key, std::vector<double>& values, const Quantity& quantity) {
                   read_stations(section, key, quantity, stations, values);
                 });
  read.airfoil = read_names(section, stations);
  read.leads_backward = section.has("leading_edge") &&
                        keys::read_word(section, keys::kBladeAerodynamicsRows, "leading_edge") == 1;
  if (const Fault fault = find_fault(read, length)) section.fail_at(fault.path, fault.text);
  return read;
}

std::optional<Air> read_air(const TomlSection& root, const std::string& folder,
                            const Model& model) {
  if (!root.has("air")) {
    for (const char* key : {"wind", "aerodynamics", "airfoil"})
      if (root.has(key)) root.fail(key, "acts in air, expected [air] along with it");
    return std::nullopt;
  }
  Air air;
  keys::read(root.section("air", keys::keys_of(keys::kAirRows)), keys::kAirRows, &air);
  if (root.has("wind")) air.wind = read_wind(root.section("wind", wind_keys()), folder, model);
  keys::read(root.section("aerodynamics", keys::keys_of(keys::kAerodynamicsRows)),
             keys::kAerodynamicsRows, &air);
  for (const TomlSection& table :
       root.sections("airfoil", keys::keys_of(keys::kAirfoilRows, keys::kPolarRows)))
    air.airfoils.push_back(read_airfoil(table, folder));
  add_files(root, folder, model, air);
  if (const Fault fault = find_fault(air, model)) root.fail_at(fault.path, fault.text);
  return air;
}

}  // namespace spoke::spatial
