#pragma once

// The files of a trace.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/trace/trace.h"

namespace spoke::trace {

struct WrittenFiles {
  std::vector<std::string> names;    ///< without their folder
  std::vector<std::string> remarks;  ///< what was not written, and why: a line each
};

/// Of all files that write_files() may write.
std::vector<std::string> file_names();

/// Removes those files that write_files() writes, and graph.svg, if they are there: of an earlier
/// trace. Throws InputError if one cannot be removed.
void remove_files(const std::filesystem::path& folder);

/// Writes trace.json, graph.dot, and trace.html from the page of graph/viewer, unless that is
/// empty. The folder must exist. Throws InputError if a file cannot be written. Precondition: there
/// is a step.
WrittenFiles write_files(const Trace& trace, const std::filesystem::path& folder,
                         std::string_view viewer_page);

/// What a reader should know of the files of so many slices, in a line; empty: nothing.
std::string remark_on_size(std::size_t slices);

}  // namespace spoke::trace
