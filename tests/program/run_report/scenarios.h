#pragma once

#include <numbers>

#include "engine/simulation.h"

/// Makes a scenario of two blades of two bodies, three elements each, that are spun up.
inline spoke::Scenario test_scenario() {
  spoke::Blade blade;
  blade.length = 6.0;
  blade.bodies = 2;
  blade.elements = 3;
  blade.density = 2766.67;
  blade.area = 7.299e-5;
  blade.second_moment = 8.214e-9;
  blade.youngs_modulus = 6.895e10;
  spoke::Scenario scenario;
  scenario.title = "two </script> blades";
  scenario.rotor.blades = {blade, blade};
  scenario.rotor.blades[1].azimuth = std::numbers::pi;
  scenario.rotor.hub.radius = 0.5;
  scenario.rotor.hub.drive = spoke::SpinUp{4.0, 5.0};
  scenario.integration.step = 0.01;
  scenario.integration.duration = 2.0;
  scenario.output.interval = 0.05;
  return scenario;
}

inline spoke::SimulationOptions test_options() {
  return {spoke::Formulation::structured, spoke::ExecutorKind::serial, 1};
}
