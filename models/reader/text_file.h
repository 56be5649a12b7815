#pragma once

// Reading of whole text files.

#include <filesystem>
#include <string>

namespace spoke {

/// The text of a file, of a scenario unless `kind` says another, read once from its beginning to
/// its end, so that it may be a pipe. Throws InputError, its text "file: what is wrong, what is
/// expected", for anything that cannot be a text file of sensible size.
std::string read_text(const std::filesystem::path& file,
                      const std::string& kind = "a scenario file (TOML)");

}  // namespace spoke
