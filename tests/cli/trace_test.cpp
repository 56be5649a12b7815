#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

json trace_in(const fs::path& folder) { return json::parse(read_file(folder / "trace.json")); }

/// The pictures in the page of a run.
json film_in(const fs::path& folder) {
  const std::string page = read_file(folder / "report.html");
  const std::string mark = "id=\"run-data\">";
  const std::size_t begin = page.find(mark);
  REQUIRE(begin != std::string::npos);
  const std::size_t end = page.find("</script>", begin);
  return json::parse(page.substr(begin + mark.size(), end - begin - mark.size()))["film"];
}

/// Of the files of two runs.
std::string hash_in(const fs::path& folder) {
  return json::parse(read_file(folder / "summary.json"))["state_hash"];
}

}  // namespace

TEST_CASE("trace writes its files and prints a summary") {
  const WorkFolder folder;
  const Ended ended =
      run_spoke({"trace", shipped("wu_haug_rotor"), "--executor", "flow_graph", "--threads", "2",
                 "--from", "0.5", "--steps", "5", "--formulation", "subsystem"},
                folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  for (const char* part :
       {"5 steps from t = 0.505 s on", "flow_graph on 2 threads", "T1", "Tinf", "makespan",
        "speedup", "max(T1/2, Tinf)", "idle", "trace.json", "graph.dot"}) {
    CAPTURE(part);
    CHECK(contains(ended.out, part));
  }
  const fs::path results = folder.path() / "results" / "wu_haug_rotor" / "trace";
  const json trace = trace_in(results);
  REQUIRE(trace["spoke"]["steps"].size() == 5);
  CHECK(trace["spoke"]["steps"][0]["step"] == 101);
  CHECK(trace["spoke"]["settings"]["formulation"] == "subsystem");
  CHECK(trace["spoke"]["graph"]["name"].size() == 61);
  CHECK(read_file(results / "graph.dot").starts_with("digraph"));
  // With Graphviz there is a picture, without a line that says so.
  const bool has_picture = fs::exists(results / "graph.svg");
  CHECK(has_picture != contains(ended.out, "no graph.svg: "));
  if (has_picture) CHECK(contains(read_file(results / "graph.svg"), "</svg>"));
}

TEST_CASE("trace of a window of steps, and of what auto has not chosen yet") {
  const WorkFolder folder;
  const Ended window = run_spoke({"trace", shipped("wu_haug_rotor"), "--executor", "flow_graph",
                                  "--threads", "2", "--window", "4", "--out", "w"},
                                 folder);
  CHECK(window.status == 0);
  CHECK(contains(window.out, "windows of 4 steps"));
  CHECK(trace_in(folder.path() / "w")["spoke"]["settings"]["window_steps"] == 4);
  const Ended automatic =
      run_spoke({"trace", shipped("wu_haug_rotor"), "--threads", "2", "--out", "a"}, folder);
  CHECK(automatic.status == 0);
  CHECK(contains(automatic.out, "auto has chosen nothing yet"));
  CHECK(trace_in(folder.path() / "a")["spoke"]["settings"]["executor"] == "auto");
}

TEST_CASE("without Graphviz all but the picture is written, and a line says so") {
  const WorkFolder folder;
  const std::string old_path = std::getenv("PATH");
  setenv("PATH", folder.path().c_str(), 1);
  const Ended ended =
      run_spoke({"trace", shipped("wu_haug_rotor"), "--steps", "1", "--out", "o"}, folder);
  setenv("PATH", old_path.c_str(), 1);
  CHECK(ended.status == 0);
  CHECK(contains(ended.out, "no graph.svg: Graphviz is not installed"));
  CHECK(fs::exists(folder.path() / "o" / "graph.dot"));
  CHECK_FALSE(fs::exists(folder.path() / "o" / "graph.svg"));
  CHECK_FALSE(fs::exists(folder.path() / "o" / "graph.svg.tmp"));
}

TEST_CASE("a full buffer drops whole steps and says how many") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"trace", shipped("wu_haug_rotor"), "--steps", "1000", "--executor",
                                 "serial", "--buffer", "1", "--out", "o"},
                                folder);
  CHECK(ended.status == 0);
  CHECK(contains(ended.out, " steps dropped, the buffer was full"));
  const json trace = trace_in(folder.path() / "o");
  const auto dropped = trace["spoke"]["dropped_steps"].get<std::size_t>();
  CHECK(dropped > 0);
  CHECK(trace["spoke"]["steps"].size() + dropped == 1000);
}

TEST_CASE("run --trace writes the trace, too, and the same results") {
  const WorkFolder folder;
  const std::vector<std::string> plain{"run",       shipped("wu_haug_rotor"),
                                       "--set",     "integration.duration=0.5",
                                       "--out",     "plain",
                                       "--threads", "2"};
  CHECK(run_spoke(plain, folder).status == 0);
  std::vector<std::string> traced = plain;
  traced[5] = "traced";
  traced.insert(traced.end(), {"--trace", "t"});
  const Ended ended = run_spoke(traced, folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  CHECK(contains(ended.out, "20 steps from t = 0.005 s on"));
  CHECK(trace_in(folder.path() / "t")["spoke"]["steps"].size() == 20);
  CHECK(hash_in(folder.path() / "plain") == hash_in(folder.path() / "traced"));
  CHECK(read_file(folder.path() / "plain" / "sensors.csv") ==
        read_file(folder.path() / "traced" / "sensors.csv"));
  traced.insert(traced.end(), {"--quiet"});
  CHECK(run_spoke(traced, folder).out.empty());
}

TEST_CASE("run --trace leaves pictures, files for ParaView and checkpoints, and traces 20 steps") {
  using Words = std::vector<std::string>;
  const WorkFolder folder;
  const auto run = [&](Words words, const std::string& out) {
    words.insert(words.begin(),
                 {"run", shipped("wu_haug_rotor"), "--set", "integration.duration=0.15", "--set",
                  "output.interval=0.005", "--threads", "2", "--out", out});
    const Ended ended = run_spoke(words, folder);
    CHECK(ended.status == 0);
    return ended.out;
  };
  for (const Words& words :
       {Words{}, Words{"--vtk"}, Words{"--executor", "flow_graph", "--window", "8"},
        Words{"--vtk", "--executor", "flow_graph", "--window", "8", "--set",
              "output.interval=0.035"},
        Words{"--checkpoint-every", "1e-9"}}) {
    CAPTURE(words.size());
    const fs::path plain = folder.path() / "plain", traced = folder.path() / "traced";
    run(words, "plain");
    Words more = words;
    more.insert(more.end(), {"--trace", "t"});
    CHECK(contains(run(more, "traced"), "20 steps from t = 0.005 s on"));
    const json steps = trace_in(folder.path() / "t")["spoke"]["steps"];
    REQUIRE(steps.size() == 20);
    for (std::size_t k = 0; k < steps.size(); ++k) CHECK(steps[k]["step"] == k + 1);
    CHECK(film_in(plain)["times"] != "");
    CHECK(film_in(plain) == film_in(traced));
    for (const char* file : {"sensors.csv", "vtk/blades.pvd", "vtk/blades_000003.vtp"})
      CHECK(read_file(plain / file) == read_file(traced / file));
    CHECK(fs::exists(plain / "checkpoint.spoke") == fs::exists(traced / "checkpoint.spoke"));
    CHECK(hash_in(plain) == hash_in(traced));
  }
}

TEST_CASE("a run shorter than the trace is traced as a whole") {
  const WorkFolder folder;
  const Ended ended = run_spoke(
      {"run", shipped("wu_haug_rotor"), "--set", "integration.duration=0.015", "--trace", "t"},
      folder);
  CHECK(ended.status == 0);
  CHECK(trace_in(folder.path() / "t")["spoke"]["steps"].size() == 3);
}

TEST_CASE("a trace that diverges ends with status 3 and writes nothing") {
  const WorkFolder folder;
  const Ended ended =
      run_spoke({"trace", shipped("wu_haug_rotor"), "--set", "blade.bodies=1", "--set",
                 "blade.geometric_stiffening=false", "--from", "15", "--executor", "serial"},
                folder);
  CHECK(ended.status == 3);
  CHECK(ended.out.empty());
  CHECK(lines_of(ended.err).size() == 1);
  CHECK(contains(ended.err, "diverged at t = "));
  CHECK(folder.entries() == 0);
}

TEST_CASE("trace refuses a bad command line in one line and writes nothing") {
  const WorkFolder folder;
  const auto refused = [&](std::vector<std::string> options, const std::string& message) {
    options.insert(options.begin(), {"trace", shipped("wu_haug_rotor")});
    const Ended ended = run_spoke(options, folder);
    CAPTURE(message);
    CAPTURE(ended.err);
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    CHECK(lines_of(ended.err).size() == 1);
    CHECK(contains(ended.err, message));
    CHECK(folder.entries() == 0);
  };
  for (const std::string steps : {"0", "-3", "x", "1.5", "100001"})
    refused({"--steps", steps}, "--steps: ");
  refused({"--steps", "4001"}, "--steps 4001: the scenario has 4000 steps, expected at most 4000");
  for (const std::string from : {"-1", "x", "nan", "inf", "", "1s"})
    refused({"--from", from}, "--from: expected a time in s, 0 or more, got " + from);
  refused({"--from", "30"},
          "--from 30: 4000 steps of 0.005 s end at 20 s, expected at most 19.9 s");
  refused({"--from", "19.95"}, "expected at most 19.9 s");
  for (const std::string buffer : {"0", "x", "-1", "1e9"})
    refused({"--buffer", buffer}, "--buffer: expected 1 to 65536 megabytes, got " + buffer);
  for (const std::string window : {"0", "x", "1001"}) refused({"--window", window}, "--window: ");
  refused({"--executor", "none"}, "--executor: ");
  refused({"--executor", "flow_graph", "--threads", "2x2"}, "--threads: ");
  refused({"--out", "/dev/null/x"}, "/dev/null/x: cannot be the folder of results");
  refused({"--set", "blade.bodies=-1"}, "blade.bodies");
}

TEST_CASE("run refuses a folder of traces that cannot be made, before it runs") {
  const WorkFolder folder;
  const Ended ended =
      run_spoke({"run", shipped("wu_haug_rotor"), "--trace", "/dev/null/x"}, folder);
  CHECK(ended.status == 2);
  CHECK(lines_of(ended.err).size() == 1);
  CHECK(contains(ended.err, "/dev/null/x: cannot be the folder of results"));
  CHECK(folder.entries() == 0);
}
