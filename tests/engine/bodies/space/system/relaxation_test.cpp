// A chain under strong tension, with steps at which a plain iteration swings. Its tension is that
// of weight, which is on the right-hand side, unlike that of rotation.

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/bodies/space/system/models.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// Light links in a row on hinges, which carry a heavy bob: the weight pulls at them, and what it
/// makes of their motion across is on the right-hand side.
std::string make_chain(int links) {
  std::string text = "[[subsystem]]\nname = \"chain\"\n", joints;
  std::string parent = "hub";
  for (int k = 1; k <= links; ++k) {
    const std::string name = "link" + std::to_string(k);
    const bool is_bob = k == links;
    text += "[[subsystem.body]]\nname = \"" + name + "\"\nkind = \"rigid\"\n" +
            (is_bob ? "mass = 60.0\ncenter = [0, 0, -0.3]\ninertia = [0.5, 0.5, 0.5]\n"
                    : "mass = 0.2\ncenter = [0, 0, -0.1]\ninertia = [1e-3, 1e-3, 1e-4]\n");
    joints +=
        "[[subsystem.joint]]\nname = \"" + name + "\"\nparent = \"" + parent + "\"\nchild = \"" +
        name + "\"\nkind = \"universal\"\naxes = [[1, 0, 0], [0, 1, 0]]\noffset = [0, 0, " +
        (k == 1 ? "0" : "-0.2") + "]\ninitial_speed = [" + (k == 2 ? "1.0" : "0.2") + ", -0.3]\n";
    parent = name;
  }
  return text + joints;
}

Scenario make_swinging_chain(double step) {
  return make_scenario(make_text("[hub]\ndrive = { kind = \"fixed\" }\n", make_chain(5), kGravity),
                       step, 0.24, IntegrationMethod::generalized_alpha);
}

Simulation run(const Scenario& scenario, ExecutorKind executor = ExecutorKind::serial,
               int threads = 1, int window = 1) {
  Simulation simulation(scenario, {Formulation::structured, executor, threads, window});
  simulation.run_until(scenario.integration.duration);
  return simulation;
}

constexpr const char* kAngles[] = {"chain.link1.1", "chain.link2.1", "chain.link4.2",
                                   "chain.tip.y"};

}  // namespace

TEST_CASE("tension: an iteration that swings ends where a plain one does, in half the passes") {
  Scenario scenario = make_swinging_chain(4e-3);
  const Simulation relaxed = run(scenario);
  scenario.integration.iterations = 40;  // plain
  const Simulation plain = run(scenario);
  CHECK(relaxed.evaluations() < 12 * relaxed.steps());
  for (const char* sensor : kAngles)
    CHECK(relaxed.sensor(sensor) == doctest::Approx(plain.sensor(sensor)).epsilon(1e-6));
}

TEST_CASE("tension: steps are made at which a plain iteration does not converge") {
  Scenario scenario = make_swinging_chain(6e-3);
  const Simulation large = run(scenario);
  const Simulation small = run(make_swinging_chain(1e-3));
  CHECK(large.evaluations() < 16 * large.steps());
  for (const char* sensor : kAngles)
    CHECK(large.sensor(sensor) == doctest::Approx(small.sensor(sensor)).epsilon(0.05));
  scenario.integration.iterations = 40;  // plain
  CHECK_THROWS_AS(run(scenario), DivergenceError);
}

TEST_CASE("tension: relaxed runs have one state, whatever executes them") {
  const Scenario scenario = make_swinging_chain(6e-3);
  const std::uint64_t known = run(scenario).state_hash();
  CHECK(run(scenario, ExecutorKind::serial, 1, 7).state_hash() == known);
  CHECK(run(scenario, ExecutorKind::flow_graph, 2).state_hash() == known);
  CHECK(run(scenario, ExecutorKind::flow_graph, 3, 5).state_hash() == known);
}
