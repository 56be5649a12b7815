// Signals, full disks and folders that vanish: a clear message, and files valid up to then.

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/program/cli/child.h"

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

using Words = std::vector<std::string>;

// The thread sanitizer puts off signals that arrive while the program waits to write.
#ifdef SPOKE_THREAD_SANITIZER
constexpr bool kPutsOffSignals = true;
#else
constexpr bool kPutsOffSignals = false;
#endif

/// A run with a row for each of 2000 steps a second; what differs. 150 s are for runs that do not
/// come to their end.
Words long_run(const Words& more, const std::string& seconds = "150") {
  Words words = {"run",    shipped("wu_haug_rotor"),
                 "--set",  "integration.step=0.0005",
                 "--set",  "integration.duration=" + seconds,
                 "--set",  "output.interval=0",
                 "--out",  "o",
                 "--quiet"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

double last_time(const fs::path& file) { return std::stod(lines_of(file_text(file)).back()); }

/// Runs until rows are on disk, then sends a signal.
ChildEnded interrupt(int signal, const Words& words, const WorkFolder& folder) {
  Child child(words, folder);
  REQUIRE(wait_until([&] { return size_of(folder.path() / "o" / "sensors.csv") > 0; }));
  child.send(signal);
  return child.wait();
}

void check_complete_rows(const fs::path& file) {
  const std::string text = file_text(file);
  REQUIRE_FALSE(text.empty());
  CHECK(text.back() == '\n');
  const auto rows = lines_of(text);
  const auto commas = [](const std::string& row) {
    return std::count(row.begin(), row.end(), ',');
  };
  CHECK(commas(rows.back()) == commas(rows.front()));
}

/// Whether these are the rows of a run that nobody disturbed.
void check_whole(const fs::path& rows, const std::string& duration) {
  const WorkFolder folder;
  REQUIRE(run_spoke(long_run({"--executor", "serial"}, duration), folder).status == 0);
  CHECK(file_text(rows) == file_text(folder.path() / "o" / "sensors.csv"));
}

}  // namespace

TEST_CASE("SIGINT and SIGTERM complete the step, write what is due and end with 130 and 143") {
  for (const int signal : {SIGINT, SIGTERM})
    for (const Words& executor :
         {Words{"--executor", "serial"},
          Words{"--executor", "flow_graph", "--threads", "2", "--window", "10"}}) {
      const WorkFolder folder;
      const fs::path results = folder.path() / "o";
      const ChildEnded ended = interrupt(signal, long_run(executor), folder);
      CAPTURE(ended.err);
      CHECK(ended.status == (signal == SIGINT ? 130 : 143));
      REQUIRE(lines_of(ended.err).size() == 1);
      const std::string name = signal == SIGINT ? "SIGINT" : "SIGTERM";
      CHECK(ended.err.find("interrupted by " + name + " at t = ") == 0);
      const json summary = json::parse(file_text(results / "summary.json"));
      CHECK(summary["status"] == "interrupted");
      CHECK(summary["message"] == lines_of(ended.err)[0]);
      const auto steps = summary["steps"].get<int>();
      CHECK(steps > 0);
      CHECK(steps < 300000);
      CHECK(lines_of(file_text(results / "sensors.csv")).size() ==
            static_cast<std::size_t>(steps + 2));
      CHECK(last_time(results / "sensors.csv") == steps * summary["step_size_s"].get<double>());
      CHECK_FALSE(fs::exists(results / "checkpoint.spoke"));
    }
}

TEST_CASE("an interrupted run with checkpoints is resumed where it was left") {
  const WorkFolder folder;
  const fs::path rows = folder.path() / "o" / "sensors.csv";
  const ChildEnded ended =
      interrupt(SIGINT, long_run({"--executor", "serial", "--checkpoint-every", "1000"}), folder);
  CHECK(ended.status == 130);
  CHECK(ended.err.find("; go on with --resume o/checkpoint.spoke") != std::string::npos);
  const double left = last_time(rows);
  const std::string duration = std::to_string(static_cast<int>(left) + 2);
  Words words = long_run({"--executor", "serial", "--resume", "o/checkpoint.spoke"}, duration);
  std::erase(words, "--quiet");
  const Ended resumed = run_spoke(words, folder);
  CHECK(resumed.status == 0);
  char text[64];
  std::snprintf(text, sizeof text, "o/checkpoint.spoke at t = %.6g s, step ", left);
  CHECK(resumed.out.find(text) != std::string::npos);
  check_whole(rows, duration);
}

TEST_CASE("a second SIGINT ends at once" * doctest::skip(kPutsOffSignals)) {
  // A pipe in place of sensors.csv that nobody empties: the run waits there for ever.
  const WorkFolder folder;
  fs::create_directory(folder.path() / "o");
  const std::string pipe = (folder.path() / "o" / "sensors.csv").string();
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  Child child(long_run({"--executor", "serial"}), folder);
  CHECK(wait_until([&] {
    int bytes = 0;
    return ioctl(reader, FIONREAD, &bytes) == 0 && bytes > 60'000;
  }));
  child.send(SIGINT);
  sleep_seconds(0.1);
  CHECK(child.is_running());
  child.send(SIGINT);
  const ChildEnded ended = child.wait();
  CHECK(ended.signal == SIGINT);
  close(reader);
}

TEST_CASE("a full disk ends the run with the file and the reason, and rows are complete") {
  const WorkFolder folder;
  Child child(long_run({"--executor", "serial"}), folder, 300'000);
  const ChildEnded ended = child.wait();
  CHECK(ended.status == 2);
  CHECK(ended.err == "o/sensors.csv: cannot be written: File too large\n");
  const fs::path results = folder.path() / "o";
  CHECK(size_of(results / "sensors.csv") > 200'000);
  check_complete_rows(results / "sensors.csv");
  CHECK_FALSE(fs::exists(results / "summary.json"));
}

TEST_CASE("what a full disk ended is resumed from its last checkpoint") {
  const WorkFolder folder;
  Child child(long_run({"--executor", "serial", "--checkpoint-every", "0.001"}), folder, 1'000'000);
  const ChildEnded ended = child.wait();
  CHECK(ended.status == 2);
  CHECK(ended.err == "o/sensors.csv: cannot be written: File too large\n");
  const Ended resumed =
      run_spoke(long_run({"--executor", "serial", "--resume", "o/checkpoint.spoke"}, "5"), folder);
  CHECK(resumed.status == 0);
  check_whole(folder.path() / "o" / "sensors.csv", "5");
}

TEST_CASE(
    "a checkpoint that does not fit on the disk ends the run and leaves nothing half-written") {
  const WorkFolder folder;
  Child child({"run", shipped("wu_haug_rotor"), "--set", "integration.duration=0.1", "--out", "o",
               "--quiet", "--checkpoint-every", "9"},
              folder, 9000);
  const ChildEnded ended = child.wait();
  CHECK(ended.status == 2);
  CHECK(ended.err == "o/checkpoint.spoke: cannot be written: File too large\n");
  CHECK(folder.entries() == 2);
  check_complete_rows(folder.path() / "o" / "sensors.csv");
}

TEST_CASE("what other commands write and does not fit on the disk is told, and nothing is left") {
  const auto ends = [](const Words& words, const std::string& file) {
    const WorkFolder folder;
    Child child(words, folder, 3000);
    const ChildEnded ended = child.wait();
    CHECK(ended.status == 2);
    CHECK(ended.err == file + ": cannot be written: File too large\n");
    CHECK(folder.entries() == 0);
  };
  ends({"trace", shipped("wu_haug_rotor"), "--out", "o"}, "o/trace.json");
  ends({"compare", shipped("simo_vu_quoc_beam"), "--set", "blade.bodies=1", "--executors", "serial",
        "--formulations", "structured", "--repeat", "2", "--out", "o"},
       "o/compare.json");
}

TEST_CASE("text that standard output does not take is told, with status 2") {
  for (const char* words : {"check", "run --set integration.duration=0.1", "check --help"}) {
    CAPTURE(words);
    const WorkFolder folder;
    const std::string place = "'" + folder.path().string() + "'";
    const std::string command = "cd " + place + " && '" SPOKE_PROGRAM "' " + words + " '" +
                                shipped("wu_haug_rotor") + "' >/dev/full 2>err";
    const int status = std::system(command.c_str());
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 2);
    CHECK(file_text(folder.path() / "err") ==
          "standard output: cannot be written: No space left on device\n");
  }
}

TEST_CASE("a folder that vanishes while the run goes on is told") {
  for (const Words& more : {Words{}, Words{"--checkpoint-every", "0.01"}}) {
    const WorkFolder folder;
    Words words = long_run({"--executor", "serial"});
    words.insert(words.end(), more.begin(), more.end());
    Child child(words, folder);
    REQUIRE(wait_until([&] { return size_of(folder.path() / "o" / "sensors.csv") > 0; }));
    CHECK(wait_until([&] {
      std::error_code error;
      fs::remove_all(folder.path() / "o", error);
      return !error && !fs::exists(folder.path() / "o");
    }));
    const ChildEnded ended = child.wait();
    CAPTURE(ended.err);
    CHECK(ended.status == 2);
    CHECK(lines_of(ended.err).size() == 1);
    CHECK(ended.err.find("cannot be written: ") != std::string::npos);
    CHECK(ended.err.starts_with("o/"));
    CHECK_FALSE(fs::exists(folder.path() / "o"));
  }
}

TEST_CASE("a place that cannot be written to is refused before the run") {
  const WorkFolder folder;
  fs::create_directories(folder.path() / "o" / "sensors.csv");
  folder.write("f", "");
  for (const auto& [out, message] :
       {std::pair<std::string, std::string>{"o",
                                            "o/sensors.csv: cannot be written: Is a directory"},
        {"f", "f: cannot be the folder of results: "},
        {"/proc/spoke", "/proc/spoke: cannot be the folder of results: "}}) {
    const Ended ended = run_spoke({"run", shipped("wu_haug_rotor"), "--out", out}, folder);
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    CHECK(lines_of(ended.err).size() == 1);
    CHECK(ended.err.find(message) == 0);
  }
}

TEST_CASE("SIGINT while files are written leaves all of them, and no other") {
  const WorkFolder folder;
  const fs::path results = folder.path() / "o";
  fs::create_directory(results);
  const fs::path pipe = results / "section_forces.csv";  // the second of three files
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  Child child({"static", shipped("wu_haug_rotor"), "--out", "o"}, folder);
  // It waits for somebody who reads the pipe.
  REQUIRE(wait_until([&] { return fs::exists(results / "static.json"); }));
  child.send(SIGINT);
  sleep_seconds(0.2);
  const int reader = open(pipe.c_str(), O_RDONLY);
  REQUIRE(reader >= 0);
  std::array<char, 4096> piece{};
  while (read(reader, piece.data(), piece.size()) > 0) {
  }
  close(reader);
  CHECK(child.wait().signal == SIGINT);
  CHECK(file_text(results / "static.html").ends_with("</html>\n"));
  CHECK(folder.entries() == 4);
}

TEST_CASE("SIGHUP ends a run with its summary, as SIGTERM does") {
  const WorkFolder folder;
  const ChildEnded ended = interrupt(SIGHUP, long_run({"--executor", "serial"}), folder);
  CHECK(ended.status == 128 + SIGHUP);
  CHECK(ended.err.find("interrupted by SIGHUP at t = ") == 0);
  const json summary = json::parse(file_text(folder.path() / "o" / "summary.json"));
  CHECK(summary["status"] == "interrupted");
  CHECK(summary["message"] == lines_of(ended.err)[0]);
  CHECK(lines_of(file_text(folder.path() / "o" / "sensors.csv")).size() ==
        summary["steps"].get<std::size_t>() + 2);
}

TEST_CASE("a signal to what measures leaves none of the folders that it made") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const WorkFolder folder;
    fs::create_directory(folder.path() / "before");
    Child child({"compare", shipped("wu_haug_rotor"), "--threads", "1", "--out", "before/o/p/q"},
                folder);
    REQUIRE(wait_until([&] { return fs::exists(folder.path() / "before/o/p/q"); }));
    child.send(signal);
    CHECK(child.wait().signal == signal);
    CHECK(fs::exists(folder.path() / "before"));
    CHECK_FALSE(fs::exists(folder.path() / "before/o"));
  }
}

TEST_CASE("who waits at a pipe is told") {
  const WorkFolder folder;
  const std::string pipe = (folder.path() / "s.toml").string();
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  // fmu needs the text twice, and reads it once.
  for (const Words& words : {Words{"check", "s.toml"}, Words{"fmu", "s.toml", "--out", "r.fmu"}}) {
#ifndef SPOKE_HAS_FMU
    if (words[0] == "fmu") continue;
#endif
    Child child(words, folder);
    int writer = -1;
    REQUIRE(wait_until([&] {
      writer = open(pipe.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
      return writer >= 0;
    }));
    const std::string text = file_text(shipped("wu_haug_rotor"));
    REQUIRE(write(writer, text.data(), text.size()) == static_cast<ssize_t>(text.size()));
    close(writer);
    const ChildEnded ended = child.wait();
    CHECK(ended.status == 0);
    CHECK(ended.err == "s.toml: is a pipe, waiting for what is written to it\n");
  }
}
