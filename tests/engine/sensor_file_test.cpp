#include "engine/sensor_file.h"

#include <doctest/doctest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/file_text.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace fs = std::filesystem;
using namespace spoke;
using spoke::test::file_text;
using spoke::test::message_of;
using spoke::test::TemporaryFolder;

namespace {

void write_rows(int first, int last, SensorFile& file) {
  for (int n = first; n < last; ++n) file.write_row(n, std::vector<double>{0.1 * n});
}

/// Writes a file of rows 0 to 9, marked behind row 4.
SensorFileMark write_marked(const fs::path& path) {
  SensorFile file(path, {"a"});
  write_rows(0, 5, file);
  const SensorFileMark mark = file.sync();
  write_rows(5, 10, file);
  file.close();
  return mark;
}

}  // namespace

TEST_CASE("a file goes on behind a mark, in its place and as a copy, without gap or duplicate") {
  const TemporaryFolder folder;
  const SensorFileMark mark = write_marked(folder / "a");
  const std::string whole = file_text(folder / "a");
  for (const char* name : {"a", "b"}) {
    SensorFile file(folder / name, mark, folder / "a");
    CHECK(file_text(folder / name) == whole.substr(0, mark.bytes));
    write_rows(5, 7, file);
    const SensorFileMark further = file.sync();
    write_rows(7, 10, file);
    file.close();
    CHECK(file_text(folder / name) == whole);
    CHECK(further.bytes > mark.bytes);
    SensorFile again(folder / name, further, folder / name);
    again.close();
    CHECK(file_text(folder / name) == whole.substr(0, further.bytes));
    write_marked(folder / "a");
  }
}

TEST_CASE("rows are read back to the last bit") {
  const TemporaryFolder folder;
  SensorFile file(folder / "a", {"one", "two"});
  const std::vector<double> numbers{0.0, 1.0 / 3.0, -1e-300, 0.1, 6.02e23, -0.0};
  for (std::size_t k = 0; k < numbers.size(); k += 3)
    file.write_row(numbers[k], std::span(numbers).subspan(k + 1, 2));
  file.close();
  std::vector<double> read;
  read_rows(folder / "a", [&](double t, std::span<const double> values) {
    read.push_back(t);
    read.insert(read.end(), values.begin(), values.end());
  });
  CHECK(read == numbers);
  CHECK(message_of([&] { read_rows(folder / "none", {}); }) ==
        (folder / "none").string() + ": cannot be read");
}

TEST_CASE("a file that is not the marked one is refused and left alone") {
  const TemporaryFolder folder;
  const fs::path path = folder / "a";
  const SensorFileMark mark = write_marked(path);
  std::string text = file_text(path);
  const auto refusal = [&] { return message_of([&] { SensorFile(path, mark, path); }); };
  text[mark.bytes / 2] ^= 1;
  std::ofstream(path) << text;
  CHECK(refusal() == path.string() + ": cannot be continued: its first " +
                         std::to_string(mark.bytes) +
                         " bytes are not those that stood there when the checkpoint was made");
  CHECK(file_text(path) == text);
  std::ofstream(path) << text.substr(0, 10);
  CHECK(refusal() == path.string() +
                         ": cannot be continued: it has 10 bytes, the checkpoint was made behind " +
                         std::to_string(mark.bytes));
  fs::remove(path);
  CHECK(refusal() == path.string() + ": cannot be continued: No such file or directory");
  CHECK_FALSE(fs::exists(path));
}

TEST_CASE("where the disk is full, the file ends with a complete row") {
  const TemporaryFolder folder;
  const fs::path path = folder / "a";
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  SensorFile file(path, {"a"});
  const rlimit small{100'000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = message_of([&] {
    write_rows(0, 100'000, file);
    file.close();
  });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  CHECK(message == path.string() + ": cannot be written: File too large");
  const std::string text = file_text(path);
  CHECK(text.size() > 99'000);
  CHECK(text.size() <= 100'000);
  CHECK(text.back() == '\n');
}

TEST_CASE("a file that was removed while it was written is an error") {
  const TemporaryFolder folder;
  SensorFile file(folder / "a", {"a"});
  write_rows(0, 3, file);
  file.sync();
  fs::remove(folder / "a");
  const std::string message =
      (folder / "a").string() + ": cannot be written: it was removed meanwhile";
  CHECK(message_of([&] { file.sync(); }) == message);
  CHECK(message_of([&] { file.close(); }) == message);
}
