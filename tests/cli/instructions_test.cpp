#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/program.h"
#include "tests/cli/refusal.h"

using nlohmann::json;

namespace {

/// Summary of a short run with these instructions, begun with such a command before it.
json summary_with(const std::string& instructions, const std::string& before = {}) {
  const WorkFolder folder;
  const Ended ended = run_spoke({"run", shipped("wu_haug_rotor"), "--set", "integration.duration=1",
                                 "--out", "o", "--quiet", "--instructions", instructions},
                                folder, before);
  CAPTURE(ended.err);
  REQUIRE(ended.status == 0);
  return json::parse(read_file(folder.path() / "o" / "summary.json"));
}

constexpr const char* kLikeOldProcessor = "env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4";

}  // namespace

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

TEST_CASE("a name of instructions that there are not is refused") {
  check_refused({"run", shipped("wu_haug_rotor"), "--instructions", "sse9"},
                "--instructions: sse9 not in {auto,baseline}");
}
