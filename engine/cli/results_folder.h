#pragma once

// Checks of the folders and files that a command is to write.

#include <filesystem>

namespace spoke::cli {

/// Throws InputError unless the folder can be made, without making it: nothing is left behind by a
/// command that fails.
void require_folder(const std::filesystem::path& folder);

/// Throws InputError if a folder stands where a file is to be written.
void require_no_folder(const std::filesystem::path& file);

/// Makes the folder and those above it, unless they exist. Throws InputError.
void make_folder(const std::filesystem::path& folder);

}  // namespace spoke::cli
