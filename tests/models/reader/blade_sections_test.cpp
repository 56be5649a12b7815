// Sections and point masses of a blade in a scenario: values read, and the one line for each
// mistake.

#include "models/reader/blade_sections.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "models/reader/scenario_check.h"
#include "models/scenario.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const std::string kBegin = R"([hub.drive]
kind = "spin_up"
speed = 4.0
ramp = 15.0
[integration]
duration = 1.0
[blade]
count = 2
length = 8.0
)";

// Lines 10 to 14.
const std::string kSections = R"([blade.sections]
station = [0.0, 3.0, 8.0]
mass_per_length = [0.3, 0.2, 0.1]
axial_stiffness = [5e6, 4e6, 3e6]
bending_stiffness = [600.0, 400.0, 100.0]
)";

Scenario parse_blade(const std::string& text, const Overrides& overrides = {}) {
  return parse_scenario(text, "f.toml", overrides);
}

std::string error_of_blade(const std::string& text) {
  return message_of([&] { parse_blade(text); });
}

/// Returns the error of the sections with one line replaced.
std::string error_with(const std::string& line, const std::string& replacement) {
  std::string text = kBegin + kSections;
  const auto at = text.find(line);
  REQUIRE(at != std::string::npos);
  return error_of_blade(text.replace(at, line.size(), replacement));
}

}  // namespace

TEST_CASE("sections and point masses are read, and written as they are read") {
  const Scenario scenario = parse_blade(kBegin + kSections + R"([[blade.point_mass]]
position = 8.0
mass = 0.5
[[blade.point_mass]]
position = 2.0
mass = 0.25
inertia = 0.01
)");
  REQUIRE(scenario.rotor.blades.size() == 2);
  for (const Blade& blade : scenario.rotor.blades) {
    CHECK(blade.sections ==
          BladeSections{{0.0, 3.0, 8.0}, {0.3, 0.2, 0.1}, {5e6, 4e6, 3e6}, {600.0, 400.0, 100.0}});
    CHECK(blade.point_masses == std::vector<PointMass>{{8.0, 0.5, 0.0}, {2.0, 0.25, 0.01}});
    CHECK(blade.density == 0.0);
  }
  const auto blade = nlohmann::json::parse(scenario.to_json())["blades"][1];
  CHECK(blade["sections"]["station"] == nlohmann::json({0.0, 3.0, 8.0}));
  CHECK(blade["point_mass"][1]["inertia"] == 0.01);
  CHECK_FALSE(blade.contains("density"));
  CHECK_NOTHROW(check_scenario(scenario));
}

TEST_CASE("a blade of its own replaces the sections, or the material, of all") {
  const std::string uniform = R"(density = 2766.67
area = 7.299e-5
second_moment = 8.214e-9
youngs_modulus = 6.895e10
)";
  std::string begin = kBegin;
  begin.erase(begin.find("count = 2\n"), 10);
  const Scenario scenario = parse_blade(begin + kSections + "[[blades]]\n[[blades]]\n" + uniform +
                                        "[[blades.point_mass]]\nposition = 1.0\nmass = 2.0\n");
  CHECK(scenario.rotor.blades[0].sections.station.size() == 3);
  CHECK(scenario.rotor.blades[1].sections.station.empty());
  CHECK(scenario.rotor.blades[1].density == 2766.67);
  CHECK(scenario.rotor.blades[0].point_masses.empty());
  CHECK(scenario.rotor.blades[1].point_masses.size() == 1);
  std::string own = kSections;
  own.replace(own.find("blade.sections"), 14, "blades.sections");
  const Scenario other = parse_blade(begin + uniform + "[[blades]]\n" + own + "[[blades]]\n");
  CHECK(other.rotor.blades[0].sections.station.size() == 3);
  CHECK(other.rotor.blades[0].density == 0.0);
  CHECK(other.rotor.blades[1].density == 2766.67);
}

TEST_CASE("sections that do not fit are refused in one line") {
  CHECK(
      error_with("0.0, 3.0, 8.0", "0.0, 9.0, 8.0") ==
      "f.toml:11:22: blade.sections.station.3: is 8.0, expected more than the value before it, 9");
  CHECK(error_with("0.0, 3.0, 8.0", "0.5, 3.0, 8.0") ==
        "f.toml:11:11: blade.sections.station: begins at 0.5, expected 0 (m, the root)");
  CHECK(error_with("0.0, 3.0, 8.0", "0.0, 3.0, 7.5") ==
        "f.toml:11:11: blade.sections.station: ends at 7.5, expected 8 (m, the blade's length)");
  CHECK(error_with("0.0, 3.0, 8.0", "0.0") ==
        "f.toml:11:11: blade.sections.station: has 1 number, expected 2 or more");
  CHECK(error_with("0.0, 3.0, 8.0", "-1.0, 3.0, 8.0") ==
        "f.toml:11:12: blade.sections.station.1: is -1.0, expected a number of 0 or more (m)");
  CHECK(error_with("0.3, 0.2, 0.1", "0.3, 0.2") ==
        "f.toml:12:19: blade.sections.mass_per_length: has 2 numbers, expected 3, one for each "
        "station");
  CHECK(error_with("5e6, 4e6, 3e6", "5e6, 4e6, 3e6, 2e6") ==
        "f.toml:13:19: blade.sections.axial_stiffness: has 4 numbers, expected 3, one for each "
        "station");
  CHECK(error_with("600.0, 400.0, 100.0", "600.0, 400.0, 0.0") ==
        "f.toml:14:36: blade.sections.bending_stiffness.3: is 0.0, expected a number greater than "
        "0 (N m^2)");
  CHECK(error_with("0.3, 0.2, 0.1", "0.3, nan, 0.1")
            .find("f.toml:12:25: blade.sections.mass_per_length.2: is nan, expected") == 0);
  CHECK(error_with("mass_per_length = [0.3, 0.2, 0.1]\n", "") ==
        "f.toml:10:1: blade.sections.mass_per_length: is missing, expected an array of numbers "
        "(kg/m)");
  CHECK(error_with("axial_stiffness", "axial_stifness").find("unknown key") != std::string::npos);
}

TEST_CASE("a blade with both sections and a material is refused") {
  CHECK(error_of_blade(kBegin + "area = 1e-4\n" + kSections) ==
        "f.toml:10:8: blade.area: given along with blade.sections, expected only one of them");
  Scenario scenario = parse_blade(kBegin + kSections);
  scenario.rotor.blades[1].area = 1e-4;
  CHECK(message_of([&] { check_scenario(scenario); }) ==
        "blades.2.area: given along with sections, expected only one of them");
}

TEST_CASE("point masses that do not fit are refused in one line") {
  const auto error = [](const std::string& mass) {
    return error_of_blade(kBegin + kSections + "[[blade.point_mass]]\n" + mass + "\n");
  };
  CHECK(error("position = 8.5\nmass = 1.0") ==
        "f.toml:16:12: blade.point_mass.1.position: is 8.5, expected a number from 0 to 8 (m, from "
        "root to tip of the blade)");
  CHECK(error("position = -0.1\nmass = 1.0").find("blade.point_mass.1.position: is -0.1") !=
        std::string::npos);
  CHECK(error("mass = 1.0").find("blade.point_mass.1.position: is missing") != std::string::npos);
  CHECK(error("position = 8.0").find("blade.point_mass.1.mass: is missing") != std::string::npos);
  CHECK(error("position = 8.0\nmass = 0.0") ==
        "f.toml:17:8: blade.point_mass.1.mass: is 0.0, expected a number greater than 0 (kg)");
  CHECK(error("position = 8.0\nmass = 1.0\ninertia = -1.0") ==
        "f.toml:18:11: blade.point_mass.1.inertia: is -1.0, expected a number of 0 or more (kg "
        "m^2)");
  CHECK(error("station = 8.0\nmass = 1.0").find("unknown key") != std::string::npos);
  CHECK(error_of_blade(kBegin + "point_mass = 3\n" + kSections).find("blade.point_mass: is 3") !=
        std::string::npos);
}

TEST_CASE("the same is refused of a blade that is filled in code") {
  const auto error = [](const auto& change) {
    Scenario scenario = parse_blade(kBegin + kSections);
    change(scenario.rotor.blades[1]);
    return message_of([&] { check_scenario(scenario); });
  };
  CHECK(error([](Blade& blade) { blade.sections.station[1] = 9.0; }) ==
        "blades.2.sections.station.3: is 8, expected more than the value before it, 9");
  CHECK(error([](Blade& blade) { blade.sections.station[0] = 0.5; }) ==
        "blades.2.sections.station: begins at 0.5, expected 0 (m, the root)");
  CHECK(error([](Blade& blade) { blade.length = 9.0; }) ==
        "blades.2.sections.station: ends at 8, expected 9 (m, the blade's length)");
  CHECK(error([](Blade& blade) { blade.sections.station.clear(); }) ==
        "blades.2.sections.station: has 0 numbers, expected 2 or more");
  CHECK(error([](Blade& blade) { blade.sections.axial_stiffness.pop_back(); }) ==
        "blades.2.sections.axial_stiffness: has 2 numbers, expected 3, one for each station");
  CHECK(error([](Blade& blade) { blade.sections.mass_per_length[1] = 0.0; }) ==
        "blades.2.sections.mass_per_length.2: is 0, expected a number greater than 0 (kg/m)");
  CHECK(error([](Blade& blade) {
          blade.point_masses = {{9.0, 1.0, 0.0}};
        }) ==
        "blades.2.point_mass.1.position: is 9, expected a number from 0 to 8 (m, from root to tip "
        "of the blade)");
  CHECK(error([](Blade& blade) {
          blade.point_masses = {{8.0, 1.0, -1.0}};
        }) == "blades.2.point_mass.1.inertia: is -1, expected a number of 0 or more (kg m^2)");
}
