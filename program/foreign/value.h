#pragma once

// A number of a file.

#include <string>

namespace spoke::foreign {

/// A number and where it came from: "HubRad, turbine.dat:46".
struct Value {
  double number = 0.0;
  std::string from;
};

}  // namespace spoke::foreign
