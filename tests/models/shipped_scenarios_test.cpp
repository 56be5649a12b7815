#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "models/scenario.h"
#include "tests/file_text.h"
#include "tests/shipped.h"

using doctest::Approx;
using namespace spoke;
using test::file_text;

namespace {

/// Checks that the documentation names every key of `json`: a value as `key`, a table as [key].
void check_documented(const nlohmann::json& json, const std::string& documentation) {
  for (const auto& item : json.items()) {
    const std::string& key = item.key();
    const nlohmann::json& value = item.value();
    CAPTURE(key);
    const bool named = documentation.find('`' + key + '`') != std::string::npos ||
                       documentation.find(key + ']') != std::string::npos;
    CHECK(named);
    if (value.is_object()) check_documented(value, documentation);
    if (value.is_array() && !value.empty() && value[0].is_object()) {
      check_documented(value[0], documentation);
    }
  }
}

}  // namespace

TEST_CASE("the Wu and Haug rotor has the values of its source") {
  const Scenario scenario = test::read_shipped("wu_haug_rotor");
  CHECK(scenario.title == "Wu & Haug 1988 rotor, spin-up to 4 rad/s");
  CHECK(scenario.name == "wu_haug_rotor");
  REQUIRE(scenario.rotor.blades.size() == 3);
  const Blade& blade = scenario.rotor.blades[1];
  CHECK(blade.length == 8.0);
  CHECK(blade.bodies == 4);
  CHECK(blade.elements == 4);
  CHECK(blade.youngs_modulus * blade.second_moment == Approx(566.355));
  CHECK(blade.youngs_modulus * blade.area == Approx(5.03266e6));
  CHECK(blade.density * blade.area == Approx(0.2019392));
  CHECK(blade.geometric_stiffening);
  CHECK(blade.reference_frame == ReferenceFrame::clamped);
  CHECK(std::get<SpinUp>(scenario.rotor.hub.drive).speed == 4.0);
  CHECK(std::get<SpinUp>(scenario.rotor.hub.drive).ramp == 15.0);
  CHECK(scenario.integration.method == IntegrationMethod::generalized_alpha);
  CHECK(scenario.integration.step == 0.005);
  CHECK(scenario.integration.duration == 20.0);
}

TEST_CASE("the paper's rotor is the same without stiffening") {
  const Scenario scenario = test::read_shipped("paper_rotor");
  CHECK_FALSE(scenario.rotor.blades[0].geometric_stiffening);
  CHECK(scenario.rotor.blades[0].reference_frame == ReferenceFrame::clamped);
  CHECK(scenario.integration.duration == 20.0);
}

TEST_CASE("the spin-up hold spin-down cycle rests after 35 of 40 s") {
  const Scenario scenario = test::read_shipped("spin_up_hold_spin_down");
  const Drive& drive = scenario.rotor.hub.drive;
  CHECK(calc_motion(drive, 15.0).speed == Approx(4.0));
  CHECK(calc_motion(drive, 20.0).speed == Approx(4.0));
  CHECK(calc_motion(drive, 35.0).speed == Approx(0.0));
  CHECK(scenario.integration.duration == 40.0);
}

TEST_CASE("the beam of Simo and Vu-Quoc has the stiffness and mass of its source") {
  const Scenario scenario = test::read_shipped("simo_vu_quoc_beam");
  REQUIRE(scenario.rotor.blades.size() == 1);
  const Blade& blade = scenario.rotor.blades[0];
  CHECK(blade.length == 10.0);
  CHECK(blade.youngs_modulus * blade.area == Approx(2.8e7));
  CHECK(blade.youngs_modulus * blade.second_moment == Approx(1.4e4));
  CHECK(blade.density * blade.area == Approx(1.2));
  CHECK(std::get<SpinUp>(scenario.rotor.hub.drive).speed == 6.0);
}

TEST_CASE("the satellite's torque has no net impulse and its booms are opposite") {
  const Scenario scenario = test::read_shipped("free_hub_satellite");
  CHECK(scenario.rotor.hub.support == HubSupport::free);
  const Curve& torque = std::get<TorqueDrive>(scenario.rotor.hub.drive).torque;
  CHECK(torque.integral(12.0) > 50.0);
  CHECK(std::abs(torque.integral(24.0)) < 1e-12);
  CHECK(torque.value(60.0) == 0.0);
  REQUIRE(scenario.rotor.blades.size() == 2);
  CHECK(scenario.rotor.blades[1].azimuth - scenario.rotor.blades[0].azimuth ==
        Approx(std::acos(-1.0)));
}

TEST_CASE("the large rotor has 24 blades of 8 by 8 elements") {
  const Scenario scenario = test::read_shipped("large_rotor");
  REQUIRE(scenario.rotor.blades.size() == 24);
  CHECK(scenario.rotor.blades[23].bodies == 8);
  CHECK(scenario.rotor.blades[23].elements == 8);
}

TEST_CASE("every shipped scenario says what it is and where it comes from") {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SPOKE_MODELS_DIR)) {
    if (entry.path().extension() != ".toml") continue;
    CAPTURE(entry.path());
    ++count;
    const std::string text = file_text(entry.path());
    CHECK(text.starts_with("# "));
    CHECK(text.find("\n# Source: ") != std::string::npos);
    CHECK_NOTHROW(read_scenario(entry.path()));
  }
  CHECK(count >= 6);
}

TEST_CASE("every key of a scenario is documented") {
  const std::string documentation = file_text(SPOKE_DOCS_DIR "/scenario.md");
  for (const char* name : {"wu_haug_rotor", "spin_up_hold_spin_down", "free_hub_satellite"}) {
    check_documented(nlohmann::json::parse(test::read_shipped(name).to_json()), documentation);
  }
}
