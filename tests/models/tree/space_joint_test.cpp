#include "models/tree/space_joint.h"

#include <doctest/doctest.h>

#include <cmath>

#include "models/tree/tree.h"
#include "tests/models/reader/spatial_texts.h"

using doctest::Approx;
using namespace spoke;
using spoke::test::edited;
using spoke::test::kBladeText;

TEST_CASE("joints become primitives in the order of their coordinates") {
  const std::string hinge = "kind = \"revolute\"\naxis = [0, -1, 0]\ndamping = 10.0";
  const auto joint_of = [&](const std::string& keys) {
    const auto model = *parse_scenario(edited(kBladeText, hinge, keys), "f.toml").space;
    const spatial::TreeBody body = build_trees(model).at(0).bodies.at(1);
    return spatial::make_space_joint(body.joint, body.placement);
  };
  const space::Joint revolute = joint_of(hinge);
  CHECK(revolute.coordinates == 1);
  CHECK(revolute.driven == 0);
  CHECK(revolute.primitives[0].axis == space::Position(0.0, -1.0, 0.0));
  CHECK(revolute.primitives[0].damping == 10.0);
  const space::Joint universal = joint_of(
      "kind = 'universal'\naxes = [[0, 3, 0], [0, 0, 1]]\nmotion = [{ mean = 0.1 }, {}]\n"
      "stiffness = [0, 5]\nrest = [0, 0.1]\noffset = [0, 0.2, 0]\norientation = [0.3, 0, 0]");
  CHECK(universal.coordinates == 1);
  CHECK(universal.driven == 1);
  CHECK(universal.primitives[0].is_driven);
  CHECK(universal.primitives[0].axis == space::Position(0.0, 1.0, 0.0));
  CHECK(universal.primitives[1].stiffness == 5.0);
  CHECK(universal.primitives[1].rest == 0.1);
  CHECK(universal.offset.p == space::Position(0.0, 0.2, 0.0));
  CHECK(universal.offset.R.axes(2, 1) == Approx(std::sin(0.3)));
  const space::Joint cylindrical = joint_of(
      "kind = 'cylindrical'\naxis = [1, 0, 0]\n"
      "stop = [{}, { lower = -1, upper = 2, stiffness = 9, width = 0.1 }]");
  CHECK(cylindrical.primitives[0].kind == space::JointPrimitive::Kind::revolute);
  CHECK(cylindrical.primitives[1].kind == space::JointPrimitive::Kind::prismatic);
  CHECK(cylindrical.primitives[1].stop.upper == 2.0);
  CHECK(cylindrical.primitives[0].stop.upper > 1e300);
  const space::Joint spherical = joint_of("kind = 'spherical'\nstiffness = 4");
  CHECK(spherical.coordinates == 3);
  CHECK(spherical.primitives[0].stiffness == 4.0);
  CHECK(joint_of("kind = 'fixed'").coordinates == 0);
}
