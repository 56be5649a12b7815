// Tests small motions of models with closed loops against null spaces that are found here by
// another way, and the matrices of such models.

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "engine/campbell.h"
#include "engine/linearize.h"
#include "engine/modes.h"
#include "engine/small_motions/steady/linear_model.h"
#include "tests/engine/small_motions/steady/loop_mechanisms.h"
#include "tests/message_of.h"

namespace spoke {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using spatial::JointKind;
using test::make_joint;
using test::make_rigid;
using test::message_of;
using test::on_body;
using test::on_hub;

/// A crank on a spring, an elastic coupler, and a slider along x.
struct SliderCrank {
  double crank = 0.15, length = 0.3, angle = 0.7;
  double crank_mass = 0.36, slider_mass = 0.08, stiffness = 50.0;
  test::UniformBeam coupler{.length = 0.3,
                            .mass_per_length = 0.5,
                            .axial = 2e5,
                            .lag = 4.0,
                            .flap = 9.0,
                            .torsion = 3.0,
                            .elements = 24};

  double coupler_angle() const { return -std::asin(crank * std::sin(angle) / length); }
  double crank_inertia() const { return crank_mass * crank * crank / 3.0; }
};

/// `has_crank`: the crank is a body; else the hub is.
Scenario make_scenario(const SliderCrank& model, bool has_crank = true) {
  spatial::Subsystem mechanism;
  mechanism.name = "slider-crank";
  mechanism.bodies = {{"coupler", test::make_beam(model.coupler)},
                      make_rigid("slider", model.slider_mass, {0, 0, 0}, {1e-4, 1e-4, 1e-4})};
  const double turned = model.coupler_angle() - model.angle;
  const Vector3d tip(model.crank, 0.0, 0.0);
  Loop guide;
  guide.name = "guide";
  guide.kind = LoopKind::prismatic;
  guide.from = on_body("slider");
  guide.to = on_hub({0.2, 0, 0});
  guide.axes[0] = Vector3d::UnitX();
  if (has_crank) {
    mechanism.bodies.push_back(
        make_rigid("crank", model.crank_mass, {0.5 * model.crank, 0, 0},
                   {1e-3, 1e-3, model.crank_mass * model.crank * model.crank / 12.0}));
    mechanism.joints = {make_joint("hub", "crank", JointKind::revolute),
                        make_joint("crank", "coupler", JointKind::revolute, tip)};
    spatial::JointCoordinate& turn = mechanism.joints[0].joint.coordinates[0];
    turn.initial = turn.rest = model.angle;
    turn.stiffness = model.stiffness;
    mechanism.joints[1].joint.coordinates[0].initial = turned;
  } else {
    const Vector3d at(tip.x() * std::cos(model.angle), tip.x() * std::sin(model.angle), 0.0);
    mechanism.joints = {make_joint("hub", "coupler", JointKind::revolute, at)};
    mechanism.joints[0].joint.coordinates[0].initial = model.coupler_angle();
    guide.to.carrier = LoopPlace::Carrier::mount;
  }
  mechanism.joints.push_back(make_joint("coupler", "slider", JointKind::revolute));
  mechanism.joints.back().joint.coordinates[0].initial = -model.coupler_angle();
  mechanism.loops = {guide};
  return test::make_mechanism(mechanism);
}

/// Adds the matrix of a two-node element of a beam in the plane to one of the nodes' u, v, psi.
void add_element(Index first, double h, const SliderCrank& model, MatrixXd& M, MatrixXd& K) {
  const test::UniformBeam& beam = model.coupler;
  const double m = beam.mass_per_length, EI = beam.lag, rho_I = m * EI / beam.axial;
  Eigen::Matrix2d of_bar, bar_mass;
  of_bar << 1, -1, -1, 1;
  bar_mass << 2, 1, 1, 2;
  Eigen::Matrix4d bend, bend_mass, turn_mass;
  bend << 12, 6 * h, -12, 6 * h, 6 * h, 4 * h * h, -6 * h, 2 * h * h, -12, -6 * h, 12, -6 * h,
      6 * h, 2 * h * h, -6 * h, 4 * h * h;
  bend_mass << 156, 22 * h, 54, -13 * h, 22 * h, 4 * h * h, 13 * h, -3 * h * h, 54, 13 * h, 156,
      -22 * h, -13 * h, -3 * h * h, -22 * h, 4 * h * h;
  turn_mass << 36, 3 * h, -36, 3 * h, 3 * h, 4 * h * h, -3 * h, -h * h, -36, -3 * h, 36, -3 * h,
      3 * h, -h * h, -3 * h, 4 * h * h;
  const std::vector<Index> along{first, first + 3};
  const std::vector<Index> across{first + 1, first + 2, first + 4, first + 5};
  K(along, along) += beam.axial / h * of_bar;
  M(along, along) += m * h / 6.0 * bar_mass;
  K(across, across) += EI / (h * h * h) * bend;
  M(across, across) += m * h / 420.0 * bend_mass + rho_I / (30.0 * h) * turn_mass;
}

/// Returns the frequencies in the plane from a free beam, its nodes resolved along and across it,
/// which crank and guide tie; unknown 0: the crank's angle.
VectorXd find_frequencies(const SliderCrank& model) {
  const Index elements = model.coupler.elements, n = 1 + 3 * (elements + 1);
  MatrixXd M = MatrixXd::Zero(n, n), K = MatrixXd::Zero(n, n);
  for (Index e = 0; e < elements; ++e)
    add_element(1 + 3 * e, model.length / static_cast<double>(elements), model, M, K);
  M(0, 0) += model.crank_inertia();
  K(0, 0) += model.stiffness;
  const double phi = model.coupler_angle(), c = std::cos(phi), s = std::sin(phi);
  const Index tip = n - 3;
  M(tip, tip) += model.slider_mass;
  M(tip + 1, tip + 1) += model.slider_mass;
  MatrixXd ties = MatrixXd::Zero(3, n);
  // The crank's tip moves by a (-sin, cos) of its angle.
  ties.row(0).segment<3>(0) << model.crank * std::sin(model.angle), c, -s;
  ties.row(1).segment<3>(0) << -model.crank * std::cos(model.angle), s, c;
  ties.row(2).segment<2>(tip) << s, c;
  const MatrixXd Z = Eigen::FullPivLU<MatrixXd>(ties).kernel();
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(Z.transpose() * K * Z,
                                                                 Z.transpose() * M * Z);
  return eigen.eigenvalues().cwiseSqrt();
}

/// Checks that each of these frequencies is that of a mode.
void check_has(const ModesResult& modes, const VectorXd& frequencies, double digits) {
  for (const double frequency : frequencies) {
    double nearest = 0.0;
    for (const Mode& mode : modes.modes)
      if (std::abs(mode.frequency - frequency) < std::abs(nearest - frequency))
        nearest = mode.frequency;
    CHECK(nearest == doctest::Approx(frequency).epsilon(digits));
  }
}

TEST_CASE("loop modes: a slider-crank with an elastic coupler has those of a null space") {
  const SliderCrank model;
  const ModesResult modes = solve_modes(make_scenario(model), {.count = 16});
  check_has(modes, find_frequencies(model).head(4), 3e-4);
}

TEST_CASE("loop modes: a hub that is the crank moves a loop on the mount") {
  SliderCrank model;
  model.stiffness = 0.0;
  const ModesResult apart = solve_modes(make_scenario(model), {.count = 10});
  Scenario scenario = make_scenario(model, false);
  scenario.space->hub.drive = FreeDrive{};
  scenario.space->hub.inertia = Vector3d(1.0, 1.0, model.crank_inertia()).asDiagonal();
  const ModesResult joined = solve_modes(scenario, {.state = {.speed = 0.0}, .count = 10});
  CHECK(joined.are_blades_coupled);
  for (std::size_t k = 0; k < 10; ++k)
    CHECK(joined.modes[k].frequency == doctest::Approx(apart.modes[k].frequency).epsilon(1e-9));
  CHECK(joined.modes[0].frequency == 0.0);
}

TEST_CASE("loop modes: the state matrix has the roots of the modes, and states with names") {
  const test::FourBar bars;
  Scenario scenario = make_scenario(bars);
  scenario.space->subsystems[0].joints[0].joint.coordinates[0].damping = 0.3;
  const LinearSystem system = solve_linear_system(scenario);
  const ModesResult modes = solve_modes(scenario, {.count = 1});
  REQUIRE(system.states.size() == 2);
  CHECK(system.states[0].name == "four-bar / joint of crank");
  CHECK(system.states[1].name == "rate of four-bar / joint of crank");
  const Eigen::EigenSolver<MatrixXd> eigen{MatrixXd(system.A)};
  CHECK(std::abs(eigen.eigenvalues()[0]) ==
        doctest::Approx(std::abs(modes.modes[0].eigenvalue)).epsilon(1e-9));
  CHECK(eigen.eigenvalues()[0].real() ==
        doctest::Approx(modes.modes[0].eigenvalue.real()).epsilon(1e-7));
  // A motor on the crank acts on the inertia by its rate; other joints follow.
  const double theta = system.equilibrium.blades[0].joints[0].value;
  const MatrixXd B(system.B), C(system.C);
  REQUIRE(system.inputs.at(0).name == "four-bar / joint of crank motor");
  CHECK(B(1, 0) == doctest::Approx(1.0 / bars.inertia(theta)).epsilon(1e-9));
  const Index first = std::ssize(system.outputs) - 3;
  REQUIRE(system.outputs[static_cast<std::size_t>(first)].name == "four-bar / joint of crank");
  const auto ahead = bars.angles(theta + 1e-5), behind = bars.angles(theta - 1e-5);
  CHECK(C(first, 0) == 1.0);
  CHECK(C(first + 1, 0) == doctest::Approx((ahead[1] - behind[1]) / 2e-5 - 1.0).epsilon(1e-7));
  CHECK(C(first + 2, 0) == doctest::Approx((ahead[2] - behind[2]) / 2e-5).epsilon(1e-7));
}

TEST_CASE("loop modes: what turns against the hub, or holds it, is refused by the loop's name") {
  SliderCrank model;
  Scenario mount = make_scenario(model);
  mount.space->subsystems[0].loops[0].to.carrier = LoopPlace::Carrier::mount;
  CHECK_NOTHROW(solve_modes(mount, {.count = 1}));
  const std::string turning =
      message_of([&] { solve_modes(mount, {.state = {.speed = 3.0}, .count = 1}); });
  CHECK(turning.find("loop \"guide\" closes on the mount, against which the hub turns") !=
        std::string::npos);
}

TEST_CASE("loop modes: a diagram over speeds follows the modes of a model with loops") {
  const CampbellResult result =
      solve_campbell(make_scenario(SliderCrank{}), {.speeds = {0.0, 1.0, 2.0}, .count = 3});
  CHECK(result.branches.size() == 3);
  CHECK(result.gaps.empty());
}

/// Checks K and C of independent coordinates against differences of the accelerations that the step
/// graph finds, which solves for the forces of loops itself.
void check_linear(const Scenario& scenario, double speed) {
  const auto model = steady::make_steady_model(scenario, {speed});
  const steady::Equilibrium equilibrium = steady::find_equilibrium(*model);
  const steady::LinearModel linear = steady::linearize(equilibrium, *model);
  const steady::LinearSubsystem& own = linear.subsystems[0];
  const VectorXd& q = equilibrium.q[0];
  const auto accelerate = [&](const VectorXd& moved, const VectorXd& v) {
    steady::SubsystemResponse response;
    model->evaluate(0, {moved, v, moved, v}, model->no_offset(), response);
    return VectorXd(model->accelerations(0)(own.independent));
  };
  const VectorXd still = VectorXd::Zero(q.size());
  const Index n = own.M.rows();
  REQUIRE(n < q.size());
  MatrixXd by_q(n, n), by_v(n, n);
  for (Index k = 0; k < n; ++k) {
    constexpr double h = 1e-6;
    const VectorXd step = h * own.basis.col(k);
    by_q.col(k) = (accelerate(q + step, still) - accelerate(q - step, still)) / (2.0 * h);
    by_v.col(k) = (accelerate(q, step) - accelerate(q, -step)) / (2.0 * h);
  }
  CHECK((own.K + own.M * by_q).norm() < 1e-6 * own.K.norm());
  CHECK((own.C + own.M * by_v).norm() < 1e-6 * own.C.norm() + 1e-10 * own.K.norm());
}

TEST_CASE("loop modes: stiffness and damping are those of the step's accelerations") {
  test::FourBar bars;
  check_linear(make_scenario(bars), 0.0);
  bars.gravity = 0.0;
  check_linear(make_scenario(bars), 2.0);
  SliderCrank model;
  model.coupler.elements = 2;
  model.stiffness = 500.0;
  Scenario turning = make_scenario(model);
  turning.space->damping.stiffness_factor = 1e-3;
  check_linear(turning, 3.0);
  Scenario sprung = turning;
  spatial::Subsystem& mechanism = sprung.space->subsystems[0];
  mechanism.loops[0].stiffness = {3e4, 0.0, 0.0, 20.0, 0.0};
  mechanism.loops[0].damping = {30.0, 0.0, 0.0, 0.1, 0.0};
  check_linear(sprung, 3.0);
}

}  // namespace
}  // namespace spoke
