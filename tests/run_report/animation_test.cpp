#include "engine/run_report/animation.h"

#include <doctest/doctest.h>

#include "tests/approx.h"
#include "tests/run_report/scenarios.h"

using namespace spoke;
using namespace spoke::run_report;
using spoke::testing::approx;

TEST_CASE("an animation has the nodes' displacements and the hub's motion at its times") {
  Simulation simulation(test_scenario(), test_options());
  Animation animation(simulation);
  CHECK(animation.most_frames() == Animation::kMostFrames);
  animation.add(simulation);
  animation.add(simulation);  // the same time again: nothing new
  simulation.run_until(1.0);
  animation.add(simulation);
  REQUIRE(animation.times() == std::vector<double>{0.0, 1.0});
  REQUIRE(animation.blades().size() == 2);
  const std::size_t nodes = animation.blades()[0].undeformed.size();
  CHECK(nodes == 7);
  CHECK(animation.blades()[0].nodes_per_body == 3);
  CHECK(animation.blades()[0].undeformed.back().x() == approx(6.5));
  CHECK(animation.blades()[1].undeformed.back().x() == approx(-6.5));
  REQUIRE(animation.displacements().size() == 2 * 2 * 2 * nodes);
  CHECK(animation.displacements()[4 * nodes + 2 * nodes - 1] ==
        approx(simulation.sensor("blade1.tip.y")));
  CHECK(animation.hub()[5] == approx(simulation.sensor("hub.angle")));
  CHECK(animation.largest_displacement() >=
        std::abs(animation.displacements()[4 * nodes + 2 * nodes - 1]));
}

TEST_CASE("a animation of many nodes has fewer frames, one of very many a part of the nodes") {
  Scenario scenario = test_scenario();
  for (Blade& blade : scenario.rotor.blades) blade.elements = 250;
  const Animation fewer(Simulation(scenario, test_options()));
  CHECK(fewer.most_frames() == Animation::kMostNumbers / (2 * 2 * 501));
  CHECK(fewer.blades()[0].undeformed.size() == 501);
  for (Blade& blade : scenario.rotor.blades) blade.elements = 999;
  const Animation part(Simulation(scenario, test_options()));
  CHECK(part.blades()[0].undeformed.size() == 1000);
  CHECK(part.blades()[0].nodes_per_body == 0);
  CHECK(part.blades()[0].undeformed.back().x() == approx(6.5));
}
