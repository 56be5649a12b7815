#pragma once

// Writes blades of scenarios as files of BeamDyn.

#include <string>
#include <vector>

#include "models/scenario.h"

namespace spoke::foreign {

/// The two files of a blade.
struct BeamDynFiles {
  std::string primary, blade;         ///< their texts
  std::vector<std::string> left_out;  ///< what BeamDyn does not know, a sentence each
};

/// Returns files of a blade of a scenario in space, blades counted from 1. `blade_file`: the name
/// by which the primary file is to name the other. Throws InputError if there is no such blade.
BeamDynFiles export_beamdyn(const Scenario& scenario, std::size_t blade,
                            const std::string& blade_file);

}  // namespace spoke::foreign
