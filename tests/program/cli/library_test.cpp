// Runs with a library of Bladed's kind, tests/engine/control/discon.c: how they end.

#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/engine/control/vanes.h"
#include "tests/program/cli/program.h"

using nlohmann::json;
using namespace spoke::test;

namespace {

const std::string kLibrary = SPOKE_TEST_DISCON;

/// Writes vanes.toml, whose library does what its input file says.
void write_vanes(const WorkFolder& folder, const std::string& does) {
  std::ofstream(folder.path() / "DISCON.IN") << does << '\n';
  std::ofstream(folder.path() / "vanes.toml")
      << make_vanes("[control.library]\nfile = \"" + kLibrary +
                    "\"\ninput = \"DISCON.IN\"\njoint = \"pitch\"\nperiod = 0.01\n");
}

}  // namespace

TEST_CASE("a library that fails in a run ends it with status 3, its message and its results") {
  const WorkFolder folder;
  write_vanes(folder, "fail 1.0");
  const Ended ended = run_spoke({"run", "vanes.toml"}, folder);
  CHECK(ended.status == 3);
  const std::string message = lines_of(ended.err).back();
  CHECK(message.ends_with("diverged at t = 1 s: control.library \"" + kLibrary +
                          "\" fails: a failure of the library"));
  const auto results = folder.path() / "results" / "vanes";
  const json summary = json::parse(file_text(results / "summary.json"));
  CHECK(summary["status"] == "diverged");
  CHECK(message.ends_with(summary["message"].get<std::string>()));
  CHECK(summary["steps"] == 200);
}

TEST_CASE("a library that cannot be, or cannot do what is asked, ends a run with status 2") {
  const WorkFolder folder;
  write_vanes(folder, "fail 0.0");
  const Ended failed = run_spoke({"run", "vanes.toml", "--quiet"}, folder);
  CHECK(failed.status == 2);
  CHECK(failed.err.find("which fails at its first call: a failure of the library") !=
        std::string::npos);
  write_vanes(folder, "none");
  const Ended saved =
      run_spoke({"run", "vanes.toml", "--quiet", "--checkpoint-every", "60"}, folder);
  CHECK(saved.status == 2);
  CHECK(saved.err.find("keeps data of its own that it does not give, expected no checkpoints") !=
        std::string::npos);
  const Ended good = run_spoke({"run", "vanes.toml", "--quiet"}, folder);
  CHECK(good.status == 0);
  CHECK(good.err.empty());
  const Ended checked = run_spoke({"check", "vanes.toml"}, folder);
  CHECK(checked.status == 0);
  CHECK(checked.out.find("library " + kLibrary + ", joint pitch, every 0.01 s") !=
        std::string::npos);
  const Ended modes = run_spoke({"modes", "vanes.toml", "--speed", "2"}, folder);
  CHECK(modes.err.find("control") == std::string::npos);
}
