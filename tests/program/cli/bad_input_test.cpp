#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/program/cli/refusal.h"

namespace fs = std::filesystem;

TEST_CASE("a bad command line is refused in one line and nothing is written") {
  const std::string scenario = shipped("wu_haug_rotor");
  check_refused(
      {},
      "spoke: no command, expected run, check, reduce, static, modes, campbell, "
      "critical, performance, linearize, wind, schema, new, help, doctor, study, import, export, "
      "fmu, verify, "
      "compare, trace or reproduce (see spoke --help)");
  check_refused({"rnu", scenario},
                "spoke: unknown command \"rnu\", expected run, check, reduce, static, modes, "
                "campbell, critical, performance, linearize, wind, schema, new, help, doctor, "
                "study, import, export, fmu, verify, "
                "compare, trace or reproduce");
  check_refused({"--quiet"}, "spoke: unknown command \"--quiet\"");
  check_refused({""}, "spoke: unknown command \"\"");
  check_refused({"run"}, "spoke run: SCENARIO is required (see spoke run --help)");
  check_refused({"check"}, "spoke check: SCENARIO is required (see spoke check --help)");
  check_refused({"run", scenario, "--frmulation", "augmented"},
                "spoke run: unexpected argument --frmulation");
  check_refused({"run", scenario, "other.toml"}, "spoke run: unexpected argument other.toml");
  check_refused({"check", scenario, "--out", "x"}, "spoke check: unexpected argument --out");
  check_refused({"run", scenario, "--formulation", "dense"},
                "--formulation: dense not in {structured,subsystem,augmented}");
  check_refused({"run", scenario, "--integrator", "euler"},
                "--integrator: euler not in {generalized_alpha,rk4}");
  check_refused(
      {"run", scenario, "--executor", "openmp"},
      "--executor: no executor is named \"openmp\"; known here: auto, flow_graph, serial");
  check_refused({"run", scenario, "--executor", "serial", "--threads", "3x2"},
                "--threads: serial has one layer of threads, expected a number, got 3x2");
  check_refused({"run", scenario, "--threads", "3x4"},
                "--threads: auto has one layer of threads, expected a number, got 3x4");
  for (const std::string threads :
       {"two", "0", "-1", "100000", "3x", "x3", "3x0", "3x2x1", "64x64"})
    check_refused({"run", scenario, "--threads", threads},
                  "--threads: expected a number from 1 to 1024, or two as in 3x2, got " + threads);
  for (const std::string window : {"0", "-1", "1001", "ten", "2.5", "99999999999"})
    check_refused({"run", scenario, "--window", window},
                  "--window: Value " + window + " not in range");
  for (const std::string threads : {"0", "x", "1,,2", "1,", "", "5000", "3x2"})
    check_refused({"trace", scenario, "--more-threads", threads},
                  "--more-threads: expected numbers from 1 to 1024, separated by commas, got \"");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"predict"}, {"predict", scenario, "--threads", "1,2"}})
    check_refused(words, "spoke predict: is the section \"More threads\" of spoke trace now");
  check_refused({"run", scenario, "--window"}, "--window: 1 required STEPS");
  check_refused({"run", scenario, "--out"}, "--out: 1 required DIR missing");
  check_refused({"run", scenario, "--set"}, "--set: 1 required KEY=VALUE missing");
}

TEST_CASE("an empty name of a folder or file is refused, as of a variable that is not set") {
  const std::string scenario = shipped("wu_haug_rotor");
  const std::string out = "--out: expected the name of a folder, got an empty one (see spoke ";
  for (const std::string command : {"run", "compare", "trace"}) {
    check_refused({command, scenario, "--out", ""}, out + command + " --help)");
    check_refused({command, scenario, "--out="}, "spoke " + command + ": ");
  }
  check_refused({"reproduce", "--out", ""}, out + "reproduce --help)");
  check_refused({"run", scenario, "--trace", ""},
                "spoke run: --trace: expected the name of a folder, got an empty one");
  check_refused({"run", scenario, "--resume", ""},
                "spoke run: --resume: expected the name of a file, got an empty one");
}

TEST_CASE("a bad scenario is refused with its place and nothing is written") {
  const WorkFolder folder;
  const std::string file = folder.write("bad.toml", "[hub]\nradius = -1\n").string();
  for (const std::string command : {"run", "check"}) {
    check_refused({command, file},
                  file + ":2:10: hub.radius: is -1, expected a number of 0 or more (m)", folder);
    check_refused({command, "none.toml"}, "none.toml: no such file", folder);
    check_refused({command, folder.path().string()}, ": is a directory", folder);
    check_refused({command, folder.write("empty.toml", "").string()}, "empty.toml: is empty",
                  folder);
    check_refused({command, folder.write("binary.toml", std::string(9, '\0')).string()},
                  "binary.toml: has a zero byte at 0", folder);
    check_refused({command, folder.write("text.toml", "once upon a time\n").string()},
                  "text.toml:1:6: not TOML: ", folder);
  }
}

TEST_CASE("a bad override is refused and nothing is written") {
  const std::string scenario = shipped("wu_haug_rotor");
  check_refused({"run", scenario, "--set", "blade.bodies=-1"},
                "--set blade.bodies=-1: blade.bodies: is -1, expected a whole number from 1 to");
  check_refused({"run", scenario, "--set", "blade.bodies"}, "--set blade.bodies: has no '='");
  check_refused({"run", scenario, "--set", "=3"}, "--set =3: the key is \"\"");
  check_refused({"run", scenario, "--set", "{}"}, "--set {}: has no '='");
  check_refused({"run", scenario, "--set", "blade.elemnts=3"},
                "blade.elemnts: unknown key, did you mean \"elements\"?");
  check_refused({"run", scenario, "--set", "integration.step=21"},
                "the step is 21 s, expected at most the duration, 20 s");
  check_refused({"run", scenario, "--set", "integration.step=nan"}, "is nan, expected a finite");
  check_refused({"run", scenario, "--set", "title=42"}, "title: is 42, expected text in quotes");
}

TEST_CASE("a model that exhausts memory is refused before anything is written") {
  const std::string scenario = shipped("wu_haug_rotor");
  const std::vector<std::string> large = {"--set", "blade.count=1000", "--set",
                                          "blade.bodies=1000"};
  const auto refused = [&](std::vector<std::string> arguments, const std::string& formulation) {
    arguments.insert(arguments.end(), large.begin(), large.end());
    check_refused(arguments, scenario + ": the model in the formulation " + formulation + " needs");
    check_refused(arguments, " GB of memory, expected at most ");
  };
  refused({"run", scenario, "--formulation", "augmented"}, "augmented");
  refused({"run", scenario, "--formulation", "subsystem", "--set", "blade.elements=20"},
          "subsystem");
}

TEST_CASE("output that cannot be written is refused in one line") {
  const std::string scenario = shipped("wu_haug_rotor");
  const WorkFolder folder;
  const std::string file = folder.write("file", "in the way").string();
  const std::vector<std::string> run = {"run",   scenario,   "--set", "integration.duration=0.1",
                                        "--out", "to be set"};
  const auto refused = [&](const std::string& out, const std::string& message) {
    std::vector<std::string> arguments = run;
    arguments.back() = out;
    check_refused(arguments, message, folder);
  };
  refused(file, "file: cannot be the folder of results: ");
  refused(file + "/below", "file/below: cannot be the folder of results: ");
  refused("/proc/spoke", "/proc/spoke: cannot be the folder of results: ");
  if (geteuid() != 0) {  // root may write everywhere
    fs::create_directory(folder.path() / "locked");
    fs::permissions(folder.path() / "locked", fs::perms::owner_read | fs::perms::owner_exec);
    refused("locked", "locked: cannot be the folder of results: ");
  }
  fs::create_directories(folder.path() / "taken" / "sensors.csv");
  refused("taken", "taken/sensors.csv: cannot be written: Is a directory");
}

TEST_CASE("a full disk is told in one line") {
  const WorkFolder folder;
  fs::create_directory(folder.path() / "out");
  fs::create_symlink("/dev/full", folder.path() / "out" / "sensors.csv");
  const Ended ended = run_spoke({"run", shipped("wu_haug_rotor"), "--quiet", "--out", "out",
                                 "--set", "integration.duration=1"},
                                folder);
  CHECK(ended.status == 2);
  CHECK(ended.err == "out/sensors.csv: cannot be written: No space left on device\n");
  CHECK_FALSE(fs::exists(folder.path() / "out" / "summary.json"));
}

TEST_CASE("an unknown key is told with the known ones, each once") {
  // A body has keys of rigid ones, beams and solids, which have some in common.
  const Ended ended = run_spoke(
      {"check", shipped("tree_of_bodies"), "--set", "subsystem.1.body.1.qqqqqqqq=1"}, WorkFolder());
  CHECK(ended.status == 2);
  std::vector<std::string> keys;
  const std::string start = "unknown key, expected ";
  REQUIRE(ended.err.find(start) != std::string::npos);
  std::size_t quote = ended.err.find('"', ended.err.find(start));
  while (quote != std::string::npos) {
    const std::size_t end = ended.err.find('"', quote + 1);
    keys.push_back(ended.err.substr(quote + 1, end - quote - 1));
    quote = ended.err.find('"', end + 1);
  }
  std::sort(keys.begin(), keys.end());
  CHECK(keys.size() > 20);
  CHECK(std::adjacent_find(keys.begin(), keys.end()) == keys.end());
  CHECK(std::find(keys.begin(), keys.end(), "geometric_stiffening") != keys.end());
}
