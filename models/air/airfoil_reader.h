#pragma once

// Aerofoils from files: AeroDyn's, C81, and plain tables. Formats: docs/aerodynamics.md.

#include <filesystem>
#include <string>
#include <string_view>

#include "models/air.h"

namespace spoke::air {

/// Reads an aerofoil file and gives the aerofoil a name. Throws InputError "file:line: ..." for
/// whatever is not as it must be.
spatial::Airfoil read_airfoil(const std::filesystem::path& file, const std::string& name);

/// Makes an aerofoil from the text of such a file.
spatial::Airfoil parse_airfoil(std::string_view text, const std::string& file,
                               const std::string& name);

}  // namespace spoke::air
