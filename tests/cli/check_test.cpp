#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/cli/program.h"

TEST_CASE("check prints the model and writes nothing") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"check", shipped("wu_haug_rotor")}, folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  for (const char* part :
       {"Wu & Haug 1988 rotor, spin-up to 4 rad/s\n",
        "3 subsystems, 12 bodies, 144 coordinates, 12 joints", " nodes, ",
        "lowest natural frequency 2.909", "rad/s (0.463", "highest natural frequency 34",
        "stable up to a step of 8.20", "generalized_alpha, 4000 steps of 0.005 s"}) {
    CAPTURE(part);
    CHECK(ended.out.find(part) != std::string::npos);
  }
  CHECK(folder.entries() == 0);
}

TEST_CASE("check accepts every shipped scenario") {
  const WorkFolder folder;
  for (const char* name : {"wu_haug_rotor", "paper_rotor", "spin_up_hold_spin_down",
                           "simo_vu_quoc_beam", "free_hub_satellite", "large_rotor"}) {
    CAPTURE(name);
    const Ended ended = run_spoke({"check", shipped(name)}, folder);
    CHECK(ended.status == 0);
    CHECK(ended.err.empty());
  }
}

TEST_CASE("check warns of a step that rk4 is not stable at") {
  const WorkFolder folder;
  const std::string scenario = shipped("wu_haug_rotor");
  const Ended unstable = run_spoke(
      {"check", scenario, "--set", "integration.method=rk4", "integration.step=9e-5"}, folder);
  CHECK(unstable.status == 0);
  CHECK(lines_of(unstable.err).size() == 1);
  CHECK(unstable.err.find("is not stable with rk4, expected at most 8.20") != std::string::npos);
  const Ended stable = run_spoke(
      {"check", scenario, "--set", "integration.method=rk4", "--set", "integration.step=8e-5"},
      folder);
  CHECK(stable.status == 0);
  CHECK(stable.err.empty());
}
