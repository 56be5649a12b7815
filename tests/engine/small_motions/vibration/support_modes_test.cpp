// Finds equilibria, modes and critical values of rotors on supports that are known.

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "engine/critical.h"
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

using doctest::Approx;
using Eigen::MatrixXd;
using test::message_of;
using Complex = std::complex<double>;

/// Returns the eigenvalues of M x'' + C x' + K x = 0 that have no negative imaginary part.
std::vector<Complex> solve(const MatrixXd& M, const MatrixXd& C, const MatrixXd& K) {
  const Eigen::Index n = M.rows();
  MatrixXd A = MatrixXd::Zero(2 * n, 2 * n);
  A.topRightCorner(n, n).setIdentity();
  A.bottomLeftCorner(n, n) = -M.inverse() * K;
  A.bottomRightCorner(n, n) = -M.inverse() * C;
  std::vector<Complex> roots;
  const Eigen::VectorXcd values = Eigen::EigenSolver<MatrixXd>(A).eigenvalues();
  for (const Complex s : values)
    if (s.imag() >= 0.0) roots.push_back(s);
  std::sort(roots.begin(), roots.end(),
            [](Complex a, Complex b) { return std::abs(a) < std::abs(b); });
  return roots;
}

double distance(Complex s, const std::vector<Mode>& modes) {
  double nearest = 1e300;
  for (const Mode& mode : modes)
    nearest = std::min(
        {nearest, std::abs(s - mode.eigenvalue), std::abs(s - std::conj(mode.eigenvalue))});
  return nearest;
}

/// Returns the roots of ground_resonance.toml by Coleman and Feingold: of the lag sums by cosine
/// and sine, and of the hub's x and y.
std::vector<Complex> solve_coleman(double speed, double damping = 0.0) {
  constexpr double kBlades = 3.0, kOffset = 0.3, kSpring = 400.0;
  const double moment = 20.0 * 2.5, inertia = 41.6667 + moment * 2.5;
  const double spring = kSpring + speed * speed * kOffset * moment;
  MatrixXd M = MatrixXd::Zero(4, 4), C = M, K = M;
  M.diagonal() << inertia, inertia, 660.0, 660.0;
  M(0, 3) = 0.5 * kBlades * moment;
  M(1, 2) = -0.5 * kBlades * moment;
  M(2, 1) = -moment;
  M(3, 0) = moment;
  C(0, 1) = 2.0 * speed * inertia;
  C(1, 0) = -C(0, 1);
  C(0, 0) = C(1, 1) = damping;
  C(2, 2) = 2000.0;
  C(3, 3) = 1500.0;
  K.diagonal() << spring - speed * speed * inertia, spring - speed * speed * inertia, 2.0e5, 1.4e5;
  K(0, 1) = damping * speed;
  K(1, 0) = -K(0, 1);
  return solve(M, C, K);
}

TEST_CASE(
    "support modes: ground resonance on unequal springs has the growth of Coleman and Feingold") {
  const Scenario scenario = test::read_shipped("ground_resonance");
  for (const double speed : {12.0, 20.0, 25.0, 28.0}) {
    CAPTURE(speed);
    const ModesResult found = solve_modes(scenario, {.state = {speed}, .count = 5});
    CHECK(found.frame == ModeFrame::fixed);
    for (const Complex s : solve_coleman(speed))
      CHECK(distance(s, found.modes) < 1e-6 * std::abs(s));
  }
}

TEST_CASE("support modes: ground resonance sets on where Coleman and Feingold's root grows") {
  constexpr double kDamping = 150.0;
  Scenario scenario = test::read_shipped("ground_resonance");
  for (spatial::Subsystem& blade : scenario.space->subsystems)
    if (!is_support(*scenario.space, blade))
      blade.joints[0].joint.coordinates[0].damping = kDamping;
  const CriticalResult found =
      solve_critical(scenario, {.of = "speed", .from = 5.0, .to = 30.0, .points = 11, .count = 5});
  REQUIRE(found.critical);
  CHECK(found.critical->kind == CriticalKind::flutter);
  const auto grows = [](double speed) {
    const std::vector<Complex> roots = solve_coleman(speed, kDamping);
    return std::any_of(roots.begin(), roots.end(), [](Complex s) { return s.real() > 0.0; });
  };
  CHECK_FALSE(grows(found.critical->value * (1.0 - 1e-6)));
  CHECK(grows(found.critical->value * (1.0 + 1e-6)));
}

/// Returns the frequencies of a disc at the end of a massless shaft of these bending stiffnesses,
/// which stands, by place and slope in both planes [rad/s].
std::vector<Complex> solve_overhung(double lag, double flap, double speed) {
  constexpr double L = 0.6, kMass = 10.0, kSpinInertia = 0.2 + 1e-5, kTiltInertia = 0.1 + 1e-5;
  Eigen::Matrix2d bend;
  bend << 12.0, -6.0 * L, -6.0 * L, 4.0 * L * L;
  bend /= L * L * L;
  MatrixXd M = MatrixXd::Zero(4, 4), C = M, K = M;
  K.topLeftCorner<2, 2>() = lag * bend;       // y and the slope of y
  K.bottomRightCorner<2, 2>() = flap * bend;  // z and the slope of z
  M.diagonal() << kMass, kTiltInertia, kMass, kTiltInertia;
  // Rotations are theta_z = y', theta_y = -z'.
  C(1, 3) = kSpinInertia * speed;
  C(3, 1) = -C(1, 3);
  return solve(M, C, K);
}

TEST_CASE("support modes: a disc overhung on a standing shaft whirls as the gyroscopic disc") {
  for (const double lag : {1600.0, 900.0})
    for (const double speed : {0.0, 60.0, 200.0}) {
      CAPTURE(lag);
      CAPTURE(speed);
      Scenario scenario = test::read_shipped("whirl_rotor");
      auto& sections =
          std::get<spatial::Beam>(scenario.space->subsystems.back().bodies[0].shape).sections;
      for (double& value : sections.lag_stiffness) value = lag;
      for (double& value : sections.mass_per_length) value = 1e-6;
      const ModesResult found = solve_modes(scenario, {.state = {speed}, .count = 8});
      for (const Complex s : solve_overhung(lag, 1600.0, speed))
        CHECK(distance(s, found.modes) < 1e-5 * std::abs(s));
    }
}

TEST_CASE("support modes: whirls are named by their sense") {
  const ModesResult found = solve_modes(test::read_shipped("whirl_rotor"), {.count = 2});
  CHECK(found.modes[0].name == "shaft backward whirl");
  CHECK(found.modes[1].name == "shaft forward whirl");
}

TEST_CASE(
    "support modes: tower and rotor of the NREL 5 MW turbine at rest have published frequencies") {
  Scenario scenario = test::read_shipped("nrel_5mw_turbine");
  scenario.space->gravity.setZero();
  scenario.space->hub.drive = FixedDrive{};
  const ModesResult found = solve_modes(scenario, {.state = {0.0}, .count = 8});
  const auto hertz_of = [&](const std::string& name) {
    for (const Mode& mode : found.modes)
      if (mode.name == name) return mode.frequency / (2.0 * std::numbers::pi);
    return 0.0;
  };
  // Jonkman and others, NREL/TP-500-38060, table 9-1: FAST, and ADAMS of the rotor.
  CHECK(hertz_of("tower fore-aft") == Approx(0.3240).epsilon(0.02));
  CHECK(hertz_of("tower side-side") == Approx(0.3120).epsilon(0.02));
  CHECK(hertz_of("flap 1 collective") == Approx(0.6993).epsilon(0.02));
}

/// Returns the frequencies in sampled motions, one in each column, by the shift invariance of the
/// space that their delays span [rad/s].
std::vector<double> find_frequencies(const MatrixXd& samples, double interval, int rank) {
  constexpr Eigen::Index kDelays = 240;
  const Eigen::Index windows = samples.rows() - kDelays + 1;
  MatrixXd delays(kDelays, windows * samples.cols());
  for (Eigen::Index c = 0; c < samples.cols(); ++c)
    for (Eigen::Index k = 0; k < windows; ++k)
      delays.col(c * windows + k) = samples.col(c).segment(k, kDelays);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> space(delays * delays.transpose());
  const MatrixXd basis = space.eigenvectors().rightCols(rank);
  const MatrixXd shift =
      basis.topRows(kDelays - 1).colPivHouseholderQr().solve(basis.bottomRows(kDelays - 1));
  const Eigen::VectorXcd values = Eigen::EigenSolver<MatrixXd>(shift).eigenvalues();
  std::vector<double> frequencies;
  for (const Complex z : values) frequencies.push_back(std::log(z).imag() / interval);
  return frequencies;
}

/// The turbine without weight, pushed at the top of its tower.
Scenario make_pushed_turbine() {
  Scenario scenario = test::read_shipped("nrel_5mw_turbine");
  spatial::Model& model = *scenario.space;
  model.gravity.setZero();
  model.hub.drive = ConstantSpeed{1.267};
  model.distributed_loads.clear();
  spatial::PointLoad push;
  push.place.subsystem = "support";
  push.place.body = "tower";
  push.frame = spatial::LoadFrame::inertial;
  push.force = {1.0e4, 0.75e4, 0.0};
  push.factor = Curve({0.0, 1.0, 2.0}, {0.0, 1.0, 0.0});
  model.loads = {push};
  scenario.initial.state = InitialState::equilibrium;
  scenario.integration.step = 0.005;
  scenario.integration.duration = 102.5;
  return scenario;
}

TEST_CASE("support modes: multi-blade frequencies are those of a time history") {
  const Scenario scenario = make_pushed_turbine();
  constexpr double kInterval = 0.1, kBegin = 2.5;
  constexpr Eigen::Index kSamples = 1000;
  MatrixXd samples(kSamples, 4);
  Simulation simulation(scenario);
  const std::vector<std::string>& names = simulation.sensor_names();
  const auto top = std::find(names.begin(), names.end(), "support.tower_top.x");
  REQUIRE(top != names.end());
  const auto first = static_cast<std::size_t>(top - names.begin());
  for (Eigen::Index k = 0; k < kSamples; ++k) {
    simulation.run_until(kBegin + kInterval * static_cast<double>(k));
    const auto values = simulation.sensor_values();
    const auto at = [&](std::size_t c) { return values[first + c]; };
    samples.row(k) << at(0), at(1), 20.0 * at(3), 20.0 * at(4);
  }
  samples.rowwise() -= samples.colwise().mean().eval();
  const std::vector<double> frequencies = find_frequencies(samples, kInterval, 24);
  const ModesResult modes = solve_modes(scenario, {.count = 6});
  for (const Mode& mode : modes.modes) {
    CAPTURE(mode.name);
    double nearest = 1e300;
    for (const double w : frequencies) nearest = std::min(nearest, std::abs(w - mode.frequency));
    CHECK(nearest < 1e-4 * mode.frequency);
  }
}

/// A column with a heavy end: as a support whose rotor is a disc, or as one subsystem.
std::string column_of(const std::string& table) {
  return "[[" + table +
         ".body]]\nname = \"column\"\nkind = \"beam\"\nlength = 10.0\nbodies = 3\n"
         "elements = 3\n[" +
         table +
         ".body.sections]\nmass_per_length = 40.0\n"
         "axial_stiffness = 1e9\nflap_stiffness = 4e6\nlag_stiffness = 3e6\n"
         "torsion_stiffness = 2e6\nflap_inertia = 0.2\nlag_inertia = 0.2\n";
}
constexpr const char* kStanding = "orientation = [0.0, -1.5707963267948966, 0.0]\n";
constexpr const char* kRest =
    "[gravity]\nacceleration = [0.0, 1.0, -9.81]\n[integration]\nduration = 1.0\n";
constexpr const char* kEndDisc =
    "kind = \"rigid\"\nmass = 300.0\ncenter = [0.4, 0.0, 0.1]\n"
    "inertia = [50.0, 60.0, 80.0]\n";

Scenario make_tower() {
  return parse_scenario(
      "world = \"space\"\n[hub]\nmass = 1e-6\ninertia = 1e-6\n[hub.drive]\nkind = \"fixed\"\n"
      "[support]\nfrom = \"ground\"\n" +
          column_of("support") + "[[support.joint]]\nchild = \"column\"\nkind = \"fixed\"\n" +
          kStanding +
          "[support.axle]\nbody = \"column\"\norientation = [0.0, 1.5707963267948966, 0.0]\n"
          "[[subsystem]]\nname = \"disc\"\n[[subsystem.body]]\nname = \"disc\"\n" +
          kEndDisc + "[[subsystem.joint]]\nparent = \"hub\"\nchild = \"disc\"\nkind = \"fixed\"\n" +
          kRest,
      "tower.toml");
}
Scenario make_subsystem_tower() {
  return parse_scenario(
      "world = \"space\"\n[hub]\nmass = 1.0\n[hub.drive]\nkind = \"fixed\"\n"
      "[[subsystem]]\nname = \"tower\"\n" +
          column_of("subsystem") +
          "[[subsystem.joint]]\nparent = \"hub\"\nchild = \"column\"\nkind = \"fixed\"\n" +
          kStanding + "[[subsystem.body]]\nname = \"disc\"\n" + kEndDisc +
          "[[subsystem.joint]]\nparent = \"column\"\nchild = \"disc\"\nkind = \"fixed\"\n"
          "orientation = [0.0, 1.5707963267948966, 0.0]\n" +
          kRest,
      "subsystem.toml");
}

TEST_CASE("support modes: at rest a support is the same tree as a subsystem") {
  const ModeOptions options{.state = {0.0}, .count = 6, .frame = ModeFrame::turning};
  const ModesResult on_support = solve_modes(make_tower(), options);
  const ModesResult tree = solve_modes(make_subsystem_tower(), options);
  REQUIRE(on_support.modes.size() == tree.modes.size());
  for (std::size_t k = 0; k < tree.modes.size(); ++k)
    CHECK(on_support.modes[k].frequency == Approx(tree.modes[k].frequency).epsilon(1e-7));
  const auto column_tip = [](const ModesResult& modes) {
    return modes.equilibrium.blades.back().nodes[9];
  };
  CHECK((column_tip(on_support) - column_tip(tree)).norm() < 1e-8);
}

TEST_CASE("support modes: the rotor's weight stands on its support") {
  const Scenario scenario = make_tower();
  const EquilibriumResult found = solve_equilibrium(scenario, {0.0});
  REQUIRE(found.hub);
  CHECK((found.hub->axes * found.hub_force - 300.0 * Eigen::Vector3d(0.0, -1.0, 9.81)).norm() <
        1e-5);
  CHECK((found.hub->position - found.blades.back().nodes.back()).norm() < 1e-9);
}

TEST_CASE("support modes: a machine that starts at its equilibrium stays there") {
  Scenario scenario = make_tower();
  scenario.initial.state = InitialState::equilibrium;
  Sensor top;
  top.subsystem = "support";
  top.body = "column";
  scenario.sensors = {top};
  scenario.integration.duration = 0.2;
  scenario.integration.step = 1e-4;
  Simulation simulation(scenario);
  const auto top_of = [&] {
    const auto values = simulation.sensor_values();
    return Eigen::Vector3d(values[3], values[4], values[5]);
  };
  const Eigen::Vector3d start = top_of();
  CHECK(start.norm() > 1e-3);
  simulation.run_until(0.2);
  CHECK((top_of() - start).norm() < 1e-8);
}

TEST_CASE("support modes: a support that is a column buckles at Euler's load") {
  Scenario scenario = make_tower();
  scenario.space->gravity.setZero();
  spatial::PointLoad push;
  push.name = "push";
  push.place.subsystem = "support";
  push.place.body = "column";
  push.frame = spatial::LoadFrame::inertial;
  push.force = {0.0, 0.0, -1.0};
  scenario.space->loads.push_back(push);
  const CriticalResult found = solve_critical(
      scenario, {.of = "load=push", .from = 0.0, .to = 1e5, .state = {0.0}, .points = 4});
  REQUIRE(found.critical);
  CHECK(found.critical->kind == CriticalKind::buckling);
  const double pi = std::numbers::pi;
  CHECK(found.critical->value == Approx(pi * pi * 3e6 / 400.0).epsilon(1e-4));
}

TEST_CASE("support modes: matrices at rest have the roots of the modes") {
  const LinearSystem linear = solve_linear_system(make_tower(), {0.0});
  const ModesResult modes =
      solve_modes(make_tower(), {.state = {0.0}, .count = 3, .frame = ModeFrame::turning});
  const Eigen::VectorXcd roots = Eigen::EigenSolver<MatrixXd>(MatrixXd(linear.A)).eigenvalues();
  for (const Mode& mode : modes.modes) {
    double nearest = 1e300;
    for (const Complex s : roots) nearest = std::min(nearest, std::abs(s - mode.eigenvalue));
    CHECK(nearest < 1e-6 * std::abs(mode.eigenvalue));
  }
}

TEST_CASE("support modes: outputs on a support are what its coordinates say") {
  Scenario scenario = make_tower();
  Sensor top;
  top.name = "top";
  top.subsystem = "support";
  top.body = "column";
  top.frame = SensorFrame::inertial;
  Sensor force = top;
  force.name = "force";
  force.quantity = SensorQuantity::section_force;
  force.frame.reset();
  force.position = 0.0;
  scenario.sensors = {top, force};
  const LinearSystem linear = solve_linear_system(scenario, {0.0});
  const auto row_of = [&](const std::string& name) {
    const auto found =
        std::find_if(linear.outputs.begin(), linear.outputs.end(),
                     [&](const LinearSignal& signal) { return signal.name == name; });
    REQUIRE(found != linear.outputs.end());
    return static_cast<Eigen::Index>(found - linear.outputs.begin());
  };
  // The hub is at the column's end, in axes that stand, but as bent as that is.
  const MatrixXd C(linear.C);
  for (const std::string axis : {"x", "y"}) {
    const MatrixXd difference =
        C.row(row_of("support.top." + axis)) - C.row(row_of("hub / " + axis));
    CHECK(difference.lpNorm<Eigen::Infinity>() < 0.02);
  }
  CHECK(std::find(linear.left_out.begin(), linear.left_out.end(), "support.force.force.x") !=
        linear.left_out.end());
}

TEST_CASE("support modes: what has no constant matrices is refused") {
  const Scenario scenario = test::read_shipped("ground_resonance");
  CHECK(message_of([&] {
          solve_modes(scenario, {.frame = ModeFrame::turning});
        }).find("the frame \"turning\" expects a hub whose support does not move") !=
        std::string::npos);
  CHECK(message_of([&] {
          solve_linear_system(scenario, {}, ModeFrame::turning);
        }).find("the frame \"turning\" expects a hub whose support does not move") !=
        std::string::npos);
}

TEST_CASE("support modes: two blades have modes in a frame that is chosen, and named") {
  const Scenario scenario = parse_scenario(
      "world = \"space\"\n[hub]\nmass = 1\ninertia = 0.1\n[hub.drive]\nkind = \"constant\"\n"
      "speed = 2.0\n[support]\nfrom = \"ground\"\n[[support.body]]\nname = \"mast\"\n"
      "kind = \"rigid\"\nmass = 5\ninertia = 1\n[[support.joint]]\nchild = \"mast\"\n"
      "kind = \"revolute\"\naxis = [0, 1, 0]\nstiffness = 100\n[support.axle]\nbody = \"mast\"\n"
      "[blade]\ncount = 2\nlength = 2\nbodies = 1\nelements = 2\n[blade.sections]\n"
      "mass_per_length = 1\naxial_stiffness = 1e4\nflap_stiffness = 1000\nlag_stiffness = 1000\n"
      "torsion_stiffness = 1000\n[integration]\nduration = 1\n",
      "two.toml");
  const auto check = [&](double speed, ModeFrame frame, const std::string& word) {
    const ModesResult chosen = solve_modes(scenario, {.state = {speed}, .count = 3});
    CHECK(chosen.frame == frame);
    REQUIRE(chosen.notes.size() == 1);
    CHECK(chosen.notes[0].find(word) != std::string::npos);
    const ModesResult asked = solve_modes(scenario, {.state = {speed}, .count = 3, .frame = frame});
    CHECK(asked.notes.empty());
    REQUIRE(asked.modes.size() == 3);
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(asked.modes[k].eigenvalue == chosen.modes[k].eigenvalue);
  };
  check(0.0, ModeFrame::turning, "\"turning\"");
  check(2.0, ModeFrame::floquet, "\"floquet\"");
  CHECK(message_of([&] {
          solve_modes(scenario, {.frame = ModeFrame::fixed});
        }).find("expects three or more equal blades, got 2") != std::string::npos);
  const std::string refused = message_of([&] {
    solve_critical(scenario, {.of = "speed", .from = 0.0, .to = 1.0, .frame = ModeFrame::floquet});
  });
  CHECK(refused.find("expected \"turning\" or \"fixed\"") != std::string::npos);
}

}  // namespace
}  // namespace spoke
