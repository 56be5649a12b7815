#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "models/error.h"
#include "models/scenario.h"
#include "tests/models/reader/check_message.h"

using namespace spoke;
using test::check_message;

namespace {

std::string error_of_file(const std::filesystem::path& file) {
  try {
    read_scenario(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// A file that is removed at the end.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& content)
      : path_(std::filesystem::temp_directory_path() /
              ("spoke_models_tests_" + std::to_string(getpid()) + '_' + name)) {
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

TEST_CASE("files that are no scenarios are refused") {
  const std::string expected = ", expected a scenario file (TOML)";
  check_message(error_of_file("no/such/file.toml"), "no/such/file.toml: no such file" + expected);
  check_message(error_of_file("/"), "/: is a directory" + expected);
  check_message(error_of_file("/dev/null"), "/dev/null: is empty" + expected);
  check_message(error_of_file("/dev/zero"), "/dev/zero: is larger than 16 MiB" + expected);
  check_message(error_of_file("/proc/self/mem"), "/proc/self/mem: cannot be read" + expected);
  const TemporaryFile empty("empty.toml", "");
  check_message(error_of_file(empty.path()), empty.path().string() + ": is empty" + expected);
  check_message(error_of_file(empty.path() / "below"),
                (empty.path() / "below").string() + ": no such file" + expected);
  const TemporaryFile binary("binary.toml", std::string("\x7F"
                                                        "ELF\0\0",
                                                        6));
  check_message(error_of_file(binary.path()),
                binary.path().string() +
                    ": has a zero byte at 4, expected a text file (TOML in "
                    "UTF-8)");
}

TEST_CASE("a file that may not be read is refused") {
  if (geteuid() == 0) return;  // root may read everything
  const TemporaryFile file("locked.toml", "title = \"test\"\n");
  std::filesystem::permissions(file.path(), std::filesystem::perms::none);
  check_message(error_of_file(file.path()), file.path().string() +
                                                ": Permission denied, expected a scenario file "
                                                "(TOML)");
}
