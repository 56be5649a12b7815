#include "tests/program/trace/samples.h"

namespace spoke::trace::testing {
namespace {

Scenario make_scenario(bool is_coupled) {
  Blade blade;
  blade.length = 8.0;
  blade.bodies = 2;
  blade.elements = 3;
  blade.density = 2766.67;
  blade.area = 7.299e-5;
  blade.second_moment = 8.214e-9;
  blade.youngs_modulus = 6.895e10;
  Scenario scenario;
  scenario.name = "sample";
  scenario.title = "A \"sample\" </script> of <three> blades";
  Rotor& rotor = scenario.rotor;
  rotor.blades.assign(3, blade);
  rotor.blades[1].azimuth = 2.0;
  rotor.blades[1].bodies = 3;
  rotor.blades[1].length = 5.0;
  rotor.blades[2].azimuth = 4.0;
  rotor.gravity = Position{0.0, -9.81};
  rotor.hub.drive = SpinUp{4.0, 15.0};
  if (is_coupled) {
    rotor.hub.support = HubSupport::free;
    rotor.hub.mass = 10.0;
    rotor.hub.inertia = 2.0;
    rotor.hub.drive = TorqueDrive{Curve(30.0)};
  }
  scenario.integration.step = 0.01;
  scenario.integration.duration = 1.0;
  return scenario;
}

}  // namespace

Simulation make_simulation(const Sample& sample) {
  Simulation simulation(make_scenario(sample.is_coupled),
                        {sample.formulation, sample.executor, sample.threads, sample.window});
  simulation.run_until(20 * simulation.step_size());
  return simulation;
}

Trace make_trace(const Sample& sample) {
  Simulation simulation = make_simulation(sample);
  StepTrace steps = simulation.trace(10);
  return describe(simulation, std::move(steps));
}

Trace small_trace() {
  Trace trace;
  trace.title = std::string("small");  // GCC 12 misjudges the assignment of the text itself
  trace.scenario = trace.title;
  trace.threads = "2";
  trace.step_size = 0.5;
  trace.created = "2026-01-01T00:00:00Z";
  StepTrace& steps = trace.steps;
  steps.graph.labels = {{"root"}, {"mass", 0, 0}, {"mass", 0, 1}};
  steps.graph.names = {"root", "blade 1 / body 1 / mass", "blade 1 / body 2 / mass"};
  steps.graph.subsystem_word = "blade";
  steps.graph.subsystems = {"blade 1"};
  steps.graph.edges = {{0, 1}, {0, 2}};
  steps.graph.next_pass_edges = {{1, 0}, {2, 0}};
  steps.steps = {{7, 3.5, 2}, {8, 4.0, 2}};
  steps.threads = 2;
  steps.executor = "by hand";
  // The root takes 1 us, the masses 3 and 2 us on two threads; there is a gap of 1 us before each
  // pass.
  for (int pass = 0; pass < 4; ++pass) {
    const std::int64_t begin = 1000 + pass * 5000, step = 7 + pass / 2;
    steps.slices.push_back({0, step, pass % 2, 4, 0, begin, begin + 1000});
    steps.slices.push_back({1, step, pass % 2, 4, 0, begin + 1000, begin + 4000});
    steps.slices.push_back({2, step, pass % 2, 5, 1, begin + 1000, begin + 3000});
    steps.runs.push_back({begin - 500, begin + 4100});
  }
  return trace;
}

}  // namespace spoke::trace::testing
