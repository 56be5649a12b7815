#pragma once

// Reads what a blade is made of along its length: sections and point masses.

#include <string_view>
#include <vector>

#include "models/reader/toml_section.h"
#include "models/rotor.h"

namespace spoke {

/// Whether a key describes the material of a uniform blade.
bool is_material(std::string_view key);

/// The table that says what a blade is made of: its own if it has sections, or, where the table of
/// all blades has them, keys of a uniform blade; else the table of all. Throws InputError if that
/// table has both.
const TomlSection& material_of(const TomlSection& own, const TomlSection& common);

/// The table "sections" of a blade's table.
BladeSections read_sections(const TomlSection& blade);
/// Throws InputError, at the key in `section`, if the sections do not fit one another or the blade.
void check_sections(const TomlSection& section, const Blade& blade);

/// The tables "point_mass" of a blade's table.
std::vector<PointMass> read_point_masses(const TomlSection& section, const Blade& blade);

}  // namespace spoke
