#pragma once

// Reads the [[parameter]] tables of a study file.

#include <vector>

#include "models/reader/toml_section.h"
#include "program/study/study.h"

namespace spoke::study {

/// Appends the parameters of the file to those made of a table's columns. Throws InputError, also
/// if a kind of parameter does not go with the design.
void read_parameters(const TomlSection& root, DesignKind design,
                     std::vector<Parameter>& parameters);

}  // namespace spoke::study
