#pragma once

// Writes drives, controllers and the joints that these move into a scenario.

#include "program/foreign/beam_table.h"
#include "program/foreign/toml_text.h"

namespace spoke::foreign {

/// Writes [hub.drive].
void write_drive(const FoundModel& model, Toml& toml);

/// Writes the pitch joint of the blades.
void write_pitch(const FoundModel& model, Toml& toml);

/// Writes the joint between tower and nacelle. `orientation`: of its frame on the tower's tip.
void write_yaw(const FoundModel& model, const std::string& orientation, Toml& toml);

/// Writes [control.library], or where it must stand alone a controller of the program's that moves
/// the same.
void write_control(const FoundModel& model, const std::string& folder, bool stands_alone,
                   Toml& toml);

/// Returns the path of a file as a scenario of a folder names it.
std::string path_from(const std::string& folder, const std::string& file);

}  // namespace spoke::foreign
