// Solids in scenario files, and in models filled in code.

#include <doctest/doctest.h>

#include <numbers>

#include "models/reader/scenario_check.h"
#include "models/reader/spatial/model_check.h"
#include "tests/models/inline_toml.h"
#include "tests/models/reader/solid_texts.h"
#include "tests/models/reader/spatial_texts.h"
#include "tests/models/solid/grid_mesh.h"

using doctest::Approx;
using namespace spoke;
using namespace spoke::spatial;
using spoke::test::edited;
using spoke::test::kSolidText;
using spoke::test::message_of;

namespace {

const SolidBody& solid_of(const Scenario& scenario) {
  return std::get<SolidBody>(scenario.space->subsystems.front().bodies.front().shape);
}

/// A bar of 1 m on the hub, in code.
Model make_bar_model() {
  test::GridMesh grid;
  grid.cells = {4, 1, 1};
  grid.lengths = {1.0, 0.1, 0.1};
  SolidBody bar;
  bar.mesh = std::make_shared<const SolidMesh>(make_grid_mesh(grid));
  bar.material = SolidMaterial{7e10, 0.3, 2700.0};
  bar.interfaces = {{"root", "X0"}, {"tip", "X1"}};
  Model model;
  spatial::Subsystem subsystem;
  subsystem.name = "arm";
  subsystem.bodies = {{"bar", bar}};
  subsystem.joints.push_back({"hub", "bar"});
  model.subsystems = {subsystem};
  return model;
}

}  // namespace

TEST_CASE("a solid is read with its mesh") {
  const Scenario scenario = parse_scenario(kSolidText, "f.toml");
  const SolidBody& solid = solid_of(scenario);
  REQUIRE(solid.mesh);
  CHECK(solid.mesh->nodes.size() > 1000);
  CHECK(solid.length_scale == 1e-3);
  CHECK(solid.material == SolidMaterial{7e10, 0.33, 2700});
  CHECK(solid.modes == 4);
  CHECK(solid.damping == std::vector<double>{0.01});
  CHECK(solid.geometric_stiffening);
  CHECK(solid.coordinates == SolidCoordinates::reduced);
  CHECK(solid.frame == SolidFrame::clamped);
  REQUIRE(solid.interfaces.size() == 2);
  CHECK(solid.interfaces[0].kind == InterfaceKind::rigid);
  CHECK(solid.interfaces[1].kind == InterfaceKind::average);
  CHECK(solid.interfaces[1].nodes == NodeChoice("TIP"));
  CHECK(scenario.space->loads[0].traction == Vector(0, 0, 100));
}

TEST_CASE("keys of solids have their values") {
  const std::string text = edited(
      edited(kSolidText, "modes = 4\ndamping = 0.01",
             "up_to = 900.0\ndamping = [0.01, 0.02]\ngeometric_stiffening = false\n"
             "reference_frame = \"mean_axis\""),
      "nodes = \"TIP\"\nkind = \"average\"",
      "nodes = { box = { from = [0.399, -1, -1], to = [1, 1, 1] } }\npoint = [0.5, 0.05, 0.02]");
  const Scenario scenario = parse_scenario(text, "f.toml");
  const SolidBody& solid = solid_of(scenario);
  CHECK(!solid.modes);
  CHECK(solid.up_to == 900.0);
  CHECK(solid.damping == std::vector<double>{0.01, 0.02});
  CHECK(!solid.geometric_stiffening);
  CHECK(solid.frame == SolidFrame::mean_axis);
  CHECK(solid.interfaces[1].nodes == NodeChoice(BoxNodes{{0.399, -1, -1}, {1, 1, 1}}));
  CHECK(solid.interfaces[1].point == Vector(0.5, 0.05, 0.02));
}

TEST_CASE("an override changes a key of a solid") {
  const Scenario scenario = parse_scenario(kSolidText, "f.toml", {"subsystem.1.body.1.modes=10"});
  CHECK(solid_of(scenario).modes == 10);
  CHECK(message_of([] {
          parse_scenario(kSolidText, "f.toml", {"subsystem.1.body.1.interface.2.nodes=TOP"});
        }).starts_with("--set subsystem.1.body.1.interface.2.nodes=TOP: "));
}

TEST_CASE("files of meshes are relative to the scenario's folder") {
  const std::string text = edited(kSolidText, test::kBracket, "meshes/bracket.msh");
  const Scenario scenario = parse_scenario(text, std::string(SPOKE_MODELS_DIR) + "/f.toml");
  CHECK(solid_of(scenario).file == test::kBracket);
}

TEST_CASE("a scenario with solids is read again from its JSON") {
  const std::string text =
      edited(kSolidText, "nodes = \"TIP\"\nkind = \"average\"",
             "nodes = { cylinder = { point = [0.26, 0.05, 0], axis = [0, 0, 1], radius = 0.025, "
             "tolerance = 1e-4 } }");
  const Scenario scenario =
      parse_scenario(edited(edited(text, "quantity = \"displacement\"",
                                   "quantity = \"interface_force\"\n"
                                   "interface = \"tip\""),
                            "name = \"arm\"", "name = \"arm\"\ncount = 2\nazimuth = 0.2"),
                     "f.toml");
  const std::string json = scenario.to_json();
  const Scenario again = parse_scenario(test::document_of(json), "elsewhere/f.toml");
  CHECK(again.to_json() == json);
  CHECK(has_same_shape(solid_of(again), solid_of(scenario)) == false);  // meshes are their own
  CHECK(solid_of(again).interfaces == solid_of(scenario).interfaces);
}

TEST_CASE("bodies of one file share its mesh") {
  const std::string second =
      "[[subsystem.body]]\nname = \"other\"\nkind = \"solid\"\nmesh = \"" + test::kBracket +
      "\"\nscale = { length = 1e-3 }\nmaterial = { youngs_modulus = 7e10, poissons_ratio = 0.3, "
      "density = 1000 }\n" +
      test::kRoot + "[[subsystem.joint]]\nparent = \"hub\"\nchild = \"other\"\nkind = \"fixed\"\n";
  const Scenario scenario = parse_scenario(
      edited(kSolidText, "[[subsystem.joint]]", second + "[[subsystem.joint]]"), "f.toml");
  const auto& bodies = scenario.space->subsystems[0].bodies;
  REQUIRE(bodies.size() == 3);
  CHECK(std::get<SolidBody>(bodies[2].shape).mesh == solid_of(scenario).mesh);
}

TEST_CASE("loads and sensors on copies of a subsystem are on each, or on one by its number") {
  const std::string text = edited(kSolidText, "name = \"arm\"", "name = \"arm\"\ncount = 3");
  const Scenario scenario = parse_scenario(text, "f.toml");
  const Model& model = *scenario.space;
  REQUIRE(model.subsystems.size() == 3);
  CHECK(model.subsystems[1].azimuth == Approx(2.0 * std::numbers::pi / 3.0));
  REQUIRE(model.loads.size() == 3);
  CHECK(model.loads[2].place.subsystem == "arm3");
  REQUIRE(scenario.sensors.size() == 3);
  CHECK(prefix_of(scenario.sensors[1], 0) == "arm2.displacement");
  const Scenario one = parse_scenario(
      edited(text, "[[load]]\nsubsystem = \"arm\"", "[[load]]\nsubsystem = \"arm2\""), "f.toml");
  REQUIRE(one.space->loads.size() == 1);
  CHECK(one.space->loads[0].place.subsystem == "arm2");
}

TEST_CASE("a solid that is made in code is checked as one of a file") {
  Model model = make_bar_model();
  check_model(model);
  read_model_files(model);
  auto& bar = std::get<SolidBody>(model.subsystems[0].bodies[0].shape);
  REQUIRE(bar.kept);
  CHECK(find_interface(bar, "") == 1);
  const auto fault = [&] { return message_of([&] { check_model(model); }); };
  bar.interfaces[1].nodes = "X2";
  CHECK(fault().starts_with("subsystem.1.body.1.interface.2.nodes: is \"X2\", "));
  bar.interfaces[1].nodes = PlaneNodes{Vector(1, 0, 0), Vector::Zero()};
  CHECK(fault() ==
        "subsystem.1.body.1.interface.2.nodes.plane.normal: has length 0, expected a direction");
  bar.interfaces[1].nodes = "X1";
  bar.material->poissons_ratio = 0.5;
  CHECK(fault().starts_with("subsystem.1.body.1.material.poissons_ratio: is 0.5, expected "));
  bar.material->poissons_ratio = 0.3;
  bar.coordinates = SolidCoordinates::nodal;
  bar.damping = {0.01};
  CHECK(fault().starts_with("subsystem.1.body.1.damping: belongs to coordinates \"reduced\""));
  bar.damping.clear();
  bar.frame = SolidFrame::mean_axis;
  CHECK(fault().starts_with("subsystem.1.body.1.reference_frame: is \"mean_axis\""));
  bar.frame = SolidFrame::clamped;
  model.loads.push_back({{BladeChoice::all(), "arm", "bar"}});
  model.loads[0].force = Vector(0, 0, 1);
  check_model(model);
  model.loads[0].nodes = "Y0";
  model.loads[0].interface = "tip";
  CHECK(fault() == "load.1.nodes: given along with interface, expected only one of them");
  bar.mesh = nullptr;
  CHECK(fault().starts_with("subsystem.1.body.1.mesh: is missing, expected "));
}

TEST_CASE("a node is found by its number in the file") {
  SolidMesh mesh;
  mesh.nodes.resize(3);
  CHECK(find_node(mesh, 3) == 2);
  CHECK(!find_node(mesh, 0));
  CHECK(!find_node(mesh, 4));
  mesh.labels = {10, 20, 30};
  CHECK(find_node(mesh, 20) == 1);
  CHECK(!find_node(mesh, 2));
}
