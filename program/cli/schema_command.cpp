// Prints which keys a scenario may have: for editors, or as tables.

#include <spdlog/fmt/fmt.h>

#include <string>
#include <string_view>

#include "models/error.h"
#include "models/reader/keys/tables.h"
#include "program/cli/commands.h"

namespace spoke::cli {

int print_schema(const Arguments& arguments) {
  if (!arguments.prints_json && !arguments.prints_markdown)
    throw InputError("no form is given, expected --json or --markdown");
  if (arguments.prints_json) {
    fmt::print("{}", keys::editor_schema().dump_lines());
    return 0;
  }
  std::string text;
  for (const std::string_view name : keys::document_names())
    text += fmt::format("{}### {}\n\n{}", text.empty() ? "" : "\n", name, keys::to_markdown(name));
  fmt::print("{}", text);
  return 0;
}

}  // namespace spoke::cli
