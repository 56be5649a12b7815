// Compares state-space matrices in multi-blade coordinates with modes, equilibria, runs, and the
// matrices of the turning frame.

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "engine/equilibrium.h"
#include "engine/linearize.h"
#include "engine/modes.h"
#include "engine/simulation.h"
#include "models/error.h"
#include "models/scenario.h"
#include "tests/message_of.h"
#include "tests/shipped.h"

namespace spoke {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::message_of;
using Complex = std::complex<double>;

constexpr Complex kI(0.0, 1.0);
constexpr double kRate = 6.0;

Eigen::Index find(const std::vector<LinearSignal>& signals, const std::string& name) {
  const auto at = std::find_if(signals.begin(), signals.end(),
                               [&](const LinearSignal& signal) { return signal.name == name; });
  CAPTURE(name);
  REQUIRE(at != signals.end());
  return at - signals.begin();
}
Eigen::Index output_of(const LinearSystem& system, const std::string& name) {
  return find(system.outputs, name);
}
Eigen::Index input_of(const LinearSystem& system, const std::string& name) {
  return find(system.inputs, name);
}

const std::string kRotorHub = R"(
world = "space"
[hub]
radius = 0.2
mass = 4.0
inertia = [0.2, 0.2, 0.3]
)";
const std::string kConstant = R"(
[hub.drive]
kind = "constant"
speed = 6.0
)";
const std::string kMast = R"(
[support]
from = "ground"
[[support.body]]
name = "mast"
kind = "beam"
length = 2.0
bodies = 1
elements = 2
[support.body.sections]
mass_per_length = 2.0
axial_stiffness = 1e6
flap_stiffness = 4e3
lag_stiffness = 2.5e3
torsion_stiffness = 2e3
flap_inertia = 0.01
lag_inertia = 0.01
[[support.joint]]
child = "mast"
kind = "fixed"
orientation = [0.0, -1.5707963267948966, 0.0]
[support.axle]
body = "mast"
offset = [0.1, 0.0, -0.3]
orientation = [0.2, 0.4, 0.1]
[damping]
stiffness_factor = 2e-3
)";
/// Blades on spring hinges that flap, lag and twist, coned and askew.
std::string blades_of(int count) {
  return "[blade]\ncount = " + std::to_string(count) +
         "\nazimuth = 0.3\nlength = 1.5\nbodies = 1\nelements = 2\nprecone = 0.1\n" +
         R"([blade.sections]
mass_per_length = 0.8
axial_stiffness = 1e5
flap_stiffness = 40.0
lag_stiffness = 90.0
torsion_stiffness = 30.0
flap_inertia = 1e-3
lag_inertia = 2e-3
twist = 0.3
[[blade.joint]]
name = "flap"
station = 0.0
kind = "revolute"
axis = [0.0, -1.0, 0.0]
stiffness = 60.0
damping = 1.0
)";
}
/// Springs and dampers from each blade to the next one, askew, and a soft coupling of their hinges.
const std::string kRing = R"(
[[blade.loop]]
name = "damper"
kind = "distance"
from = { station = 0.75, point = [0.0, 0.1, 0.02] }
to = { blade = "next", station = 0.75, point = [0.0, -0.05, 0.0] }
stiffness = 80.0
damping = 3.0
[[blade.coupling]]
name = "linkage"
joints = [{ joint = "flap", ratio = 1.0 }, { blade = "next", joint = "flap", ratio = -0.6 }]
stiffness = 15.0
damping = 0.4
)";
const std::string kMastSensor = R"(
[[sensor]]
name = "top"
quantity = "displacement"
subsystem = "support"
body = "mast"
frame = "inertial"
)";
const std::string kBladeSensors = R"(
[[sensor]]
name = "near"
quantity = "section_force"
position = 0.2
[[sensor]]
name = "along"
quantity = "displacement"
frame = "blade"
[[sensor]]
name = "shake"
quantity = "acceleration"
)";
const std::string kEnd = "[integration]\nduration = 1.0\n";

/// A load on blades that has ended.
const std::string kEndedLoad = R"(
[[load]]
frame = "body"
force = [0.3, 1.0, 2.0]
time = [0.0, 1.0]
factor = [0.0, 0.0]
)";
Scenario make_scenario(const std::string& text) { return parse_scenario(text, "rotor.toml"); }
/// `ring`: what ties the blades.
Scenario make_machine(int blades, const std::string& more = "", const std::string& ring = "") {
  return make_scenario(kRotorHub + kConstant + kMast + blades_of(blades) + ring + kMastSensor +
                       kBladeSensors + more + kEnd);
}

MatrixXcd transfer(const LinearSystem& system, Complex s) {
  const Eigen::Index n = system.A.rows();
  const MatrixXcd sA = s * MatrixXcd::Identity(n, n) - MatrixXd(system.A).cast<Complex>();
  return MatrixXd(system.C).cast<Complex>() *
             sA.partialPivLu().solve(MatrixXd(system.B).cast<Complex>()) +
         MatrixXd(system.D).cast<Complex>();
}

TEST_CASE("multi-blade system: its eigenvalues are those of the modes, of the fixed frame") {
  for (const std::string& ring : {std::string(), kRing})
    for (const int blades : {3, 4, 5}) {
      CAPTURE(ring);
      CAPTURE(blades);
      const Scenario scenario = make_machine(blades, "", ring);
      const LinearSystem system = solve_linear_system(scenario);
      CHECK(system.frame == ModeFrame::fixed);
      const Eigen::VectorXcd roots = MatrixXd(system.A).eigenvalues();
      const ModesResult modes = solve_modes(scenario, {.count = 14});
      for (const Mode& mode : modes.modes) {
        CAPTURE(mode.name);
        CHECK((roots.array() - mode.eigenvalue).abs().minCoeff() <
              1e-6 * std::abs(mode.eigenvalue));
      }
    }
}

TEST_CASE("multi-blade system: signals have names, and only what is constant is there") {
  for (const std::string& ring : {std::string(), kRing}) {
    CAPTURE(ring);
    const LinearSystem system = solve_linear_system(
        make_machine(4,
                     "[[load]]\nframe = \"body\"\nforce = [0.0, 0.0, 1.0]\n[[load]]\nblade = "
                     "2\nframe = \"body\"\n"
                     "force = [0.0, 1.0, 0.0]\nfactor = [0.0, 0.0]\ntime = [0.0, 1.0]\n",
                     ring));
    CHECK(system.states[0].name == "support / mast / node 1 / u");
    find(system.states, "blades 1 to 4 / flap cosine");
    find(system.states, "rate of blades 1 to 4 / flap differential");
    for (const std::string which : {"collective", "cosine", "sine", "differential"}) {
      input_of(system, "blades 1 to 4 / load.1 " + which);
      input_of(system, "blades 1 to 4 / flap motor " + which);
      output_of(system, "blades 1 to 4 / near.moment.y " + which);
      output_of(system, "blades 1 to 4 / flap " + which);
    }
    input_of(system, "hub / force x");
    output_of(system, "support.top.x");
    output_of(system, "rate of hub / rotation y");
    CHECK(system.left_out_inputs == std::vector<std::string>{"blade 2 / load.2"});
  }
}

/// Returns a scenario whose load number k is constant.
Scenario with_load(Scenario scenario, std::size_t k, double factor) {
  scenario.space->loads[k].factor = Curve(factor);
  return scenario;
}

/// The same, and loads on the mast, and of constant direction on blades.
const std::string kEndedLoads = kEndedLoad + R"(
[[load]]
subsystem = "support"
body = "mast"
frame = "inertial"
force = [2.0, -1.0, 0.5]
moment = [0.3, 0.1, -0.2]
time = [0.0, 1.0]
factor = [0.0, 0.0]
[[load]]
frame = "inertial"
force = [1.0, 2.0, -1.5]
time = [0.0, 1.0]
factor = [0.0, 0.0]
)";

TEST_CASE("multi-blade system: static gains are differences of equilibria") {
  const Scenario scenario = make_machine(3, kEndedLoads);
  const LinearSystem system = solve_linear_system(scenario);
  const MatrixXd gains = transfer(system, 0.0).real();
  const EquilibriumResult at = solve_equilibrium(scenario);
  constexpr double kStep = 1e-2;
  const std::array<std::string, 2> inputs{"blades 1 to 3 / load.1 collective", "support / load.2"};
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    CAPTURE(inputs[k]);
    const Eigen::Index column = input_of(system, inputs[k]);
    const EquilibriumResult plus = solve_equilibrium(with_load(scenario, k, kStep));
    const EquilibriumResult minus = solve_equilibrium(with_load(scenario, k, -kStep));
    const auto differ = [&](const auto& of) {
      return Vector3d((of(plus) - of(minus)) / (2.0 * kStep));
    };
    const auto check = [&](const Vector3d& known, const std::string& name,
                           const std::string& which) {
      CAPTURE(name);
      Vector3d found;
      for (int c = 0; c < 3; ++c)
        found[c] = gains(output_of(system, name + std::string(1, "xyz"[c]) + which), column);
      CHECK((found - known).norm() < 1e-6 * known.norm() + 1e-9);
    };
    check(differ([&](const EquilibriumResult& e) {
            return Vector3d(at.hub->axes.transpose() * e.hub->position);
          }),
          "hub / ", "");
    // The mast's end.
    check(differ([](const EquilibriumResult& e) { return e.blades.back().nodes[2]; }),
          "support.top.", "");
    check(differ([](const EquilibriumResult& e) {
            const Eigen::AngleAxisd back(-0.3, Vector3d::UnitZ());
            return Vector3d(back * e.blades[0].tip_displacement);
          }),
          "blades 1 to 3 / tip.", " collective");
  }
}

constexpr double kTimeStep = 1e-3;
constexpr int kRunSteps = 700;

/// The course of an input, which an equilibrium at t = 0 does not have.
double rise(double t) { return std::min(t / 0.1, 1.0); }

/// Outputs over time under an input that rises to `size`, by the trapezoidal rule.
MatrixXd simulate_linear(const LinearSystem& system, Eigen::Index input, double size) {
  const Eigen::Index n = system.A.rows();
  const MatrixXd half = 0.5 * kTimeStep * MatrixXd(system.A), one = MatrixXd::Identity(n, n);
  const Eigen::PartialPivLU<MatrixXd> implicit(one - half);
  const VectorXd b = size * MatrixXd(system.B).col(input), d = size * MatrixXd(system.D).col(input);
  VectorXd x = VectorXd::Zero(n);
  MatrixXd outputs = MatrixXd::Zero(system.C.rows(), kRunSteps + 1);
  for (int k = 1; k <= kRunSteps; ++k) {
    const double before = rise(kTimeStep * (k - 1)), now = rise(kTimeStep * k);
    x = implicit.solve(x + half * x + 0.5 * kTimeStep * (before + now) * b);
    outputs.col(k) = system.C * x + now * d;
  }
  return outputs;
}

/// Returns a scenario whose load number k rises.
Scenario with_rising(Scenario scenario, std::size_t k, double size) {
  scenario.space->loads[k].factor = Curve({0.0, 0.1}, {0.0, size});
  return scenario;
}

/// Returns loads that rise, one for each blade in the place of load `k`, which go with the blades'
/// azimuths.
Scenario with_pattern(Scenario scenario, std::size_t k, const std::string& which, double size) {
  std::vector<spatial::PointLoad>& loads = scenario.space->loads;
  const spatial::PointLoad pattern = loads[k];
  loads.clear();
  for (int blade = 1; blade <= 3; ++blade) {
    std::vector<double> times, factors;
    for (int step = 0; step <= 2 * kRunSteps + 2; ++step) {
      const double t = 0.5 * kTimeStep * step;
      const double psi = 0.3 + 2.0 * std::numbers::pi * (blade - 1) / 3.0 + kRate * t;
      times.push_back(t);
      factors.push_back(size * rise(t) *
                        (which == "cosine" ? std::cos(psi)
                         : which == "sine" ? std::sin(psi)
                                           : 1.0));
    }
    spatial::PointLoad& load = loads.emplace_back(pattern);
    load.place.blade = BladeChoice::number(blade);
    load.factor = Curve(times, factors);
  }
  return scenario;
}

/// Sensors over time, as differences from their start: the mast's, then amplitudes of the three
/// blades' tips along their own axes.
struct Run {
  MatrixXd top;                     ///< x, y, z
  std::array<MatrixXd, 3> tips;     ///< collective, cosine, sine; x, y, z
  std::array<MatrixXd, 3> moments;  ///< of the section of the sensor "near"
  std::array<MatrixXd, 3> shakes;   ///< accelerations of the tips, along their own axes
};
Run run(Scenario scenario) {
  scenario.initial.state = InitialState::equilibrium;
  scenario.integration.step = kTimeStep;
  scenario.integration.duration = kRunSteps * kTimeStep;
  scenario.integration.spectral_radius = 1.0;
  scenario.integration.tolerance = 1e-14;
  Simulation simulation(scenario);
  const MatrixXd none = MatrixXd::Zero(3, kRunSteps + 1);
  Run run{none, {none, none, none}, {none, none, none}, {none, none, none}};
  const auto sense = [&](const std::string& name) {
    return Vector3d(simulation.sensor(name + "x"), simulation.sensor(name + "y"),
                    simulation.sensor(name + "z"));
  };
  const auto take = [&](int step) {
    run.top.col(step) = sense("support.top.");
    for (int blade = 0; blade < 3; ++blade) {
      const double azimuth = 0.3 + 2.0 * std::numbers::pi * blade / 3.0;
      const double psi = azimuth + kRate * kTimeStep * step;
      const std::string prefix = "blade" + std::to_string(blade + 1);
      const Eigen::AngleAxisd along(-azimuth, Vector3d::UnitZ());
      const Vector3d tip = along * sense(prefix + ".tip.");
      const Vector3d shake = along * sense(prefix + ".shake.");
      const Vector3d moment = sense(prefix + ".near.moment.");
      const std::array<double, 3> shares{1.0 / 3.0, 2.0 / 3.0 * std::cos(psi),
                                         2.0 / 3.0 * std::sin(psi)};
      for (std::size_t k = 0; k < 3; ++k) {
        run.tips[k].col(step) += shares[k] * tip;
        run.moments[k].col(step) += shares[k] * moment;
        run.shakes[k].col(step) += shares[k] * shake;
      }
    }
  };
  take(0);
  while (!simulation.done()) {
    simulation.step();
    take(static_cast<int>(simulation.steps()));
  }
  const auto from_start = [](MatrixXd& values) { values.colwise() -= VectorXd(values.col(0)); };
  from_start(run.top);
  for (auto* all : {&run.tips, &run.moments, &run.shakes})
    for (MatrixXd& values : *all) from_start(values);
  return run;
}

/// Checks rows of outputs against a run, to `error` of the largest value.
void compare(const LinearSystem& system, const MatrixXd& linear, const Run& run, double error) {
  const auto check = [&](const MatrixXd& known, const std::string& prefix, const std::string& which,
                         double size) {
    for (Eigen::Index c = 0; c < 3; ++c) {
      const std::string name = prefix + "xyz"[c] + which;
      CAPTURE(name);
      const Eigen::Index row = output_of(system, name);
      const VectorXd difference = linear.row(row) - known.row(c);
      CHECK(difference.lpNorm<Eigen::Infinity>() < error * size);
    }
  };
  const auto size_of = [](const MatrixXd& m) { return m.cwiseAbs().maxCoeff(); };
  check(run.top, "support.top.", "", size_of(run.top));
  const std::array<std::string, 3> names{" collective", " cosine", " sine"};
  double tip = 0.0, moment = 0.0, shake = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    tip = std::max(tip, size_of(run.tips[k]));
    moment = std::max(moment, size_of(run.moments[k]));
    shake = std::max(shake, size_of(run.shakes[k]));
  }
  for (std::size_t k = 0; k < 3; ++k) {
    check(run.tips[k], "blades 1 to 3 / tip.", names[k], tip);
    check(run.moments[k], "blades 1 to 3 / near.moment.", names[k], moment);
    // Accelerations of the method of a run follow with more error.
    check(run.shakes[k], "blades 1 to 3 / shake.", names[k], 5.0 * shake);
  }
}

TEST_CASE("multi-blade system: a run under small loads answers likewise") {
  constexpr double kSmall = 5e-4;
  for (const std::string& ring : {std::string(), kRing}) {
    CAPTURE(ring);
    const Scenario scenario = make_machine(3, kEndedLoads, ring);
    const LinearSystem system = solve_linear_system(scenario);
    const auto check = [&](const std::string& input, const Scenario& loaded) {
      CAPTURE(input);
      compare(system, simulate_linear(system, input_of(system, input), kSmall), run(loaded), 2e-4);
    };
    for (const std::string which : {"collective", "cosine", "sine"})
      check("blades 1 to 3 / load.1 " + which, with_pattern(scenario, 0, which, kSmall));
    check("support / load.2", with_rising(scenario, 1, kSmall));
    // Of constant direction, on all blades: a pattern by itself.
    check("blades 1 to 3 / load.3 collective", with_rising(scenario, 2, kSmall));
  }
}

TEST_CASE("multi-blade system: a drive that is a torque acts between hub and support") {
  Scenario scenario = make_machine(3);
  scenario.space->hub.drive = TorqueDrive{Curve(0.0), 0.0};
  const LinearSystem system = solve_linear_system(scenario, {kRate});
  const MatrixXd B(system.B);
  const Eigen::Index axle = find(system.states, "support / axle");
  const Eigen::Index torque = input_of(system, "axle / torque");
  const Eigen::Index rate = find(system.states, "rate of support / axle");
  CHECK(rate == axle + system.A.rows() / 2);
  CHECK(B(rate, torque) > 0.0);
}

TEST_CASE("multi-blade system: what the hub yields to forces is reciprocal, of rotation turned") {
  const auto comply = [](double speed) {
    const LinearSystem system = solve_linear_system(make_machine(4), {speed});
    const MatrixXcd all = transfer(system, 9.0 * kI);
    MatrixXcd own(6, 6);
    const std::array<std::string, 6> moves{"x", "y", "z", "rotation x", "rotation y", "angle"};
    const std::array<std::string, 6> efforts{"force x",  "force y",  "force z",
                                             "moment x", "moment y", "torque"};
    for (Eigen::Index r = 0; r < 6; ++r)
      for (Eigen::Index c = 0; c < 6; ++c)
        own(r, c) = all(output_of(system, "hub / " + moves[static_cast<std::size_t>(r)]),
                        input_of(system, "hub / " + efforts[static_cast<std::size_t>(c)]));
    return own;
  };
  const MatrixXcd there = comply(kRate), back = comply(-kRate);
  CHECK((there - back.transpose()).cwiseAbs().maxCoeff() < 1e-6 * there.cwiseAbs().maxCoeff());
  CHECK((there - there.transpose()).cwiseAbs().maxCoeff() > 1e-3 * there.cwiseAbs().maxCoeff());
}

TEST_CASE("multi-blade system: of a rotor on an axle blades answer as in the turning frame") {
  for (const std::string& ring : {std::string(), kRing}) {
    CAPTURE(ring);
    constexpr int blades = 3;
    const Scenario scenario = make_scenario(kRotorHub + kConstant + blades_of(blades) + ring +
                                            kBladeSensors + kEndedLoad + kEnd);
    const LinearSystem turning = solve_linear_system(scenario);
    CHECK(turning.frame == ModeFrame::turning);
    const LinearSystem fixed = solve_linear_system(scenario, {}, ModeFrame::fixed);
    CHECK(fixed.states.size() == turning.states.size());
    constexpr double kFrequency = 11.0;
    // Blade 1 under loads on all blades, whose phases go with n times their azimuths from it.
    const auto blade = [&](double w, int n, const std::string& output) {
      const MatrixXcd all = transfer(turning, w * kI);
      Complex sum = 0.0;
      for (int b = 0; b < blades; ++b)
        sum += std::polar(1.0, 2.0 * std::numbers::pi * n * b / blades) *
               all(output_of(turning, "blade1." + output),
                   input_of(turning, "blade " + std::to_string(b + 1) + " / load.1"));
      return sum;
    };
    const MatrixXcd all = transfer(fixed, kFrequency * kI);
    for (const std::string output :
         {"along.x", "along.y", "along.z", "near.force.x", "near.moment.y", "shake.z"}) {
      CAPTURE(output);
      const Complex plus = blade(kFrequency + kRate, 1, output);
      const Complex minus = blade(kFrequency - kRate, -1, output);
      const auto check = [&](const std::string& to, const std::string& by, Complex known) {
        const Complex found = all(output_of(fixed, "blades 1 to 3 / " + output + ' ' + to),
                                  input_of(fixed, "blades 1 to 3 / load.1 " + by));
        CHECK(std::abs(found - known) < 1e-7 * (std::abs(plus) + std::abs(minus)));
      };
      check("collective", "collective", blade(kFrequency, 0, output));
      check("cosine", "cosine", 0.5 * (plus + minus));
      check("sine", "cosine", 0.5 * kI * (plus - minus));
      check("cosine", "sine", -0.5 * kI * (plus - minus));
      check("sine", "collective", 0.0);
    }
  }
}

TEST_CASE("multi-blade system: a free hub answers forces as in the turning frame") {
  const Scenario scenario = make_scenario(
      "world = \"space\"\n[hub]\nsupport = \"free\"\nradius = 0.2\nmass = 4.0\n"
      "inertia = [0.2, 0.2, 0.3]\nangular_velocity = [0.0, 0.0, 6.0]\n" +
      blades_of(3) + kBladeSensors + kEnd);
  const LinearSystem turning = solve_linear_system(scenario, {kRate});
  const LinearSystem fixed = solve_linear_system(scenario, {kRate}, ModeFrame::fixed);
  constexpr double kFrequency = 13.0;
  const auto block = [](const LinearSystem& system, double w, const std::string& move,
                        const std::string& effort) {
    const MatrixXcd all = transfer(system, w * kI);
    Eigen::Matrix2cd own;
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 2; ++c)
        own(r, c) = all(output_of(system, "hub / " + move + "xy"[r]),
                        input_of(system, "hub / " + effort + "xy"[c]));
    return own;
  };
  Eigen::Matrix2cd E;
  E << 1.0, kI, -kI, 1.0;
  for (const std::string move : {"", "rotation "})
    for (const std::string effort : {"force ", "moment "}) {
      CAPTURE(move + effort);
      // Turning forces are (E^T exp(i W t) + E^H exp(-i W t))/2 times standing ones.
      const Eigen::Matrix2cd plus = block(turning, kFrequency + kRate, move, effort);
      const Eigen::Matrix2cd minus = block(turning, kFrequency - kRate, move, effort);
      const Eigen::Matrix2cd known =
          0.25 * (E.conjugate() * plus * E.transpose() + E * minus * E.adjoint());
      const Eigen::Matrix2cd found = block(fixed, kFrequency, move, effort);
      CHECK((found - known).norm() < 1e-7 * known.norm());
    }
}

TEST_CASE("multi-blade system: a push of constant direction on the hub is forces on it") {
  const Scenario scenario = test::read_shipped("ground_resonance");
  const LinearSystem system = solve_linear_system(scenario);
  const MatrixXd B(system.B);
  const VectorXd push = B.col(input_of(system, "hub / hub_load.1"));
  const VectorXd known =
      10.0 * (B.col(input_of(system, "hub / force x")) + B.col(input_of(system, "hub / force y")));
  CHECK(known.norm() > 0.0);
  CHECK((push - known).norm() < 1e-9 * known.norm());
}

TEST_CASE("multi-blade system: what has no constant matrices is refused") {
  const auto contains = [](const std::string& text, const std::string& part) {
    CAPTURE(text);
    CHECK(text.find(part) != std::string::npos);
  };
  contains(message_of([] { solve_linear_system(make_machine(2)); }),
           "expects three or more equal blades, got 2");
  contains(message_of([] { solve_linear_system(make_machine(3), {}, ModeFrame::turning); }),
           "expects a hub whose support does not move");
  contains(message_of([] { solve_linear_system(make_machine(3), {}, ModeFrame::floquet); }),
           "matrices are not constant, expected \"turning\" or \"fixed\"");
}

}  // namespace
}  // namespace spoke
