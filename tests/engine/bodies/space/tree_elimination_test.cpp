// Trees of rigid bodies by all kinds of joints: elimination against one dense system, and hubs.

#include <doctest/doctest.h>

#include "tests/engine/bodies/space/random_tree.h"
#include "tests/models/space/random_space.h"

using namespace spoke::space;
using namespace spoke::space::testing;

namespace {

/// Largest difference of all unknowns of a kind, by the largest of them.
struct Difference {
  double difference = 0.0;
  double largest = 0.0;
  void add(double a, double b) {
    difference = std::max(difference, std::abs(a - b));
    largest = std::max(largest, std::abs(b));
  }
  void add(const Twist& a, const Twist& b) {
    for (int c = 0; c < kTwist; ++c) add(a[c], b[c]);
  }
  double relative() const { return difference / largest; }
};

void check_equal(const TreeAccelerations& a, const TreeAccelerations& b, double tolerance) {
  Difference accelerations, wrenches;
  accelerations.add(a.hub.acceleration, b.hub.acceleration);
  wrenches.add(a.hub.reaction, b.hub.reaction);
  for (std::size_t j = 0; j < a.bodies.size(); ++j) {
    accelerations.add(a.bodies[j], b.bodies[j]);
    wrenches.add(a.wrenches[j], b.wrenches[j]);
    for (std::size_t c = 0; c < a.joints[j].size(); ++c)
      accelerations.add(a.joints[j][c], b.joints[j][c]);
  }
  CHECK(accelerations.relative() < tolerance);
  CHECK(wrenches.relative() < tolerance);
}

}  // namespace

TEST_CASE("eliminating the joints of a tree solves the equations of all its bodies and joints") {
  std::mt19937 random(1);
  for (const HubKind hub : {HubKind::fixed, HubKind::driven, HubKind::torque, HubKind::free})
    for (const ImplicitShares& shares : {ImplicitShares{}, ImplicitShares{1e-2, 0.1}})
      for (int round = 0; round < 6; ++round) {
        CAPTURE(static_cast<int>(hub));
        CAPTURE(shares.stiffness);
        RigidTree tree = make_random_tree({14, hub}, random);
        tree.update(0.2, shares);
        check_equal(tree.eliminate(), tree.solve_dense(), 1e-12);
      }
}
