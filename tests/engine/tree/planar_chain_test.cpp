// The elimination of trees, in the plane, does to a chain what the formulation `structured` does:
// it finds the same bits.

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>

#include "engine/kernels/hub_motion.h"
#include "engine/tree/joint_recovery.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;

namespace {

struct PlanarWorld {
  static constexpr int kTwist = spoke::kTwist;
  static constexpr int kMostJointCoordinates = 0;
  using Twist = spoke::Twist;
  using TwistMatrix = spoke::TwistMatrix;
  using SymmetricTwistMatrix = spoke::SymmetricTwistMatrix;
};

struct RigidJoint {
  Rotation R;
};
struct RootJoint {
  Rotation R;
  Position p;
  Twist bias;
};

template <class Derived>
bool has_bits_of(const Eigen::MatrixBase<Derived>& a, const Derived& b) {
  for (Eigen::Index k = 0; k < a.size(); ++k)
    if (std::bit_cast<std::uint64_t>(a.derived().data()[k]) !=
        std::bit_cast<std::uint64_t>(b.data()[k]))
      return false;
  return true;
}

void check_subsystem(const Subsystem& subsystem, const SubsystemData& data,
                     const structured::SubsystemWork& work) {
  const std::size_t count = work.bodies.size();
  std::vector<tree::JointElimination<PlanarWorld>> joints(count);
  tree::Branch<PlanarWorld> branch{work.bodies[count - 1].port.P_ii,
                                   work.bodies[count - 1].port.free_i};
  for (std::size_t j = count - 1; j-- > 0;) {
    const TwoPort& port = work.bodies[j].port;
    const Twist f = tree::eliminate_joint(port.P_oo, port.free_o, RigidJoint{data.rotations[j + 1]},
                                          branch, joints[j]);
    branch = tree::join<PlanarWorld>(port.P_ii, port.P_io, port.free_i, joints[j].Pi, f);
    CHECK(has_bits_of(joints[j].Pi.matrix(), work.bodies[j].joint.Pi.matrix()));
    CHECK(has_bits_of(joints[j].rhs, work.bodies[j].joint.rhs));
  }
  const Position& p = subsystem.root.p;
  const double ww = data.hub->twist[kRotation] * data.hub->twist[kRotation];
  const RootJoint root{data.rotations[0], p, Twist(-ww * p.x(), -ww * p.y(), 0.0)};
  tree::RootElimination<PlanarWorld> elimination;
  const tree::HubShare<PlanarWorld> share = tree::eliminate_root(root, branch, elimination);
  CHECK(has_bits_of(share.mass.matrix(), data.effective.mass));
  CHECK(has_bits_of(share.force, data.effective.force));

  Twist F = tree::recover_root(
      root, elimination,
      calc_root_acceleration(subsystem, *data.hub, *data.hub_acceleration, root.R));
  for (std::size_t j = 0; j < count; ++j) {
    CHECK(has_bits_of(F, data.wrenches[j].inboard));
    if (j + 1 == count) break;
    TwistMatrix P_io = work.bodies[j].port.P_io;
    const tree::MultiPort<PlanarWorld> port{2, nullptr, &P_io, nullptr};
    const RigidJoint joint{data.rotations[j + 1]};
    const Twist f = tree::recover_child(1, joint, port, joints[j], &F);
    CHECK(has_bits_of(f, data.wrenches[j].outboard));
    F = tree::pass_to_child<PlanarWorld>(joint, f);
  }
}

}  // namespace

TEST_CASE(
    "a planar chain of rigid joints is eliminated to the bits of the formulation structured") {
  std::mt19937 random(1);
  for (const HubSupport support : {HubSupport::axle, HubSupport::free}) {
    const Rotor rotor = make_random_rotor({4, support, false}, random);
    StepContext context;
    make_context(rotor, Formulation::structured, Rk4{1e-5}, context);
    randomize_state(random, context);
    evaluate(6.0, context);
    for (std::size_t i = 0; i < context.data.subsystems.size(); ++i)
      check_subsystem(context.system.subsystems[i], context.data.subsystems[i],
                      context.work.structured[i]);
  }
}
