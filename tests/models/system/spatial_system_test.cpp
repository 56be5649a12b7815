#include "models/system/spatial_system.h"

#include <doctest/doctest.h>

#include <string>

#include "models/scenario.h"

using namespace spoke;

TEST_CASE("equal blades in space share their bodies, and other blades do not") {
  Scenario scenario =
      read_scenario(std::string(SPOKE_MODELS_DIR) + "/spatial_wu_haug.toml", {"blade.count=3"});
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
  CHECK(first[0].body != first[1].body);
}
