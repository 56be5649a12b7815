#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "models/space/reference_curve.h"
#include "models/tree/tree.h"
#include "tests/message_of.h"
#include "tests/models/reader/loop_texts.h"
#include "tests/models/reader/spatial_texts.h"
#include "tests/models/space_model.h"

using doctest::Approx;
using namespace spoke::spatial;
using spoke::test::edited;
using spoke::test::kBladeText;
using spoke::test::kTreeText;

namespace {

const FlexibleBody& flexible(const TreeBody& body) { return std::get<FlexibleBody>(body.shape); }

void check_same_mass(const MassProperties& a, const MassProperties& b) {
  CHECK(a.mass == Approx(b.mass).epsilon(1e-12));
  CHECK((a.first_moment - b.first_moment).norm() <= 1e-11 * b.inertia.norm());
  CHECK(a.inertia.isApprox(b.inertia, 1e-11));
}

}  // namespace

TEST_CASE("a blade is a chain of bodies with its joints at their stations") {
  const std::vector<Tree> trees = build_trees(spoke::test::space_model(kBladeText));
  REQUIRE(trees.size() == 3);
  const Tree& tree = trees[1];
  CHECK(tree.name == "blade 2");
  CHECK(tree.azimuth == Approx(2.0 * std::numbers::pi / 3));
  REQUIRE(tree.bodies.size() == 6);  // 0.3 m, 0.2 m, and 7.5 m by at most 2 m
  const JointKind kinds[] = {JointKind::fixed, JointKind::revolute, JointKind::revolute,
                             JointKind::fixed, JointKind::fixed,    JointKind::fixed};
  for (std::size_t i = 0; i < 6; ++i) {
    CAPTURE(i);
    CHECK(tree.bodies[i].parent == static_cast<int>(i) - 1);
    CHECK(tree.bodies[i].parent_node == (i == 0 ? 0 : 4));
    CHECK(tree.bodies[i].joint.kind == kinds[i]);
    if (i > 0)
      CHECK(flexible(tree.bodies[i]).nodes.front() == flexible(tree.bodies[i - 1]).nodes[4]);
  }
  CHECK(tree.bodies[1].joint.name == "flap");
  CHECK(flexible(tree.bodies[1]).nodes.front() == 0.3);
  CHECK(tree.bodies[2].joint.coordinates[0].motion.has_value());
  CHECK(flexible(tree.bodies[5]).nodes.back() == 8.0);
}

TEST_CASE("azimuth, precone and radius put a blade's root where they say") {
  Model model =
      spoke::test::space_model(edited(kBladeText, "count = 3", "count = 4\nprecone = 0.2"));
  model.hub.radius = 0.5;
  const Tree tree = build_trees(model)[1];  // at a quarter turn
  const Placement root = calc_placements(tree)[0];
  const Vector outward(0.0, std::cos(0.2), std::sin(0.2));
  CHECK((root.rotation * Vector::UnitX()).isApprox(outward, 1e-14));
  CHECK((root.rotation * Vector::UnitY()).isApprox(-Vector::UnitX(), 1e-14));
  CHECK(root.position.isApprox(0.5 * outward, 1e-14));
}

TEST_CASE("blades stand around the hub's axis") {
  Model model = spoke::test::space_model(kBladeText);
  const MassProperties upright = calc_mass_properties(model.hub, build_trees(model));
  model.hub.inertia = 3.0 * Tensor::Identity();
  model.hub.axis = Vector(1.0, -2.0, 0.5);
  const Tensor turn =
      spoke::space::smallest_rotation(Vector::UnitZ(), model.hub.axis.normalized()).axes;
  Model straight = model;
  straight.hub.axis = Vector::UnitZ();
  check_same_mass(calc_mass_properties(model.hub, build_trees(model)),
                  calc_mass_properties(straight.hub, build_trees(straight))
                      .seen_from_outside({Vector::Zero(), turn}));
  // Three blades balance, and are symmetric about the axis.
  CHECK(upright.first_moment.norm() < 1e-12 * upright.inertia.norm());
  CHECK(upright.inertia(0, 0) == Approx(upright.inertia(1, 1)));
}

TEST_CASE("a blade's mass does not depend on joints and on the number of bodies") {
  Model model = spoke::test::space_model(kBladeText);
  const MassProperties jointed = calc_mass_properties(build_trees(model)[0]);
  model.blades[0].joints.clear();
  model.blades[0].beam.bodies = 1;
  model.blades[0].beam.sections.prebend = {};
  check_same_mass(jointed, calc_mass_properties(build_trees(model)[0]));
}

TEST_CASE("a bent blade goes on where the body before it ends") {
  Model model = spoke::test::space_model(kBladeText);
  Blade& blade = model.blades[0];
  blade.beam.sections.prebend = {0.0, 0.3, 1.2};
  const std::vector<Placement> placements = calc_placements(build_trees(model)[0]);
  const spoke::space::ReferenceCurve axis({{0.0, 0.0, 0.0}, {3.0, 0.0, 0.3}, {8.0, 0.0, 1.2}});
  const Vector root(0.1, 0.0, 0.0);
  CHECK(placements[2].position.isApprox(root + axis.at(0.5), 1e-13));
  CHECK(placements[2].rotation.isApprox(Tensor::Identity(), 1e-15));
}

TEST_CASE("a joint's offset and orientation move and turn what is outboard") {
  Model model = spoke::test::space_model(kBladeText);
  Joint& flap = model.blades[0].joints[0].joint;
  flap.offset = Vector(0.0, 0.1, 0.0);
  flap.orientation = Vector(0.0, 0.0, 0.5 * std::numbers::pi);
  const std::vector<Placement> placements = calc_placements(build_trees(model)[0]);
  CHECK(placements[1].position.isApprox(Vector(0.4, 0.1, 0.0), 1e-14));  // radius 0.1, station 0.3
  CHECK(placements[2].position.isApprox(Vector(0.4, 0.3, 0.0), 1e-14));  // 0.2 m outboard
}

TEST_CASE("a point mass counts once, where two bodies meet too") {
  Model model = spoke::test::space_model(kBladeText);
  model.blades[0].beam.point_masses = {{0.0, 4.0}, {0.5, 2.0}, {8.0, 1.0}, {1.0, 3.0}};
  const Tree tree = build_trees(model)[0], bare = build_trees(model)[1];
  CHECK(calc_mass_properties(tree).mass == Approx(calc_mass_properties(bare).mass + 10.0));
  const double inner[] = {4.0, 2.0, 3.0, 0.0, 0.0, 1.0};
  for (std::size_t i = 0; i < 6; ++i)
    CHECK(calc_mass_properties(tree, tree.bodies[i]).mass ==
          Approx(calc_mass_properties(bare, bare.bodies[i]).mass + inner[i]));
}

TEST_CASE("a hub whose axis points down carries its blades upside down") {
  Model model = spoke::test::space_model(kBladeText);
  model.hub.axis = Vector(0.0, 0.0, -2.0);
  const Tensor rotation = rotor_placement(model.hub).rotation;
  CHECK(rotation.isApprox(Vector(1.0, -1.0, -1.0).asDiagonal().toDenseMatrix(), 1e-15));
}

TEST_CASE("a subsystem's bodies stand behind their parents, in whatever order they are named") {
  const std::string text = edited(kTreeText, "[integration]",
                                  "[[subsystem.body]]\nname = 'foot'\nkind = 'rigid'\nmass = 1\n"
                                  "inertia = [1, 1, 1]\n[[subsystem.joint]]\nparent = 'hub'\n"
                                  "child = 'foot'\nkind = 'fixed'\n[integration]");
  std::string turned =
      edited(text, "parent = \"hub\"\nchild = \"boom\"", "parent = \"foot\"\nchild = \"boom\"");
  const Tree tree = build_trees(spoke::test::space_model(turned))[0];
  REQUIRE(tree.bodies.size() == 6);
  CHECK(tree.name == "arm");
  CHECK(tree.bodies[0].name == "foot");
  CHECK(tree.bodies[0].parent == -1);
  CHECK(tree.bodies[1].name == "boom / body 1");
  CHECK(tree.bodies[1].parent == 0);
  CHECK(tree.bodies[5].name == "mirror");
  CHECK(tree.bodies[5].parent == 4);
  CHECK(tree.bodies[5].parent_node == 4);
  CHECK(tree.bodies[5].joint.kind == JointKind::spherical);
}

TEST_CASE("a child within a beam is on a node at its station") {
  for (const double station : {0.0, 0.7, 1.0, 2.5, 4.0}) {
    CAPTURE(station);
    Model model = spoke::test::space_model(kTreeText);
    model.subsystems[0].joints[1].station = station;
    const Tree tree = build_trees(model)[0];
    const TreeBody& mirror = tree.bodies.back();
    const FlexibleBody& parent = flexible(tree.bodies[static_cast<std::size_t>(mirror.parent)]);
    CHECK(parent.nodes[mirror.parent_node] == Approx(station).epsilon(1e-14));
    CHECK(parent.nodes.size() == 5);
    CHECK(calc_placements(tree).back().position.isApprox(Vector(station, 0.0, 0.0), 1e-13));
  }
}

TEST_CASE("places of a blade's loop on hub, mount and anchors are turned by its azimuth") {
  Model model =
      spoke::test::space_model(edited(spoke::test::kPitchLinkText, "count = 3", "count = 4"));
  const auto placement_of = [&model](std::size_t blade) {
    const std::vector<Tree> trees = build_trees(model);
    REQUIRE(trees[blade].loops.size() == 1);
    CHECK(trees[blade].loops[0].from.placement.position == Vector(0.0, 0.2, 0.0));
    return trees[blade].loops[0].to.placement;
  };
  CHECK(placement_of(0).position.isApprox(Vector(0.5, 0.2, 0.0), 1e-14));
  CHECK(placement_of(1).position.isApprox(Vector(-0.2, 0.5, 0.0), 1e-14));
  CHECK((placement_of(1).rotation * Vector::UnitX()).isApprox(Vector::UnitY(), 1e-14));
  model.hub.axis = {0.0, 3.0, 0.0};
  CHECK(placement_of(1).position.isApprox(Vector(0.0, 0.2, -0.5), 1e-14));
}

namespace {

/// A blade of 20 m and 25 kg/m whose axis begins 0.3 m beside its frame, straight along x.
const std::string kBesideText =
    "world = \"space\"\n[hub]\nradius = 0.5\n[hub.drive]\nkind = \"constant\"\nspeed = 15.0\n"
    "[blade]\ncount = 1\nlength = 20.0\nbodies = 2\n[blade.sections]\nsweep = 0.3\nprebend = -0.2\n"
    "mass_per_length = 25.0\naxial_stiffness = 1e9\nflap_stiffness = 2e7\nlag_stiffness = 8e7\n"
    "torsion_stiffness = 5e6\nflap_inertia = 0.5\nlag_inertia = 2.0\n"
    "[integration]\nduration = 1.0\nstep = 0.005\n";

MassProperties mass_of(const std::string& text) {
  const Model model = spoke::test::space_model(text);
  return calc_mass_properties(build_trees(model)[0]);
}

}  // namespace

TEST_CASE("an axis that begins beside the root has its mass there") {
  // A rod from (0.5, 0.3, -0.2) to (20.5, 0.3, -0.2).
  const MassProperties m = mass_of(kBesideText);
  CHECK(m.mass == Approx(500.0));
  CHECK(m.first_moment.isApprox(Vector(500.0 * 10.5, 150.0, -100.0), 1e-12));
  const double xx = 25.0 * (std::pow(20.5, 3) - std::pow(0.5, 3)) / 3.0;
  const double yy = 500.0 * 0.09 + 20.0 * 2.0, zz = 500.0 * 0.04 + 20.0 * 0.5;
  Tensor inertia;
  inertia << yy + zz, -0.3 * 5250.0, 0.2 * 5250.0, -0.3 * 5250.0, xx + zz, 500.0 * 0.06,
      0.2 * 5250.0, 500.0 * 0.06, xx + yy;
  CHECK(m.inertia.isApprox(inertia, 1e-12));
}

TEST_CASE("a joint at the root of such an axis stands on it, one that carries it at its frame") {
  const std::string joint =
      "[[blade.joint]]\nstation = 0.0\nkind = \"revolute\"\naxis = [0, 1, 0]\n"
      "offset = [0.0, 0.1, 0.0]\n";
  const Tree hinged = build_trees(spoke::test::space_model(kBesideText + joint))[0];
  CHECK(calc_placements(hinged)[0].position.isApprox(Vector(0.5, 0.4, -0.2), 1e-14));
  CHECK(hinged.bodies[0].joint.kind == JointKind::revolute);
  const std::string body =
      "world = \"space\"\n[hub.drive]\nkind = \"fixed\"\n[[subsystem]]\nname = \"s\"\n"
      "[[subsystem.body]]\nname = \"b\"\nkind = \"beam\"\nlength = 20.0\n"
      "[subsystem.body.sections]\nsweep = 0.3\nmass_per_length = 25.0\naxial_stiffness = 1e9\n"
      "flap_stiffness = 2e7\nlag_stiffness = 8e7\ntorsion_stiffness = 5e6\n"
      "[[subsystem.joint]]\nparent = \"hub\"\nchild = \"b\"\nkind = \"fixed\"\n"
      "offset = [1.0, 0.0, 0.0]\norientation = [0.0, 0.0, 1.5707963267948966]\n"
      "[integration]\nduration = 1.0\nstep = 0.005\n";
  const Tree fixed = build_trees(spoke::test::space_model(body))[0];
  CHECK(calc_placements(fixed)[0].position.isApprox(Vector(0.7, 0.0, 0.0), 1e-14));
  const std::string moving =
      edited(body, "kind = \"fixed\"\noffset", "kind = \"revolute\"\naxis = [0, 0, 1]\noffset");
  CHECK(spoke::test::message_of([&] { spoke::test::space_model(moving); })
            .find("subsystem.1.joint.1.kind: is \"revolute\", but the axis of \"b\" begins beside "
                  "the joint, at sweep = 0.3 and prebend = 0; expected \"fixed\", or a beam whose "
                  "sweep and prebend are 0 at its root") != std::string::npos);
}
