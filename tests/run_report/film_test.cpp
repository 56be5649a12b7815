#include "engine/run_report/film.h"

#include <doctest/doctest.h>

#include "tests/approx.h"
#include "tests/run_report/scenarios.h"

using namespace spoke;
using namespace spoke::run_report;
using spoke::testing::approx;

TEST_CASE("a film has the nodes' displacements and the hub's motion at its times") {
  Simulation simulation(test_scenario(), test_options());
  Film film(simulation);
  CHECK(film.most_frames() == Film::kMostFrames);
  film.add(simulation);
  film.add(simulation);  // the same time again: nothing new
  simulation.run_until(1.0);
  film.add(simulation);
  REQUIRE(film.times() == std::vector<double>{0.0, 1.0});
  REQUIRE(film.blades().size() == 2);
  const std::size_t nodes = film.blades()[0].undeformed.size();
  CHECK(nodes == 7);
  CHECK(film.blades()[0].nodes_per_body == 3);
  CHECK(film.blades()[0].undeformed.back().x() == approx(6.5));
  CHECK(film.blades()[1].undeformed.back().x() == approx(-6.5));
  REQUIRE(film.displacements().size() == 2 * 2 * 2 * nodes);
  CHECK(film.displacements()[4 * nodes + 2 * nodes - 1] ==
        approx(simulation.sensor("blade1.tip.y")));
  CHECK(film.hub()[5] == approx(simulation.sensor("hub.angle")));
  CHECK(film.largest_displacement() >= std::abs(film.displacements()[4 * nodes + 2 * nodes - 1]));
}

TEST_CASE("a film of many nodes has fewer frames, one of very many a part of the nodes") {
  Scenario scenario = test_scenario();
  for (Blade& blade : scenario.rotor.blades) blade.elements = 250;
  const Film fewer(Simulation(scenario, test_options()));
  CHECK(fewer.most_frames() == Film::kMostNumbers / (2 * 2 * 501));
  CHECK(fewer.blades()[0].undeformed.size() == 501);
  for (Blade& blade : scenario.rotor.blades) blade.elements = 999;
  const Film part(Simulation(scenario, test_options()));
  CHECK(part.blades()[0].undeformed.size() == 1000);
  CHECK(part.blades()[0].nodes_per_body == 0);
  CHECK(part.blades()[0].undeformed.back().x() == approx(6.5));
}
