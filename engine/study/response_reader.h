#pragma once

// Reads the [[response]] tables of a study file.

#include <vector>

#include "engine/study/study.h"
#include "models/reader/toml_section.h"

namespace spoke::study {

/// The responses of a study file, one at least; whether sensors exist is not known yet. Throws
/// InputError.
std::vector<Response> read_responses(const TomlSection& root);

}  // namespace spoke::study
