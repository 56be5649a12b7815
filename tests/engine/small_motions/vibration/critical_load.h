#pragma once

// Critical loads of scenarios.

#include <doctest/doctest.h>

#include <string>

#include "engine/critical.h"
#include "models/scenario.h"

namespace spoke::test {

/// Returns the factor of the load "push" of a scenario, the text of `text` in TOML, at which its
/// equilibrium is lost, between 0 and `to`.
inline double find_critical_load(const std::string& text, double to) {
  CriticalOptions options;
  options.of = "load=push";
  options.to = to;
  const CriticalResult result = solve_critical(parse_scenario(text, "beam.toml"), options);
  REQUIRE(result.critical);
  return result.critical->value;
}

}  // namespace spoke::test
