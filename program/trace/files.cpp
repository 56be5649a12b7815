// Writes each file whole or not at all.

#include "program/trace/files.h"

#include <cassert>
#include <string>
#include <system_error>
#include <vector>

#include "engine/results.h"
#include "models/error.h"
#include "program/trace/chrome_trace.h"
#include "program/trace/graph_picture.h"
#include "program/trace/page_data.h"

namespace spoke::trace {

std::vector<std::string> file_names() {
  // The last one is a picture that Graphviz made of an earlier graph.dot.
  return {"trace.json", "graph.dot", "trace.html", "graph.svg"};
}

void remove_files(const std::filesystem::path& folder) {
  for (const std::string& file : file_names()) {
    std::error_code error;
    std::filesystem::remove(folder / file, error);
    if (error)
      throw InputError((folder / file).string() + ": cannot be replaced: " + error.message());
  }
}

WrittenFiles write_files(const Trace& trace, const std::filesystem::path& folder,
                         std::string_view viewer_page) {
  assert(!trace.steps.steps.empty());
  WrittenFiles written{{"trace.json", "graph.dot"}, {}};
  write_file(folder / "trace.json", make_chrome_trace(trace));
  write_file(folder / "graph.dot", make_dot(trace));
  if (!viewer_page.empty()) {
    write_file(folder / "trace.html", make_trace_page(viewer_page, make_page_data(trace)));
    written.names.emplace_back("trace.html");
  } else {
    std::error_code ignored;
    std::filesystem::remove(folder / "trace.html", ignored);  // page of another trace
    written.remarks.emplace_back("no trace.html: this program was built without its page");
  }
  return written;
}

std::string remark_on_size(std::size_t slices) {
  constexpr std::size_t many = 1'000'000;
  if (slices <= many) return {};
  return std::to_string(slices) +
         " slices: browsers are slow to open so many; spoke trace --steps K records fewer";
}

}  // namespace spoke::trace
