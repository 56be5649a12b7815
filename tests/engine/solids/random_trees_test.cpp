// Random trees of solids, beams and rigid bodies, some with a closed loop: the formulations agree.

#include <doctest/doctest.h>

#include <memory>
#include <random>
#include <string>

#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/solids/solid_models.h"

using namespace spoke;
using namespace spoke::test;
using spatial::Vector;

namespace {

class RandomTree {
 public:
  explicit RandomTree(unsigned seed) : random_(seed) {}

  spatial::Model make() {
    spatial::Model model;
    model.hub.mass = 20.0;
    model.hub.inertia = Vector(3.0, 4.0, 5.0).asDiagonal();
    model.hub.support = choose(2) == 0 ? HubSupport::axle : HubSupport::free;
    if (model.hub.support == HubSupport::free)
      model.hub.angular_velocity = vector(3.0);
    else
      model.hub.drive = choose(2) == 0 ? Drive(FreeDrive{3.0}) : Drive(ConstantSpeed{3.0});
    model.gravity = vector(9.0);
    spatial::Subsystem tree;
    tree.name = "tree";
    const int bodies = 2 + choose(3);
    for (int j = 0; j < bodies; ++j) add_body(j, tree);
    if (choose(2) == 0) add_loop(tree);
    model.subsystems.push_back(tree);
    return model;
  }

 private:
  int choose(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  double unit() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
  Vector vector(double size) { return size * Vector(unit(), unit(), unit()); }

  spatial::SolidBody make_solid() {
    const auto kind = [&] {
      return choose(2) == 0 ? spatial::InterfaceKind::rigid : spatial::InterfaceKind::average;
    };
    spatial::SolidBody solid = make_bar(slender_grid(), rubber(), kind(), kind());
    solid.interfaces.push_back(
        {"side", spatial::BoxNodes{Vector(0.3, -0.06, 0.04), Vector(0.7, 0.06, 0.06)}, kind(), {}});
    solid.modes = 3 + choose(6);
    solid.geometric_stiffening = choose(4) > 0;
    if (choose(3) == 0) {
      solid.coordinates = spatial::SolidCoordinates::nodal;
      solid.modes.reset();
    } else if (choose(3) == 0) {
      solid.frame = spatial::SolidFrame::mean_axis;
    } else {
      solid.damping = {0.03};
    }
    return solid;
  }

  spatial::Beam make_beam() {
    spatial::Beam beam;
    beam.length = 0.7;
    beam.bodies = 1 + choose(2);
    beam.elements = 2;
    beam.sections.station = {0.0, 0.7};
    beam.sections.mass_per_length = {2.0, 1.5};
    beam.sections.axial_stiffness = {1e5, 1e5};
    beam.sections.lag_stiffness = beam.sections.flap_stiffness = {60.0, 40.0};
    beam.sections.torsion_stiffness = {50.0, 50.0};
    beam.sections.flap_inertia = beam.sections.lag_inertia = {2e-3, 2e-3};
    return beam;
  }

  void add_body(int j, spatial::Subsystem& tree) {
    spatial::Body body;
    body.name = "body" + std::to_string(j);
    const int shape = j == 0 ? 0 : choose(4);
    if (shape <= 1)
      body.shape = make_solid();
    else if (shape == 2)
      body.shape = make_beam();
    else
      body.shape = spatial::RigidBody{2.0, vector(0.1), Vector(0.03, 0.04, 0.05).asDiagonal()};
    spatial::SubsystemJoint joint;
    const int parent = choose(j + 1) - 1;
    if (parent >= 0) {
      joint.parent = tree.bodies[static_cast<std::size_t>(parent)].name;
      if (std::holds_alternative<spatial::SolidBody>(
              tree.bodies[static_cast<std::size_t>(parent)].shape))
        joint.interface = choose(2) == 0 ? "tip" : "side";
    }
    joint.child = body.name;
    constexpr spatial::JointKind kKinds[] = {
        spatial::JointKind::fixed, spatial::JointKind::revolute, spatial::JointKind::spherical,
        spatial::JointKind::prismatic};
    joint.joint.kind = kKinds[choose(4)];
    joint.joint.axes[0] = vector(1.0);
    joint.joint.offset = vector(0.1);
    joint.joint.orientation = vector(1.0);
    for (int c = 0; c < count_coordinates(joint.joint.kind); ++c)
      joint.joint.coordinates[static_cast<std::size_t>(c)].stiffness = 200.0;
    tree.bodies.push_back(body);
    tree.joints.push_back(joint);
  }

  /// Ties the first body's side to the hub by a spring.
  void add_loop(spatial::Subsystem& tree) {
    Loop tie;
    tie.name = "tie";
    tie.kind = LoopKind::distance;
    tie.from.name = "body0";
    tie.from.interface = "side";
    tie.to.carrier = LoopPlace::Carrier::hub;
    tie.to.point = Vector(0.4, 1.0, 0.8) + vector(0.5);
    tie.stiffness = {300.0};
    tree.loops.push_back(tie);
  }

  std::mt19937 random_;
};

}  // namespace

TEST_CASE("three formulations agree on random trees with solids") {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    const System<Space> system = make_system(RandomTree(seed).make());
    const auto run = [&](Formulation formulation) {
      Run<Space> run(system,
                     {.method = make_generalized_alpha(0.8, 1e-3), .formulation = formulation});
      run.advance(25);
      return deformations(run);
    };
    const Eigen::VectorXd structured = run(Formulation::structured);
    CHECK(structured.cwiseAbs().maxCoeff() > 1e-4);
    CHECK((structured - run(Formulation::subsystem)).cwiseAbs().maxCoeff() < 1e-9);
    CHECK((structured - run(Formulation::augmented)).cwiseAbs().maxCoeff() < 1e-9);
  }
}
