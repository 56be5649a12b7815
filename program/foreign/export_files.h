#pragma once

// Files of another program that a scenario is written as.

#include <string>
#include <vector>

#include "models/scenario.h"
#include "program/foreign/beamdyn_reader.h"

namespace spoke::foreign {

/// Files by their names, the first the one that was asked for.
struct ExportedFiles {
  std::vector<SourceFile> files;
  std::vector<std::string> left_out;  ///< what they do not know, a sentence each
};

/// Returns a blade of a scenario in space, blades counted from 1. Throws InputError if there is no
/// such blade.
const spatial::Blade& choose_blade(const Scenario& scenario, std::size_t blade);

/// Returns the shortest degrees that are read as this angle, of the other sign, to the last bit.
double turned_degrees_of(double angle);

}  // namespace spoke::foreign
