// Drive trains: closed forms of shaft, gearbox and generator, and what holds of any.

#include "models/tree/drive_train.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "engine/courses.h"
#include "engine/modes.h"
#include "engine/simulation.h"
#include "models/system/spatial_system.h"
#include "models/tree/mass_properties.h"
#include "tests/contains.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/step/step_declarations.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr double kShaft = 5e4, kTeeth = 12.0, kGeneratorInertia = 0.07, kHubInertia = 40.0,
                 kNacelleInertia = 30.0;

/// A hub on a nacelle on `from`, which may roll about the axle or is held, or on a fuselage.
std::string make_train(const std::string& joint, const std::string& drive,
                       const std::string& more = "") {
  return "world='space'\n[hub]\naxis=[1,0,0]\nmass=20\ninertia=[40,21,21]\n[hub.drive]\n" + drive +
         "[support]\nbody=[ { name='nacelle', kind='rigid', mass=200, center=[0.1,0,0.3], "
         "inertia=[30,40,50] } ]\njoint=[ { name='roll', parent='ground', child='nacelle', " +
         joint + " } ]\n[support.axle]\nbody='nacelle'\nstiffness=5e4\ngear_ratio=12\n" +
         "generator_inertia=0.07\n" + more + "[integration]\nstep=1e-3\nduration=1\n";
}

const std::string kRolling = "kind='revolute', axis=[1,0,0]";
const std::string kHeld = "kind='fixed'";

/// Returns the frequencies above zero of roll, axle and generator [rad/s].
Eigen::VectorXd find_frequencies(bool rolls, bool turns) {
  Eigen::Matrix3d M;
  M << kNacelleInertia + kHubInertia + kGeneratorInertia, kHubInertia, kGeneratorInertia,
      kHubInertia, kHubInertia, 0.0, kGeneratorInertia, 0.0, kGeneratorInertia;
  M(0, 0) += 200.0 * 0.3 * 0.3;  // the nacelle's centre is above the axis
  if (!rolls) M(0, 0) += 1e12;
  if (!turns) M(2, 2) += 1e12;
  const Eigen::Vector3d turn(0.0, 1.0, -1.0 / kTeeth);
  const Eigen::Matrix3d K = kShaft * turn * turn.transpose();
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d>(K, M)
      .eigenvalues()
      .cwiseAbs()
      .cwiseSqrt();
}

double highest_mode(const std::string& text) {
  const ModesResult found = solve_modes(parse_scenario(text, "f"), {.state = {.speed = 0.0}});
  double highest = 0.0;
  for (const Mode& mode : found.modes) highest = std::max(highest, std::abs(mode.eigenvalue));
  return highest;
}

constexpr Formulation kFormulations[] = {Formulation::structured, Formulation::subsystem,
                                         Formulation::augmented};

const std::string kBrake = "kind='torque_by_speed'\ninitial_speed=2\nspeed=[0,5]\ntorque=[0,-60]\n";

/// A flying rotor of two elastic blades behind a drive train whose fuselage turns in space.
std::string make_flying(const std::string& drive, const std::string& damping) {
  return "world='space'\n[hub]\naxis=[1,0,0.2]\nmass=5\ninertia=2\n[hub.drive]\n" + drive +
         "[support]\nfrom='free'\nmass=80\n"
         "center=[0.1,0,-0.4]\ninertia=[9,12,11]\nangular_velocity=[0.2,0.5,-0.3]\n"
         "[support.axle]\noffset=[0.6,0.1,0.4]\nstiffness=2e3\ngear_ratio=-8\n"
         "generator_inertia=0.05\n" +
         damping +
         "[blade]\ncount=2\nlength=2\nbodies=1\nelements=2\n"
         "sections={ mass_per_length=2, axial_stiffness=4e5, flap_stiffness=1e3, "
         "lag_stiffness=2e3, torsion_stiffness=800, flap_inertia=1e-3, lag_inertia=3e-3 }\n"
         "[integration]\nstep=1e-3\nduration=1\n";
}

}  // namespace

TEST_CASE(
    "a carrier and its generator keep the carrier's mass, and its inertia but for the axle's") {
  const spatial::Model model = parse_model(make_train(kHeld, "kind='free'\n"));
  const spatial::Tree tree = build_trees(model).back();
  REQUIRE(tree.bodies[1].is_generator());
  const auto& carrier = std::get<spatial::RigidBody>(tree.bodies[0].shape);
  const spatial::RigidBody housing = without_shares(carrier, tree, 0);
  const spatial::RigidBody generator = with_share(tree, 1, {});
  const auto of = [](const spatial::RigidBody& body, const spatial::Placement& at) {
    const spatial::Vector c = at.position + at.rotation * body.center;
    const spatial::Tensor own = at.rotation * body.inertia * at.rotation.transpose();
    return spatial::Tensor(
        own + body.mass * (c.squaredNorm() * spatial::Tensor::Identity() - c * c.transpose()));
  };
  CHECK(std::abs(housing.mass + generator.mass - 200.0) < 1e-10);
  spatial::Tensor expected = of(carrier, {});
  expected(0, 0) += kGeneratorInertia;
  CHECK((of(housing, {}) + of(generator, tree.bodies[1].placement) - expected).norm() < 1e-10);
}

TEST_CASE("modes of a shaft: the generator held, turning freely, and on a nacelle that rolls") {
  const std::string fixed = "kind='fixed'\n", free = "kind='free'\n";
  CHECK(std::abs(highest_mode(make_train(kHeld, fixed)) / std::sqrt(kShaft / kHubInertia) - 1.0) <
        1e-8);
  const double both =
      std::sqrt(kShaft * (1.0 / kHubInertia + 1.0 / (kTeeth * kTeeth * kGeneratorInertia)));
  CHECK(std::abs(highest_mode(make_train(kHeld, free)) / both - 1.0) < 1e-8);
  CHECK(std::abs(highest_mode(make_train(kRolling, free)) / find_frequencies(true, true)[2] - 1.0) <
        1e-8);
  CHECK(std::abs(highest_mode(make_train(kRolling, fixed)) / find_frequencies(true, false)[2] -
                 1.0) < 1e-6);
}

TEST_CASE("a run has the frequency of the shaft, and hub.torque is its torque") {
  const std::string text =
      make_train(kHeld, "kind='fixed'\n", "") + "[[hub_load]]\ntorque=[100,0,0]\n";
  Simulation simulation(parse_scenario(text, "f"));
  const double w = std::sqrt(kShaft / kHubInertia);
  for (const double t : {0.05, 0.1, 0.2}) {
    simulation.run_until(t);
    const double angle = 100.0 / kShaft * (1.0 - std::cos(w * t));
    CHECK(std::abs(simulation.sensor("hub.angle") - angle) < 2e-6);
    CHECK(std::abs(simulation.sensor("hub.torque") + kShaft * simulation.sensor("hub.angle")) <
          1e-8 * kShaft);
  }
}

TEST_CASE("a torque by speed acts on the generator by its own speed, and its power is told") {
  for (const Formulation formulation : kFormulations) {
    // On the rigid axle's side: (J + n^2 J_g) w' = -12 w, for the shaft hardly twists in 1 s.
    std::string text = make_train(kHeld, kBrake);
    Simulation simulation(parse_scenario(text, "f"), {.formulation = formulation});
    simulation.run_until(1.0);
    const double inertia = kHubInertia + kTeeth * kTeeth * kGeneratorInertia;
    CHECK(std::abs(simulation.sensor("hub.speed") / (2.0 * std::exp(-12.0 / inertia)) - 1.0) <
          1e-3);
    CHECK(std::abs(simulation.sensor("energy.residual")) < 1e-5);
  }
}

TEST_CASE("sensors are on a generator, and a program turns it") {
  const std::string text = make_train(kHeld, "kind='free'\n") +
                           "[[sensor]]\nname='generator'\nquantity='velocity'\n"
                           "subsystem='support'\nbody='generator'\nframe='inertial'\n";
  Simulation simulation(parse_scenario(text, "f"));
  set_joint_torque(simulation, 0, simulation.joint_index(0, "generator"), 0, 10.0);
  simulation.run_until(0.2);
  // n J_g q'' + J psi'' = n T, whatever the shaft does.
  const double generator = simulation.sensor("support.generator.rotation.x");
  const double sum =
      kTeeth * kGeneratorInertia * generator + kHubInertia * simulation.sensor("hub.speed");
  CHECK(std::abs(sum - kTeeth * 10.0 * 0.2) < 1e-9);
  CHECK(generator > kTeeth * 0.4);  // 0.48 behind a rigid shaft
}

TEST_CASE("a run from the equilibrium begins with the shaft twisted by the torque") {
  std::string text = make_train(kHeld, "kind='torque_by_speed'\nspeed=[0,5]\ntorque=[0,-60]\n") +
                     "[[hub_load]]\ntorque=[36,0,0]\n[initial]\nstate='equilibrium'\nspeed=3\n";
  Simulation simulation(parse_scenario(text, "f"));
  simulation.run_until(0.5);
  CHECK(std::abs(simulation.sensor("hub.speed") - 3.0) < 1e-9);
  CHECK(std::abs(simulation.sensor("hub.torque") + 36.0) < 1e-6);
}

TEST_CASE("a flying rotor behind a drive train keeps momentum, and energy by the method's order") {
  check_conservation(make_system(parse_model(make_flying("kind='free'\ninitial_speed=6\n", ""))),
                     0.1, 2e-4);
}

TEST_CASE("formulations agree on a flying rotor behind a drive train") {
  const System<Space> system = make_system(
      parse_model(make_flying("kind='torque'\ntorque=30\ninitial_speed=6\n", "damping=3\n")));
  for (const Method& method : {Method(make_generalized_alpha(0.8, 1e-3)), Method(Rk4{2e-4})}) {
    check_formulations(system, method, 100, 1e-9);
    check_equal_bits(system, method, 30);
    for (const Formulation formulation : kFormulations)
      check_step_declarations(system, formulation, method);
  }
}

namespace {

/// A mast that is held at its root and carries the axle at its tip, or a nacelle of a mass there.
std::string make_mast(const std::string& base, const std::string& drive, double nacelle = 0.0) {
  const std::string mass = std::to_string(nacelle);
  const bool has_nacelle = nacelle > 0.0;
  return "world='space'\n[hub]\naxis=[1,0,0]\nmass=20\ninertia=[40,21,21]\n[hub.drive]\n" + drive +
         "[support]\n" + base +
         "body=[ { name='mast', kind='beam', length=1, elements=2, sections={ mass_per_length=3, "
         "axial_stiffness=1e7, flap_stiffness=2e5, lag_stiffness=3e5, torsion_stiffness=2e4, "
         "flap_inertia=5e-4, lag_inertia=5e-4 } }" +
         (has_nacelle
              ? ", { name='nacelle', kind='rigid', mass=" + mass + ", inertia=" + mass + " }"
              : "") +
         " ]\njoint=[ { parent='" + (base.empty() ? "ground" : "fuselage") +
         "', child='mast', kind='fixed' }" +
         (has_nacelle ? ", { parent='mast', child='nacelle', kind='fixed' }" : "") +
         " ]\n[support.axle]\nbody='" + (has_nacelle ? "nacelle" : "mast") +
         "'\nstiffness=5e4\ngear_ratio=12\ngenerator_inertia=0.07\n"
         "[integration]\nstep=1e-3\nduration=1\n";
}

/// A flying one that bends easily.
std::string make_flying_mast(const std::string& drive) {
  std::string text =
      make_mast("from='free'\nmass=80\ninertia=[9,12,11]\nangular_velocity=[2,5,-3]\n", drive);
  text.erase(text.find("sections={"), text.find(" } }") - text.find("sections={"));
  return text.insert(text.find("elements=2, ") + 12,
                     "bodies=1, sections={ mass_per_length=3, axial_stiffness=1e6, "
                     "flap_stiffness=2e3, lag_stiffness=3e3, torsion_stiffness=2e3, "
                     "flap_inertia=5e-3, lag_inertia=5e-3");
}

}  // namespace

TEST_CASE("a drive train on a beam has the frequencies of shaft and beam in torsion") {
  // The mast's own inertia, as of a linear shape, is next to none.
  constexpr double kTorsion = 2e4, kOwn = 1e-3 / 3.0;
  Eigen::Matrix3d M;
  M << kOwn + kHubInertia + kGeneratorInertia, kHubInertia, kGeneratorInertia, kHubInertia,
      kHubInertia, 0.0, kGeneratorInertia, 0.0, kGeneratorInertia;
  const Eigen::Vector3d turn(0.0, 1.0, -1.0 / kTeeth), roll = Eigen::Vector3d::UnitX();
  const Eigen::Matrix3d K = kShaft * turn * turn.transpose() + kTorsion * roll * roll.transpose();
  const Eigen::VectorXd squares =
      Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d>(K, M).eigenvalues();
  const ModesResult found =
      solve_modes(parse_scenario(make_mast("", "kind='free'\n"), "f"), {.state = {.speed = 0.0}});
  double nearest = 1.0;
  for (const Mode& mode : found.modes)
    nearest = std::min(nearest, std::abs(std::abs(mode.eigenvalue) / std::sqrt(squares[1]) - 1.0));
  CHECK(nearest < 1e-5);
}

TEST_CASE("a drive train on a beam moves as on a rigid body of next to no mass between") {
  const std::string drive = "kind='torque'\ntorque=30\ninitial_speed=6\n";
  const auto find = [&drive](double nacelle) {
    Simulation simulation(parse_scenario(
        make_mast("", drive, nacelle) + "[[hub_load]]\nforce=[5,40,30]\nposition=[0.3,0,0]\n",
        "f"));
    simulation.run_until(0.1);
    return Eigen::Vector4d(simulation.sensor("hub.angle"), simulation.sensor("hub.x"),
                           simulation.sensor("hub.y"), simulation.sensor("hub.z"));
  };
  const Eigen::Vector4d none = find(0.0);
  CHECK(none.norm() > 1e-2);
  for (const double nacelle : {1e-2, 1e-3}) CHECK((find(nacelle) - none).norm() < 1e-6);
}

TEST_CASE("a drive train on a beam: formulations, momentum and energy, executors") {
  check_conservation(make_system(parse_model(make_flying_mast("kind='free'\ninitial_speed=40\n"))),
                     0.1, 2e-4);
  const System<Space> system =
      make_system(parse_model(make_flying_mast("kind='torque'\ntorque=30\ninitial_speed=6\n")));
  check_formulations(system, make_generalized_alpha(0.8, 1e-3), 100, 1e-9);
  check_equal_bits(system, make_generalized_alpha(0.8, 1e-3), 30);
  for (const Formulation formulation : kFormulations)
    check_step_declarations(system, formulation, make_generalized_alpha(0.8, 1e-3));
}

TEST_CASE("a drive train on a beam needs a hub with mass") {
  std::string text = make_mast("", "kind='free'\n");
  text.replace(text.find("mass=20"), 7, "mass=0");
  text +=
      "[blade]\ncount=2\nlength=2\nsections={ mass_per_length=2, axial_stiffness=4e5, "
      "flap_stiffness=1e3, lag_stiffness=2e3, torsion_stiffness=800 }\n";
  CHECK(contains(message_of([&text] { parse_scenario(text, "f"); }),
                 "hub.mass: is 0, expected a number greater than 0 (kg) of a hub whose drive train "
                 "stands on a body that bends"));
}

TEST_CASE("drive trains that cannot be are refused") {
  const auto message = [](const std::string& from, const std::string& to) {
    std::string text = make_train(kHeld, "kind='free'\n");
    text.replace(text.find(from), from.size(), to);
    return message_of([&text] { parse_scenario(text, "f"); });
  };
  CHECK(contains(message("generator_inertia=0.07\n", ""),
                 "support.axle.generator_inertia: is missing, expected that of the drive train's"));
  CHECK(contains(message("stiffness=5e4\n", ""), "support.axle.stiffness: is missing, expected"));
  CHECK(contains(message("gear_ratio=12", "gear_ratio=0"),
                 "support.axle.gear_ratio: is 0, expected a number other than 0"));
  CHECK(contains(message("name='roll'", "name='generator'"),
                 "support.joint.1.name: is \"generator\", which is the generator of a rotor"));
}
