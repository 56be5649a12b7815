// Damping by direction and by mode in motion: decay, equal formulations, energy and momentum,
// declared accesses.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "engine/modes.h"
#include "engine/simulation.h"
#include "engine/step/step_graph_builder.h"
#include "graph/declaration_check.h"
#include "models/scenario.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/bodies/space/system/random_system.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/step/damaged_graph.h"

using namespace spoke;
using namespace spoke::test;
using doctest::Approx;

namespace {

const std::string kKeys =
    "[damping]\nflap = 2e-3\nlag = 1e-3\ntorsion = 5e-4\nflap_shear = 1e-3\n"
    "ratios = [0.02, 0.05, 0.01]\nabove = 0.03\n";

/// Ratio of damping of an oscillation about `rest`, by the peaks from the first to the last.
double find_ratio(const std::vector<double>& values, double rest) {
  std::vector<double> peaks;
  for (std::size_t k = 1; k + 1 < values.size(); ++k) {
    const double a = values[k - 1] - rest, b = values[k] - rest, c = values[k + 1] - rest;
    if (b <= 0.0 || b < a || b <= c) continue;
    peaks.push_back(b + (a - c) * (a - c) / (8.0 * (2.0 * b - a - c)));  // of the parabola
  }
  REQUIRE(peaks.size() > 6);
  const double decrement =
      std::log(peaks[2] / peaks.back()) / static_cast<double>(peaks.size() - 3);
  return decrement / std::hypot(2.0 * std::numbers::pi, decrement);
}

/// A cantilever of 1 m that a small force at its tip, there at once, makes swing.
std::string swinging(const std::string& force, const std::string& more) {
  return "world = \"space\"\n[hub]\n[hub.drive]\nkind = \"constant\"\nspeed = 0.0\n"
         "[blade]\ncount = 1\nlength = 1.0\nbodies = 2\nelements = 3\n[blade.sections]\n"
         "mass_per_length = 1.0\naxial_stiffness = 900.0\nlag_stiffness = 2.0\n"
         "flap_stiffness = 1.0\ntorsion_stiffness = 0.02\nlag_inertia = 1e-4\n"
         "flap_inertia = 1e-4\n[[load]]\n" +
         force + more + "[integration]\nspectral_radius = 1.0\nstep = 0.004\nduration = 18.0\n";
}

/// Simulates a scenario; returns a sensor by step, and the last value.
std::vector<double> values_of(const std::string& text, const std::string& sensor) {
  Simulation simulation(parse_scenario(text, "t.toml"), {Formulation::structured});
  std::vector<double> values;
  while (!simulation.done()) {
    simulation.step();
    values.push_back(simulation.sensor(sensor));
  }
  return values;
}

/// A free machine with hinged and cut beams, all of whose beams are damped.
System<Space> flying_system() {
  return make_system(parse_model(make_text(kFlyingHub, kBooms + kHinges, kKeys)));
}

}  // namespace

TEST_CASE("damping: a swinging cantilever loses what its direction or mode takes") {
  // Modes above the first die out at once.
  const double flap = 3.516, lag = 3.516 * std::sqrt(2.0);
  const auto ratio_of = [](const std::string& force, const char* sensor, double rest,
                           const std::string& keys) {
    return find_ratio(values_of(swinging(force, keys), sensor), rest);
  };
  const std::string z = "force = [0.0, 0.0, 3e-4]\n", y = "force = [0.0, 3e-4, 0.0]\n";
  const std::string factors = "[damping]\nflap = 0.02\nlag = 0.005\n";
  CHECK(ratio_of(z, "blade1.tip.z", 1e-4, factors) == Approx(0.01 * flap).epsilon(0.01));
  CHECK(ratio_of(y, "blade1.tip.y", 5e-5, factors) == Approx(0.0025 * lag).epsilon(0.01));
  const std::string ratios = "[damping]\nratios = [0.04, 0.015]\nabove = 0.4\n";
  CHECK(ratio_of(z, "blade1.tip.z", 1e-4, ratios) == Approx(0.04).epsilon(0.01));
  CHECK(ratio_of(y, "blade1.tip.y", 5e-5, ratios) == Approx(0.015).epsilon(0.01));
}

TEST_CASE("damping: ratios of all modes in proportion to their frequency are a stiffness_factor") {
  // The modes are complete, and D = b K to round-off: motion, work and section forces are equal.
  // Loads that rise make no difference of the implicit pass at the start, which has no D of modes.
  const double b = 2e-3;
  const auto text = [](const std::string& world, const std::string& keys) {
    const std::string sections = world == "plane"
                                     ? "density = 1.0\narea = 1.0\nsecond_moment = 1e-3\n"
                                       "youngs_modulus = 1000.0\n"
                                     : "[blade.sections]\nmass_per_length = 1.0\n"
                                       "axial_stiffness = 900.0\nlag_stiffness = 2.0\n"
                                       "flap_stiffness = 1.0\ntorsion_stiffness = 0.5\n"
                                       "lag_inertia = 0.01\nflap_inertia = 0.01\n";
    return "world = \"" + world +
           "\"\n[hub]\n[hub.drive]\nkind = \"constant\"\nspeed = 0.0\n[blade]\ncount = 1\nlength = "
           "1.0\n"
           "bodies = 2\nelements = 1\n" +
           sections + keys + "[integration]\nstep = 0.002\ntolerance = 1e-13\nduration = 0.6\n";
  };
  for (const std::string& world : {std::string("plane"), std::string("space")}) {
    CAPTURE(world);
    const std::string load =
        world == "plane" ? "[[load]]\nforce = [0.3, 0.1]\nramp = 0.2\n"
                         : "[[load]]\nforce = [0.2, 0.1, 0.1]\nmoment = [0.1, 0, 0]\nramp = 0.2\n";
    std::ostringstream ratios;
    ratios.precision(17);
    const ModesResult modes =
        solve_modes(parse_scenario(text(world, ""), "t.toml"),
                    {.state = {.speed = 0.0}, .count = world == "plane" ? 6 : 12});
    for (const Mode& mode : modes.modes) {
      REQUIRE(0.5 * b * mode.frequency < 1.0);
      ratios << (ratios.str().empty() ? "" : ", ") << 0.5 * b * mode.frequency;
    }
    for (const Formulation formulation : formulations()) {
      Simulation by_modes(
          parse_scenario(text(world, load + "[damping]\nratios = [" + ratios.str() + "]\n"),
                         "t.toml"),
          {formulation});
      Simulation by_factor(
          parse_scenario(text(world, load + "[damping]\nstiffness_factor = 2e-3\n"), "t.toml"),
          {formulation});
      by_modes.run_until(0.3);
      by_factor.run_until(0.3);
      const char* const tip = "blade1.tip.y";
      CHECK(by_modes.sensor(tip) == Approx(by_factor.sensor(tip)).epsilon(1e-8));
      CHECK(by_modes.sensor("energy.dissipated") ==
            Approx(by_factor.sensor("energy.dissipated")).epsilon(1e-8));
      const Marker marker{0, 1, 0.3};
      const Wrench a = by_modes.section_force(marker), c = by_factor.section_force(marker);
      CHECK((a.force - c.force).norm() < 1e-8 * c.force.norm());
      CHECK((a.moment - c.moment).norm() < 1e-8 * c.moment.norm());
    }
  }
}

TEST_CASE("damping: three formulations move alike") {
  for (const Method& method : {Method(Rk4{2e-5}), Method(make_generalized_alpha(0.8, 0.002))}) {
    const double time = std::holds_alternative<Rk4>(method) ? 0.02 : 0.2;
    Run<Space> structured(flying_system(), {method});
    structured.advance_for(time);
    for (const Formulation other : {Formulation::subsystem, Formulation::augmented}) {
      CAPTURE(name_of(other));
      RunSetup setup{method};
      setup.formulation = other;
      Run<Space> run(flying_system(), setup);
      run.advance_for(time);
      CHECK(largest_difference(structured, run) < 1e-9);
      CHECK(run.dissipated == Approx(structured.dissipated).epsilon(1e-8));
    }
  }
}

TEST_CASE("damping: a free machine keeps its momenta, and loses what damping takes") {
  const auto measure = [](const Method& method) {
    Run<Space> run(flying_system(), {method});
    const double energy = calc_energy(run);
    const space::Twist momentum = calc_momentum(run);
    run.advance_for(0.2);
    CHECK(run.dissipated > 1e-4 * energy);
    return std::pair(std::abs(calc_energy(run) - energy + run.dissipated),
                     (calc_momentum(run) - momentum).norm());
  };
  const auto [energy, momentum] = measure(Rk4{4e-5});
  const auto [finer, better] = measure(Rk4{2e-5});
  CHECK(energy < 1e-6);
  CHECK(finer < energy / 3.5);  // the quadrature of the power is of second order or better
  CHECK(momentum < 1e-9);
  const auto [coarse_alpha, unused] = measure(make_generalized_alpha(1.0, 0.001));
  const auto [fine_alpha, also_unused] = measure(make_generalized_alpha(1.0, 0.0005));
  CHECK(fine_alpha < coarse_alpha / 3.0);
}

TEST_CASE("damping: nodes declare what damping reads and writes") {
  for (const Formulation formulation : formulations())
    for (const auto& [method, control] :
         {std::pair(Method(Rk4{1e-5}), PassControl{0.1, 1, false}),
          std::pair(Method(make_generalized_alpha(0.8, 0.005)), PassControl{0.1, 1, true})}) {
      CAPTURE(name_of(formulation));
      SystemContext<Space> context;
      context.system =
          make_system(parse_model(make_text(kDrivenHub, kBooms + kHinges, kGravity + kKeys)));
      context.formulation = formulation;
      context.integrator = {method, {1e-10, 0, 50}};
      allocate(context);
      std::mt19937 random(4);
      randomize_state(random, context.data);
      const graph::StepGraph graph = build_step_graph(context);
      set_progress(control, context);
      for (const graph::DeclarationFault& fault : graph::check_declarations(graph))
        FAIL_CHECK(fault.message);
      CHECK(graph::conflicts_are_ordered(graph));
    }
}

TEST_CASE("damping: equal bits on executors, threads and windows") {
  const System<Space> system =
      make_system(parse_model(make_text(kDrivenHub, kBooms + kHinges, kGravity + kKeys)));
  const Method method = make_generalized_alpha(0.8, 0.002);
  Run<Space> serial(system, {method});
  serial.advance(20);
  RunSetup setup{method};
  setup.executor = graph::ExecutorKind::flow_graph;
  setup.threads = graph::Threads{2};
  setup.window = 4;
  Run<Space> parallel(system, setup);
  parallel.advance(20);
  CHECK(parallel.hash() == serial.hash());
}
