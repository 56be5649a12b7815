#pragma once

#include <filesystem>

namespace spoke::cli {

/// Throws InputError unless the folder can be made, without making it: nothing is left behind by a
/// command that fails.
void demand_folder(const std::filesystem::path& folder);

/// Makes the folder and those above it, unless they exist. Throws InputError.
void make_folder(const std::filesystem::path& folder);

}  // namespace spoke::cli
