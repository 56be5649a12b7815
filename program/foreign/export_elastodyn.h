#pragma once

// Writes blades and towers of scenarios as files of ElastoDyn.

#include "program/foreign/export_files.h"

namespace spoke::foreign {

/// Returns the blade file of a blade, counted from 1, and that of the tower if the support has one
/// that stands on the ground: `tower_file` is its name. Throws InputError if there is no such
/// blade.
ExportedFiles export_elastodyn(const Scenario& scenario, std::size_t blade,
                               const std::string& blade_file, const std::string& tower_file);

}  // namespace spoke::foreign
