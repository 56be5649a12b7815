#pragma once

// Reads [wind] alone.

#include <string>

#include "models/reader/spatial/wind_reader.h"
#include "models/reader/toml_document.h"
#include "models/reader/toml_section.h"
#include "tests/message_of.h"

namespace spoke::test {

/// Reads a scenario that is a wind and nothing else; files are relative to `folder`.
inline Wind read_wind_text(const std::string& text, const std::string& folder = ".") {
  const TomlDocument document(text, "f.toml");
  const TomlSection root(document, {"wind"});
  return spatial::read_wind(root.section("wind", spatial::wind_keys()), folder, {});
}

}  // namespace spoke::test
