#pragma once

// Keeps commands from losing data: none writes over a file that it has read, by whatever name or
// link, nor, without --force, over a file that is not of the kind that it writes.

#include <filesystem>
#include <string>
#include <vector>

#include "program/cli/file_kinds.h"

namespace spoke::cli {

/// From now on notes all files that this process reads, and has every file of results refused that
/// would take the place of one of them.
void guard_files();

/// --force: files of other kinds may be replaced from now on.
void let_replace_other_kinds();

/// Throws InputError, before anything is computed, if a file of the kind may not be written: a
/// folder stands there, or a file that was read or is of another kind. The same holds for the
/// temporary file beside it (engine/output_file.h). Whatever is empty, a device or a pipe has
/// nothing to lose.
void require_place(const std::filesystem::path& file, const FileKind& kind);

/// As above, for results, whose names tell their kinds.
void require_places(const std::filesystem::path& folder, const std::vector<std::string>& names);

}  // namespace spoke::cli
