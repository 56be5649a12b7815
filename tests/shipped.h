#pragma once

#include <string>

#include "models/scenario.h"

namespace spoke::test {

/// Reads a shipped scenario by its name, with `overrides` of its keys.
inline Scenario read_shipped(const std::string& name, const Overrides& overrides = {}) {
  std::string file = SPOKE_MODELS_DIR;
  file += '/';
  file += name;
  file += ".toml";
  return read_scenario(file, overrides);
}

}  // namespace spoke::test
