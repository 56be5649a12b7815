// Tests modes seen from outside: multi-blade coordinates against the frame that turns, and against
// Coleman's equations on springs that differ in two directions.

#include "engine/small_motions/vibration/multi_blade.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "engine/campbell.h"
#include "engine/modes.h"
#include "engine/small_motions/vibration/coupled_roots.h"
#include "models/error.h"
#include "models/scenario.h"
#include "tests/contains.h"
#include "tests/engine/small_motions/steady/blades.h"
#include "tests/engine/small_motions/vibration/lag_rotor.h"
#include "tests/message_of.h"

namespace spoke {
namespace {

using Eigen::MatrixXd;
using steady::HubFreedom;
using vibration::FixedFrame;
using vibration::SecondOrder;
using Complex = std::complex<double>;

/// Blades of unlike flap and lag at equal angles about an axle, of which one may turn freely.
Scenario make_rotor(int blades, double damping = 0.0) {
  Scenario scenario = test::make_spatial({.bodies = 2, .elements = 2, .radius = 0.3});
  for (double& value : scenario.space->blades[0].beam.sections.lag_stiffness) value = 5.0;
  for (int b = 1; b < blades; ++b) {
    scenario.space->blades.push_back(scenario.space->blades[0]);
    scenario.space->blades.back().azimuth += b * 2.0 * std::numbers::pi / blades;
  }
  scenario.space->damping.stiffness_factor = damping;
  return scenario;
}

Scenario make_free(int blades) {
  Scenario scenario = make_rotor(blades, 0.002);
  spatial::Hub& hub = scenario.space->hub;
  hub.support = HubSupport::free;
  hub.mass = 2.0;
  hub.inertia = Eigen::Vector3d(0.7, 0.7, 1.1).asDiagonal();
  hub.drive = FreeDrive{};
  return scenario;
}

const Mode& find(const ModesResult& result, const std::string& name) {
  const auto found = std::find_if(result.modes.begin(), result.modes.end(),
                                  [&](const Mode& mode) { return mode.name == name; });
  REQUIRE_MESSAGE(found != result.modes.end(), name);
  return *found;
}

FixedFrame make_frame(const test::LagRotor& rotor) {
  return vibration::make_fixed_frame(rotor.linear, rotor.azimuths, rotor.names, rotor.axes);
}

}  // namespace

TEST_CASE("fixed frame: a blade's roots are shifted by the speed where patterns go round") {
  for (const double speed : {-3.0, 1.7, 9.0}) {
    CAPTURE(speed);
    const Scenario scenario = make_rotor(4, 0.002);
    const ModesResult turning = solve_modes(scenario, {.state = {.speed = speed}, .count = 3});
    const ModesResult fixed =
        solve_modes(scenario, {.state = {.speed = speed}, .count = 20, .frame = ModeFrame::fixed});
    CHECK(fixed.frame == ModeFrame::fixed);
    for (const Mode& blade : turning.modes) {
      CAPTURE(blade.name);
      const double w = blade.frequency, n = std::abs(speed);
      const auto check = [&](const std::string& pattern, double expected) {
        const Mode& mode = find(fixed, blade.name + ' ' + pattern);
        CHECK(mode.frequency == doctest::Approx(expected).epsilon(1e-8));
        CHECK(mode.eigenvalue.real() == doctest::Approx(blade.eigenvalue.real()).epsilon(1e-6));
        CHECK(mode.of == "blades 1 to 4");
      };
      check("collective", w);
      check("differential", w);
      check("progressive", w + n);
      check("regressive", std::abs(w - n));
    }
  }
}

TEST_CASE("fixed frame: a free hub and its blades have the roots of the turning frame, shifted") {
  for (const int blades : {3, 5}) {
    CAPTURE(blades);
    const Scenario scenario = make_free(blades);
    const double speed = 2.0;
    const auto model = steady::make_steady_model(scenario, {speed});
    const steady::Equilibrium equilibrium = steady::find_equilibrium(*model);
    const steady::LinearModel linear = steady::linearize(equilibrium, *model);
    const vibration::StandingAxes axes =
        vibration::make_standing_axes(model->free_components(), true, speed);
    const std::vector<std::string> names(linear.alike.size(), "blade");
    const FixedFrame frame = vibration::make_fixed_frame(linear, model->azimuths(), names, axes);
    const auto fixed = vibration::find_fixed_roots(frame, 24);
    const auto turning = vibration::find_coupled_roots(linear, model->azimuths(), 40);
    int compared = 0;
    for (const vibration::Root& root : fixed) {
      if (std::abs(root.s) < 2.5 * speed) continue;  // motions of the hub meet at zero
      double nearest = 1e9;
      for (const vibration::Root& other : turning)
        for (const double n : {-2.0, -1.0, 0.0, 1.0, 2.0})
          nearest = std::min(nearest, std::abs(other.s + Complex(0.0, n * speed) - root.s));
      CHECK(nearest < 1e-7 * std::abs(root.s));
      ++compared;
    }
    CHECK(compared > 10);
  }
}

TEST_CASE("fixed frame: what a free machine keeps is at zero") {
  // Places, turns and the hub's angle go on: none of them turns with the frame.
  const ModesResult result =
      solve_modes(make_free(3), {.state = {.speed = 2.0}, .count = 8, .frame = ModeFrame::fixed});
  int rigid = 0;
  for (const Mode& mode : result.modes) rigid += mode.eigenvalue == 0.0;
  CHECK(rigid == 5);  // of the turns across the axis, which are one gyroscopic motion, a pair
}

TEST_CASE("fixed frame: on springs that differ in two directions growth is Coleman's") {
  for (const int blades : {3, 4, 5})
    for (const double speed : {1.5, 2.2, 2.9}) {
      CAPTURE(blades);
      CAPTURE(speed);
      const test::LagRotor rotor = test::make_lag_rotor(blades, speed);
      const test::HubSprings springs{5.0, 9.0, 2.0, 1.0, 0.05, 0.02};
      const FixedFrame frame =
          vibration::stand_on(make_frame(rotor), test::in_plane(), test::matrices_of(springs));
      const auto roots = vibration::find_fixed_roots(frame, blades + 2);
      const std::vector<Complex> expected = test::solve_coleman(blades, speed, springs);
      double growth = -1e9, classical = -1e9;
      for (const vibration::Root& root : roots) growth = std::max(growth, root.s.real());
      for (const Complex s : expected) {
        classical = std::max(classical, s.real());
        double nearest = 1e9;
        for (const vibration::Root& root : roots)
          nearest = std::min({nearest, std::abs(root.s - s), std::abs(std::conj(root.s) - s)});
        CHECK(nearest < 1e-6);
      }
      CHECK(std::abs(growth - classical) < 1e-6);
    }
}

TEST_CASE("fixed frame: all six components of a hub on an axle are those of a free one") {
  Scenario on_axle = make_free(3);
  on_axle.space->hub.support = HubSupport::axle;
  on_axle.space->hub.drive = ConstantSpeed{2.0};
  const auto make = [](const Scenario& scenario, HubFreedom freedom) {
    const auto model = steady::make_steady_model(scenario, {2.0});
    return steady::linearize(steady::find_equilibrium(*model), *model, freedom);
  };
  const steady::LinearModel free = make(make_free(3), HubFreedom::described);
  const steady::LinearModel all = make(on_axle, HubFreedom::all);
  REQUIRE(all.M.rows() == 6);
  const auto check = [](const MatrixXd& a, const MatrixXd& b) {
    CHECK((a - b).norm() < 1e-9 * (1.0 + b.norm()));
  };
  check(all.M, free.M);
  check(all.C, free.C);
  check(all.K, free.K);
  REQUIRE(all.alike == free.alike);
  for (std::size_t i = 0; i < 3; ++i) {
    check(all.couplings[i].M_bh, free.couplings[i].M_bh);
    check(all.couplings[i].C_bh, free.couplings[i].C_bh);
    check(all.couplings[i].K_bh, free.couplings[i].K_bh);
    check(all.couplings[i].K_hb, free.couplings[i].K_hb);
  }
}

TEST_CASE("fixed frame: a steady wrench turns with the rotor") {
  // A hub at rest under gravity along its axis: the force m g on it turns by theta, and what stands
  // still sees none of that. A shift of the hub changes nothing either.
  Scenario scenario = make_rotor(3);
  scenario.space->hub.mass = 2.0;
  scenario.space->gravity = {0.0, 0.0, -9.81};
  const auto model = steady::make_steady_model(scenario, {0.0});
  const steady::LinearModel all =
      steady::linearize(steady::find_equilibrium(*model), *model, HubFreedom::all);
  CHECK(all.K.topRows(3).norm() < 1e-5 * 9.81 * 5.0);
  CHECK(all.K.leftCols(3).norm() < 1e-5 * 9.81 * 5.0);
}

TEST_CASE("fixed frame: rotors that it cannot take are refused, and told of another frame") {
  const auto message = [](const Scenario& scenario) {
    return test::message_of(
        [&] { solve_modes(scenario, {.state = {.speed = 2.0}, .frame = ModeFrame::fixed}); });
  };
  CHECK(message(make_rotor(2)) ==
        "the frame \"fixed\" expects three or more equal blades, got 2 of the kind of blade 1, "
        "blade 2: of modes the frame \"floquet\" takes any blades");
  CHECK(test::contains(message(make_rotor(1)), "three or more equal blades, got 1 of the kind"));
  Scenario uneven = make_rotor(3);
  uneven.space->blades[1].azimuth += 0.01;
  CHECK(test::contains(message(uneven), "expects equal angles between blade 1, blade 2, blade 3"));
  Scenario unequal = make_rotor(3);
  for (double& mass : unequal.space->blades[2].beam.sections.mass_per_length) mass *= 1.01;
  CHECK(test::contains(message(unequal), "got 2 of the kind of blade 1, blade 2"));
  Scenario unround = make_free(3);
  unround.space->hub.inertia = Eigen::Vector3d(0.7, 0.9, 1.1).asDiagonal();
  CHECK(test::contains(message(unround), "alike in all directions across its axis"));
}

TEST_CASE("fixed frame: modes are followed and named through zero") {
  Scenario scenario = make_rotor(3);
  CampbellOptions options{.count = 6, .frame = ModeFrame::fixed, .harmonics = 3};
  for (int k = 0; k <= 10; ++k) options.speeds.push_back(0.6 * k);
  const CampbellResult result = solve_campbell(scenario, options);
  std::set<std::string> names;
  for (const CampbellBranch& branch : result.branches) {
    names.insert(branch.name);
    for (std::size_t k = 1; k < options.speeds.size(); ++k) {
      REQUIRE(branch.modes[k]);
      CHECK(result.states[k].modes[*branch.modes[k]].name == branch.name);
    }
  }
  for (const std::string pattern : {"collective", "progressive", "regressive"}) {
    CHECK(names.contains("flap 1 " + pattern));
    CHECK(names.contains("lag 1 " + pattern));
  }
}

}  // namespace spoke
