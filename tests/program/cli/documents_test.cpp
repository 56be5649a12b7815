// The commands of the README and of the tutorials do what they say: each block is given to a shell,
// with the files that the document has a reader write.

#include <doctest/doctest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/contains.h"
#include "tests/program/cli/program.h"

namespace fs = std::filesystem;
using spoke::test::contains;

namespace {

/// A block of a document.
struct Block {
  std::string kind;    ///< "sh", "toml" and so on
  std::string before;  ///< the last line before it that is not empty
  std::string text;
};

std::vector<Block> blocks_of(const std::string& document) {
  std::vector<Block> blocks;
  std::string before;
  bool is_open = false;
  for (const std::string& line : lines_of(document)) {
    if (line.starts_with("```")) {
      is_open = !is_open;
      if (is_open) blocks.push_back({line.substr(3), before, {}});
      before.clear();
    } else if (is_open) {
      blocks.back().text += line + '\n';
    } else if (!line.empty()) {
      before = line;
    }
  }
  return blocks;
}

/// Returns the name of the file that a block is, which the line before it ends in: "`study.toml`:";
/// empty: it is none.
std::string file_of(const Block& block) {
  if (!block.before.ends_with("`:")) return {};
  const std::size_t end = block.before.size() - 2, begin = block.before.rfind('`', end - 1);
  return begin == std::string::npos ? "" : block.before.substr(begin + 1, end - begin - 1);
}

/// What stands for `spoke` and `./spoke` in a shell. The tests are not run from a test, and of a
/// load set of an hour the list.
std::string shell_function() {
  return "spoke() {\n  case \"$*\" in\n    test*) ;;\n    *load_cases*) \"" SPOKE_PROGRAM
         "\" \"$@\" --list ;;\n    *) \"" SPOKE_PROGRAM "\" \"$@\" ;;\n  esac\n}\nset -e\n";
}

std::string without_folder(std::string text) {
  for (std::size_t at = 0; (at = text.find("./spoke ", at)) != std::string::npos;)
    text.erase(at, 2);
  return text;
}

/// Runs all commands of a document in a folder where the shipped models are; returns their number.
int run_commands(const fs::path& document) {
  const WorkFolder folder;
  fs::create_directory_symlink(SPOKE_MODELS_DIR, folder.path() / "models");
  int count = 0;
  for (const Block& block : blocks_of(file_text(document))) {
    if (const std::string file = file_of(block); !file.empty()) folder.write(file, block.text);
    if (block.kind != "sh" || !contains(block.text, "spoke ")) continue;
    const fs::path script =
        folder.write("script.sh", shell_function() + without_folder(block.text));
    const Ended ended = run_program("/bin/bash", {script.string()}, folder);
    CAPTURE(block.text);
    CAPTURE(ended.err);
    CHECK(ended.status == 0);
    CHECK_FALSE(contains(ended.err, "warning"));
    ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("the commands of the README and of the tutorials do what they say") {
  const fs::path root = fs::path(SPOKE_MODELS_DIR).parent_path();
  CHECK(run_commands(root / "README.md") >= 1);
  for (const char* name : {"rotor", "mechanism", "turbine"}) {
    CAPTURE(name);
    CHECK(run_commands(root / "docs" / (std::string("tutorial_") + name + ".md")) >= 5);
  }
}
