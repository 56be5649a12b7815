// spoke run under mpirun: one model in several processes, with the files of one process.

#include "tests/program/cli/run_ranks.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/program/cli/program.h"

namespace fs = std::filesystem;
using nlohmann::json;

TEST_CASE("a run in several processes writes the bytes of one process") {
  const WorkFolder folder;
  const auto check = [&](const std::string& scenario, const std::string& duration, int ranks) {
    CAPTURE(scenario);
    const Ended alone = run_spoke(run_of(scenario, duration, {"--out", "alone"}), folder);
    const Ended shared =
        run_spoke(run_of(scenario, duration, {"--out", "shared", "--vtk"}), folder, mpirun(ranks));
    CAPTURE(shared.err);
    CHECK(alone.status == 0);
    CHECK(shared.status == 0);
    const fs::path one = folder.path() / "alone", all = folder.path() / "shared";
    CHECK(file_text(one / "sensors.csv") == file_text(all / "sensors.csv"));
    CHECK(figures_in(one) == figures_in(all));
    CHECK(json::parse(file_text(all / "summary.json"))["processes"] == ranks);
    CHECK(fs::exists(all / "report.html"));
    CHECK(fs::exists(all / "vtk"));
  };
  check("wu_haug_rotor", "2", 2);
  check("satellite_booms", "1", 3);
  check("solid_blade_rotor", "0.02", 3);
  check("ground_resonance", "0.5", 2);
  check("helicopter_on_gear", "0.1", 3);
}
