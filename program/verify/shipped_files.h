#pragma once

// The files of cases and their scenarios, which the build embeds, so that an installed program
// has them wherever it is.

#include <span>
#include <string_view>

namespace spoke::verify {

/// A file by its path: "cases/beams.toml", "scenarios/column.toml", "airfoils/nrel_5mw/du21.txt".
struct ShippedFile {
  std::string_view path;
  std::string_view text;
};

std::span<const ShippedFile> shipped_files();

}  // namespace spoke::verify
