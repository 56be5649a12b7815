#include "models/scenario.h"

#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "tests/models/inline_toml.h"

using doctest::Approx;
using namespace spoke;
using std::numbers::pi;
using test::document_of;

namespace {

const std::string kHub = "[hub.drive]\nkind = 'spin_up'\nspeed = 4\nramp = 15\n";
const std::string kSection =
    "density = 2700\narea = 1e-4\nsecond_moment = 1e-8\nyoungs_modulus = 7e10\n";
const std::string kBlade = "[blade]\ncount = 3\nlength = 8\n" + kSection;
const std::string kIntegration = "[integration]\nduration = 20\n";

Scenario parse(const std::string& text, const Overrides& overrides = {}) {
  return parse_scenario(text, "folder/some_name.toml", overrides);
}

}  // namespace

TEST_CASE("a minimal scenario gets the documented defaults") {
  const Scenario scenario = parse(kHub + kBlade + kIntegration);
  CHECK(scenario.title == "some_name");
  CHECK(scenario.name == "some_name");
  const Hub& hub = scenario.rotor.hub;
  CHECK(hub.support == HubSupport::axle);
  CHECK(hub.radius == 0.0);
  CHECK(hub.mass == 0.0);
  CHECK(hub.inertia == 1.0);
  const Blade& blade = scenario.rotor.blades.at(0);
  CHECK(blade.bodies == 4);
  CHECK(blade.elements == 4);
  CHECK(blade.geometric_stiffening);
  CHECK(blade.reference_frame == ReferenceFrame::clamped);
  CHECK(scenario.rotor.gravity == Position::Zero());
  CHECK(scenario.rotor.damping.mass_factor == 0.0);
  CHECK(scenario.rotor.damping.stiffness_factor == 0.0);
  CHECK(scenario.rotor.loads.empty());
  const Integration& integration = scenario.integration;
  CHECK(integration.method == IntegrationMethod::generalized_alpha);
  CHECK(integration.step == 0.005);
  CHECK(integration.spectral_radius == 0.8);
  CHECK(integration.tolerance == 1e-10);
  CHECK(goal_of(integration) == IterationGoal::error);
  CHECK(integration.iterations == 0);
  CHECK(integration.max_iterations == 30);
  CHECK(scenario.limits.deflection == 0.1);
  CHECK(scenario.limits.energy_growth == 0.01);
  CHECK(scenario.limits.on_energy_growth == EnergyGrowth::warn);
  CHECK(scenario.limits.step_error == 2e-4);
  CHECK(scenario.limits.momentum == 0.01);
  CHECK(scenario.output.interval == 0.05);
}

TEST_CASE("a tolerance that is given is iterated to") {
  const auto goal = [](const std::string& keys) {
    const Scenario scenario = parse(kHub + kBlade + kIntegration + keys);
    const Scenario again = parse_scenario(
        kHub + kBlade + kIntegration, "again.toml",
        {"integration.tolerance=1e-10",
         "integration.iterate_to=" + std::string(name_of(goal_of(scenario.integration)))});
    CHECK(goal_of(again.integration) == goal_of(scenario.integration));
    return goal_of(scenario.integration);
  };
  CHECK(goal("") == IterationGoal::error);
  CHECK(goal("tolerance = 1e-10\n") == IterationGoal::tolerance);
  CHECK(goal("tolerance = 1e-12\niterate_to = 'error'\n") == IterationGoal::error);
  CHECK(goal("iterate_to = 'tolerance'\n") == IterationGoal::tolerance);
  Integration in_code;
  in_code.tolerance = 1e-13;
  CHECK(goal_of(in_code) == IterationGoal::tolerance);
}

TEST_CASE("counted blades are alike and spaced evenly from the first azimuth") {
  const Scenario scenario = parse(kHub + kBlade + "azimuth = 0.5\n" + kIntegration);
  REQUIRE(scenario.rotor.blades.size() == 3);
  for (int i = 0; i < 3; ++i) {
    const Blade& blade = scenario.rotor.blades[static_cast<std::size_t>(i)];
    CHECK(blade.azimuth == Approx(0.5 + 2.0 * pi * i / 3));
    CHECK(blade.length == 8.0);
  }
}

TEST_CASE("blades given one by one differ and take what they miss from the common blade") {
  const Scenario scenario =
      parse(kHub + "[blade]\nlength = 8\nbodies = 2\n" + kSection +
            "[[blades]]\n[[blades]]\nlength = 6\nbodies = 3\nazimuth = 2.5\n"
            "reference_frame = 'chord'\ngeometric_stiffening = false\ndensity = 1800.5\n" +
            kIntegration);
  REQUIRE(scenario.rotor.blades.size() == 2);
  const Blade& first = scenario.rotor.blades[0];
  const Blade& second = scenario.rotor.blades[1];
  CHECK(first.length == 8.0);
  CHECK(first.bodies == 2);
  CHECK(first.azimuth == 0.0);
  CHECK(first.geometric_stiffening);
  CHECK(second.length == 6.0);
  CHECK(second.bodies == 3);
  CHECK(second.azimuth == 2.5);
  CHECK(second.reference_frame == ReferenceFrame::chord);
  CHECK_FALSE(second.geometric_stiffening);
  CHECK(second.density == 1800.5);
  CHECK(second.area == 1e-4);
}

TEST_CASE("blades given one by one need no common blade and are spaced evenly") {
  const std::string blade = "[[blades]]\nlength = 8\n" + kSection;
  const Scenario scenario = parse(kHub + blade + blade + blade + blade + kIntegration);
  REQUIRE(scenario.rotor.blades.size() == 4);
  CHECK(scenario.rotor.blades[3].azimuth == Approx(1.5 * pi));
}

TEST_CASE("every kind of drive is read") {
  const auto drive = [](const std::string& keys) {
    return parse("hub.drive = {" + keys + "}\n" + kBlade + kIntegration).rotor.hub.drive;
  };
  CHECK(std::get<SpinUp>(drive("kind = 'spin_up', speed = -4, ramp = 2.5")).speed == -4.0);
  const auto cycle = std::get<SpinUpHoldSpinDown>(
      drive("kind = 'spin_up_hold_spin_down', speed = 4, ramp = 3, hold = 5"));
  CHECK(cycle.hold == 5.0);
  CHECK(cycle.ramp_down == 3.0);
  const auto table = std::get<SpeedTable>(drive("kind='table', time=[0, 2], speed=[1, 5]"));
  CHECK(table.speed.value(1.0) == Approx(3.0));
  const auto torque = std::get<TorqueDrive>(drive("kind='torque', torque=3, initial_speed=2"));
  CHECK(torque.torque.value(99.0) == 3.0);
  CHECK(torque.initial_speed == 2.0);
  const auto profile = std::get<TorqueDrive>(drive("kind='torque', time=[0, 1], torque=[0, 2]"));
  CHECK(profile.torque.value(0.5) == Approx(1.0));
  CHECK(profile.initial_speed == 0.0);
  CHECK(std::get<FreeDrive>(drive("kind = 'free', initial_speed = 1")).initial_speed == 1.0);
  CHECK(std::get<FreeDrive>(drive("kind = 'free'")).initial_speed == 0.0);
}

TEST_CASE("hub and gravity and damping and integration and limits and output are read") {
  const Scenario scenario =
      parse("title = 'T'\n[hub]\nsupport = 'free'\nradius = 0.5\nmass = 3\ninertia = 2\n" + kHub +
            kBlade +
            "bodies = 1\n[gravity]\nacceleration = [0, -9.81]\n[damping]\nmass_factor = 0.1\n"
            "stiffness_factor = 0.002\n[integration]\nmethod = 'rk4'\nstep = 1e-4\nduration = 2\n"
            "spectral_radius = 1\ntolerance = 1e-8\niterations = 2\nmax_iterations = 9\n"
            "[limits]\ndeflection = 0\nenergy_growth = 2\non_energy_growth = 'stop'\n"
            "step_error = 0\nmomentum = 0.5\n"
            "[output]\ninterval = 0\n");
  CHECK(scenario.title == "T");
  CHECK(scenario.rotor.hub.support == HubSupport::free);
  CHECK(scenario.rotor.hub.radius == 0.5);
  CHECK(scenario.rotor.hub.mass == 3.0);
  CHECK(scenario.rotor.hub.inertia == 2.0);
  CHECK(scenario.rotor.gravity == Position(0.0, -9.81));
  CHECK(scenario.rotor.damping.mass_factor == 0.1);
  CHECK(scenario.rotor.damping.stiffness_factor == 0.002);
  CHECK(scenario.integration.method == IntegrationMethod::rk4);
  CHECK(scenario.integration.step == 1e-4);
  CHECK(scenario.integration.spectral_radius == 1.0);
  CHECK(scenario.integration.tolerance == 1e-8);
  CHECK(scenario.integration.iterations == 2);
  CHECK(scenario.integration.max_iterations == 9);
  CHECK(scenario.limits.deflection == 0.0);
  CHECK(scenario.limits.energy_growth == 2.0);
  CHECK(scenario.limits.on_energy_growth == EnergyGrowth::stop);
  CHECK(scenario.limits.step_error == 0.0);
  CHECK(scenario.limits.momentum == 0.5);
  CHECK(scenario.output.interval == 0.0);
}

TEST_CASE("loads are read with their blade and place and frame and course") {
  const Scenario scenario =
      parse(kHub + kBlade +
            "[[load]]\nforce = [1, 2]\n"
            "[[load]]\nblade = 2\nposition = 3.5\nframe = 'section'\nmoment = -4\n"
            "time = [0, 1]\nfactor = [0, 1]\n"
            "[[load]]\nblade = 'all'\nposition = 0\nframe = 'inertial'\nforce = [0, 1]\n" +
            kIntegration);
  REQUIRE(scenario.rotor.loads.size() == 3);
  const PointLoad& tip = scenario.rotor.loads[0];
  CHECK(tip.blade.is_all());
  CHECK(tip.position == 8.0);
  CHECK(tip.frame == LoadFrame::hub);
  CHECK(tip.force == Position(1.0, 2.0));
  CHECK(tip.moment == 0.0);
  CHECK(tip.factor.value(5.0) == 1.0);
  const PointLoad& follower = scenario.rotor.loads[1];
  CHECK(follower.blade.number() == 2);
  CHECK(follower.position == 3.5);
  CHECK(follower.frame == LoadFrame::section);
  CHECK(follower.moment == -4.0);
  CHECK(follower.factor.value(0.5) == Approx(0.5));
  CHECK(scenario.rotor.loads[2].frame == LoadFrame::inertial);
  CHECK(scenario.rotor.loads[2].blade.is_all());
}

TEST_CASE("a load on every tip finds the tips of blades of different lengths") {
  const Scenario scenario =
      parse(kHub + "[blade]\nlength = 8\n" + kSection +
            "[[blades]]\n[[blades]]\nlength = 6\n[[load]]\nmoment = 1\n" + kIntegration);
  REQUIRE(scenario.rotor.loads.size() == 2);
  CHECK(scenario.rotor.loads[0].blade.number() == 1);
  CHECK(scenario.rotor.loads[0].position == 8.0);
  CHECK(scenario.rotor.loads[1].blade.number() == 2);
  CHECK(scenario.rotor.loads[1].position == 6.0);
}

TEST_CASE("overrides change and add keys and the last one wins") {
  const Scenario scenario = parse(
      kHub + kBlade + kIntegration,
      {"blade.bodies=2", "blade.bodies=8", "blade.reference_frame=chord", "load.1.force=[0,1]",
       "hub.drive={kind=\"free\", initial_speed=3}", "gravity.acceleration=[0, -9.81]",
       "gravity.acceleration.1=1", "integration.step=0.01", "title=A new title"});
  CHECK(scenario.rotor.blades[2].bodies == 8);
  CHECK(scenario.rotor.blades[0].reference_frame == ReferenceFrame::chord);
  CHECK(scenario.rotor.loads.at(0).force == Position(0.0, 1.0));
  CHECK(std::get<FreeDrive>(scenario.rotor.hub.drive).initial_speed == 3.0);
  CHECK(scenario.rotor.gravity == Position(1.0, -9.81));
  CHECK(scenario.integration.step == 0.01);
  CHECK(scenario.title == "A new title");
}

TEST_CASE("an override reaches one of the blades given one by one") {
  const std::string blade = "[[blades]]\nlength = 8\n" + kSection;
  const Scenario scenario = parse(kHub + blade + blade + kIntegration, {"blades.2.length=7"});
  CHECK(scenario.rotor.blades[0].length == 8.0);
  CHECK(scenario.rotor.blades[1].length == 7.0);
}

TEST_CASE("the JSON of a scenario is the file with every value in force") {
  const std::vector<std::string> hubs = {
      kHub,
      "hub.drive = {kind = 'table', time = [0, 1, 3], speed = [0, 2, 2.5]}\n",
      "hub.drive = {kind = 'torque', time = [0, 1], torque = [0, 2], initial_speed = 1}\n",
      "hub = {support = 'free', mass = 4, drive = {kind = 'torque', torque = 2}}\n",
      "hub.drive = {kind = 'spin_up_hold_spin_down', speed = 1, ramp = 2, hold = 3}\n",
      "hub.drive = {kind = 'free', initial_speed = 1}\n"};
  for (const std::string& hub : hubs) {
    const std::string json =
        parse(hub + kBlade + "[[load]]\nblade = 2\nforce = [1, 2]\n[[load]]\nmoment = 0.1\n" +
              "[[sensor]]\nquantity = 'section_force'\nposition = 1\n[[sensor]]\nquantity = "
              "'joint_reaction'\njoint = 2\nblade = 3\n" +
              kIntegration)
            .to_json();
    CHECK(parse(document_of(json)).to_json() == json);
    const auto parsed = nlohmann::json::parse(json);
    CHECK(parsed["blades"].size() == 3);
    CHECK(parsed["blades"][1]["elements"] == 4);
    CHECK(parsed["load"][0]["blade"] == 2);
    CHECK(parsed["load"][1]["blade"] == "all");
    CHECK(parsed["load"][1]["position"] == 8.0);
    CHECK(parsed["integration"]["method"] == "generalized_alpha");
  }
}

TEST_CASE("a file with a byte-order mark and Windows line ends is read") {
  std::string text = kHub + kBlade + kIntegration;
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) {
    text.replace(at, 1, "\r\n");
  }
  CHECK(parse("\xEF\xBB\xBF" + text).rotor.blades.size() == 3);
}
