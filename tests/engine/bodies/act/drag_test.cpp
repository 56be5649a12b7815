// Drag of bodies against closed forms: what a tower bears, and how a body falls.

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "engine/equilibrium.h"
#include "engine/simulation.h"
#include "models/scenario.h"
#include "tests/shipped.h"

namespace spoke {
namespace {

using doctest::Approx;

/// Returns a tower on the ground that is as good as rigid. `drag`: keys; `wind`: likewise.
Scenario make_tower(const std::string& drag, const std::string& wind, int bodies) {
  return parse_scenario(
      "world = \"space\"\n[hub]\nmass = 10.0\ninertia = 1.0\ndrive = { kind = \"fixed\" }\n"
      "[support]\nfrom = \"ground\"\n"
      "[[support.body]]\nname = \"tower\"\nkind = \"beam\"\nlength = 80.0\nelements = 4\nbodies "
      "= " +
          std::to_string(bodies) +
          "\n[support.body.sections]\nmass_per_length = 1.0\naxial_stiffness = 1e15\n"
          "flap_stiffness = 1e17\nlag_stiffness = 1e17\ntorsion_stiffness = 1e17\n"
          "[support.body.drag]\n" +
          drag +
          "[[support.joint]]\nchild = \"tower\"\nkind = \"fixed\"\n"
          "orientation = [0, -1.5707963267948966, 0]\n[support.axle]\nbody = \"tower\"\n"
          "[[sensor]]\nname = \"foot\"\nquantity = \"section_force\"\nsubsystem = \"support\"\n"
          "body = \"tower\"\nposition = 0.0\n"
          "[air]\ndensity = 1.2\n[wind]\n" +
          wind + "[integration]\nstep = 0.01\nduration = 0.01\n",
      "tower.toml");
}

SectionLoad foot_of(const EquilibriumResult& rest) { return rest.blades.back().loads.at(0); }

TEST_CASE("drag: a tower bears in the wind what its width, its coefficient and the wind make") {
  // q(s) = 1/2 rho c d v^2 with d from 6 to 4 m: force q_mean L, moment about the foot.
  const double pressure = 0.5 * 1.2 * 50.0 * 50.0 * 0.9;
  const double force = pressure * 5.0 * 80.0;
  const double moment = pressure * 80.0 * 80.0 * (6.0 / 6.0 + 4.0 / 3.0);
  for (const int bodies : {1, 3}) {
    const SectionLoad foot = foot_of(solve_equilibrium(make_tower(
        "diameter = [6.0, 4.0]\ncoefficient = 0.9\n", "velocity = [30.0, 40.0, 7.0]\n", bodies)));
    CHECK(foot.force.norm() == Approx(force).epsilon(1e-7));
    CHECK(foot.moment.norm() == Approx(moment).epsilon(1e-7));
  }
}

TEST_CASE("drag: of stations that are not at nodes, in wind that grows with the height") {
  // A stretch from 13 to 57 m, with a kink at 31 m; v = 20 (z/40)^0.5: v^2 = 10 z.
  const Scenario scenario = make_tower(
      "station = [13.0, 31.0, 57.0]\ndiameter = [1.0, 3.0, 3.0]\ncoefficient = [1.0, 1.0, 1.0]\n",
      "velocity = [20.0, 0.0, 0.0]\nshear_exponent = 0.5\nreference_height = 40.0\n", 2);
  const auto integrate = [](int power) {
    constexpr int kParts = 20000;
    double sum = 0.0;
    for (int k = 0; k < kParts; ++k) {
      const double s = 13.0 + 44.0 * (k + 0.5) / kParts;
      const double d = s < 31.0 ? 1.0 + (s - 13.0) / 9.0 : 3.0;
      sum += 0.5 * 1.2 * d * 10.0 * s * std::pow(s, power) * 44.0 / kParts;
    }
    return sum;
  };
  const SectionLoad foot = foot_of(solve_equilibrium(scenario));
  CHECK(foot.force.norm() == Approx(integrate(0)).epsilon(1e-6));
  CHECK(foot.moment.norm() == Approx(integrate(1)).epsilon(1e-6));
}

/// Returns a body that slides down a rail, in still air.
Scenario make_falling(const std::string& method) {
  return parse_scenario(
      "world = \"space\"\n[hub]\ndrive = { kind = \"fixed\" }\n"
      "[gravity]\nacceleration = [0, 0, -9.81]\n"
      "[[subsystem]]\nname = \"rail\"\n"
      "[[subsystem.body]]\nname = \"ball\"\nkind = \"rigid\"\nmass = 2.0\ninertia = 0.1\n"
      "drag = { area = [0.1, 0.2, 0.05], point = [0, 0, 0.3] }\n"
      "[[subsystem.joint]]\nparent = \"hub\"\nchild = \"ball\"\nname = \"fall\"\n"
      "kind = \"prismatic\"\naxis = [0, 0, 1]\n[air]\ndensity = 1.2\n"
      "[integration]\nmethod = \"" +
          method + "\"\nstep = 0.005\nduration = 4.0\n",
      "fall.toml");
}

TEST_CASE("drag: a body that falls comes to its last speed as the hyperbolic tangent says") {
  const double last = std::sqrt(2.0 * 2.0 * 9.81 / (1.2 * 0.05));
  for (const char* method : {"rk4", "generalized_alpha"}) {
    Simulation simulation(make_falling(method));
    simulation.run_until(4.0);
    const double expected = -last * std::tanh(9.81 * 4.0 / last);
    const double found = simulation.joint_motion(0, simulation.joint_index(0, "fall")).velocity;
    CHECK(found == Approx(expected).epsilon(method[0] == 'r' ? 1e-9 : 1e-5));
    CHECK(std::abs(simulation.sensor("energy.residual")) <
          1e-4 * simulation.sensor("energy.kinetic"));
  }
}

}  // namespace
}  // namespace spoke
