#pragma once

// The files of a trace.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "program/trace/trace.h"

namespace spoke::trace {

struct WrittenFiles {
  std::vector<std::string> names;    ///< names without their folder
  std::vector<std::string> remarks;  ///< a line for each file not written, with the reason
};

/// Returns the names of all files that write_files() may write, and of graph.svg.
std::vector<std::string> file_names();

/// Removes the files of these names, if an earlier trace left them.
/// Throws InputError if one cannot be removed.
void remove_files(const std::filesystem::path& folder);

/// Writes trace.json, graph.dot, and trace.html from the page of program/viewer, unless that is
/// empty. The folder must exist. Throws InputError if a file cannot be written. Precondition: there
/// is a step.
WrittenFiles write_files(const Trace& trace, const std::filesystem::path& folder,
                         std::string_view viewer_page);

/// Returns a remark for readers of files with so many slices, in a line; empty: none.
std::string remark_on_size(std::size_t slices);

}  // namespace spoke::trace
