#include "program/run_report/animation.h"

#include <doctest/doctest.h>

#include "models/space/quaternion.h"
#include "tests/approx.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/program/run_report/scenarios.h"

using namespace spoke;
using namespace spoke::run_report;
using namespace spoke::test;
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
  const scene::Scene& scene = animation.scene();
  REQUIRE(scene.subsystems.size() == 2);
  const std::size_t nodes = scene.nodes.size();
  CHECK(nodes == 2 * 2 * 4);  // each body has its own
  const auto tip = static_cast<std::size_t>(scene.tips[0]);
  CHECK(scene.nodes[tip].p.x() == approx(6.5));
  CHECK(scene.nodes.back().p.x() == approx(-6.5));
  // In the plane each node has two displacements and an angle.
  REQUIRE(animation.displacements().size() == 2 * 2 * nodes);
  REQUIRE(animation.rotations().size() == 2 * nodes);
  CHECK(animation.displacements()[2 * (nodes + tip) + 1] ==
        approx(simulation.sensor("blade1.tip.y")));
  REQUIRE(animation.hub().size() == 2 * 4);
  CHECK(animation.hub()[7] == approx(simulation.sensor("hub.angle")));
  CHECK(animation.groups().empty());
  CHECK(animation.axial_forces().size() == 2 * 2 * 2 * 3);
}

TEST_CASE("an animation in space has the poses of groups, and of a free hub") {
  Scenario scenario = parse_scenario(make_text(kFlyingHub, kTree), "test");
  Simulation simulation(scenario, test_options());
  Animation animation(simulation);
  animation.add(simulation);
  simulation.run_until(0.5);
  animation.add(simulation);
  const scene::Scene& scene = animation.scene();
  REQUIRE(animation.times().size() == 2);
  REQUIRE(animation.hub().size() == 2 * 7);
  CHECK(animation.hub()[7] == approx(simulation.sensor("hub.x")));
  CHECK(animation.hub()[3] == 1.0F);
  const float* q = animation.hub().data() + 10;
  const space::Rotation R = make_rotation(space::Quaternion{q[0], {q[1], q[2], q[3]}});
  CHECK((R.axes - simulation.hub_pose().rotation).norm() < 1e-6);
  REQUIRE(animation.groups().size() == 2 * 7 * static_cast<std::size_t>(scene.groups - 1));
  REQUIRE(animation.displacements().size() == 2 * 3 * scene.nodes.size());
  REQUIRE(animation.rotations().size() == 2 * 3 * scene.nodes.size());
}

TEST_CASE("an animation of many nodes has fewer frames, one of very many a part of the nodes") {
  Scenario scenario = test_scenario();
  for (Blade& blade : scenario.rotor.blades) blade.elements = 250;
  const Animation fewer(Simulation(scenario, test_options()));
  // A node has three numbers, an element two.
  CHECK(fewer.most_frames() == Animation::kMostNumbers / (3 * 4 * 251 + 2 * 4 * 250));
  CHECK(fewer.scene().nodes.size() == 4 * 251);
  for (Blade& blade : scenario.rotor.blades) blade.elements = 999;
  const Animation part(Simulation(scenario, test_options()));
  CHECK(part.scene().nodes.size() <= Animation::kMostNodes + 4);  // and the bodies' ends
  CHECK(part.scene().nodes.back().p.x() == approx(-6.5));
}
