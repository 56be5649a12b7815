// spoke fmu on the command line, and the examples of docs/fmu.md.

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/contains.h"
#include "tests/program/cli/examples.h"
#include "tests/program/cli/program.h"
#include "tests/program/cli/refusal.h"

using spoke::test::contains;
namespace fs = std::filesystem;

TEST_CASE("fmu writes an FMU and says what importers see") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"fmu", shipped("wu_haug_rotor"), "--set", "blade.bodies=2",
                                 "--out", "rotor.fmu", "--output", "hub.speed", "blade1.tip"},
                                folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  for (const char* part : {"Wu & Haug", "drive.speed [rad/s], 0 at the start", "hub.speed [rad/s]",
                           "blade1.tip.y [m]", "0.005 s", "rotor.fmu"}) {
    CAPTURE(part);
    CHECK(contains(ended.out, part));
  }
  CHECK(folder.entries() == 1);
  const std::string first = file_text(folder.path() / "rotor.fmu");
  CHECK(first.starts_with("PK"));
  // Written again it is the same, and takes the old one's place.
  CHECK(run_spoke({"fmu", shipped("wu_haug_rotor"), "--set", "blade.bodies=2", "--out", "rotor.fmu",
                   "--output", "hub.speed", "blade1.tip"},
                  folder)
            .status == 0);
  CHECK(file_text(folder.path() / "rotor.fmu") == first);
}

TEST_CASE("fmu --help names every option, and the kinds of inputs") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"fmu", "--help"}, folder);
  CHECK(ended.status == 0);
  for (const char* part : {"SCENARIO", "--out", "--input", "--output", "--set", "drive.torque",
                           "drive.speed", "load.NAME", "wind.x", ".velocity", ".acceleration",
                           "FMI 3.0", "--fmi 2", "Exit status:", "spoke fmu models/"}) {
    CAPTURE(part);
    CHECK(contains(ended.out, part));
  }
}

TEST_CASE("what cannot become an FMU is refused before anything is written") {
  const WorkFolder folder;
  const std::string rotor = shipped("wu_haug_rotor"), turbine = shipped("nrel_5mw_turbine");
  const auto refused = [&](const std::vector<std::string>& words, const std::string& message) {
    CAPTURE(message);
    check_refused(words, message, folder);
  };
  refused({"fmu", rotor}, "--out is required");
  refused({"fmu", "--out", "a.fmu"}, "SCENARIO is required");
  refused({"fmu", rotor, "--out", "a.zip"}, "--out a.zip: expected a file NAME.fmu");
  refused({"fmu", rotor, "--out", "a"}, "expected a file NAME.fmu");
  refused({"fmu", rotor, "--out", ".fmu"}, "expected a file NAME.fmu");
  refused({"fmu", rotor, "--out", "none/a.fmu"}, "none/a.fmu");
  refused({"fmu", "none.toml", "--out", "a.fmu"}, "none.toml: no such file");
  refused({"fmu", rotor, "--out", "a.fmu", "--set", "blade.length=-8"}, "blade.length");
  refused({"fmu", rotor, "--out", "a.fmu", "--input", "drive.sped"}, "drive.speed");
  refused({"fmu", rotor, "--out", "a.fmu", "--input", "drive.torque"},
          "the input is \"drive.torque\"");
  refused({"fmu", rotor, "--out", "a.fmu", "--input", "load.gust"}, "the input is \"load.gust\"");
  refused({"fmu", rotor, "--out", "a.fmu", "--input", "drive.speed", "drive.speed"}, "twice");
  refused({"fmu", rotor, "--out", "a.fmu", "--input", "blade1.pitch.velocity"},
          "blade1.pitch.velocity");
  refused({"fmu", turbine, "--out", "a.fmu", "--input", "drive.speed"}, "drive.torque");
  refused({"fmu", rotor, "--out", "a.fmu", "--output", "hub.sped"},
          "the output \"hub.sped\" is no sensor, did you mean \"hub.speed\"?");
  refused({"fmu", rotor, "--out", "a.fmu", "--output", "wind"}, "is no sensor");
  refused({"fmu", rotor, "--out", "a.fmu", "--inputs", "drive.speed"}, "--inputs");
  for (const char* version : {"1", "4", "2.5", "two"})
    refused({"fmu", rotor, "--out", "a.fmu", "--fmi", version}, "--fmi");
  refused({"fmu", rotor, "--out", "a.fmu", "--input", "wind.x"}, "the input is \"wind.x\"");
}

TEST_CASE("without the library beside it, fmu says where it belongs") {
  const WorkFolder folder, other;
  const fs::path program = fs::canonical(folder.path()) / "spoke-fmu";
  fs::copy_file(std::string(SPOKE_PROGRAM) + "-fmu", program);
  const Ended ended =
      run_program(program.string(), {shipped("wu_haug_rotor"), "--out", "a.fmu"}, other);
  CHECK(ended.status == 2);
  CHECK(lines_of(ended.err).size() == 1);
  CHECK(contains(ended.err, "the library of FMUs is not there, expected " +
                                (program.parent_path() / "spoke_fmu.so").string()));
  CHECK(other.entries() == 0);
}

TEST_CASE("the examples of docs/fmu.md show what the program prints") {
  const WorkFolder folder;
  fs::create_directory_symlink(SPOKE_MODELS_DIR, folder.path() / "models");
  const auto examples =
      examples_of(file_text(fs::path(SPOKE_MODELS_DIR).parent_path() / "docs" / "fmu.md"));
  CHECK(examples.size() >= 3);
  for (const Example& example : examples) {
    std::string printed;
    for (const std::string& command : example.commands) {
      CAPTURE(command);
      const Ended ended = run_spoke(words_of(command), folder);
      CHECK(ended.status == 0);
      CHECK(ended.err.empty());
      printed += ended.out;
    }
    for (const std::string& line : example.shown) {
      CAPTURE(line);
      CHECK(contains(printed, line));
    }
  }
}
