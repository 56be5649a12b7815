#pragma once

// Reads study files.

#include <string>

#include "program/study/study.h"

namespace spoke::study {

/// Reads and validates a study file, with the texts of its scenario and of its table, whose file
/// names are relative to the study's folder. check_study() finds whether the parameters' keys and
/// the sensors exist. Throws InputError, its text "file:line:column: key: what is wrong, what is
/// expected".
Study read_study(const std::string& file);

}  // namespace spoke::study
