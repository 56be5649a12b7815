// Springs of joints that relax: motions of closed form, energies, and states that are saved.

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <string>
#include <vector>

#include "engine/equilibrium.h"
#include "engine/simulation.h"
#include "graph/execute/executor_kinds.h"
#include "tests/contains.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/serial.h"
#include "tests/message_of.h"
#include "tests/models/inline_toml.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr double kMass = 2.0, kSpring = 50.0;               // [kg, N/m]
constexpr double kRelaxing = 80.0, kTime = 0.3, kAt = 0.1;  // [N/m, s, m]

const std::string kSeries = "relaxation = { stiffness = 80.0, time = 0.3 }\n";

/// A mass on a spring, and what else its joint has.
std::string mass_on_spring(const std::string& relaxation, double step = 0.002) {
  return R"(
world = "space"
[hub.drive]
kind = "fixed"
[[subsystem]]
name = "mount"
body = [{ name = "mass", kind = "rigid", mass = 2.0, inertia = 0.2 }]
[[subsystem.joint]]
name = "rubber"
parent = "hub"
child = "mass"
kind = "prismatic"
axis = [1.0, 0.0, 0.0]
stiffness = 50.0
initial = 0.1
)" + relaxation +
         "[integration]\nduration = 2.0\nstep = " + std::to_string(step) + '\n';
}

Scenario read(const std::string& text, IntegrationMethod method) {
  Scenario scenario = parse_scenario(text, "relaxing.toml");
  scenario.integration.method = method;
  return scenario;
}

/// Place, speed and force -z of the mass at a time, by the roots of s^3 + s^2/T + s (k + k1)/m +
/// k/(m T).
struct Exact {
  double q = 0.0, v = 0.0, z = 0.0;

  explicit Exact(double t) {
    Eigen::Matrix3d A;  // of (q, v, z)
    A << 0.0, 1.0, 0.0, -kSpring / kMass, 0.0, -1.0 / kMass, 0.0, kRelaxing, -1.0 / kTime;
    const Eigen::EigenSolver<Eigen::Matrix3d> roots(A);
    const Eigen::Matrix3cd shapes = roots.eigenvectors();
    const Eigen::Vector3cd start = shapes.partialPivLu().solve(Eigen::Vector3cd(kAt, 0.0, 0.0));
    const Eigen::Vector3cd x =
        shapes * (roots.eigenvalues() * t).array().exp().matrix().cwiseProduct(start);
    q = x[0].real();
    v = x[1].real();
    z = x[2].real();
  }
};

double error_at(double t, double step, IntegrationMethod method, Formulation formulation) {
  Simulation simulation(read(mass_on_spring(kSeries, step), method), serial(formulation));
  simulation.run_until(t);
  const CoordinateMotion now = simulation.joint_motion(0, 0);
  const Exact exact(t);
  return std::hypot(now.value - exact.q, (now.velocity - exact.v) / std::sqrt(kSpring / kMass));
}

}  // namespace

TEST_CASE("a mass on a spring that relaxes moves by the roots of its cubic equation") {
  for (const Formulation formulation :
       {Formulation::structured, Formulation::subsystem, Formulation::augmented})
    for (const IntegrationMethod method :
         {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4}) {
      CAPTURE(static_cast<int>(formulation));
      CAPTURE(static_cast<int>(method));
      const double whole = error_at(1.2, 0.008, method, formulation);
      const double half = error_at(1.2, 0.004, method, formulation);
      CHECK(whole < 4e-3 * kAt);
      CHECK(whole > 3.6 * half);
      CHECK(whole < 4.6 * half);
    }
}

TEST_CASE("a spring that relaxes holds energy, and takes z^2/(k T)") {
  for (const IntegrationMethod method :
       {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4}) {
    Simulation simulation(read(mass_on_spring(kSeries, 0.001), method), kSerial);
    const double start = 0.5 * kSpring * kAt * kAt;
    CHECK(std::abs(simulation.sensor("energy.strain") - start) < 1e-12);
    double largest = 0.0;
    simulation.run_until(1.2, [&](double t, std::span<const double>) {
      const Exact exact(t);
      const double strain = 0.5 * kSpring * exact.q * exact.q + 0.5 * exact.z * exact.z / kRelaxing;
      CHECK(std::abs(simulation.sensor("energy.strain") - strain) < 3e-4 * start);
      largest = std::max(largest, std::abs(simulation.sensor("energy.residual")));
    });
    CHECK(largest < 3e-4 * start);
    const Exact exact(1.2);
    const double left = 0.5 * (kMass * exact.v * exact.v + kSpring * exact.q * exact.q +
                               exact.z * exact.z / kRelaxing);
    CHECK(left < 0.7 * start);
    CHECK(std::abs(simulation.sensor("energy.dissipated") - (start - left)) < 3e-4 * start);
  }
}

TEST_CASE("a stiff spring that relaxes at once is a damper, and one that never does a spring") {
  const auto end_of = [](const std::string& keys, double stiffness, double rest) {
    Scenario scenario = read(mass_on_spring(keys), IntegrationMethod::generalized_alpha);
    spatial::JointCoordinate& coordinate =
        scenario.space->subsystems[0].joints[0].joint.coordinates[0];
    coordinate.stiffness = stiffness;
    coordinate.rest = rest;
    Simulation simulation(scenario, kSerial);
    simulation.run_until(1.0);
    return simulation.joint_motion(0, 0).value;
  };
  const double damped = end_of("damping = 4.0\n", kSpring, 0.0);
  // A damper that feels the mean speed of a step: of first order.
  CHECK(std::abs(end_of("relaxation = { stiffness = 4e6, time = 1e-6 }\n", kSpring, 0.0) - damped) <
        1e-3 * kAt);
  const double both = kSpring + kRelaxing;
  const double sprung = end_of("", both, kRelaxing * kAt / both);
  CHECK(std::abs(end_of("relaxation = { stiffness = 80.0, time = 1e9 }\n", kSpring, 0.0) - sprung) <
        1e-6 * kAt);
}

namespace {

/// An arm whose elbow turns and slides, and a mass in a bushing; all relax.
const std::string kArm = R"(
world = "space"
[hub.drive]
kind = "constant"
speed = 1.5
[gravity]
acceleration = [0.0, 0.0, -9.81]
[[subsystem]]
name = "arm"
body = [
  { name = "upper", kind = "rigid", mass = 2.0, center = [0.5, 0.0, 0.0], inertia = 0.2 },
  { name = "fore", kind = "rigid", mass = 1.0, center = [0.3, 0.0, 0.0], inertia = 0.05 },
  { name = "load", kind = "rigid", mass = 0.5, inertia = 0.02 }]
[[subsystem.joint]]
name = "shoulder"
parent = "hub"
child = "upper"
kind = "universal"
axes = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
stiffness = [60.0, 40.0]
relaxation = [{}, { stiffness = 100.0, time = 0.05 }]
[[subsystem.joint]]
name = "elbow"
parent = "upper"
child = "fore"
kind = "cylindrical"
axis = [0.0, 1.0, 0.0]
offset = [1.0, 0.0, 0.0]
stiffness = [20.0, 300.0]
relaxation = [{ stiffness = 30.0, time = 0.2 }, { stiffness = 500.0, time = 0.01 }]
[[subsystem.joint]]
name = "mount"
parent = "fore"
child = "load"
kind = "bushing"
offset = [0.6, 0.0, 0.0]
stiffness = [4e3, 4e3, 4e3, 5.0, 0.0, 0.0]
relaxation = [{ stiffness = 2e3, time = 0.02 }, {}, { stiffness = 2e3, time = 0.02 },
              { stiffness = 8.0, time = 0.1 }, {}, {}]
[integration]
step = 0.002
duration = 1.0
)";

SimulationOptions options_of(Formulation formulation, ExecutorKind executor, int threads) {
  return {formulation, executor, threads};
}

}  // namespace

TEST_CASE("formulations agree on joints that relax, and executors have equal bits") {
  std::vector<double> ends;
  for (const Formulation formulation :
       {Formulation::structured, Formulation::subsystem, Formulation::augmented}) {
    Simulation serial_run(parse_scenario(kArm, "arm.toml"),
                          options_of(formulation, ExecutorKind::serial, 1));
    Simulation parallel(parse_scenario(kArm, "arm.toml"),
                        options_of(formulation, ExecutorKind::flow_graph, 3));
    serial_run.run_until(0.5);
    parallel.run_until(0.5);
    CHECK(serial_run.state_hash() == parallel.state_hash());
    CHECK(std::abs(serial_run.sensor("energy.residual")) <
          2e-3 * serial_run.sensor("energy.dissipated"));
    ends.push_back(serial_run.joint_motion(0, 1).value);
  }
  for (const double end : ends) CHECK(std::abs(end - ends[0]) < 1e-7);
}

TEST_CASE("springs that relax go on from saved states, and clones do") {
  Simulation simulation(parse_scenario(kArm, "arm.toml"), kSerial);
  simulation.run_until(0.3);
  const SavedState state = simulation.save();
  Simulation clone = simulation.clone();
  simulation.run_until(0.6);
  const std::uint64_t expected = simulation.state_hash();
  clone.run_until(0.6);
  CHECK(clone.state_hash() == expected);
  simulation.restore(state);
  simulation.run_until(0.6);
  CHECK(simulation.state_hash() == expected);
  Simulation other(parse_scenario(kArm, "arm.toml"), kSerial);
  other.restore(state);
  other.run_until(0.6);
  CHECK(other.state_hash() == expected);
}

TEST_CASE("at rest a spring has relaxed") {
  Scenario relaxing = parse_scenario(mass_on_spring(kSeries + "force = 10.0\n"), "relaxing.toml");
  const EquilibriumResult found = solve_equilibrium(relaxing);
  const EquilibriumResult plain =
      solve_equilibrium(parse_scenario(mass_on_spring("force = 10.0\n"), "plain.toml"));
  CHECK(std::abs(found.blades[0].joints[0].value - plain.blades[0].joints[0].value) < 1e-12);
  relaxing.initial = {InitialState::equilibrium, {}};
  Simulation simulation(relaxing, kSerial);
  simulation.run_until(0.5);
  CHECK(std::abs(simulation.joint_motion(0, 0).value - 0.2) < 1e-9);
}

TEST_CASE("a relaxation is read, written and refused where no spring can be") {
  const Scenario scenario = parse_scenario(kArm, "arm.toml");
  CHECK(parse_scenario(document_of(scenario.to_json()), "arm.toml").to_json() ==
        scenario.to_json());
  const auto refusal = [](const std::string& keys) {
    return message_of([&] { parse_scenario(mass_on_spring(keys), "relaxing.toml"); });
  };
  CHECK(contains(refusal("relaxation = { stiffness = 80.0 }\n"), "time"));
  CHECK(contains(refusal("relaxation = { stiffness = 80.0, time = 0.0 }\n"), "time"));
  CHECK(contains(refusal("relaxation = { stiffness = -1.0, time = 0.1 }\n"), "stiffness"));
  CHECK(contains(refusal("relaxation = {}\n"), "stiffness"));
  std::string held = kArm;
  held.replace(held.find("{ stiffness = 8.0, time = 0.1 }, {}"), 35,
               "{}, { stiffness = 8.0, time = 0.1 }");
  CHECK(contains(message_of([&] { parse_scenario(held, "arm.toml"); }),
                 "relaxation.5: is in a direction that is held"));
}
