#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/program/cli/program.h"
#include "tests/program/cli/refusal.h"

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Every timing has samples, and those of steps a median.
void check_timings(const json& timings) {
  for (const char* work : {"steps", "inverse", "implicit_run"}) {
    CAPTURE(work);
    REQUIRE_FALSE(timings[work].empty());
    for (const json& timing : timings[work]) {
      CAPTURE(timing.dump());
      CHECK((timing["status"] == "measured" || timing["status"] == "slow"));
      CHECK(timing["median_s"].get<double>() > 0.0);
      CHECK(timing["step_times_s"].size() == timing["rounds"].get<std::size_t>());
    }
  }
}

}  // namespace

TEST_CASE("reproduce --quick writes a page and a file of everything, from any folder") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"reproduce", "--quick"}, folder);
  CAPTURE(ended.err);
  REQUIRE(ended.status == 0);
  CHECK(ended.err.empty());
  for (const char* part :
       {"conventional", "layered parallel", "Spoke, implicit", "reproduce.html"}) {
    CAPTURE(part);
    CHECK(ended.out.find(part) != std::string::npos);
  }
  const fs::path results = folder.path() / "results" / "reproduce";
  const json all = json::parse(file_text(results / "reproduce.json"));
  for (const char* key : {"version", "machine", "load_average", "rounds", "scenario", "openmp"})
    CHECK(all.contains(key));
  CHECK(all["kind"] == "reproduce");
  CHECK(all["quick"] == true);
  for (const char* part : {"table_2", "fig_8", "fig_10", "fig_11", "fig_12", "table_3"}) {
    CAPTURE(part);
    const bool is_of_threads = std::string(part) == "fig_10" || std::string(part) == "fig_11";
    CHECK(all[part]["claims"].empty() == (is_of_threads && !all["openmp"].get<bool>()));
  }
  CHECK(all["table_2"]["paper_total"] == 7790118);
  CHECK(all["fig_9"]["models"].size() == 3);
  CHECK(all["table_3"]["methods"].size() == 7);
  check_timings(all["timings"]);
  const std::string page = file_text(results / "reproduce.html");
  CHECK(page.starts_with("<!DOCTYPE html>"));
  CHECK(page.find("</html>") != std::string::npos);
  for (const char* heading :
       {"Table 2", "Fig. 8", "Fig. 9", "Fig. 10", "Fig. 11", "Fig. 12", "Fig. 13"})
    CHECK(page.find(heading) != std::string::npos);
  const std::string warm_up = std::to_string(all["warm_up_batches"].get<int>());
  CHECK(page.find("2 trials of a quarter of a batch and " + warm_up + " untimed batches") !=
        std::string::npos);
  for (const char* wrong : {"nan", "inf<", "{:"}) {
    CAPTURE(wrong);
    CHECK(page.find(wrong) == std::string::npos);
  }
}

TEST_CASE("reproduce refuses a bad command line in one line and writes nothing") {
  check_refused({"reproduce", "--quickly"}, "unexpected argument --quickly");
  check_refused({"reproduce", "models/paper_rotor.toml"}, "unexpected argument");
  check_refused({"reproduce", "--out"}, "--out");
  check_refused({"reproduce", "--out", "/dev/null/x"},
                "/dev/null/x: cannot be the folder of results");
}

TEST_CASE("reproduce --help explains") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"reproduce", "--help"}, folder);
  CHECK(ended.status == 0);
  for (const char* part : {"--out", "--quick", "reproduce.html", "reproduce.json", "Exit status:"})
    CHECK(ended.out.find(part) != std::string::npos);
}
