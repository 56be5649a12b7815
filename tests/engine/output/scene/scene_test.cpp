#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/output/scene/make_scene.h"
#include "engine/output/scene/section_size.h"
#include "engine/output/scene/solids.h"
#include "models/tree/space_beam.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/shipped.h"

using namespace spoke;
using namespace spoke::scene;
using namespace spoke::test;

namespace {

Scene shipped(const std::string& name, std::size_t most_nodes = 2000) {
  return make_scene(read_shipped(name), most_nodes);
}

Scene scene_of(const std::string& bodies) {
  return make_scene(parse_scenario(make_text(kDrivenHub, bodies), "test"), 2000);
}

/// Returns half the extent of a solid along a direction.
double half_extent(const Solid& solid, const Vector& direction) {
  double low = 1e9, high = -1e9;
  for (const Vector& vertex : solid.vertices) {
    low = std::min(low, direction.dot(vertex));
    high = std::max(high, direction.dot(vertex));
  }
  return 0.5 * (high - low);
}

Vector normal_of(const Solid& solid, const std::vector<int>& face) {
  const auto vertex = [&](std::size_t k) {
    return solid.vertices[static_cast<std::size_t>(face[k])];
  };
  return (vertex(1) - vertex(0)).cross(vertex(2) - vertex(0)).normalized();
}

/// Whether all faces look out.
bool faces_look_out(const Solid& solid, const Vector& center) {
  return std::all_of(solid.faces.begin(), solid.faces.end(), [&](const std::vector<int>& face) {
    return normal_of(solid, face).dot(solid.vertices[static_cast<std::size_t>(face[0])] - center) >
           0.0;
  });
}

constexpr const char* kFlatBeam = R"(
[blade]
count = 1
length = 2.0
[blade.sections]
station = [0.0, 1.0, 2.0]
mass_per_length = 8.0
axial_stiffness = 2e4
lag_stiffness = 40.0
flap_stiffness = 30.0
torsion_stiffness = 30.0
lag_inertia = 0.5
flap_inertia = 0.02
twist = [0.0, 0.5, 0.5]
)";

}  // namespace

TEST_CASE("a body's box has its inertia, a body of revolution is a cylinder") {
  // A brick of 0.6 x 0.8 x 1.4 m and 12 kg about the x, y, z axis.
  const double m = 12.0, x = 0.6 * 0.6, y = 0.8 * 0.8, z = 1.4 * 1.4;
  const Vector J = m / 12.0 * Vector(y + z, x + z, x + y);
  const Vector center(1.0, 2.0, 3.0);
  const Solid brick = make_body(center, m, J.asDiagonal());
  CHECK(brick.vertices.size() == 8);
  CHECK(half_extent(brick, Vector::UnitX()) == doctest::Approx(0.3));
  CHECK(half_extent(brick, Vector::UnitY()) == doctest::Approx(0.4));
  CHECK(half_extent(brick, Vector::UnitZ()) == doctest::Approx(0.7));
  CHECK(faces_look_out(brick, center));

  // A drum about y of radius 0.5 m and height 0.2 m.
  const double across = m * (3.0 * 0.25 + 0.04) / 12.0, along = m * 0.125;
  const Solid drum = make_body(center, m, Vector(across, along, across).asDiagonal());
  CHECK(half_extent(drum, Vector::UnitY()) == doctest::Approx(0.1));
  CHECK(half_extent(drum, Vector::UnitX()) == doctest::Approx(0.5));
  CHECK(faces_look_out(drum, center));
}

TEST_CASE("sections have chord and thickness, or are ellipses of their inertias") {
  Scenario scenario = parse_scenario(make_text(kDrivenHub, kFlatBeam), "test");
  spatial::Beam& beam = scenario.space->blades[0].beam;
  const auto size_at = [&](double station) {
    return find_section_size(beam, make_space_beam(beam), station);
  };
  // In an ellipse the mean of y^2 is a quarter of the square of the semi-axis.
  CHECK(size_at(0.5).half_y == doctest::Approx(0.5));
  CHECK(size_at(0.5).half_z == doctest::Approx(0.1));
  beam.sections.chord = {0.4, 0.2, 0.2};
  CHECK(size_at(0.5).half_y == doctest::Approx(0.15));
  CHECK(size_at(2.0).half_y == doctest::Approx(0.1));
  CHECK(size_at(0.5).half_z == doctest::Approx(0.1));
  beam.sections.thickness = {0.0, 0.06, 0.06};
  CHECK(size_at(0.5).half_z == doctest::Approx(0.015));
  beam.sections.mass_center = {{0.1, 0.02}, {0.1, 0.02}, {0.1, 0.02}};
  CHECK(size_at(0.5).center_y == 0.0);
  beam.sections.chord.clear();
  beam.sections.thickness.clear();
  CHECK(size_at(0.5).center_y == doctest::Approx(0.1));
  CHECK(size_at(0.5).center_z == doctest::Approx(0.02));
  CHECK(size_at(0.5).half_y == doctest::Approx(0.5));
}

TEST_CASE("rings stand across the twisted beam, at its place in the hub's frame") {
  Scenario scenario = parse_scenario(
      make_text("[hub]\nradius = 0.3\n[hub.drive]\nkind = \"fixed\"\n", kFlatBeam), "test");
  scenario.space->blades[0].azimuth = std::numbers::pi / 2.0;
  const Scene scene = make_scene(scenario, 2000);
  REQUIRE(scene.strips.size() == 4);
  const Ring &root = scene.strips[0].rings.front(), &tip = scene.strips[3].rings.back();
  CHECK((root.at.p - Vector(0.0, 0.3, 0.0)).norm() < 1e-12);
  CHECK((tip.at.p - Vector(0.0, 2.3, 0.0)).norm() < 1e-12);
  CHECK((root.y - Vector(-1.0, 0.0, 0.0)).norm() < 1e-12);
  // The section is twisted by 0.5 about the x axis of the blade, which is y here: from y of the
  // blade, -x, towards z.
  CHECK((tip.y - Vector(-std::cos(0.5), 0.0, std::sin(0.5))).norm() < 1e-12);
  CHECK((tip.z - Vector(std::sin(0.5), 0.0, std::cos(0.5))).norm() < 1e-12);
  CHECK(scene.tips[0] == static_cast<int>(scene.nodes.size()) - 1);
  CHECK((scene.nodes.back().p - tip.at.p).norm() < 1e-12);
}

TEST_CASE("joints have their kinds, axes and what moves them") {
  const Scene scene = shipped("articulated_rotor");
  REQUIRE(scene.joints.size() == 8);
  const JointMark &hinges = scene.joints[2], &pitch = scene.joints[3];  // of the blade along y
  CHECK(hinges.name == "blade 2 / hinges");
  CHECK(hinges.kind == "universal");
  CHECK(hinges.coordinates == std::vector<std::string>{"free", "free"});
  REQUIRE(hinges.axes.size() == 2);
  CHECK((hinges.axes[0] - Vector(1.0, 0.0, 0.0)).norm() < 1e-9);
  CHECK((hinges.axes[1] - Vector(0.0, 0.0, 1.0)).norm() < 1e-9);
  CHECK((scene.nodes[static_cast<std::size_t>(hinges.node)].p - Vector(0.0, 0.3, 0.0)).norm() <
        1e-9);
  CHECK(pitch.coordinates == std::vector<std::string>{"prescribed"});
  CHECK(scene.groups == 1 + 8);
  // The part inboard of the hinges stands on the hub.
  CHECK(scene.nodes[0].group == 0);
  CHECK(shipped("tree_of_bodies").joints[0].kind == "fixed");
}

TEST_CASE("loads are where they act, in the axes that they turn with") {
  const Scene rotor = shipped("articulated_rotor");
  REQUIRE(rotor.loads.size() == 4 * 9);
  const LoadMark &inner = rotor.loads[9], &outer = rotor.loads[17];  // of the blade along y
  CHECK(inner.frame == "section");
  CHECK(inner.is_distributed);
  CHECK((inner.at.p - Vector(0.0, 1.8, 0.0)).norm() < 1e-9);
  CHECK((outer.at.p - Vector(0.0, 7.3, 0.0)).norm() < 1e-9);
  // The force is along the normal of a section that is twisted by 0.02.
  CHECK((outer.force - 330.0 * Vector(std::sin(0.02), 0.0, std::cos(0.02))).norm() < 1e-6);

  const Scene tree = scene_of(kTree + R"(
[[load]]
subsystem = "arm"
body = "boom"
position = 0.75
frame = "inertial"
force = [0.0, 2.0, 0.0]
[[load]]
subsystem = "arm"
body = "mirror"
point = [0.0, 0.0, 0.1]
moment = [0.0, 0.0, 1.0]
frame = "body"
)");
  REQUIRE(tree.loads.size() == 2);
  const LoadMark& boom = tree.loads[0];
  CHECK(boom.at.node == tree.strips[0].first);
  CHECK(boom.at.xi == doctest::Approx(0.75));
  CHECK((boom.force - Vector(0.0, 2.0, 0.0)).norm() == 0.0);
  // The load is on the mirror, which the boom carries undeformed at its end.
  const Solid& mirror = *std::find_if(tree.solids.begin(), tree.solids.end(),
                                      [](const Solid& s) { return s.name == "arm / mirror"; });
  CHECK(tree.loads[1].at.node == mirror.node);
  CHECK(tree.loads[1].at.xi == 0.0);
  const Node& node = tree.nodes[static_cast<std::size_t>(mirror.node)];
  CHECK((tree.loads[1].at.p - node.p - 0.1 * node.axes.col(2)).norm() < 1e-12);
  CHECK((tree.loads[1].moment - node.axes.col(2)).norm() < 1e-12);
}

TEST_CASE("a planar rotor lies in the plane, round as its bending stiffness says") {
  const Scene scene = shipped("wu_haug_rotor");
  CHECK(scene.is_planar);
  CHECK(scene.subsystems == std::vector<std::string>{"blade 1", "blade 2", "blade 3"});
  for (const Node& node : scene.nodes) CHECK(node.p.z() == 0.0);
  const double gyration = std::sqrt(8.214e-9 / 7.299e-5);
  CHECK(scene.strips[0].rings[0].half_y == doctest::Approx(2.0 * gyration));
  CHECK((scene.nodes.back().p - 8.0 * Vector(-0.5, -std::sqrt(0.75), 0.0)).norm() < 1e-9);
}

TEST_CASE("sensors of a planar rotor are where they measure") {
  Scenario scenario = read_shipped("wu_haug_rotor");
  scenario.sensors.resize(2);
  scenario.sensors[0].name = "mid";
  scenario.sensors[0].position = 4.5;
  scenario.sensors[0].blade = BladeChoice::number(1);
  scenario.sensors[1].quantity = SensorQuantity::kinetic_energy;
  const Scene scene = make_scene(scenario, 2000);
  REQUIRE(scene.sensors.size() == 1);
  CHECK(scene.sensors[0].name == "mid");
  CHECK((scene.sensors[0].at.p - Vector(4.5, 0.0, 0.0)).norm() < 1e-12);
}

TEST_CASE("of many nodes every few are shown, the ends of bodies always") {
  const Scene all = shipped("large_rotor"), part = shipped("large_rotor", all.nodes.size() / 3);
  CHECK(part.nodes.size() < all.nodes.size() / 2);
  CHECK(part.strips.size() == all.strips.size());
  for (std::size_t k = 0; k < all.strips.size(); ++k) {
    const auto last = [](const Scene& scene, const Strip& strip) {
      return scene.nodes[static_cast<std::size_t>(strip.first + strip.nodes - 1)].p;
    };
    CHECK((last(all, all.strips[k]) - last(part, part.strips[k])).norm() < 1e-12);
  }
}
