#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/program/cli/program.h"

namespace {

void check_contains(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    CAPTURE(part);
    CHECK(text.find(part) != std::string::npos);
  }
}

}  // namespace

TEST_CASE("--version prints name and version") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"--version"}, folder);
  CHECK(ended.status == 0);
  CHECK(ended.out.starts_with("spoke "));
  CHECK(lines_of(ended.out).size() == 1);
  CHECK(ended.err.empty());
}

TEST_CASE("--help names commands and exit statuses and examples") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"--help"}, folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  check_contains(ended.out, {"run", "check", "reduce", "compare", "trace", "reproduce", "--version",
                             "Exit status:", "spoke run models/"});
}

TEST_CASE("reduce --help names every option, and where results are kept") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"reduce", "--help"}, folder);
  CHECK(ended.status == 0);
  check_contains(ended.out, {"SCENARIO", "--set", "--force", "-v", "$SPOKE_CACHE", "XDG_CACHE_HOME",
                             "SPOKE_CACHE=none", "spoke reduce models/", "Exit status:"});
}

TEST_CASE("run --help names every option and what is written") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"run", "--help"}, folder);
  CHECK(ended.status == 0);
  check_contains(ended.out, {"SCENARIO",
                             "--out",
                             "--set",
                             "--formulation",
                             "structured,subsystem,augmented",
                             "--integrator",
                             "generalized_alpha,rk4",
                             "--executor",
                             "flow_graph,serial",
                             "--threads",
                             "--window",
                             "--checkpoint-every",
                             "--resume",
                             "--statistics-from",
                             "--no-report",
                             "--vtk",
                             "--trace",
                             "--quiet",
                             "-v",
                             "sensors.csv",
                             "summary.json",
                             "report.html",
                             "checkpoint.spoke",
                             "SIGINT",
                             "Exit status:",
                             "Examples:"});
  CHECK(folder.entries() == 0);
}

TEST_CASE("trace --help names every option and what is written") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"trace", "--help"}, folder);
  CHECK(ended.status == 0);
  check_contains(ended.out,
                 {"SCENARIO", "--out", "--set", "--steps", "--from", "--buffer", "--formulation",
                  "--integrator", "--executor", "--threads", "--window", "-v", "trace.json",
                  "graph.dot", "trace.html", "Exit status:", "Example:"});
  CHECK(folder.entries() == 0);
}

TEST_CASE("check --help names its options and output") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"check", "--help"}, folder);
  CHECK(ended.status == 0);
  check_contains(ended.out, {"SCENARIO", "--html", "--set", "-v", "natural frequency", "rk4",
                             "Exit status:", "Example:"});
}

TEST_CASE("commands that write at their end promise no results of what was ended") {
  const WorkFolder folder;
  for (const char* command : {"compare", "reproduce"}) {
    CAPTURE(command);
    const std::string help = run_spoke({command, "--help"}, folder).out;
    check_contains(help, {"Exit status:", "the simulation diverged; nothing is written"});
    CHECK(help.find("results so far") == std::string::npos);
  }
}

TEST_CASE("no line of help is wider than 100 columns") {
  const WorkFolder folder;
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--help"},
                                                    {"run", "--help"},
                                                    {"check", "--help"},
                                                    {"compare", "--help"},
                                                    {"trace", "--help"},
                                                    {"reproduce", "--help"}}) {
    for (const std::string& line : lines_of(run_spoke(arguments, folder).out)) {
      CAPTURE(line);
      CHECK(line.size() <= 100);
    }
  }
}
