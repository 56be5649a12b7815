// What a simulation says of its closed loops: counts by Gruebler's rule, and rows that geometry
// makes redundant.

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "tests/shipped.h"

using namespace spoke;

namespace {

LoopsAtStart start_of(const std::string& name, const std::vector<std::string>& assignments = {}) {
  const Scenario scenario = test::read_shipped(name, assignments);
  return Simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1}).loops_at_start();
}

}  // namespace

TEST_CASE("mechanisms have the freedoms that they should have") {
  struct Expected {
    const char* name;
    int joints, rows, redundant, mobility;
  };
  // Closed by ball joints, planar loops lock their normal twice.
  for (const Expected& expected :
       {Expected{"andrews_squeezer", 7, 9, 3, 1}, Expected{"four_bar", 5, 6, 2, 1},
        Expected{"bricard", 5, 5, 1, 1}, Expected{"vehicle", 6, 4, 0, 2}}) {
    CAPTURE(expected.name);
    const LoopsAtStart start = start_of(expected.name);
    for (const SubsystemFreedoms& own : start.subsystems) {
      CHECK(own.joints == expected.joints);
      CHECK(own.deformations == 0);
      CHECK(own.rows == expected.rows);
      CHECK(own.independent == expected.rows - expected.redundant);
      CHECK(own.mobility == expected.mobility);
    }
    CHECK(std::ssize(start.redundant) == expected.redundant);
    CHECK(start.moved.empty());
  }
  CHECK(start_of("vehicle").subsystems.size() == 4);
  CHECK(start_of("vehicle").subsystems[1].name == "front_right");
  CHECK(start_of("wu_haug_rotor").subsystems.empty());
}

TEST_CASE("redundant rows are named") {
  const LoopsAtStart squeezer = start_of("andrews_squeezer");
  REQUIRE(squeezer.redundant.size() == 3);
  CHECK(squeezer.redundant[0] == "squeezer / lever_end: displacement along z");
  const LoopsAtStart ring = start_of("bricard");
  REQUIRE(ring.redundant.size() == 1);
  CHECK(ring.redundant[0].starts_with("ring / hinge_6: "));
}

TEST_CASE("joints that were moved are named, and how far") {
  const LoopsAtStart start = start_of("four_bar", {"subsystem.1.joint.1.initial=0.1"});
  REQUIRE_FALSE(start.moved.empty());
  // The least change leaves the bars parallel again: 0.1 is shared out.
  for (const MovedJoint& joint : start.moved) {
    CHECK(joint.joint.starts_with("linkage / "));
    CHECK(joint.unit == "rad");
    CHECK(std::abs(joint.by) < 0.11);
  }
}
