// Conservation of momenta and energy by motions in space, and the change of energy by work.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/bodies/space/system/runs.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// What flies: with linear strains, and with those of second order.
const std::string kFlyers[] = {kBooms,
                               kTree,
                               kForest,
                               with_nonlinear_strains(kBooms),
                               with_nonlinear_strains(kTree),
                               with_nonlinear_strains(kForest)};

Drift fly(const std::string& text, const Method& method, double seconds) {
  return calc_drift(make_system(parse_model(text)), method, seconds);
}

/// Energy, less what was done, over a run [J].
double calc_residual(const std::string& text, const Method& method, double seconds) {
  Run<Space> run(make_system(parse_model(text)), {method});
  const double energy = calc_energy(run);
  run.advance_for(seconds);
  CHECK(std::abs(run.work) > 1e-3);
  return std::abs(calc_energy(run) - energy - run.work + run.dissipated);
}

}  // namespace

TEST_CASE("a free flight keeps energy and momentum: rk4, of order 4") {
  for (const std::string& bodies : kFlyers) {
    const std::string text = make_text(kFlyingHub, bodies);
    const Drift whole = fly(text, Rk4{1e-3}, 0.2), half = fly(text, Rk4{5e-4}, 0.2);
    CHECK(half.energy < 1e-6);
    CHECK(whole.energy / half.energy > 13.0);
    CHECK(space::linear(half.momentum).norm() < 1e-7);
    CHECK(space::angular(half.momentum).norm() < 1e-7);
  }
}

TEST_CASE("a free flight keeps energy and momentum: generalized_alpha, of order 2") {
  for (const std::string& bodies : kFlyers) {
    const std::string text = make_text(kFlyingHub, bodies);
    const auto run = [&](double h) { return fly(text, make_generalized_alpha(1.0, h), 0.2); };
    const Drift whole = run(5e-4), half = run(2.5e-4);
    CHECK(whole.energy / half.energy > 3.5);  // 4 in the limit, which stiff modes reach last
  }
}

TEST_CASE("the energy in space grows by what drives, motors, loads and dampers do") {
  const std::string load =
      "[[hub_load]]\nposition = [0.1, 0.2, 0.0]\nforce = [1.0, 2.0, 3.0]\n"
      "torque = [0.5, 0.3, 0.8]\n";
  const std::string texts[] = {make_text(kDrivenHub, kBooms + kHinges, kGravity),
                               make_text(kDrivenHub, kBooms + kHinges + kPitch, kRisingGravity),
                               make_text(kTurnedHub, kBooms + kHinges, kRisingGravity + load),
                               make_text(kFlyingHub, kTree + kMotors, kGravity + load),
                               make_text(kFlyingHub, kForest, kGravity + load),
                               make_text(kFlyingHub, kMotors, kRisingGravity + load),
                               make_text(kDrivenHub, kMotors, kRisingGravity)};
  // Ends before the first point of a table, where the acceleration that it prescribes jumps.
  for (const std::string& text : texts) {
    const double whole = calc_residual(text, Rk4{1e-3}, 0.16);
    const double half = calc_residual(text, Rk4{5e-4}, 0.16);
    const double alpha = calc_residual(text, make_generalized_alpha(1.0, 5e-4), 0.16);
    const double alpha_half = calc_residual(text, make_generalized_alpha(1.0, 2.5e-4), 0.16);
    CHECK(half < 1e-6);
    CHECK(whole / half > 13.0);
    CHECK(alpha_half < 1e-4);
    CHECK(alpha / alpha_half > 3.2);  // 4 in the limit, as in free flight
  }
}

TEST_CASE("a flight deforms alike at another velocity of all") {
  for (const std::string& bodies : kFlyers) {
    const auto fly_at = [&](const spatial::Vector& velocity) {
      spatial::Model model = parse_model(make_text(kFlyingHub, bodies));
      model.hub.velocity += velocity;
      Run<Space> run(make_system(model), {Rk4{1e-3}});
      run.advance_for(0.2);
      return deformations(run);
    };
    const Eigen::VectorXd slow = fly_at(spatial::Vector::Zero());
    const Eigen::VectorXd fast = fly_at({7.0, -3.0, 4.0});
    CHECK(slow.norm() > 0.01);
    CHECK((slow - fast).cwiseAbs().maxCoeff() < 1e-12);
  }
}
