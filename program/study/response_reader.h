#pragma once

// Reads the [[response]] tables of a study file.

#include <vector>

#include "models/reader/toml_section.h"
#include "program/study/study.h"

namespace spoke::study {

/// Reads responses, one or more where they are required; whether their sensors exist is checked
/// later. Throws InputError.
std::vector<Response> read_responses(const TomlSection& root, bool is_required);

}  // namespace spoke::study
