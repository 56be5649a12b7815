#pragma once

// Reads the sections and point masses of a blade, and the strains of any beam.

#include <string_view>
#include <vector>

#include "models/reader/toml_section.h"
#include "models/rotor.h"

namespace spoke {

/// Whether a key describes the material of a uniform blade.
bool is_material(std::string_view key);

/// Returns the table that says what a blade is made of: its own if it has sections, or has keys of
/// a uniform blade where the common table has sections; otherwise the common one. Throws InputError
/// if that table has both.
const TomlSection& material_of(const TomlSection& own, const TomlSection& common);

/// Reads the table "sections" of a blade's table.
BladeSections read_sections(const TomlSection& blade);
/// Throws InputError, at the key in `section`, if the sections do not fit one another or the blade.
void check_sections(const TomlSection& section, const Blade& blade);

/// Reads the tables "point_mass" of a blade's table.
std::vector<PointMass> read_point_masses(const TomlSection& section, const Blade& blade);

}  // namespace spoke
