#include "models/system/system.h"

#include <doctest/doctest.h>

#include <cmath>

#include "models/scenario.h"
#include "tests/models/reader/loop_texts.h"

using namespace spoke;

TEST_CASE("loops of blades in the plane end where bodies do, and are turned by the azimuth") {
  const Scenario scenario = parse_scenario(test::kPlaneLoopText, "f.toml");
  const System<Plane> system = make_system(scenario.rotor);
  REQUIRE(system.anchors.size() == 1);
  for (const double sign : {1.0, -1.0}) {
    const Subsystem<Plane>& blade = system.subsystems[sign > 0.0 ? 0 : 1];
    REQUIRE(blade.loops.size() == 1);
    const LoopModel& loop = blade.loops[0];
    CHECK(loop.from.body == 1);  // the second one of 2 m
    CHECK(loop.from.offset.p == space::Position(0.0, 0.0, 0.0));
    CHECK(loop.to.anchor == 0);
    const space::Position place(sign * 1.0, sign * 2.0, 0.0);
    CHECK((loop.to.offset.p - place).norm() <= 1e-15);
    // Turned by its orientation of 0.5 rad as well.
    const space::Position x = loop.to.offset.R * space::Position(1.0, 0.0, 0.0);
    CHECK(x.x() == doctest::Approx(sign * std::cos(0.5)));
    CHECK(x.y() == doctest::Approx(sign * std::sin(0.5)));
  }
}
