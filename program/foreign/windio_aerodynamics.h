#pragma once

// Reads the outer shape of the blade of an ontology of WindIO, and the air.

#include "program/foreign/beam_table.h"
#include "program/foreign/windio_entry.h"

namespace spoke::foreign {

/// Returns whether an ontology has aerofoils, and says where they are along the blade.
bool has_windio_aerodynamics(const Entry& root, bool is_version_2);

/// Reads aerodynamics into `model.air`; the model's blade is read already. `axis`: its reference
/// axis; `twist`: the table of its sections' twist. Throws InputError.
void read_windio_aerodynamics(const Entry& root, bool is_version_2, const Entry& axis,
                              const Entry& twist, FoundModel& model);

}  // namespace spoke::foreign
