#include <doctest/doctest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/program/cli/program.h"

namespace fs = std::filesystem;

namespace {

/// The exit status of a line of bash in the folder, in which $spoke is the program.
int status_of(const std::string& line, const WorkFolder& folder) {
  folder.write("line.sh", "spoke='" SPOKE_PROGRAM "'\nrotor='" + shipped("wu_haug_rotor") +
                              "'\ncd '" + folder.path().string() + "'\n" + line + '\n');
  const int status = std::system(("bash '" + (folder.path() / "line.sh").string() + '\'').c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

const std::string kRun = "$spoke run $rotor --set integration.duration=0.5 --out ";

}  // namespace

TEST_CASE("streams that are closed or full change neither the files of a run nor its status") {
  const WorkFolder folder;
  REQUIRE(status_of(kRun + "whole >out", folder) == 0);
  const std::string rows = file_text(folder.path() / "whole" / "sensors.csv");
  REQUIRE_FALSE(rows.empty());
  for (const std::string streams :
       {"1>&-", "2>&-", "1>&- 2>&-", "0<&- 1>&- 2>&-", "2>/dev/full >out", "1>&- 2>/dev/full"})
    for (const std::string options : {"", " -vv", " --set limits.deflection=0.001"}) {
      CAPTURE(streams);
      CAPTURE(options);
      fs::remove_all(folder.path() / "o");
      CHECK(status_of(kRun + "o" + options + ' ' + streams, folder) == 0);
      CHECK(file_text(folder.path() / "o" / "sensors.csv") == rows);
      CHECK(fs::exists(folder.path() / "o" / "report.html"));
    }
}

TEST_CASE("a reader that goes away does not end the run, whose status tells of it") {
  const WorkFolder folder;
  CHECK(status_of("{ " + kRun +
                      "o --trace t -vv 2>&3; echo $? >status; } 3>&1 >&2 | true; "
                      "[ $(cat status) = 0 ]",
                  folder) == 0);
  CHECK(status_of("{ sleep 0.3; " + kRun +
                      "o2 2>err; echo $? >status; } | true; "
                      "[ $(cat status) = 2 ]",
                  folder) == 0);
  CHECK(file_text(folder.path() / "err") == "standard output: cannot be written: Broken pipe\n");
  CHECK(file_text(folder.path() / "o" / "sensors.csv") ==
        file_text(folder.path() / "o2" / "sensors.csv"));
  CHECK(fs::exists(folder.path() / "o2" / "report.html"));
  CHECK(fs::exists(folder.path() / "t" / "trace.html"));
}

TEST_CASE("a full standard output leaves all files of a run and its trace") {
  const WorkFolder folder;
  CHECK(status_of(kRun + "o --trace t >/dev/full 2>err", folder) == 2);
  CHECK(file_text(folder.path() / "err") ==
        "standard output: cannot be written: No space left on device\n");
  for (const char* file : {"o/sensors.csv", "o/summary.json", "o/report.html", "t/trace.html"})
    CHECK(fs::exists(folder.path() / file));
}

TEST_CASE("what only prints ends with status 2 if nobody can read it") {
  const WorkFolder folder;
  for (const std::string words : {"check $rotor", "--help", "--version", "run --help"}) {
    CAPTURE(words);
    CHECK(status_of("$spoke " + words + " 1>&- 2>err", folder) == 2);
    CHECK(file_text(folder.path() / "err") == "standard output: cannot be written: it is closed\n");
    CHECK(status_of("$spoke " + words + " >/dev/full 2>err", folder) == 2);
    CHECK(file_text(folder.path() / "err") ==
          "standard output: cannot be written: No space left on device\n");
    CHECK(status_of("$spoke " + words + " >out 2>/dev/full", folder) == 0);
  }
}

TEST_CASE("errors keep their status where they cannot be told") {
  const WorkFolder folder;
  for (const std::string streams : {"2>&-", "2>/dev/full", "1>&- 2>&-"}) {
    CAPTURE(streams);
    CHECK(status_of("$spoke run none.toml " + streams, folder) == 2);
    CHECK(status_of(kRun +
                        "o --set blade.bodies=1 --set blade.geometric_stiffening=false --set "
                        "integration.duration=12 --quiet " +
                        streams,
                    folder) == 3);
  }
}
