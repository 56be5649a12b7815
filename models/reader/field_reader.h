#pragma once

// Reads the numbers that scenario_fields.h lists.

#include "models/reader/scenario_fields.h"
#include "models/reader/toml_section.h"

namespace spoke {

/// Reads for visit_fields() the numbers of a structure from a table of the file. An optional one
/// that is missing keeps its value.
struct FieldReader {
  const TomlSection& section;

  void operator()(std::string_view key, double& value, const Quantity& quantity,
                  Presence presence) const {
    if (presence == Presence::required || section.has(key)) value = section.number(key, quantity);
  }
  void operator()(std::string_view key, int& value, const Count& count, Presence presence) const {
    if (presence == Presence::required || section.has(key)) value = section.integer(key, count);
  }
};

}  // namespace spoke
