// Checks that shipped scenarios in space are read and written, are documented, and have the mass of
// their sources.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "models/scenario.h"
#include "models/tree/tree.h"
#include "tests/file_text.h"
#include "tests/models/inline_toml.h"
#include "tests/shipped.h"

using doctest::Approx;
using namespace spoke;
using test::document_of;
using test::file_text;
using Json = nlohmann::ordered_json;

namespace {

const char* const kNames[] = {"andrews_squeezer", "articulated_rotor", "bricard",
                              "drone_rotor",      "fairground_ride",   "four_bar",
                              "ground_resonance", "heavy_top",         "helicopter_on_gear",
                              "helicopter_rotor", "nrel_5mw_rotor",    "nrel_5mw_turbine",
                              "quadcopter",       "satellite_booms",   "solid_blade_rotor",
                              "solid_bracket",    "spatial_wu_haug",   "tree_of_bodies",
                              "vehicle",          "whirl_rotor",       "wu_haug_solid"};

/// Checks the keys of all tables within.
void check_documented(const Json& json, const std::string& documentation) {
  for (const auto& item : json.items()) {
    if (json.is_object()) {
      const std::string& key = item.key();
      CAPTURE(key);
      const bool named = documentation.find('`' + key + '`') != std::string::npos ||
                         documentation.find(key + ']') != std::string::npos;
      CHECK(named);
    }
    if (item.value().is_structured()) check_documented(item.value(), documentation);
  }
}

/// Returns a blade's mass properties about its root, in its own frame.
spatial::MassProperties blade_of(const Scenario& scenario) {
  const spatial::Tree tree = build_trees(*scenario.space).front();
  const spatial::Placement& root = tree.bodies.front().placement;
  const spatial::Tensor back = root.rotation.transpose();
  return calc_mass_properties(tree).seen_from_outside({-(back * root.position), back});
}

}  // namespace

TEST_CASE("what a scenario in space says, written and read again, is the same") {
  for (const char* name : kNames) {
    CAPTURE(name);
    const Scenario scenario = test::read_shipped(name);
    REQUIRE(scenario.space.has_value());
    const std::string json = scenario.to_json();
    CHECK(parse_scenario(document_of(json), scenario.name).to_json() == json);
  }
}

TEST_CASE("every key of a scenario in space is documented") {
  const std::string documentation = file_text(SPOKE_DOCS_DIR "/scenario.md");
  for (const char* name : kNames)
    check_documented(Json::parse(test::read_shipped(name).to_json()), documentation);
}

TEST_CASE("the NREL blade has the published mass and moments") {
  const spatial::MassProperties blade = blade_of(test::read_shipped("nrel_5mw_rotor"));
  // NREL/TP-500-38060, table 2-2.
  CHECK(blade.mass == Approx(17740.0).epsilon(0.003));
  CHECK(blade.first_moment.x() == Approx(363231.0).epsilon(0.003));
  CHECK(blade.inertia(1, 1) == Approx(11776047.0).epsilon(0.003));
  CHECK(blade.inertia(2, 2) == Approx(11776047.0).epsilon(0.003));
}

TEST_CASE("the NREL rotor's axis points downwind and down by 5 degrees") {
  const spatial::Model model = *test::read_shipped("nrel_5mw_rotor").space;
  CHECK(model.hub.axis.norm() == Approx(1.0).epsilon(1e-8));
  CHECK(std::atan2(-model.hub.axis.z(), model.hub.axis.x()) * 180.0 / 3.14159265358979 ==
        Approx(5.0));
  CHECK(calc_motion(model.hub.drive, 60.0).angle / (2.0 * 3.14159265358979) == Approx(12.1));
}

TEST_CASE("the rotor of Wu and Haug in space has the mass and stiffness of the planar one") {
  const Scenario space = test::read_shipped("spatial_wu_haug"),
                 plane = test::read_shipped("wu_haug_rotor");
  const Blade& planar = plane.rotor.blades[0];
  const spatial::Beam& beam = space.space->blades[0].beam;
  CHECK(beam.sections.axial_stiffness[0] == Approx(planar.youngs_modulus * planar.area));
  CHECK(beam.sections.lag_stiffness[0] == Approx(planar.youngs_modulus * planar.second_moment));
  CHECK(beam.sections.mass_per_length[0] == Approx(planar.density * planar.area));
  CHECK(space.space->blades[2].azimuth == plane.rotor.blades[2].azimuth);
  CHECK(space.integration.step == plane.integration.step);
}

TEST_CASE("the heavy top has the data of its source") {
  const spatial::Model model = *test::read_shipped("heavy_top").space;
  const auto& top = std::get<spatial::RigidBody>(model.subsystems[0].bodies[0].shape);
  CHECK(top.mass == 15.0);
  CHECK(top.center == spatial::Vector(0.0, 1.0, 0.0));
  CHECK(top.inertia.diagonal() == spatial::Vector(0.234375, 0.46875, 0.234375));
  const auto& joint = model.subsystems[0].joints[0].joint;
  CHECK(joint.kind == spatial::JointKind::spherical);
  CHECK(joint.coordinates[1].initial_speed == 150.0);
  CHECK(model.gravity.z() == -9.81);
}

TEST_CASE("the satellite's torques have no net impulse") {
  const spatial::Model model = *test::read_shipped("satellite_booms").space;
  REQUIRE(model.hub_loads.size() == 1);
  CHECK(model.hub_loads[0].factor.integral(12.0) > 5.0);
  CHECK(std::abs(model.hub_loads[0].factor.integral(24.0)) < 1e-12);
  CHECK(model.blades.size() == 4);
}

TEST_CASE("the branched appendage has children at a node within a beam, at its tip and on a body") {
  const spatial::Tree tree = build_trees(*test::read_shipped("tree_of_bodies").space).front();
  REQUIRE(tree.bodies.size() == 5);
  std::vector<int> children(tree.bodies.size(), 0);
  for (const spatial::TreeBody& body : tree.bodies)
    if (body.parent >= 0) ++children[static_cast<std::size_t>(body.parent)];
  CHECK(children == std::vector<int>{2, 1, 1, 0, 0});
}
