#pragma once

#include <filesystem>

namespace spoke::cli {

/// Throws InputError unless the folder can be made, without making it: a command that fails later
/// leaves nothing behind.
void demand_folder(const std::filesystem::path& folder);

/// Makes the folder and those above it. Throws InputError.
void make_folder(const std::filesystem::path& folder);

}  // namespace spoke::cli
