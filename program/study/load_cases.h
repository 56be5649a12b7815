#pragma once

// Load cases of IEC 61400-1, third edition, table 2, as the table of a design.

#include <string>

#include "models/reader/toml_section.h"

namespace spoke::study {

/// The runs of load cases.
struct LoadCases {
  std::string table;    ///< CSV, as read_table() reads it
  double settle = 0.0;  ///< time before a run counts [s]
};

/// Reads the table [load_cases] of a study file. Throws InputError.
LoadCases read_load_cases(const TomlSection& root);

}  // namespace spoke::study
