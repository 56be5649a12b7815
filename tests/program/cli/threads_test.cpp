#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/program/cli/program.h"
#include "tests/program/cli/refusal.h"

using nlohmann::json;

namespace {

/// A run of the paper's rotor.
std::vector<std::string> run_rotor(const std::string& duration,
                                   const std::vector<std::string>& more) {
  std::vector<std::string> arguments{
      "run", shipped("wu_haug_rotor"), "--set", "integration.duration=" + duration, "--out", "o"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// Its summary, if it has run with `before`.
json summary_of(const std::vector<std::string>& arguments, const std::string& before) {
  const WorkFolder folder;
  const Ended ended = run_spoke(arguments, folder, before);
  CAPTURE(before);
  CAPTURE(ended.err);
  REQUIRE(ended.status == 0);
  return json::parse(file_text(folder.path() / "o" / "summary.json"));
}

int cores_with(const std::string& before, const std::string& executor = "auto") {
  const json summary = summary_of(run_rotor("0.01", {"--executor", executor, "--quiet"}), before);
  if (executor != "serial") CHECK(summary["threads"] == summary["machine"]["cores"]);
  return summary["machine"]["cores"].get<int>();
}

}  // namespace

TEST_CASE("what binds OpenMP's threads leaves the number of processors as it is") {
  const int cores = cores_with("");
  for (const char* variable : {"OMP_PROC_BIND=true", "OMP_PLACES={0}", "GOMP_CPU_AFFINITY=0"})
    CHECK(cores_with(std::string("env ") + variable) == cores);
  CHECK(cores_with("env OMP_PROC_BIND=true", "flow_graph") == cores);
  const Ended ended =
      run_spoke(run_rotor("0.01", {"--threads", "2"}), WorkFolder(), "env OMP_PROC_BIND=true");
  CHECK((ended.out.find("serial: one thread") != std::string::npos) == (cores == 1));
}

TEST_CASE("the processors that a user allows are counted, bound or not") {
  // The first of those that this test may use.
  const std::string one_processor = "taskset -c $(taskset -cp $$ | sed 's/.*: //; s/[,-].*//') ";
  CHECK(cores_with(one_processor) == 1);
  CHECK(cores_with(one_processor + "env OMP_PROC_BIND=true") == 1);
  CHECK(cores_with(one_processor + "env OMP_PROC_BIND=true", "flow_graph") == 1);
}

TEST_CASE("compare measures with all processors, whatever binds OpenMP's threads outside") {
  const WorkFolder folder;
  const Ended ended =
      run_spoke({"compare", shipped("simo_vu_quoc_beam"), "--set", "blade.bodies=1", "--executors",
                 "flow_graph", "--formulations", "structured", "--repeat", "2", "--out", "o"},
                folder, "env OMP_PROC_BIND=true OMP_PLACES={0}");
  CHECK(ended.status == 0);
  const json all = json::parse(file_text(folder.path() / "o" / "compare.json"));
  const int cores = cores_with("");
  CHECK(all["machine"]["cores"] == cores);
  CHECK(all["configurations"].back()["threads"] == cores);
}

#ifndef SPOKE_SANITIZED  // sanitizers reserve more memory than is allowed here

namespace {

constexpr const char* kFewThreads = "ulimit -s 8192; ulimit -v 2000000;";

}  // namespace

TEST_CASE("of oneTBB no more threads are made than there are processors") {
  CHECK(run_spoke(run_rotor("0.01", {"--executor", "flow_graph", "--threads", "1024", "--set",
                                     "blade.count=300"}),  // so many would find work
                  WorkFolder(), kFewThreads)
            .status == 0);
}

#ifdef SPOKE_HAS_OPENMP

TEST_CASE("of scheme 1 no more threads are made than there are processors") {
  CHECK(run_spoke(run_rotor("0.01", {"--executor", "openmp_scheme1", "--threads", "32x32"}),
                  WorkFolder(), kFewThreads)
            .status == 0);
}

TEST_CASE("threads that the system refuses are told in one line") {
  const auto check = [](const std::string& executor, const std::string& threads) {
    check_refused(run_rotor("0.01", {"--executor", executor, "--threads", threads}),
                  "1024 threads cannot be made here: the system refuses more than ", WorkFolder(),
                  kFewThreads);
  };
  check("openmp_levels", "1024");
  check("openmp_scheme2", "32x32");
  check("openmp_tasks", "1024");
}

#endif

#endif

#ifdef SPOKE_HAS_OPENMP

TEST_CASE("OpenMP's executors count the processors, too, where their threads are bound") {
  CHECK(cores_with("env OMP_PROC_BIND=true", "openmp_levels") == cores_with(""));
}

TEST_CASE("stacks that the system refuses are told before anything is written") {
  for (const std::string executor : {"openmp_levels", "openmp_scheme1", "openmp_tasks"})
    check_refused(run_rotor("0.01", {"--executor", executor, "--threads", "2"}),
                  "2 threads cannot be made here: the system refuses more than 1 (", WorkFolder(),
                  "env OMP_STACKSIZE=900000G");
  for (const std::string stack : {"16M", "8000", " 4 m", "nonsense", "-1", ""})
    CHECK(run_spoke(run_rotor("0.01", {"--executor", "openmp_levels", "--threads", "2"}),
                    WorkFolder(), "env OMP_STACKSIZE='" + stack + "'")
              .status == 0);
}

TEST_CASE("a run is the same whatever OMP_NUM_THREADS says, also what OpenMP's runtime dies of") {
  const auto levels = run_rotor("0.01", {"--executor", "openmp_levels", "--threads", "2"});
  const json expected = summary_of(levels, "");
  for (const std::string value : {"junk", "", "0", "2,junk", "99999999999", "7"}) {
    const json summary = summary_of(levels, "env OMP_NUM_THREADS='" + value + "'");
    CHECK(summary["state_hash"] == expected["state_hash"]);
    CHECK(summary["threads"] == expected["threads"]);
  }
  // Where threads are to be bound, the runtime is asked for the executor auto, too.
  summary_of(run_rotor("0.01", {}), "env OMP_PROC_BIND=true OMP_NUM_THREADS=junk");
}

TEST_CASE("who asks for nested teams is told who takes them") {
  check_refused(run_rotor("0.01", {"--threads", "3x4"}),
                "--threads: auto has one layer of threads, expected a number, got 3x4 "
                "(openmp_scheme1 and openmp_scheme2 take two)");
}

TEST_CASE("more threads than OpenMP allows are refused") {
  for (const std::string executor : {"openmp_scheme1", "openmp_scheme2"})
    check_refused(run_rotor("0.01", {"--executor", executor, "--threads", "3x4"}),
                  executor + " on 3x4 threads: OMP_THREAD_LIMIT allows 2", WorkFolder(),
                  "env OMP_THREAD_LIMIT=2");
  check_refused(run_rotor("0.01", {"--executor", "openmp_levels", "--threads", "3"}),
                "openmp_levels on 3 threads: OMP_THREAD_LIMIT allows 2", WorkFolder(),
                "env OMP_THREAD_LIMIT=2");
  CHECK(run_spoke(run_rotor("0.01", {"--executor", "flow_graph", "--threads", "3"}), WorkFolder(),
                  "env OMP_THREAD_LIMIT=2")
            .status == 0);
}

TEST_CASE("teams of more threads than processors go on, and end in the serial state") {
  const auto hash = [](const std::vector<std::string>& executor) {
    std::vector<std::string> arguments = run_rotor("5", {"--quiet"});  // 1000 steps
    arguments.insert(arguments.end(), executor.begin(), executor.end());
    return summary_of(arguments, "timeout 600")["state_hash"];
  };
  CHECK(hash({"--executor", "openmp_scheme1", "--threads", "3x4"}) ==
        hash({"--executor", "serial"}));
}

#endif
