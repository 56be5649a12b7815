#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/approx.h"
#include "tests/program/cli/program.h"
#include "tests/program/cli/refusal.h"

namespace fs = std::filesystem;
using nlohmann::json;
using spoke::testing::approx;

namespace {

/// A comparison of seconds.
std::vector<std::string> quick(const std::vector<std::string>& more,
                               const std::string& scenario = shipped("simo_vu_quoc_beam")) {
  std::vector<std::string> arguments{
      "compare",           scenario,    "--set", "blade.bodies=1", "--executors",
      "flow_graph,serial", "--threads", "1,2",   "--repeat",       "2"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// Whether the program knows executors on OpenMP: its help lists them.
bool has_openmp() {
  const WorkFolder folder;
  return run_spoke({"compare", "--help"}, folder).out.find("openmp_levels") != std::string::npos;
}

}  // namespace

TEST_CASE("compare measures every configuration and all end in the same bits") {
  const WorkFolder folder;
  // Steps that are long beside what an executor adds: on a busy machine, too, none is too slow to
  // take part in all rounds.
  const Ended ended = run_spoke(quick({"--set", "blade.bodies=8"}, shipped("paper_rotor")), folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  for (const char* part : {"structured: ", "subsystem: ", "flow_graph 2", "times serial's speed",
                           "same bits as serial", "processor", "compare.html"}) {
    CAPTURE(part);
    CHECK(ended.out.find(part) != std::string::npos);
  }
  const fs::path results = folder.path() / "results" / "paper_rotor" / "compare";
  const json all = json::parse(file_text(results / "compare.json"));
  CHECK(all["rounds"] == 2);
  CHECK(all["scenario"]["blades"][0]["bodies"] == 8);
  REQUIRE(all["configurations"].size() == 6);
  for (const json& configuration : all["configurations"]) {
    CAPTURE(configuration["name"].get<std::string>());
    CHECK(configuration["status"] == "measured");
    CHECK(configuration["hash_equal"] == true);
    CHECK(configuration["step_times_s"].size() == 2);
    // A hash after each trial, warm-up and round.
    const auto batches = 2 + all["warm_up_batches"].get<std::size_t>() + 2;
    CHECK(configuration["state_hashes"].size() == batches);
    CHECK(configuration["figures"]["median_s"].get<double>() > 0.0);
  }
  for (const json& model : all["models"]) {
    CHECK(model["span_step_s"].get<double>() > 0.0);
    CHECK(model["span_step_s"].get<double>() <= model["serial_step_s"].get<double>());
    CHECK(model["steps_per_sample"].get<int>() >= 1);
  }
  CHECK(lines_of(file_text(results / "compare.csv")).size() == 7);
  CHECK(file_text(results / "compare.html").starts_with("<!DOCTYPE html>"));
}

TEST_CASE("spin counts are an axis of OpenMP's executors, shown wherever configurations are") {
  if (!has_openmp()) return;
  const WorkFolder folder;
  const Ended ended =
      run_spoke({"compare", shipped("simo_vu_quoc_beam"), "--set", "blade.bodies=1",
                 "--formulations", "subsystem", "--executors", "flow_graph,openmp_levels",
                 "--threads", "2", "--spin", "0,1000", "--repeat", "2", "--out", "o"},
                folder);
  CHECK(ended.status == 0);
  const std::vector<std::string> names{"serial", "flow_graph 2", "openmp_levels 2 spin 0",
                                       "openmp_levels 2 spin 1000"};
  const std::vector<std::string> spins{"default", "default", "0", "1000"};
  const json all = json::parse(file_text(folder.path() / "o" / "compare.json"));
  const auto rows = lines_of(file_text(folder.path() / "o" / "compare.csv"));
  const std::string page = file_text(folder.path() / "o" / "compare.html");
  REQUIRE(all["configurations"].size() == names.size());
  REQUIRE(rows.size() == names.size() + 1);
  CHECK(rows[0].ends_with(",spin"));
  for (std::size_t k = 0; k < names.size(); ++k) {
    CAPTURE(names[k]);
    CHECK(all["configurations"][k]["name"] == names[k]);
    CHECK(all["configurations"][k]["spin"] == spins[k]);
    CHECK(rows[k + 1].ends_with("," + spins[k]));
    CHECK(ended.out.find(names[k]) != std::string::npos);
    CHECK(page.find(names[k]) != std::string::npos);
  }
}

TEST_CASE("compare reads its scenario once, as from a pipe") {
  const WorkFolder folder;
  // Another process finds something else under this name.
  const Ended ended = run_spoke(quick({"--formulations", "subsystem", "--out", "o"}, "/dev/stdin"),
                                folder, "", shipped("simo_vu_quoc_beam"));
  CAPTURE(ended.err);
  CHECK(ended.status == 0);
  const json all = json::parse(file_text(folder.path() / "o" / "compare.json"));
  REQUIRE(all["configurations"].size() == 3);
  for (const json& configuration : all["configurations"]) {
    CAPTURE(configuration.dump());
    CHECK(configuration["hash_equal"] == true);
  }
}

TEST_CASE("compare goes on where the scenario would end") {
  const WorkFolder folder;
  const Ended ended =
      run_spoke(quick({"--set", "integration.duration=0.02", "--formulations", "subsystem", "--out",
                       "o", "--integrator", "rk4", "--set", "integration.step=1e-5"}),
                folder);
  CHECK(ended.status == 0);
  const json all = json::parse(file_text(folder.path() / "o" / "compare.json"));
  CHECK(all["integrator"] == "rk4");
  CHECK(all["step_size_s"].get<double>() == approx(1e-5));
  CHECK(all["scenario"]["integration"]["duration"].get<double>() >= 0.02);
  for (const json& configuration : all["configurations"])
    CHECK(configuration["hash_equal"] == true);
}

TEST_CASE("compare refuses a bad command line in one line and writes nothing") {
  const std::string scenario = shipped("simo_vu_quoc_beam");
  const auto refused = [&](const std::vector<std::string>& options, const std::string& message) {
    std::vector<std::string> arguments{"compare", scenario};
    arguments.insert(arguments.end(), options.begin(), options.end());
    check_refused(arguments, message);
  };
  check_refused({"compare"}, "spoke compare: SCENARIO is required");
  refused({"--executors", "serial,flowgraph"}, "--executors: unknown \"flowgraph\", expected");
  refused({"--executors", ""}, "--executors: unknown \"\", expected");
  // The defaults that the help names are words of the options: what is refused is the other one.
  refused({"--executors", "all", "--wait", "all", "--bind", "false", "--repeat", "x"},
          "--repeat: ");
  refused({"--executors", "all,serial"}, "--executors: unknown \"all\", expected some of");
  refused({"--formulations", "dense"},
          "--formulations: unknown \"dense\", expected some of structured, subsystem, augmented");
  refused({"--wait", "sleepy"}, "--wait: unknown \"sleepy\", expected some of default, passive");
  refused({"--bind", "yes"}, "--bind: unknown \"yes\", expected some of false, true");
  for (const std::string spin : {"-1", "1.5", "3ms", "", "1,,2", "100000000001", "often"})
    refused({"--spin", spin},
            "--spin: expected default, infinite or a count from 0 to 100000000000, got \"");
  for (const std::string threads : {"0", "3x", "-1", "100000", "1,,2", "two"})
    refused({"--threads", threads}, "--threads: expected a number from 1 to 1024");
  refused({"--threads", "3x2", "--executors", "flow_graph"}, "--threads: 3x2 is of nested teams");
  for (const std::string rounds : {"0", "-1", "x", "100000"})
    refused({"--repeat", rounds}, "--repeat: ");
  refused({"--out", "/dev/null/x"}, "/dev/null/x: cannot be the folder of results");
  refused({"--set", "blade.bodies=-1"}, "blade.bodies");
}

TEST_CASE("a scenario that diverges while it is measured ends with status 3") {
  const WorkFolder folder;
  const Ended ended =
      run_spoke(quick({"--integrator", "rk4", "--set", "integration.step=0.01"}), folder);
  CHECK(ended.status == 3);
  CHECK(ended.out.empty());
  CHECK(lines_of(ended.err).size() == 1);
  CHECK(ended.err.starts_with("diverged at t = "));
  CHECK(folder.entries() == 0);
}

TEST_CASE("compare --help explains, and the child's command is in no help") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"compare", "--help"}, folder);
  CHECK(ended.status == 0);
  for (const char* part :
       {"--executors", "--threads", "--formulations", "--wait", "--spin", "--bind", "--repeat",
        "--out", "compare.json", "compare.csv", "compare.html"}) {
    CAPTURE(part);
    CHECK(ended.out.find(part) != std::string::npos);
  }
  for (const std::string& line : lines_of(ended.out)) CHECK(line.size() <= 100);
  CHECK(run_spoke({"--help"}, folder).out.find("measure-child") == std::string::npos);
  CHECK(run_spoke({"measure-child"}, folder).status == 2);
}
