#include <doctest/doctest.h>

#include <memory>
#include <numbers>

#include "models/tree/tree.h"
#include "tests/approx.h"
#include "tests/models/reader/solid_texts.h"
#include "tests/models/reader/spatial_texts.h"
#include "tests/models/solid/grid_mesh.h"
#include "tests/models/space_model.h"

using doctest::Approx;
using namespace spoke::spatial;
using spoke::test::edited;
using spoke::test::kSolidText;
using spoke::testing::approx;

TEST_CASE("a solid stands in its tree by its interfaces") {
  const Model model =
      spoke::test::space_model(edited(kSolidText, "child = \"bracket\"\nkind = \"fixed\"",
                                      "child = \"bracket\"\nkind = \"fixed\"\noffset = [1, 2, 3]"));
  const Tree tree = build_trees(model).front();
  REQUIRE(tree.bodies.size() == 2);
  CHECK(tree.bodies[1].parent == 0);
  CHECK(tree.bodies[1].parent_node == 1);
  // From the middle of ROOT, (0.02, 0.05, 0.4), to that of TIP, (0.4, 0.05, 0.02).
  const std::vector<Placement> at = calc_placements(tree);
  CHECK((at[0].position - Vector(1, 2, 3)).norm() <= 1e-12);
  CHECK((at[1].position - Vector(1.38, 2.0, 2.62)).norm() <= 1e-9);
  CHECK(at[1].rotation.isIdentity(1e-14));
}

TEST_CASE("mass of a solid is that of its volume, its moments are about its first interface") {
  const Tree tree = build_trees(spoke::test::space_model(kSolidText)).front();
  const MassProperties mass = calc_mass_properties(tree, tree.bodies.front());
  // Two arms that overlap, a fillet, two holes.
  const double pi = std::numbers::pi;
  const double volume = (2 * 0.4 - 0.04) * 0.1 * 0.04 + (1 - pi / 4) * 0.06 * 0.06 * 0.1 -
                        2 * pi * 0.025 * 0.025 * 0.04;
  CHECK(mass.mass == Approx(2700 * volume).epsilon(2e-4));
  // It is symmetric about the bisector x = z of its arms, and about y = 0.05 m.
  const Vector centre = mass.first_moment / mass.mass + Vector(0.02, 0.05, 0.4);
  CHECK(centre.x() == Approx(centre.z()).epsilon(1e-3));
  CHECK(centre.y() == approx(0.05).epsilon(1e-4));
}

TEST_CASE("loads on a solid are on its interfaces, or on sets behind them") {
  Model model = spoke::test::space_model(kSolidText);
  spoke::spatial::PointLoad load = model.loads.front();
  load.traction = std::nullopt;
  load.nodes = BoxNodes{{0.39, -1, -1}, {1, 1, 1}};
  model.loads.push_back(load);
  load.nodes = std::nullopt;
  load.interface = "root";
  model.loads.push_back(load);
  model.loads.push_back(model.loads.front());  // the same set again
  const Tree tree = build_trees(model).front();
  const auto& solid = std::get<SolidPart>(tree.bodies.front().shape);
  REQUIRE(solid.sets.size() == 2);
  CHECK(solid.sets[0] == NodeChoice("TIP"));
  CHECK(find_loaded_place(model.loads[0], solid) == 2);
  CHECK(find_loaded_place(model.loads[1], solid) == 3);
  CHECK(find_loaded_place(model.loads[2], solid) == 0);
  CHECK(find_loaded_place(model.loads[3], solid) == 2);
  model.loads[2].traction = Vector(1, 0, 0);  // spread by area over the interface's nodes
  const Tree with_traction = build_trees(model).front();
  const auto& other = std::get<SolidPart>(with_traction.bodies.front().shape);
  REQUIRE(other.sets.size() == 3);
  CHECK(find_loaded_place(model.loads[2], other) == 4);
}

TEST_CASE("a changed description does not keep its geometry") {
  Model model = spoke::test::space_model(kSolidText);
  auto& solid = std::get<SolidBody>(model.subsystems[0].bodies[0].shape);
  REQUIRE(solid.kept);
  CHECK(spoke::solid::find_geometry(solid) == solid.kept);
  solid.material->density = 5400;
  const auto changed = spoke::solid::find_geometry(solid);
  CHECK(changed != solid.kept);
  CHECK(changed->geometry.mass == Approx(2 * solid.kept->geometry.mass).epsilon(1e-12));
}

TEST_CASE("bodies of one description read its mesh once, and keep one geometry") {
  const std::size_t from = kSolidText.find("[[subsystem]]"), to = kSolidText.find("[[load]]");
  std::string second = kSolidText.substr(from, to - from);
  second = edited(second, "name = \"arm\"", "name = \"other\"");
  const auto solid_of = [](const Model& model, std::size_t subsystem) {
    return std::get<SolidBody>(model.subsystems[subsystem].bodies[0].shape);
  };
  const Model equal = spoke::test::space_model(kSolidText + second);
  REQUIRE(solid_of(equal, 1).kept);
  CHECK(solid_of(equal, 1).kept == solid_of(equal, 0).kept);
  // Another reduction has constants of its own.
  const Model other =
      spoke::test::space_model(kSolidText + edited(second, "modes = 4", "modes = 5"));
  CHECK(solid_of(other, 1).mesh == solid_of(other, 0).mesh);
  CHECK(solid_of(other, 1).kept != solid_of(other, 0).kept);
  CHECK(solid_of(other, 1).kept->of.modes == 5);
}

TEST_CASE("coordinates of solids are counted as they are made") {
  SolidBody body;
  body.mesh = std::make_shared<SolidMesh>(
      spoke::test::make_grid_mesh({.cells = {3, 1, 1}, .lengths = {0.6, 0.1, 0.1}}));
  body.material = SolidMaterial{7e10, 0.33, 2700.0};
  body.geometric_stiffening = false;
  const auto count_made = [&](const SolidPart& part) {
    return find_constants(part, {}).constants->coordinates;
  };
  for (const auto first : {InterfaceKind::rigid, InterfaceKind::average})
    for (const auto last : {InterfaceKind::rigid, InterfaceKind::average})
      for (const auto frame : {SolidFrame::clamped, SolidFrame::mean_axis})
        for (const auto coordinates : {SolidCoordinates::reduced, SolidCoordinates::nodal}) {
          const bool is_nodal = coordinates == SolidCoordinates::nodal;
          if (is_nodal && frame == SolidFrame::mean_axis) continue;  // is refused
          CAPTURE(is_nodal);
          body.interfaces = {{"root", "X0", first}, {"tip", "X1", last}};
          body.frame = frame;
          body.coordinates = coordinates;
          const SolidPart part{spoke::solid::find_geometry(body)};
          CHECK(count_coordinates(part) == count_made(part));
        }
  // Modes up to a frequency come in addition, however many these are.
  body.coordinates = SolidCoordinates::reduced;
  body.up_to = 2e4;
  const SolidPart part{spoke::solid::find_geometry(body)};
  const auto made = find_constants(part, {}).constants;
  CHECK(count_coordinates(part) + std::ssize(made->frequencies) == made->coordinates);
}

TEST_CASE("copies of a subsystem stand around the hub and share what they are made of") {
  Model model = spoke::test::space_model(
      edited(kSolidText, "name = \"arm\"", "name = \"arm\"\ncount = 3\nazimuth = 0.1"));
  REQUIRE(model.subsystems.size() == 3);
  CHECK(model.subsystems[2].name == "arm3");
  model.hub.axis = Vector(0, 0, -1);
  model.subsystems[1].joints[0].joint.offset = Vector(2, 0, 0);
  const std::vector<Tree> trees = build_trees(model);
  const double angle = 0.1 + 2.0 * std::numbers::pi / 3.0;
  CHECK(trees[1].azimuth == Approx(angle).epsilon(1e-14));
  const Placement at = trees[1].bodies[0].placement;
  CHECK((at.position - Vector(2 * std::cos(angle), -2 * std::sin(angle), 0)).norm() <= 1e-14);
  CHECK((at.rotation * Vector::UnitX() - at.position / 2).norm() <= 1e-14);
  const auto& first = std::get<SolidPart>(trees[0].bodies[0].shape);
  const auto& last = std::get<SolidPart>(trees[2].bodies[0].shape);
  CHECK(first.kept == last.kept);
  CHECK(model.loads.size() == 3);
}
