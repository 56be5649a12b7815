#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/program/cli/program.h"
#include "tests/program/cli/refusal.h"
#include "tests/program/cli/study_folder.h"

using nlohmann::json;

namespace {

/// Summary of a short run with these instructions, begun with such a command before it.
json summary_with(const std::string& instructions, const std::string& before = {},
                  const std::string& scenario = "wu_haug_rotor") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"run", shipped(scenario), "--set", "integration.duration=1",
                                 "--out", "o", "--quiet", "--instructions", instructions},
                                folder, before);
  CAPTURE(ended.err);
  REQUIRE(ended.status == 0);
  return json::parse(file_text(folder.path() / "o" / "summary.json"));
}

constexpr const char* kLikeOldProcessor = "env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4";

/// Returns the instructions that "auto" means in this build on this processor.
std::string expect_auto() {
#if defined(SPOKE_NATIVE)
  return "native";
#elif defined(__x86_64__)
  const bool fuses = __builtin_cpu_supports("fma");
#ifndef SPOKE_SANITIZED
  if (fuses && __builtin_cpu_supports("avx2"))
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                   __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw")
               ? "avx512"
               : "avx2";
#endif
  return fuses ? "fma" : "baseline";
#else
  return "baseline";
#endif
}

}  // namespace

TEST_CASE("a run says which instructions it used, and wide ones change results by round-off") {
  for (const std::string scenario : {"wu_haug_rotor", "spatial_wu_haug"}) {
    CAPTURE(scenario);
    const json wide = summary_with("auto", {}, scenario);
    CHECK(wide["instructions"] == expect_auto());
    const json baseline = summary_with("baseline", {}, scenario);
    CHECK(wide["evaluations"] == baseline["evaluations"]);
    for (const auto& column : baseline["sensors"].items()) {
      const std::string& name = column.key();
      const json& sensor = column.value();
      CAPTURE(name);
      const double least = sensor["min"], largest = sensor["max"], end = sensor["final"];
      // Residuals of the energy are round-off themselves, and what stays in its plane is, too.
      const double scale = std::max({std::abs(least), std::abs(largest), 1e-3});
      CHECK(std::abs(wide["sensors"][name]["final"].get<double>() - end) < 1e-8 * scale);
    }
  }
}

TEST_CASE("baseline instructions give the bits of a processor that has no others") {
  const json baseline = summary_with("baseline");
  CHECK(baseline["instructions"] == "baseline");
  const json old = summary_with("auto", kLikeOldProcessor);
  CHECK(old["instructions"] == "baseline");
  CHECK(old["state_hash"] == baseline["state_hash"]);
}

TEST_CASE("baseline instructions keep what the environment asks of the C library besides") {
  const json summary = summary_with(
      "baseline", "env GLIBC_TUNABLES=glibc.malloc.perturb=85:glibc.malloc.tcache_count=3");
  CHECK(summary["instructions"] == "baseline");
}

TEST_CASE("instructions of AVX2 are those of a processor that has no wider ones, or are refused") {
  const std::string best = expect_auto();
  if (best == "avx2" || best == "avx512") {
    const json summary = summary_with("avx2", {}, "spatial_wu_haug");
    CHECK(summary["instructions"] == "avx2");
    const json own = summary_with("auto", {}, "spatial_wu_haug");
    CHECK((own["state_hash"] == summary["state_hash"] || best == "avx512"));
  } else {
    check_refused({"run", shipped("wu_haug_rotor"), "--instructions", "avx2"},
                  "--instructions avx2: this program ");
  }
}

TEST_CASE("AVX2 is refused where the environment forbids it, as the C library then does without") {
  const WorkFolder folder;
  check_refused({"run", shipped("wu_haug_rotor"), "--instructions", "avx2"},
                "--instructions avx2: this program ", folder, kLikeOldProcessor);
}

namespace {

/// A run of so many seconds in the folder o.
std::vector<std::string> run_of(const std::string& seconds, const std::vector<std::string>& more) {
  std::vector<std::string> words = {
      "run",    shipped("wu_haug_rotor"), "--set", "integration.duration=" + seconds, "--out", "o",
      "--quiet"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// The instructions that a run of this build can have by name, the processor's own first.
std::vector<std::string> choices() {
  const std::string best = expect_auto();
  if (best == "native") return {"auto"};
  if (best == "avx512") return {"auto", "avx2", "baseline"};
  return {"auto", "baseline"};
}

json summary_in(const WorkFolder& folder) {
  return json::parse(file_text(folder.path() / "o" / "summary.json"));
}

}  // namespace

TEST_CASE("a resumed run goes on with the instructions of its checkpoint, to the same bits") {
  for (const std::string& instructions : choices()) {
    CAPTURE(instructions);
    const WorkFolder whole, folder;
    REQUIRE(run_spoke(run_of("2", {"--instructions", instructions}), whole).status == 0);
    REQUIRE(
        run_spoke(run_of("1", {"--instructions", instructions, "--checkpoint-every", "99"}), folder)
            .status == 0);
    const Ended ended = run_spoke(run_of("2", {"--resume", "o/checkpoint.spoke"}), folder);
    CAPTURE(ended.err);
    REQUIRE(ended.status == 0);
    CHECK(summary_in(folder)["instructions"] == summary_in(whole)["instructions"]);
    CHECK(summary_in(folder)["state_hash"] == summary_in(whole)["state_hash"]);
    CHECK(file_text(folder.path() / "o" / "sensors.csv") ==
          file_text(whole.path() / "o" / "sensors.csv"));
  }
}

TEST_CASE("a checkpoint is refused where its instructions are not those of the run") {
  const std::string own = expect_auto();
  if (own == "native" || own == "baseline") return;
  const WorkFolder folder;
  const std::vector<std::string> resume = {"--resume", "o/checkpoint.spoke"};
  REQUIRE(run_spoke(run_of("1", {"--checkpoint-every", "99"}), folder).status == 0);
  const std::string rows = file_text(folder.path() / "o" / "sensors.csv");
  const std::string message =
      "o/checkpoint.spoke: cannot be resumed: it was computed with the instructions \"" + own +
      "\", here they are \"baseline\", which have other bits (see --instructions)";
  check_refused(run_of("2", resume), message, folder, kLikeOldProcessor);
  check_refused(run_of("2", {"--resume", "o/checkpoint.spoke", "--instructions", "baseline"}),
                message, folder);
  CHECK(file_text(folder.path() / "o" / "sensors.csv") == rows);
}

TEST_CASE("a resumed study goes on with the instructions of its journal, or is refused") {
  const std::string own = expect_auto();
  if (own == "native" || own == "baseline") return;
  const StudyFolder folder;
  folder.write_study(kSmallStudy);
  const Left whole = folder.run({"--out", "whole", "--instructions", "baseline"});
  const std::filesystem::path cut = folder.work().path() / "cut";
  std::filesystem::create_directory(cut);
  std::filesystem::copy_file(folder.work().path() / "whole" / "study.journal",
                             cut / "study.journal");
  std::filesystem::resize_file(cut / "study.journal",
                               std::filesystem::file_size(cut / "study.journal") * 2 / 3);
  if (own == "avx512" || own == "avx2")
    check_refused({"study", "study.toml", "--out", "cut", "--resume", "--instructions", "avx2"},
                  "cut/study.journal: is of another study, expected the same one to resume: it was "
                  "begun with the instructions \"baseline\", here they are \"avx2\"",
                  folder.work());
  CHECK(folder.run({"--out", "cut", "--resume"}) == whole);
}

TEST_CASE("a name of instructions that there are not is refused") {
  check_refused({"run", shipped("wu_haug_rotor"), "--instructions", "sse9"},
                "--instructions: sse9 not in {auto,avx2,baseline}");
}
