#include <doctest/doctest.h>
#include <sys/resource.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/program/cli/program.h"
#include "tests/program/cli/refusal.h"

TEST_CASE("check says that a simulation starts at its equilibrium") {
  const WorkFolder folder;
  const Ended ended = run_spoke(
      {"check", shipped("wu_haug_rotor"), "--set", "initial.state=\"equilibrium\""}, folder);
  CHECK(ended.status == 0);
  CHECK(ended.out.find("at its equilibrium at 4 rad/s, all ramps over") != std::string::npos);
}

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

#ifndef SPOKE_SANITIZED

namespace {

/// The most memory that a child of this process has had [MB].
double most_memory_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return 1.024e-3 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace

TEST_CASE("the memory that check tells is what the model takes, in proportion to its bodies") {
  const WorkFolder folder;
  REQUIRE(run_spoke({"check", shipped("wu_haug_rotor")}, folder).status == 0);
  const double program = most_memory_of_children();
  // Each larger than those before it.
  struct Size {
    std::string count, bodies;
  };
  for (const Size& blades : {Size{"1500", "4"}, {"1", "12000"}, {"3000", "4"}, {"1", "24000"}}) {
    CAPTURE(blades.count);
    CAPTURE(blades.bodies);
    const Ended ended =
        run_spoke({"check", shipped("wu_haug_rotor"), "--set", "blade.count=" + blades.count,
                   "--set", "blade.bodies=" + blades.bodies},
                  folder);
    REQUIRE(ended.status == 0);
    const std::string label = "memory          about ";
    const double told = std::stod(ended.out.substr(ended.out.find(label) + label.size()));
    const double used = most_memory_of_children() - program;
    CHECK(told > 0.8 * used);
    CHECK(told < 1.2 * used);
  }
}

#endif

TEST_CASE("an azimuth beyond a turn is asked whether it is in degrees") {
  const auto warnings = [](const std::string& command, const std::string& assignment) {
    const Ended ended = run_spoke({command, shipped("wu_haug_rotor"), "--set", assignment, "--set",
                                   "integration.duration=0.05"},
                                  WorkFolder());
    CHECK(ended.status == 0);
    return ended.err;
  };
  for (const std::string command : {"check", "run"}) {
    CHECK(warnings(command, "blade.azimuth=90") ==
          "warning: " + shipped("wu_haug_rotor") +
              ": the azimuth of blade 1 is 90 rad, beyond a turn of 2 pi: degrees?\n");
    for (const char* usual : {"blade.azimuth=6.28", "blade.azimuth=-6.28", "blade.azimuth=3"})
      CHECK(warnings(command, usual).empty());
  }
}

TEST_CASE("an azimuth beyond a turn is asked for in space, too") {
  for (const std::string command : {"check", "run"}) {
    const Ended ended = run_spoke({command, shipped("spatial_wu_haug"), "--set", "blade.azimuth=90",
                                   "integration.duration=0.05"},
                                  WorkFolder());
    CHECK(ended.status == 0);
    CHECK(ended.err == "warning: " + shipped("spatial_wu_haug") +
                           ": the azimuth of blade 1 is 90 rad, beyond a turn of 2 pi: degrees?\n");
  }
}

TEST_CASE("a precone in degrees is asked for by all that find out about a model") {
  for (const std::string command : {"check", "run", "static", "modes", "linearize"}) {
    CAPTURE(command);
    const Ended ended = run_spoke({command, shipped("spatial_wu_haug"), "--set",
                                   "blade.precone=-2.5", "integration.duration=0.05"},
                                  WorkFolder());
    CHECK(ended.status == 0);
    const std::string warning = "warning: " + shipped("spatial_wu_haug") +
                                ": the precone of blade 1 is -2.5 rad, beyond a right angle, pi/2: "
                                "degrees?\n";
    // Where an equilibrium is found, a second warning says how far the blades bend.
    CHECK(ended.err.substr(0, warning.size()) == warning);
  }
}

TEST_CASE("check draws no page in the place of the scenario") {
  const WorkFolder folder;
  const std::string scenario = folder.write("s.toml", file_text(shipped("wu_haug_rotor"))).string();
  check_refused({"check", scenario, "--html", scenario},
                scenario + ": cannot be written: the command reads this file", folder);
}

TEST_CASE("check warns of a step that rk4 is not stable at") {
  const WorkFolder folder;
  const std::string scenario = shipped("wu_haug_rotor");
  const Ended unstable = run_spoke(
      {"check", scenario, "--set", "integration.method=rk4", "integration.step=9e-5"}, folder);
  CHECK(unstable.status == 0);
  CHECK(lines_of(unstable.err).size() == 1);
  CHECK(unstable.err.starts_with("warning: "));
  CHECK(unstable.err.find("is not stable with rk4, expected at most 8.20") != std::string::npos);
  const Ended stable = run_spoke(
      {"check", scenario, "--set", "integration.method=rk4", "--set", "integration.step=8e-5"},
      folder);
  CHECK(stable.status == 0);
  CHECK(stable.err.empty());
}
