// Published values of mechanisms with closed loops, and the orders at which they are reached.

#include "tests/engine/loops/mechanisms.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/engine/bodies/space/system/runs.h"

using namespace spoke;
using namespace spoke::test;

namespace {

double angle_of(const Run<Space>& run, std::size_t body) {
  return run.context.data.subsystems[0].bodies[body].joint.coordinates.q[0];
}

double speed_of(const Run<Space>& run, std::size_t body) {
  return run.context.data.subsystems[0].bodies[body].joint.coordinates.v[0];
}

/// Largest opening of rigid rows by the last evaluation, redundant ones too.
double opening_of(const Run<Space>& run) {
  const LoopReport& report = run.context.data.subsystems[0].loops.report;
  return std::max(report.opening, report.dropped);
}

}  // namespace

TEST_CASE("Andrews' squeezer: the published solution, at order 2, and its multiplier") {
  // Test Set for IVP Solvers, t = 0.03 s: beta, Theta, gamma, delta, phi, epsilon, Omega.
  const std::array<double, 7> published{
      15.81077119629904,   -15.75637105984298, 0.04082224013073101, 0.5244099658805304,
      -0.5347301163226948, 1.048080741042263,  0.5347301163226948};
  constexpr double kMultiplier = 199.1753333731910;
  std::array<double, 2> errors{}, of_multiplier{};
  for (std::size_t k = 0; k < 2; ++k) {
    const double h = k == 0 ? 2e-5 : 1e-5;
    Run<Space> run(make_system(make_andrews_squeezer()), {make_generalized_alpha(0.8, h)});
    run.advance(std::lround(0.03 / h));
    for (std::size_t j = 0; j < published.size(); ++j)
      errors[k] = std::max(errors[k], std::abs(angle_of(run, j) - published[j]));
    // The first loop's force on K2 along the inertial x axis: its rows are along the axes of K3.
    const double* lambda = run.context.data.subsystems[0].loops.kept_multipliers.data();
    const double gamma = angle_of(run, 2);
    const double along = std::cos(gamma) * lambda[0] - std::sin(gamma) * lambda[1];
    of_multiplier[k] = std::abs(std::abs(along) / kMultiplier - 1.0);
    CHECK(opening_of(run) < 1e-13);
  }
  CHECK(errors[1] < 1e-4);
  CHECK(errors[0] / errors[1] > 3.6);
  CHECK(of_multiplier[1] < 3e-4);
}

TEST_CASE("Andrews' squeezer by rk4: order 4, up to the digits of the published solution") {
  constexpr double kPublished = 15.81077119629904;
  std::array<double, 3> angles{};
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const double h = 2e-5 / static_cast<double>(1 << k);
    Run<Space> run(make_system(make_andrews_squeezer()), {Rk4{h}});
    const double before = calc_energy(run);
    run.advance(std::lround(0.03 / h));
    angles[k] = angle_of(run, 0);
    CHECK(opening_of(run) < 1e-13);
    CHECK(std::abs(calc_energy(run) - before - run.work) < 1e-6 * run.work);
  }
  CHECK(std::abs(angles[2] - kPublished) < 3e-9);
  CHECK((angles[0] - angles[1]) / (angles[1] - angles[2]) > 12.0);
}

TEST_CASE("the N-four-bar through its singular positions: order 2") {
  // By the differential equation of its one freedom.
  constexpr double kX = 0.32845811154, kSpeedX = 1.42305147020;
  std::array<double, 2> errors{};
  for (std::size_t k = 0; k < 2; ++k) {
    const double h = k == 0 ? 0.01 : 0.005;
    Run<Space> run(make_system(make_four_bars(2)), {make_generalized_alpha(0.9, h)});
    run.advance_for(10.0);
    const double angle = angle_of(run, 0);
    errors[k] = std::abs(std::cos(angle) - kX);
    CHECK(std::abs(-std::sin(angle) * speed_of(run, 0) - kSpeedX) < 0.01);
    CHECK(opening_of(run) < 1e-12);
  }
  CHECK(errors[1] < 1e-4);
  CHECK(errors[0] / errors[1] > 3.5);
}

TEST_CASE("ten four-bars in a row stay closed through their singular positions") {
  // Where all bars lie in one line, round-off alone changes coordinates by 1e-12.
  Run<Space> run(make_system(make_four_bars(10)),
                 {.method = make_generalized_alpha(0.9, 0.005), .tolerance = 1e-11});
  run.advance_for(2.0);
  CHECK(opening_of(run) < 1e-12);
}

TEST_CASE(
    "Bricard's mechanism moves, though a count of its rows leaves nothing: one is redundant") {
  for (const double radius : {0.8, 0.95}) {
    Run<Space> run(make_system(make_bricard()), {make_generalized_alpha(radius, 0.002)});
    const LoopFreedoms& freedoms = run.context.loop_start.freedoms[0];
    CHECK(freedoms.joints == 5);
    CHECK(freedoms.rows == 5);
    CHECK(freedoms.independent == 4);
    CHECK(freedoms.mobility() == 1);
    REQUIRE(run.context.loop_start.dropped.size() == 1);
    const double before = calc_energy(run);
    run.advance_for(3.0);
    CHECK(opening_of(run) < 1e-9);
    CHECK(std::abs(calc_energy(run) - before) < 0.02);
    CHECK(std::abs(angle_of(run, 0)) > 0.1);
  }
}

TEST_CASE("a stiff closure needs no small steps, and moves as a rigid one") {
  const auto angle_after = [](double stiffness, const Method& method) {
    spatial::Model model = make_four_bars(1);
    if (stiffness > 0.0) model.subsystems[0].loops[0].stiffness = {stiffness, stiffness, stiffness};
    Run<Space> run(make_system(model), {method});
    run.advance_for(0.5);
    return angle_of(run, 0);
  };
  const Method method = make_generalized_alpha(0.8, 0.005);
  const double rigid = angle_after(0.0, method);
  // The step resolves no vibration of it: (k/m)^1/2 h = 500.
  CHECK(std::abs(angle_after(1e10, method) - rigid) < 1e-6);
  // One that gives opens by the forces over its stiffness.
  const double soft = angle_after(2e4, method);
  CHECK(std::abs(soft - rigid) > 1e-6);
  CHECK(std::abs(soft - angle_after(2e4, Rk4{5e-4})) < 1e-3);
}
