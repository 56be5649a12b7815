#pragma once

// Reads the tower, the nacelle and the drive train of an ontology of WindIO.

#include "program/foreign/beam_table.h"
#include "program/foreign/windio_entry.h"

namespace spoke::foreign {

/// Returns whether an ontology of version 1 has a tower of layers and says where the hub is on it.
bool has_windio_turbine(const Entry& root);

/// Reads these into the model, whose rotor and air are read already. `is_upwind`: where the rotor
/// stands. Throws InputError.
void read_windio_turbine(const Entry& root, bool is_upwind, FoundModel& model);

}  // namespace spoke::foreign
