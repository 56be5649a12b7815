#pragma once

// What could not be carried over, worst first.

#include <string>

namespace spoke::foreign {

/// How much what is left out changes what the model does, the most first.
enum class Loss {
  part,    ///< a part of the machine, of its control or of its loads is missing
  value,   ///< a number or a state is another one
  theory,  ///< what is there goes by another model
  detail   ///< nothing that moves: mode shapes, numerics, outputs
};

/// A sentence on what is left out.
struct LeftOut {
  Loss loss;
  std::string text;
};

}  // namespace spoke::foreign
