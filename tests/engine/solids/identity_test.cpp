// Saved states know the mesh that they belong to.

#include <doctest/doctest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "engine/simulation.h"
#include "engine/simulation/model_identity.h"
#include "models/error.h"
#include "tests/contains.h"
#include "tests/engine/solids/solid_models.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

using namespace spoke;
using namespace spoke::test;

namespace {

Scenario make_held_bar(const spatial::SolidBody& body) {
  Scenario scenario;
  spatial::Model& model = scenario.space.emplace();
  model.hub.drive = FixedDrive{};
  spatial::Subsystem& subsystem = model.subsystems.emplace_back();
  subsystem.name = "holder";
  subsystem.bodies = {{"bar", body}};
  subsystem.joints.emplace_back().child = "bar";
  scenario.integration.step = 1e-3;
  scenario.integration.duration = 0.01;
  return scenario;
}

std::string identify(const Scenario& scenario) {
  return make_identity(scenario, Formulation::structured, scenario.integration.step);
}

}  // namespace

TEST_CASE("a saved state belongs to the content of its meshes, whatever their files are called") {
  spatial::SolidBody body = make_bar(slender_grid(), rubber());
  body.modes = 4;
  const Scenario scenario = make_held_bar(body);
  const std::string identity = identify(scenario);

  // The same mesh, made once more.
  body.mesh = std::make_shared<const spatial::SolidMesh>(*body.mesh);
  CHECK(find_difference(identity, identify(make_held_bar(body))) == "");

  spatial::SolidMesh moved = *body.mesh;
  const std::size_t inner = moved.nodes.size() / 2;
  moved.nodes[inner].x() += 1e-9;
  body.mesh = std::make_shared<const spatial::SolidMesh>(moved);
  const Scenario other = make_held_bar(body);
  const std::string difference = find_difference(identity, identify(other));
  CAPTURE(difference);
  CHECK(difference.starts_with("subsystem.1.body.1.mesh is \"contents "));
  CHECK(contains(difference, " in the saved state and \"contents "));

  const SimulationOptions options{Formulation::structured, ExecutorKind::serial, 1};
  const SavedState state = Simulation(scenario, options).save();
  Simulation into(other, options);
  CHECK_THROWS_AS(into.restore(state), InputError);
  Simulation same(scenario, options);
  same.restore(state);
}
