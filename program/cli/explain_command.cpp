// Tells what a key of scenarios means.

#include <spdlog/fmt/fmt.h>

#include <string>

#include "models/error.h"
#include "models/reader/keys/key_help.h"
#include "program/cli/commands.h"

namespace spoke::cli {

int explain_key(const Arguments& arguments) {
  const std::string text = keys::explain(arguments.key);
  if (text.empty()) {
    const std::string alike = keys::find_alike(arguments.key);
    throw InputError(
        "scenarios have no key \"" + arguments.key + "\", " +
        (alike.empty() ? "expected one of docs/scenario.md" : "did you mean \"" + alike + "\"?"));
  }
  fmt::print("{}", text);
  return 0;
}

}  // namespace spoke::cli
