#pragma once

// Reads the parameters of ROSCO, NREL's reference controller, a file DISCON.IN.

#include "program/foreign/beam_table.h"
#include "program/foreign/beamdyn_reader.h"

namespace spoke::foreign {

/// Whether a text is such a file: lines of values, "!" and the key, VS_ControlMode among them.
bool is_discon(std::string_view text);

/// Reads the laws into `model.laws`, on the hub's side of the gearbox of the file, and says what of
/// them it leaves out. Throws InputError with file and line.
void read_discon(const SourceFile& source, FoundModel& model);

}  // namespace spoke::foreign
