#include "models/system/spatial_system.h"

#include <doctest/doctest.h>

#include <string>

#include "models/scenario.h"
#include "tests/shipped.h"

using namespace spoke;

TEST_CASE("equal blades in space share their bodies, and other blades do not") {
  Scenario scenario = test::read_shipped("spatial_wu_haug", {"blade.count=3"});
  scenario.space->blades[1].beam.point_masses.push_back({3.0, 0.1});
  const System<Space> system = make_system(*scenario.space);
  const auto& first = system.subsystems[0].bodies;
  const auto& other = system.subsystems[1].bodies;
  const auto& equal = system.subsystems[2].bodies;
  REQUIRE(first.size() == 4);
  for (std::size_t j = 0; j < first.size(); ++j) {
    CHECK(first[j].body == equal[j].body);
    CHECK(first[j].body != other[j].body);
  }
}

TEST_CASE("equal parts of a uniform blade share their bodies, wherever they are") {
  // Their lengths differ by round-off: 8 m times (j + 1)/7 less 8 m times j/7.
  Scenario scenario = test::read_shipped("spatial_wu_haug", {"blade.count=1", "blade.bodies=7"});
  const auto make = [&scenario] { return make_system(*scenario.space).subsystems[0].bodies; };
  const auto bodies = make();
  REQUIRE(bodies.size() == 7);
  for (std::size_t j = 0; j < bodies.size(); ++j) {
    const space::FlexibleBody& body = *bodies[j].body->flexible();
    CHECK(body.stations.front() == 0.0);
    CHECK(bodies[j].begin == doctest::Approx(8.0 * static_cast<double>(j) / 7.0));
    CHECK(body.length() == doctest::Approx(8.0 / 7.0).epsilon(1e-14));
    if (j + 1 < bodies.size()) CHECK(bodies[j].body == bodies[0].body);
  }
  CHECK(bodies[6].body != bodies[0].body);  // it carries none

  SUBCASE("but for one with a small mass") {
    scenario.space->blades[0].beam.point_masses.push_back({2.5 * 8.0 / 7.0, 0.1});
    const auto heavier = make();
    CHECK(heavier[0].body == heavier[1].body);
    CHECK(heavier[2].body != heavier[1].body);
    CHECK(heavier[3].body == heavier[1].body);
    CHECK(heavier[2].begin + heavier[2].body->flexible()->stations.front() ==
          doctest::Approx(16.0 / 7.0));
  }
  SUBCASE("but for those where sections change") {
    spatial::Sections& sections = scenario.space->blades[0].beam.sections;
    REQUIRE(sections.station.size() == 2);
    sections.twist = {0.0, 0.1};
    const auto twisted = make();
    CHECK(twisted[0].body != twisted[1].body);
    CHECK(twisted[1].begin == 0.0);
    CHECK(twisted[1].body->flexible()->stations.front() == doctest::Approx(8.0 / 7.0));
  }
}
