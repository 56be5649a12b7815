#include "engine/output_file.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <string>

#include "tests/file_text.h"
#include "tests/temporary_folder.h"

namespace fs = std::filesystem;
using namespace spoke;
using spoke::test::file_text;
using spoke::test::TemporaryFolder;

TEST_CASE("a file is replaced as a whole or stays as it is") {
  const TemporaryFolder folder;
  const fs::path file = folder / "a";
  replace_file(file, "old");
  {
    ReplacedFile given_up(file);
    given_up.append("new");
    CHECK(file_text(file) == "old");
  }
  CHECK(file_text(file) == "old");
  CHECK_FALSE(fs::exists(folder / "a.tmp"));
  replace_file(file, "new");
  CHECK(file_text(file) == "new");
}

TEST_CASE("a pipe keeps its place and is written to") {
  const TemporaryFolder folder;
  const fs::path pipe = folder / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  REQUIRE(reader >= 0);
  replace_file(pipe, "text");
  std::array<char, 8> read_back{};
  CHECK(read(reader, read_back.data(), read_back.size()) == 4);
  CHECK(std::string(read_back.data()) == "text");
  close(reader);
  CHECK(fs::is_fifo(pipe));
  CHECK_FALSE(fs::exists(folder / "pipe.tmp"));
}

namespace {

extern "C" void clean_up_and_end(int signal) {
  remove_unfinished_files();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

TEST_CASE("a file that has not taken its place is gone when a signal ends the process") {
  const TemporaryFolder folder;
  const fs::path file = folder / "a", other = folder / "b";
  replace_file(file, "old");
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    std::signal(SIGTERM, clean_up_and_end);
    replace_file(other, "done");
    ReplacedFile replaced(file), third(folder / "c");
    replaced.append("half of the ne");
    std::raise(SIGTERM);
    _exit(1);
  }
  int how = 0;
  REQUIRE(waitpid(child, &how, 0) == child);
  CHECK((WIFSIGNALED(how) && WTERMSIG(how) == SIGTERM));
  CHECK(file_text(file) == "old");
  CHECK(file_text(other) == "done");
  CHECK_FALSE(fs::exists(folder / "a.tmp"));
  CHECK_FALSE(fs::exists(folder / "c.tmp"));
}
