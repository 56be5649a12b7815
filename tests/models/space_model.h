#pragma once

#include <string>

#include "models/scenario.h"

namespace spoke::test {

/// Returns the model of a scenario in space.
inline spatial::Model space_model(const std::string& text) {
  return *parse_scenario(text, "f.toml").space;
}

}  // namespace spoke::test
