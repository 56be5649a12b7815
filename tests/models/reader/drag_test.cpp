// Drag of bodies as files have it: what is read, written again and refused.

#include <doctest/doctest.h>

#include <string>

#include "models/scenario.h"
#include "tests/contains.h"
#include "tests/message_of.h"
#include "tests/models/inline_toml.h"

using namespace spoke;
using namespace spoke::test;

namespace {

std::string make_drag_text(const std::string& of_beam, const std::string& of_rigid) {
  return R"(world = "space"
[hub.drive]
kind = "fixed"
[[subsystem]]
name = "mast"
[[subsystem.body]]
name = "boom"
kind = "beam"
length = 2.0
sections = { mass_per_length = 1, axial_stiffness = 1e6, flap_stiffness = 1e3, lag_stiffness = 1e3, torsion_stiffness = 1e3 }
drag = )" +
         of_beam +
         R"(
[[subsystem.body]]
name = "ball"
kind = "rigid"
mass = 1
inertia = 1
drag = )" +
         of_rigid +
         R"(
[[subsystem.joint]]
parent = "hub"
child = "boom"
kind = "fixed"
[[subsystem.joint]]
parent = "boom"
child = "ball"
kind = "fixed"
[air]
[integration]
duration = 1.0
)";
}

const std::string kBoom = "{ diameter = 0.2 }", kBall = "{ area = [1, 2, 3] }";

std::string refusal(const std::string& of_beam, const std::string& of_rigid) {
  return message_of([&] { parse_scenario(make_drag_text(of_beam, of_rigid), "f.toml"); });
}

}  // namespace

TEST_CASE("drag of bodies: what is read is written, and read again") {
  const Scenario scenario = parse_scenario(
      make_drag_text("{ station = [0.5, 1.0, 1.5], diameter = [0.1, 0.2, 0.3], coefficient = 1.2 }",
                     "{ area = [1, 2, 3], point = [0, 0, 0.5] }"),
      "f.toml");
  const auto& bodies = scenario.space->subsystems.at(0).bodies;
  REQUIRE(bodies[0].drag.has_value());
  CHECK(bodies[0].drag->diameter == std::vector<double>{0.1, 0.2, 0.3});
  CHECK(bodies[0].drag->coefficient == std::vector<double>{1.2, 1.2, 1.2});
  REQUIRE(bodies[1].drag.has_value());
  CHECK(bodies[1].drag->area.y() == 2.0);
  CHECK(bodies[1].drag->point.z() == 0.5);
  const std::string json = scenario.to_json();
  CHECK(parse_scenario(document_of(json), "f.toml").to_json() == json);
  // A number is for all stations, which are the ends unless they are given.
  const Scenario plain = parse_scenario(make_drag_text(kBoom, kBall), "f.toml");
  CHECK(plain.space->subsystems[0].bodies[0].drag->station == std::vector<double>{0.0, 2.0});
}

TEST_CASE("drag of bodies: what is wrong is refused by its key") {
  CHECK(contains(refusal("{ coefficient = 1.0 }", kBall), "drag.diameter: is missing"));
  CHECK(contains(refusal("{ diameter = [1, 2, 3] }", kBall),
                 "drag.diameter: has 3 values, expected 2, one for each station"));
  CHECK(contains(refusal("{ station = [0, 3], diameter = 1 }", kBall),
                 "drag.station.2: is 3, expected"));
  CHECK(contains(refusal("{ station = [1], diameter = 1 }", kBall),
                 "drag.station: has 1, expected 2 or more"));
  CHECK(contains(refusal("{ diameter = -1 }", kBall), "drag.diameter: is -1, expected"));
  CHECK(contains(refusal("{ diameter = 1, area = [1, 1, 1] }", kBall),
                 "drag.area: would be ignored, expected only of a rigid body"));
  CHECK(contains(refusal(kBoom, "{ point = [0, 0, 1] }"), "drag.area: is missing"));
  CHECK(contains(refusal(kBoom, "{ area = [1, -1, 1] }"), "drag.area"));
  CHECK(contains(refusal(kBoom, "{ area = [1, 1, 1], diameter = 1 }"),
                 "drag.diameter: would be ignored, expected only of a beam"));
  CHECK(contains(refusal(kBoom, "{ areas = [1, 1, 1] }"), "areas"));
}

TEST_CASE("drag of bodies: what towers do to the wind of blades is read, written and refused") {
  const std::string json =
      read_scenario(std::string(SPOKE_MODELS_DIR) + "/nrel_5mw_turbine.toml",
                    {"air={}",
                     "support.body.1.drag={diameter=[6, 4], potential=\"bak\", "
                     "shadow=\"powles\"}"})
          .to_json();
  CHECK(contains(json, "\"bak\""));
  CHECK(contains(json, "\"powles\""));
  const Scenario again = parse_scenario(document_of(json), "f.toml");
  CHECK(again.to_json() == json);
  const spatial::BodyDrag& drag = *again.space->subsystems.back().bodies.front().drag;
  CHECK(drag.potential == spatial::TowerPotential::bak);
  CHECK(drag.shadow == spatial::TowerShadow::powles);
  CHECK(contains(refusal("{ diameter = 1, potential = \"cylinder\" }", kBall),
                 "drag.potential: would be ignored, expected only of a beam of a support"));
  CHECK(contains(refusal("{ diameter = 1, shadow = \"powles\" }", kBall),
                 "drag.shadow: would be ignored, expected only of a beam of a support"));
  CHECK(contains(refusal(kBoom, "{ area = [1, 1, 1], potential = \"bak\" }"),
                 "drag.potential: would be ignored, expected only of a beam"));
  CHECK(contains(refusal("{ diameter = 1, potential = \"stokes\" }", kBall),
                 "drag.potential: is \"stokes\", expected \"none\", \"cylinder\" or \"bak\""));
}
