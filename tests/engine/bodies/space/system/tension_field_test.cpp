// Tension by what accelerates a whole tree: a mount that shakes along a beam, and a hub that falls.

#include <doctest/doctest.h>

#include <string>

#include "engine/simulation.h"
#include "models/scenario.h"

namespace spoke {
namespace {

std::string beam(int bodies, int elements, bool is_stiffened) {
  return "[blade]\ncount = 1\nlength = 1.0\nbodies = " + std::to_string(bodies) +
         "\nelements = " + std::to_string(elements) +
         "\ngeometric_stiffening = " + (is_stiffened ? "true" : "false") +
         "\n[blade.sections]\nmass_per_length = 1.0\naxial_stiffness = 1e5\nflap_stiffness = 1.0\n"
         "lag_stiffness = 0.8\ntorsion_stiffness = 5.0\nflap_inertia = 3e-4\nlag_inertia = 2e-4\n"
         "[[load]]\nforce = [0.0, 0.05, 0.05]\nramp = 0.3\n"
         "[integration]\nstep = 2e-3\nduration = 1.0\n";
}

/// Displacement of the tip across the beam at the end.
Eigen::Vector2d find_tip(const std::string& hub, const std::string& beam) {
  const Scenario scenario = parse_scenario("world = \"space\"\n" + hub + beam, "field.toml");
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
  simulation.run_until(scenario.integration.duration);
  return {simulation.sensor("blade1.tip.y"), simulation.sensor("blade1.tip.z")};
}

}  // namespace

TEST_CASE("a mount that shakes along a beam stretches and compresses one body as it does many") {
  const std::string shaken =
      "[hub.drive]\nkind = \"fixed\"\n[hub.mount]\n"
      "translation = { amplitude = [0.3, 0.0, 0.0], frequency = 6.0 }\n";
  const Eigen::Vector2d many = find_tip(shaken, beam(8, 2, true));
  const Eigen::Vector2d one = find_tip(shaken, beam(1, 8, true));
  const Eigen::Vector2d linear = find_tip(shaken, beam(1, 8, false));
  CHECK((one - many).norm() < 5e-3 * many.norm());
  CHECK((linear - many).norm() > 0.3 * many.norm());  // what between bodies alone is missing
}

TEST_CASE("gravity puts no tension on a hub that falls, and its beam") {
  const std::string hub =
      "[hub]\nsupport = \"free\"\nmass = 0.5\ninertia = 0.2\nangular_velocity = [0.0, 0.5, 3.0]\n";
  const std::string gravity = "[gravity]\nacceleration = [9.0, -5.0, 3.0]\n";
  const Eigen::Vector2d weightless = find_tip(hub, beam(1, 4, true));
  for (const char* ramp : {"0.0", "0.4"}) {
    const Eigen::Vector2d falling =
        find_tip(hub + gravity + "ramp = " + ramp + "\n", beam(1, 4, true));
    CHECK((falling - weightless).norm() < 1e-7 * weightless.norm());
  }
}

}  // namespace spoke
