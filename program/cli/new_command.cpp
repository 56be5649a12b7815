// Writes a commented scenario to begin with.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/output_file.h"
#include "models/error.h"
#include "program/cli/commands.h"
#include "program/cli/new_scenarios.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;

const Template& find_template(const std::string& kind) {
  std::string kinds;
  for (const Template& one : templates()) {
    if (one.kind == kind) return one;
    const bool is_last = &one == &templates().back();
    kinds += (kinds.empty() ? "" : is_last ? " or " : ", ") + std::string(one.kind);
  }
  throw InputError("there is no kind \"" + kind + "\", expected " + kinds);
}

/// Returns the path of the scenario without its ending. Throws InputError if its name could not
/// stand in a file.
fs::path base_of(const std::string& name) {
  fs::path base(name);
  if (base.extension() == ".toml") base.replace_extension();
  constexpr std::string_view kLetters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  const std::string own = base.filename().string();
  if (own.empty() || own.find_first_not_of(kLetters) != std::string::npos)
    throw InputError("the name is \"" + own + "\", expected letters, digits, _ and -");
  return base;
}

std::string with_name(std::string_view text, const std::string& name) {
  constexpr std::string_view kName = "NAME";
  std::string written;
  for (std::size_t at = text.find(kName); at != std::string_view::npos; at = text.find(kName)) {
    written += std::string(text.substr(0, at)) + name;
    text.remove_prefix(at + kName.size());
  }
  return written + std::string(text);
}

fs::path file_of(const TemplateFile& file, const fs::path& base) {
  return base.string() + std::string(file.ending);
}

}  // namespace

int write_new(const Arguments& arguments) {
  const Template& chosen = find_template(arguments.kind);
  const fs::path base = base_of(arguments.scenario);
  std::vector<FileText> files;
  for (const TemplateFile& file : {chosen.mesh, chosen.scenario}) {
    if (file.text.empty()) continue;
    files.push_back({file_of(file, base).string(), with_name(file.text, base.filename().string())});
    if (fs::exists(files.back().file))
      throw InputError("there is a file " + files.back().file + " already, expected another name");
  }
  replace_files(files);
  const std::string scenario = file_of(chosen.scenario, base).string();
  fmt::print(
      "{}: {}\n  run it       spoke run {}\n  look at it   spoke check {} --html model.html\n"
      "  its keys     spoke help KEY\n",
      scenario, chosen.about, scenario, scenario);
  return 0;
}

}  // namespace spoke::cli
