#pragma once

#include <string>

#include "models/scenario.h"

namespace spoke::test {

/// Reads a shipped scenario by its name.
inline Scenario read_shipped(const std::string& name) {
  std::string file = SPOKE_MODELS_DIR;
  file += '/';
  file += name;
  file += ".toml";
  return read_scenario(file);
}

}  // namespace spoke::test
