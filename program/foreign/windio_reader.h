#pragma once

// Reads the blade of a turbine in the ontology of WindIO (YAML), as the IEA's reference turbines
// are published.

#include "program/foreign/beam_table.h"
#include "program/foreign/beamdyn_reader.h"

namespace spoke::foreign {

/// Reads rotor and blade: components.blade.elastic_properties_mb.six_x_six, and of the hub diameter
/// and cone angle. Throws InputError with file and line, and where this build lacks libyaml-cpp.
void read_windio(const SourceFile& source, FoundModel& model);

}  // namespace spoke::foreign
