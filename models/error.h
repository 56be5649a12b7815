#pragma once

#include <stdexcept>
#include <string>

#include "spoke/export.h"

namespace spoke {

/// Input that cannot be used: one sentence naming where it stands (file:line:column where there is
/// one), the key, the value, and what was expected. The program ends with status 2.
class SPOKE_EXPORT InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A simulation that left the range of its model: one sentence naming time, step, subsystem, body,
/// node of the graph and quantity, and what to try. The program ends with status 3.
class SPOKE_EXPORT DivergenceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace spoke
