#pragma once

// Reads beams: sections by station, point masses.

#include "models/reader/toml_section.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// Returns the keys of a table that describes a beam.
TomlSection::Keys beam_keys();

/// Returns a matrix of a section in Spoke's axes from the one in BeamDyn's axes, and the other way
/// round.
SectionMatrix swap_beamdyn_axes(const SectionMatrix& matrix);

/// Reads the table "sections" of a beam's table; the beam has its length.
Sections read_sections(const TomlSection& beam, double length);

/// Reads the tables "point_mass" of a beam's table.
std::vector<PointMass> read_point_masses(const TomlSection& beam);

}  // namespace spoke::spatial
