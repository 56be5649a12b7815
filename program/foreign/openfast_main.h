#pragma once

// Reads OpenFAST's main file (.fst), which names those of its modules.

#include "program/foreign/beam_table.h"
#include "program/foreign/keyed_lines.h"

namespace spoke::foreign {

/// What a main file says besides what goes to the model. Modules that it switches off name no file.
struct OpenFastMain {
  std::string title;
  NamedFile elastodyn, beamdyn, inflowwind, aerodyn, servodyn;
  Value density, viscosity;  ///< of the air [kg/m^3, m^2/s]; 0: not in the file
  Value time_step;           ///< [s]
};

/// Reads a main file: gravity and duration go to the model. Throws InputError with file and
/// line.
OpenFastMain read_openfast_main(const SourceFile& source, FoundModel& model);

}  // namespace spoke::foreign
