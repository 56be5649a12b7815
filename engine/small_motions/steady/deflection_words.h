#pragma once

// The words of warnings that a body in space deforms beyond the range of linear elasticity.

#include <cstddef>
#include <string>

#include "models/spatial_model.h"

namespace spoke::steady {

/// Words about a body by its kind.
struct DeflectionWords {
  std::string name;     ///< "blade 1 / body 2", "bracket / arm"
  std::string verb;     ///< "bends by", "deforms by"
  std::string measure;  ///< what the share is of: " of its length"
  std::string advice;   ///< what to do about it
};

/// Returns the words for body `body` of subsystem `subsystem` of a model, from 0.
DeflectionWords word_deflection(const spatial::Model& model, std::size_t subsystem,
                                std::size_t body);

}  // namespace spoke::steady
