#pragma once

// Reads ElastoDyn's files: the primary one of a turbine, of a blade and of a tower.

#include <string>

#include "program/foreign/beam_table.h"
#include "program/foreign/beamdyn_reader.h"
#include "program/foreign/keyed_lines.h"

namespace spoke::foreign {

/// What a primary file says besides what goes to the model.
struct ElastoDynPrimary {
  Value blade_length, tower_height;  ///< [m]
  Value tip_mass, yaw_bearing_mass;  ///< [kg]
  NamedFile blade, tower;
};

/// Reads a primary file: rotor, hub, nacelle and shaft go to the model. Throws InputError with file
/// and line.
ElastoDynPrimary read_elastodyn_primary(const SourceFile& source, FoundModel& model);

/// Reads a blade file, whose stations are shares of the length: the blade and its damping go to the
/// model. Throws InputError with file and line.
void read_elastodyn_blade(const SourceFile& source, const Value& length, FoundModel& model);

/// Reads a tower file likewise. Flap is fore-aft, lag side-to-side. Its damping goes to the model
/// if there is none yet.
void read_elastodyn_tower(const SourceFile& source, const Value& height, FoundModel& model);

}  // namespace spoke::foreign
