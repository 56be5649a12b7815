#pragma once

// The paper's rotor in any size, the model of most benchmarks.

#include <string>

#include "models/scenario.h"

namespace spoke::bench {

/// A number of blades, bodies per blade, finite elements per body: the (N, M, E) of the tables.
struct RotorSize {
  int blades = 3;
  int bodies = 4;
  int elements = 4;

  int total_elements() const { return blades * bodies * elements; }
  /// Returns "(3,4,4)".
  std::string name() const;
};

/// Reads a rotor of models/ in another size.
Scenario sized_rotor(const std::string& file, const RotorSize& size, bool stiffening);
/// Reads the paper's rotor (models/paper_rotor.toml) in another size.
Scenario paper_rotor(const RotorSize& size, bool stiffening = false);

}  // namespace spoke::bench
