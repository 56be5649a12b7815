#pragma once

// Reads [wind].

#include <string>

#include "models/reader/spatial/fault.h"
#include "models/reader/toml_section.h"
#include "models/scenario.h"
#include "models/wind.h"

namespace spoke::spatial {

/// Returns the keys of [wind].
TomlSection::Keys wind_keys();

/// Reads the table [wind], and the file that it names, relative to `folder`. `model`: tells the
/// height of the hub and the diameter of the rotor. Throws InputError with file, line and key; of
/// what is wrong in a file of wind, with its name and place.
Wind read_wind(const TomlSection& section, const std::string& folder, const Model& model);

/// Finds a fault of a wind that is filled in code, whatever is in its file.
Fault find_fault(const Wind& wind);

/// Finds a wind of a file, or of the program's own, that ends before the run; seen from the
/// scenario.
Fault find_end_fault(const Scenario& scenario);

}  // namespace spoke::spatial
