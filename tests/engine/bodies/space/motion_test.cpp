// Tests motions of trees of rigid bodies: conserved quantities, and a top whose motion is known.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/bodies/space/random_tree.h"
#include "tests/engine/bodies/space/rigid_tree_steps.h"

using namespace spoke;
using namespace spoke::space;
using namespace spoke::space::testing;

namespace {

/// Makes the top of Exudyn's test model heavyTop, on a spherical joint at its foot.
RigidTree make_heavy_top(TurnFrame frame) {
  TreeHub hub;
  hub.support = HubSupport::axle;
  hub.is_driven = true;
  space::testing::TreeBody top;
  top.body.mass = 15.0;
  top.body.centre = {0.0, 1.0, 0.0};
  top.body.inertia = space::Position(0.234375, 0.46875, 0.234375).asDiagonal();
  JointPrimitive spherical;
  spherical.kind = JointPrimitive::Kind::spherical;
  spherical.frame = frame;
  top.joint = make_joint({}, std::span(&spherical, 1));
  RigidTree tree(hub, {top}, {0.0, 0.0, -9.81});
  tree.bodies[0].coordinates.v = {0.0, 150.0, -4.61538};
  return tree;
}

// The motion of the top by a general solver of order 8 to 1e-8.
const space::Position kCentreAt1{0.17334396, 0.64008859, -0.74849079};
const Angular kVelocityAt1{-0.8220781, 150.0, -5.92329135};
const Quaternion kTurnAt02{0.70827915, {-0.43878109, -0.5457284, -0.08939975}};

space::Position centre_of(const RigidTree& top) {
  return top.bodies[0].pose.R * top.models[0].body.centre;
}

double rk4_error(TurnFrame frame, double h) {
  RigidTree top = make_heavy_top(frame);
  run_rk4(1.0, h, top);
  return (centre_of(top) - kCentreAt1).norm();
}

double generalized_alpha_error(TurnFrame frame, double h) {
  RigidTree top = make_heavy_top(frame);
  run_generalized_alpha(1.0, h, 1.0, top);
  return (centre_of(top) - kCentreAt1).norm();
}

/// Changes within half a second of quantities that a free flight conserves.
struct Drift {
  double energy, momentum;
};

template <class Run>
Drift fly(const RandomTree& kind, unsigned seed, const Run& run) {
  std::mt19937 random(seed);
  RigidTree tree = make_random_tree(kind, random);
  tree.gravity.setZero();
  tree.update(0.0);
  const double energy = tree.calc_energy();
  const space::Twist momentum = tree.calc_momentum();
  run(tree);
  return {std::abs(tree.calc_energy() - energy), (tree.calc_momentum() - momentum).norm()};
}

}  // namespace

TEST_CASE("a heavy top moves as it should: rk4, of order 4, in either frame of its joint") {
  const double child = rk4_error(TurnFrame::child, 1e-3);
  const double child_half = rk4_error(TurnFrame::child, 5e-4);
  CHECK(child < 1.4e-4);
  CHECK(child_half < 1e-5);
  CHECK(child / child_half > 13.0);
  const double parent = rk4_error(TurnFrame::parent, 1e-3);
  const double parent_half = rk4_error(TurnFrame::parent, 5e-4);
  CHECK(parent < 6e-6);
  CHECK(parent_half < 3e-7);
  CHECK(parent / parent_half > 13.0);
}

TEST_CASE("a heavy top's orientation and angular velocity") {
  RigidTree top = make_heavy_top(TurnFrame::parent);
  run_rk4(0.2, 2.5e-4, top);
  CHECK((top.bodies[0].pose.R.axes - make_rotation(kTurnAt02).axes).norm() < 1e-7);
  RigidTree later = make_heavy_top(TurnFrame::parent);
  run_rk4(1.0, 2.5e-4, later);
  CHECK((angular(later.bodies[0].twist) - kVelocityAt1).norm() < 1e-5);
}

TEST_CASE("a heavy top by generalized_alpha, of order 2") {
  for (const TurnFrame frame : {TurnFrame::child, TurnFrame::parent}) {
    const double error = generalized_alpha_error(frame, 5e-4);
    const double half = generalized_alpha_error(frame, 2.5e-4);
    CHECK(half < 8e-3);
    CHECK(error / half > 3.8);
    CHECK(error / half < 4.2);
  }
}

TEST_CASE("a free flight of rk4 conserves energy and momentum to order 4") {
  const RandomTree kind{8, HubKind::free, true};
  for (const unsigned seed : {1u, 2u, 3u}) {
    CAPTURE(seed);
    const Drift whole = fly(kind, seed, [](RigidTree& tree) { run_rk4(0.5, 0.01, tree); });
    const Drift half = fly(kind, seed, [](RigidTree& tree) { run_rk4(0.5, 0.005, tree); });
    CHECK(half.energy < 1e-6);
    CHECK(half.momentum < 1e-6);
    CHECK(whole.energy / half.energy > 13.0);
    CHECK(whole.momentum / half.momentum > 13.0);
  }
}

TEST_CASE("a free flight of generalized_alpha conserves energy and momentum to order 2") {
  const RandomTree kind{8, HubKind::free, true};
  const auto run = [](double h) {
    return [h](RigidTree& tree) { run_generalized_alpha(0.5, h, 0.9, tree); };
  };
  for (const unsigned seed : {1u, 2u, 3u}) {
    CAPTURE(seed);
    const Drift whole = fly(kind, seed, run(0.005));
    const Drift half = fly(kind, seed, run(0.0025));
    CHECK(half.energy < 1e-3);
    CHECK(half.momentum < 1e-3);
    CHECK(whole.energy / half.energy > 3.8);
    CHECK(whole.momentum / half.momentum > 3.8);
  }
}

TEST_CASE("a flight is the same at another velocity of all") {
  const RandomTree kind{8, HubKind::free, true};
  const auto fly_at = [&](double speed) {
    std::mt19937 random(4);
    RigidTree tree = make_random_tree(kind, random);
    tree.hub_coordinates.v[0] += speed;
    run_rk4(0.5, 0.01, tree);
    return tree;
  };
  const RigidTree slow = fly_at(0.0), fast = fly_at(30.0);
  for (std::size_t j = 0; j < slow.bodies.size(); ++j) {
    const space::Position moved = fast.bodies[j].pose.p - slow.bodies[j].pose.p;
    CHECK((moved - space::Position(15.0, 0.0, 0.0)).norm() < 1e-10);
    CHECK((fast.bodies[j].pose.R.axes - slow.bodies[j].pose.R.axes).norm() < 1e-10);
  }
}

TEST_CASE("the energy of a tree grows by what hub, drives, motors and loads do") {
  std::mt19937 random(5);
  for (const HubKind hub : {HubKind::driven, HubKind::torque, HubKind::free})
    for (int round = 0; round < 3; ++round) {
      RigidTree tree = make_random_tree({8, hub}, random);
      start(tree);
      const double h = 2.5e-4;
      const double energy = tree.calc_energy(), power = tree.calc_power(tree.eliminate());
      step(Rk4{h}, 1, tree);
      const double middle_energy = tree.calc_energy();
      const double middle_power = tree.calc_power(tree.eliminate());
      step(Rk4{h}, 2, tree);
      // Simpson's rule.
      const double last_power = tree.calc_power(tree.eliminate());
      const double work = h / 3.0 * (power + 4.0 * middle_power + last_power);
      CHECK(std::abs(middle_energy - energy) > 1e-6);
      CHECK(std::abs(tree.calc_energy() - energy - work) < 1e-12);
    }
}
