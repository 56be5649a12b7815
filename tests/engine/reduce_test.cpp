// Solids reduced for people to see, and kept with the scenario.

#include "engine/reduce.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "models/error.h"
#include "models/reader/spatial/model_check.h"
#include "tests/approx.h"
#include "tests/contains.h"
#include "tests/engine/solids/solid_models.h"
#include "tests/message_of.h"
#include "tests/shipped.h"

using namespace spoke;
using namespace spoke::test;
using spatial::Vector;
using spoke::testing::approx;

namespace {

/// A bar of 1 x 0.05 x 0.05 m, clamped at its root: E 2e11 Pa, nu 0, rho 8000 kg/m^3.
spatial::SolidBody make_cantilever() {
  GridMesh grid;
  grid.cells = {10, 1, 1};
  grid.lengths = {1.0, 0.05, 0.05};
  grid.shift = {0.0, -0.025, -0.025};
  grid.kind = spatial::ElementKind::hex20;
  spatial::SolidBody body = make_bar(grid, {2e11, 0.0, 8000.0});
  body.interfaces.pop_back();
  body.modes = 4;
  body.damping = {0.02};
  return body;
}

/// Two subsystems, each a body of these; meshes are read.
Scenario make_pair(const spatial::SolidBody& first, const spatial::SolidBody& second) {
  Scenario scenario;
  spatial::Model& model = scenario.space.emplace();
  model.hub.drive = FixedDrive{};
  for (const spatial::SolidBody* body : {&first, &second}) {
    spatial::Subsystem& subsystem = model.subsystems.emplace_back();
    subsystem.name = "bar" + std::to_string(model.subsystems.size());
    subsystem.bodies = {{"body", *body}};
    subsystem.joints.emplace_back().child = "body";
  }
  scenario.integration.step = 1e-4;
  scenario.integration.duration = 1e-2;
  spatial::read_model_files(model);
  return scenario;
}

spatial::SolidBody& body_of(Scenario& scenario, std::size_t subsystem) {
  return std::get<spatial::SolidBody>(scenario.space->subsystems[subsystem].bodies[0].shape);
}

}  // namespace

TEST_CASE("a cantilever of solids has the frequencies and shapes of a beam") {
  const spatial::SolidBody body = make_cantilever();
  const std::vector<SolidReduction> solids = reduce(make_pair(body, body));
  REQUIRE(solids.size() == 2);
  const SolidReduction& bar = solids[0];
  CHECK(bar.subsystem == "bar1");
  CHECK(bar.body == "body");
  CHECK(bar.elements == 10);
  CHECK_FALSE(bar.has_locking_elements);
  CHECK(bar.mass == approx(20.0));
  REQUIRE(bar.interfaces.size() == 1);
  CHECK(bar.interfaces[0].nodes == 8);
  CHECK(bar.interfaces[0].point.norm() < 1e-15);
  REQUIRE(bar.frequencies.size() == 4);
  // Euler and Bernoulli, (beta L)^2 / (2 pi L^2) sqrt(EI / (rho A)): shear and rotary inertia lower
  // them by less than 1 % and, in the second mode, 3 %.
  const double unit = std::sqrt(2e11 * 0.05 * 0.05 / 12.0 / 8000.0) / (2.0 * std::numbers::pi);
  for (const int axis : {0, 1}) {
    CHECK(bar.frequencies[static_cast<std::size_t>(axis)] == approx(3.5160 * unit).epsilon(0.01));
    CHECK(bar.frequencies[static_cast<std::size_t>(2 + axis)] ==
          approx(22.0345 * unit).epsilon(0.03));
  }
  // Nothing but the root is held: the modes are those of vibration.
  REQUIRE(bar.vibration_frequencies.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(bar.frequencies[k] == approx(bar.vibration_frequencies[k]));
    CHECK(bar.damping_ratios[k] == approx(0.02));
  }
  // The tip of a mode of unit mass moves by 2 / sqrt(m); the root does not.
  REQUIRE(bar.shapes.size() == 4);
  for (std::size_t i = 0; i < bar.nodes.size(); ++i) {
    const double moved = std::hypot(bar.shapes[0][i].y(), bar.shapes[0][i].z());
    if (bar.nodes[i].x() == 0.0) CHECK(bar.shapes[0][i].norm() < 1e-12);
    if (bar.nodes[i].x() == 1.0) CHECK(moved == approx(2.0 / std::sqrt(20.0)).epsilon(0.02));
  }
}

TEST_CASE("equal solids are reduced once, and what was made is kept with the scenario") {
  const spatial::SolidBody body = make_cantilever();
  spatial::SolidBody other = body;
  other.modes = 3;
  int calls = 0;
  ReduceOptions options;
  options.progress = [&calls](const std::string& step, double done) {
    ++calls;
    CHECK(step.starts_with("bar"));
    CHECK(contains(step, " / body: "));
    CHECK(done >= 0.0);
    CHECK(done <= 1.0);
  };
  const std::vector<SolidReduction> equal = reduce(make_pair(body, body), options);
  CHECK(equal[0].same_as == 0);
  CHECK(equal[1].same_as == 0);
  CHECK(equal[1].subsystem == "bar2");
  CHECK(equal[1].frequencies == equal[0].frequencies);
  const Scenario scenario = make_pair(body, other);
  const std::vector<SolidReduction> unlike = reduce(scenario, options);
  CHECK(unlike[1].same_as == 1);
  CHECK(unlike[1].frequencies.size() == 3);
  calls = 0;
  const Scenario copy = scenario;
  const std::vector<SolidReduction> again = reduce(copy, options);
  CHECK(calls == 0);
  CHECK(again[1].seconds == unlike[1].seconds);
  options.anew = true;
  CHECK(reduce(copy, options)[1].frequencies == unlike[1].frequencies);
  CHECK(calls > 0);
}

TEST_CASE("what code changes of a solid after its mesh was read is heeded") {
  const spatial::SolidBody body = make_cantilever();
  Scenario scenario = make_pair(body, body);
  body_of(scenario, 1).modes = 2;
  body_of(scenario, 1).damping = {0.5};
  const std::vector<SolidReduction> solids = reduce(scenario);
  CHECK(solids[0].frequencies.size() == 4);
  REQUIRE(solids[1].frequencies.size() == 2);
  CHECK(solids[1].damping_ratios[0] == approx(0.5));
  CHECK(
      Simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1}).size().coordinates ==
      6);
}

TEST_CASE("errors of the reduction name the key of the body") {
  spatial::SolidBody body = make_cantilever();
  Scenario scenario = make_pair(body, body);
  body_of(scenario, 1).modes = 9999;
  const auto check = [](const auto& work) {
    try {
      work();
      FAIL("nothing was thrown");
    } catch (const InputError& error) {
      CHECK(error.place().key == "subsystem.2.body.1.modes");
      CHECK(contains(error.what(), "subsystem.2.body.1.modes: 9999 modes, expected at most"));
    }
  };
  check([&] { reduce(scenario); });
  check([&] { const Simulation simulation(scenario); });
}

TEST_CASE("linear elements are told, and a model without solids has nothing to reduce") {
  GridMesh grid = slender_grid();
  grid.kind = spatial::ElementKind::hex8;
  const spatial::SolidBody body = make_bar(grid, rubber());
  CHECK(reduce(make_pair(body, body))[0].has_locking_elements);
  CHECK(reduce(read_shipped("heavy_top")).empty());
  CHECK(reduce(read_shipped("wu_haug_rotor")).empty());
}
