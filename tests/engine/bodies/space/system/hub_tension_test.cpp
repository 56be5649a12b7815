// The acceleration of a hub on a support in the tension of its blades.

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "engine/bodies/kernels/space/section_balance.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/bodies/space/system/runs.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// Booms that have the tension of the tree.
const std::string kLinearBooms = with_strain(kBooms, "linear");

const std::string kSteadyHub = R"(
[hub]
axis = [0.2, 0.3, 1.0]
radius = 0.1
mass = 2.0
inertia = 0.5
[hub.drive]
kind = "constant"
speed = 6.0
)";

/// A rigid body that stands on the ground.
const std::string kBlock = R"(
[support]
from = "ground"
[[support.body]]
name = "block"
kind = "rigid"
mass = 3.0
inertia = [0.1, 0.1, 0.1]
[[support.joint]]
parent = "ground"
child = "block"
kind = "fixed"
[support.axle]
body = "block"
)";

const std::string kShake =
    "[hub.mount]\ntranslation = { amplitude = [0.03, 0.02, 0.04], frequency = 30.0 }\n";

/// A fuselage with its mass centre out of the axle, a flexible arm, and the hub at its end.
const std::string kMachine = R"(
[hub]
radius = 0.1
mass = 2.0
center = [0.03, 0.02, 0.0]
inertia = 0.5
[hub.drive]
kind = "free"
initial_speed = 5.0
[support]
from = "free"
mass = 3.0
center = [-0.3, 0.1, 0.0]
inertia = [0.5, 0.6, 0.7]
velocity = [0.3, -0.2, 0.5]
angular_velocity = [0.8, -0.5, 0.6]
[[support.body]]
name = "arm"
kind = "beam"
length = 1.0
bodies = 1
elements = 2
[support.body.sections]
mass_per_length = 1.0
axial_stiffness = 2e4
lag_stiffness = 100.0
flap_stiffness = 80.0
torsion_stiffness = 60.0
[[support.joint]]
parent = "fuselage"
child = "arm"
kind = "fixed"
[support.axle]
body = "arm"
offset = [0.1, 0.0, 0.1]
orientation = [0.3, 0.2, 0.0]
)";

System<Space> make(const std::string& text) { return make_system(parse_model(text)); }

/// Deformations of the two booms, which are the first subsystems.
Eigen::VectorXd of_booms(const System<Space>& system, const Method& method, double seconds) {
  Run<Space> run(system, {method});
  run.advance_for(seconds);
  Eigen::Index size = 0;
  for (int i = 0; i < 2; ++i)
    for (const BodyData<Space>& body :
         run.context.data.subsystems[static_cast<std::size_t>(i)].bodies)
      size += body.joint.coordinates.size + body.coordinates.size;
  return deformations(run).head(size);
}

double largest(const Eigen::VectorXd& x) { return x.cwiseAbs().maxCoeff(); }

/// Momentum of the machine, and that about the origin of space.
space::Twist sum_momentum(const Run<Space>& run) {
  const StepData<Space>& data = run.context.data;
  const space::Hub& base = run.context.system.hub;
  space::Twist sum =
      translate(data.hub.p, data.hub.R * space::Twist(base.inertia.matrix() * data.hub.twist));
  for (const SubsystemData<Space>& subsystem : data.subsystems) sum += calc_momentum(subsystem);
  return sum;
}

}  // namespace

TEST_CASE("a rotor on a rigid support has the tension of one on a mount") {
  const System<Space> axle = make(make_text(kSteadyHub + kShake, kLinearBooms + kHinges, kGravity));
  const System<Space> block =
      make(make_text(kSteadyHub + kShake, kLinearBooms + kHinges, kBlock + kGravity));
  for (const Method& method : {Method{Rk4{1e-3}}, Method{make_generalized_alpha(0.8, 2e-3)}}) {
    const Eigen::VectorXd expected = of_booms(axle, method, 0.4);
    CHECK(largest(expected) > 0.05);
    CHECK(largest(of_booms(block, method, 0.4) - expected) < 1e-9);
  }
}

TEST_CASE("a support whose joint is driven pulls as a mount that moves so") {
  const std::string times = "time = [0.0, 0.1, 0.2, 0.3, 0.5], ";
  const std::string mount =
      "[hub.mount]\ntranslation = { " + times + "x = [0.0, 0.0, 0.1, 0.15, 0.15] }\n";
  std::string slide = kBlock;
  slide.replace(slide.find("kind = \"fixed\""), 14,
                "kind = \"prismatic\"\naxis = [1.0, 0.0, 0.0]\nmotion = { " + times +
                    "value = [0.0, 0.0, 0.1, 0.15, 0.15] }");
  const System<Space> axle = make(make_text(kSteadyHub + mount, kLinearBooms, kGravity));
  const System<Space> driven = make(make_text(kSteadyHub, kLinearBooms, slide + kGravity));
  const Eigen::VectorXd expected = of_booms(axle, Rk4{1e-3}, 0.3);
  CHECK(largest(expected) > 0.05);
  CHECK(largest(of_booms(driven, Rk4{1e-3}, 0.3) - expected) < 1e-9);
}

// A hub that does not turn, out on an arm that does, is a root bracket so far from the axis.
TEST_CASE("a rotor out on an arm that turns has the tension of a rotor with that radius") {
  std::string boom = kLinearBooms;
  boom.replace(boom.find("count = 2"), 9, "count = 1");
  boom.replace(boom.find("precone = 0.1"), 13, "precone = 0.0");  // which the radius follows
  const auto hub = [](const std::string& radius, const std::string& drive) {
    return "[hub]\nmass = 2.0\ninertia = 0.5\nradius = " + radius + "\n[hub.drive]\n" + drive;
  };
  const System<Space> wide =
      make(make_text(hub("1.5", "kind = \"constant\"\nspeed = 4.0\n"), boom, kGravity));
  const System<Space> arm = make(make_text(
      hub("0.0", "kind = \"fixed\"\n") + "[hub.mount]\nrotation = { rate = [0.0, 0.0, 4.0] }\n",
      boom, kBlock + "offset = [1.5, 0.0, 0.0]\n" + kGravity));
  for (const Method& method : {Method{Rk4{1e-3}}, Method{make_generalized_alpha(0.8, 2e-3)}}) {
    Run<Space> a(wide, {method}), b(arm, {method});
    a.advance_for(0.4);
    b.advance_for(0.4);
    const Eigen::VectorXd expected = deformations(a);
    CHECK(largest(expected) > 0.1);
    CHECK(largest(deformations(b).head(expected.size()) - expected) < 1e-9);
  }
}

TEST_CASE("a rotor that a heavy machine pulls along has the tension of one under weight") {
  const std::string fuselage = R"(
[support]
from = "free"
mass = 1e8
inertia = [1e8, 1e8, 1e8]
)";
  // The force on fuselage, hub and booms gives them 30 and 12 m/s^2.
  const std::string force =
      "[[hub_load]]\nframe = \"inertial\"\nforce = [3000000180.0, 0.0, 1200000072.0]\n";
  const std::string weight = "[gravity]\nacceleration = [-30.0, 0.0, -12.0]\n";
  const System<Space> pulled = make(make_text(kSteadyHub, kLinearBooms, fuselage + force));
  const System<Space> heavy = make(make_text(kSteadyHub, kLinearBooms, weight));
  const Eigen::VectorXd expected = of_booms(heavy, Rk4{1e-3}, 0.4);
  CHECK(largest(expected) > 0.1);
  CHECK(largest(of_booms(pulled, Rk4{1e-3}, 0.4) - expected) < 1e-6);
}

TEST_CASE("a free machine keeps energy and momentum, by the order of the method") {
  struct Loss {
    double energy = 0.0;
    space::Twist momentum;
  };
  std::string hinges = kHinges;  // without dampers and stops
  hinges.replace(hinges.find("damping"), 7, "# those");
  hinges.erase(hinges.find("stop"));
  const System<Space> machine = make(make_text(kMachine, kLinearBooms + hinges));
  const auto lose = [&machine](const Method& method) {
    Run<Space> run(machine, {method});
    const double energy = calc_energy(run);
    const space::Twist momentum = sum_momentum(run);
    run.advance_for(0.4);
    return Loss{std::abs(calc_energy(run) - energy), sum_momentum(run) - momentum};
  };
  const Loss whole = lose(Rk4{5e-4}), half = lose(Rk4{2.5e-4});
  CHECK(half.energy < 1e-6);
  CHECK(whole.energy / half.energy > 12.0);
  CHECK(half.momentum.norm() < 1e-7);
  const Loss coarse = lose(make_generalized_alpha(0.9, 2e-4)),
             fine = lose(make_generalized_alpha(0.9, 1e-4));
  CHECK(coarse.energy / fine.energy > 3.3);
}
