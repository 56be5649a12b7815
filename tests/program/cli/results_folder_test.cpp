#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/program/cli/child.h"
#include "tests/program/cli/program.h"
#include "tests/program/cli/refusal.h"

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

/// A run that would take minutes.
const Words kLongRun = {"run",     shipped("wu_haug_rotor"),
                        "--set",   "integration.step=0.0005",
                        "--set",   "integration.duration=150",
                        "--set",   "output.interval=0",
                        "--quiet", "--out",
                        "o"};

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

}  // namespace

TEST_CASE("a folder that a run writes to is refused to others, until that ends or is killed") {
  const WorkFolder folder;
  const fs::path rows = folder.path() / "o" / "sensors.csv";
  const std::string message = "o: cannot be the folder of results: another run of spoke is writing";
  const Words short_run = {
      "run", shipped("wu_haug_rotor"), "--set", "integration.duration=0.1", "--quiet", "--out"};
  Child child(with(kLongRun, {"--trace", "t"}), folder);
  REQUIRE(wait_until([&] { return size_of(rows) > 0; }));
  check_refused(with(short_run, {"o"}), message, folder);
  check_refused(with(short_run, {"o/../o/"}), "o/: cannot be the folder", folder);
  check_refused(with(short_run, {"p", "--trace", "o"}), message, folder);
  check_refused(with(short_run, {"t"}), "t: cannot be the folder of results: another", folder);
  check_refused(with(kLongRun, {"--resume", "o/checkpoint.spoke"}), message, folder);
  for (const std::string command : {"trace", "compare"})
    check_refused({command, shipped("wu_haug_rotor"), "--out", "o"}, message, folder);
  check_refused({"reproduce", "--out", "o"}, message, folder);
  CHECK(child.is_running());
  child.send(SIGKILL);
  CHECK(child.wait().signal == SIGKILL);
  CHECK(run_spoke(with(short_run, {"o"}), folder).status == 0);
  CHECK(run_spoke(with(short_run, {"p"}), folder).status == 0);
  CHECK(file_text(rows) == file_text(folder.path() / "p" / "sensors.csv"));
}

TEST_CASE("two resumes of one checkpoint do not share a folder") {
  const WorkFolder folder;
  {
    Child child(with(kLongRun, {"--checkpoint-every", "0.001"}), folder);
    REQUIRE(wait_until([&] { return size_of(folder.path() / "o" / "checkpoint.spoke") > 0; }));
    child.send(SIGKILL);
    child.wait();
  }
  const Words resume = with(kLongRun, {"--resume", "o/checkpoint.spoke"});
  const auto size = size_of(folder.path() / "o" / "sensors.csv");
  Child first(resume, folder);
  REQUIRE(
      wait_until([&] { return size_of(folder.path() / "o" / "sensors.csv") > size + 200'000; }));
  check_refused(resume, "another run of spoke is writing to it", folder);
  CHECK(first.is_running());
}

TEST_CASE("folders that were made for nothing are removed again") {
  const WorkFolder folder;
  const fs::path empty = folder.path() / "empty";
  fs::create_directory(empty);
  const auto refused = [&](const std::string& out) {
    check_refused({"run", shipped("wu_haug_rotor"), "--resume", "none.spoke", "--out", out},
                  "none.spoke: ", folder);
  };
  for (const char* out : {"a", "a/b/c", "a/b/c/", "./a/../b", "empty/a/b", "empty"}) refused(out);
  CHECK(fs::exists(empty));
}

TEST_CASE("a trace may go to the folder of the results") {
  const WorkFolder folder;
  const auto run = [&](const std::string& trace) {
    return run_spoke({"run", shipped("wu_haug_rotor"), "--set", "integration.duration=0.1",
                      "--quiet", "--out", "o", "--trace", trace},
                     folder)
        .status;
  };
  CHECK(run("o") == 0);
  CHECK(fs::exists(folder.path() / "o" / "trace.html"));
  CHECK(run("./o/") == 0);
  CHECK(run("o/t") == 0);
}

TEST_CASE("a folder in the place of a file is refused before anything is measured or written") {
  const WorkFolder folder;
  const std::string rotor = shipped("wu_haug_rotor");
  const auto refused = [&](const Words& words, const std::string& file) {
    fs::create_directories(folder.path() / "o" / file);
    check_refused(with(words, {"--out", "o"}), "o/" + file + ": cannot be written: Is a directory",
                  folder);
    fs::remove_all(folder.path() / "o");
  };
  refused({"static", rotor}, "static.html");
  refused({"modes", rotor}, "modes.csv");
  refused({"campbell", rotor, "--speeds", "0:1:1"}, "campbell.html");
  refused({"linearize", rotor}, "linear.json");
  refused({"compare", rotor}, "compare.html");
  refused({"trace", rotor}, "graph.dot");
  refused({"run", rotor, "--trace", "o"}, "graph.dot");
  refused({"reproduce"}, "reproduce.json");
}
