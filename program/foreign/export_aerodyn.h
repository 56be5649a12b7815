#pragma once

// Writes the aerodynamics of a blade as files of AeroDyn 15.

#include <functional>

#include "program/foreign/export_files.h"

namespace spoke::foreign {

/// Returns the primary file, that of the blade, counted from 1, and one of each of its aerofoils,
/// whose names `airfoil_file` makes. Throws InputError if there is no such blade, or it has no
/// aerodynamics, or another sense of rotation than AeroDyn's.
ExportedFiles export_aerodyn(const Scenario& scenario, std::size_t blade,
                             const std::string& primary_file, const std::string& blade_file,
                             const std::function<std::string(const std::string&)>& airfoil_file);

}  // namespace spoke::foreign
