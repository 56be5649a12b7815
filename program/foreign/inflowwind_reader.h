#pragma once

// Reads InflowWind's file and the table of a uniform wind.

#include "program/foreign/beam_table.h"
#include "program/foreign/keyed_lines.h"

namespace spoke::foreign {

/// What the file says besides what goes to the model.
struct InflowWindFile {
  NamedFile uniform;              ///< a table of a uniform wind, if there is one
  NamedFile turbsim;              ///< a file of TurbSim, likewise
  double reference_length = 1.0;  ///< of linear shears in the table [m]
};

/// Reads the file: a steady wind goes to `model.air`, which must be there, and of others what does
/// not stand in the files that it names. Throws InputError with file and line.
InflowWindFile read_inflowwind(const SourceFile& source, FoundModel& model);

/// Reads the table of a uniform wind, which goes to the wind of `model.air`. Throws InputError with
/// file and line.
void read_uniform_wind(const SourceFile& source, const InflowWindFile& file, FoundModel& model);

}  // namespace spoke::foreign
