// Libraries of Bladed's kind, by one of the tests' own (discon.c): what it reads, what it demands,
// and how it fails.

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "engine/checkpoint.h"
#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/control/vanes.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

using namespace spoke;
using namespace spoke::test;
using doctest::Approx;

namespace {

/// Returns [control.library] with what the library is to do in its input file.
std::string library_that(const TemporaryFolder& folder, const std::string& does,
                         const std::string& keys = "joint = \"pitch\"\n",
                         const std::string& file = SPOKE_TEST_DISCON) {
  const std::filesystem::path input = folder / "DISCON.IN";
  std::ofstream(input) << does << '\n';
  return "[control.library]\nfile = \"" + file + "\"\ninput = \"" + input.string() +
         "\"\nname = \"" + (folder / "records").string() + "\"\n" + keys;
}

Scenario with_library(const TemporaryFolder& folder, const std::string& does,
                      const std::string& keys = "joint = \"pitch\"\n",
                      const std::string& more = {}) {
  return parse_scenario(make_vanes(library_that(folder, does, keys), more), "vanes.toml");
}

/// Returns the numbers that the library has written, call by call, at the index of their records.
std::vector<std::vector<double>> written_records(const TemporaryFolder& folder) {
  std::ifstream file(folder / "records");
  std::vector<std::vector<double>> calls;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string input, name;
    words >> input >> name;
    CHECK(input == (folder / "DISCON.IN").string());
    CHECK(name == (folder / "records").string());
    std::vector<double>& records = calls.emplace_back(1, 0.0);
    for (double value = 0.0; words >> value;) records.push_back(value);
  }
  return calls;
}

/// Returns the distance of the speed after 5 s from that of J w' = -k w^2.
double distance_from_square(const TemporaryFolder& folder, double step) {
  constexpr double k = 2.0, ratio = 3.0, seconds = 5.0, start = 2.0;
  Scenario scenario = with_library(folder, "square 2.0", "gear_ratio = 3.0\n");
  scenario.integration.step = step;
  Simulation simulation(scenario, {.executor = ExecutorKind::serial});
  simulation.run_until(seconds);
  const double on_hub = k * ratio * ratio * ratio;
  return simulation.sensor("hub.speed") - start / (1.0 + on_hub * start * seconds / kVaneInertia);
}

}  // namespace

TEST_CASE("a library's torque by the square of the speed slows a rotor as its closed form does") {
  const TemporaryFolder folder;
  const double coarse = distance_from_square(folder, 0.01);
  const double fine = distance_from_square(folder, 0.005);
  CHECK(std::abs(fine) < 0.01);
  CHECK(coarse / fine == Approx(2.0).epsilon(0.1));  // the torque is late by a sample
}

TEST_CASE("a library's law of pitch moves a rotor as [control.pitch] of that law does") {
  const TemporaryFolder folder;
  const std::string law =
      "[control.pitch]\njoint = \"pitch\"\nspeed = 1.9\nproportional = 0.6\nintegral = "
      "0.4\nminimum = -1.5\nmaximum = 1.5\ninitial = 0.0\nperiod = 0.02\n";
  Simulation built_in(parse_scenario(make_vanes(law, kLift), "vanes.toml"),
                      {.executor = ExecutorKind::serial});
  Simulation library(
      with_library(folder, "pitch 0.6 0.4 1.9", "joint = \"pitch\"\nperiod = 0.02\n", kLift),
      {.executor = ExecutorKind::serial});
  for (const double t : {0.5, 2.0, 8.0}) {
    built_in.run_until(t);
    library.run_until(t);
    for (const char* name : {"hub.speed", "vane1.pitch", "vane3.pitch", "control.pitch.demand"})
      CHECK(std::abs(library.sensor(name) - built_in.sensor(name)) < 3e-6);  // floats
  }
  CHECK(std::abs(library.sensor("vane2.pitch")) > 1e-3);
}

TEST_CASE("a library is told records of the state at its samples") {
  const TemporaryFolder folder;
  // Gravity bends the roots of the vanes, whose mass centres are one metre beyond their joints.
  std::string text = make_vanes(
      library_that(folder, "write",
                   "joint = \"pitch\"\ngear_ratio = 4.0\nefficiency = 0.9\ninitial = 0.25\nperiod "
                   "= 0.02\n[[control.library.record]]\nnumber = 1001\nsensor = "
                   "\"energy.kinetic\"\nfactor = 2.0\n"),
      "[gravity]\nacceleration = [0, 0, -10.0]\n");
  text.replace(text.find("mass = 0.5"), 10, "mass = 0.5\ncenter = [1.0, 0.0, 0.0]");
  double kinetic = 0.0, speed = 0.0, angle = 0.0;
  {
    Simulation simulation(parse_scenario(text, "vanes.toml"), {.executor = ExecutorKind::serial});
    simulation.run_until(0.1);
    kinetic = simulation.sensor("energy.kinetic");
    speed = simulation.sensor("hub.speed");
    angle = simulation.sensor("hub.angle");
    simulation.step();
  }
  const std::vector<std::vector<double>> calls = written_records(folder);
  REQUIRE(calls.size() == 7);  // at 0, 0.02, ..., 0.1, and a last one
  CHECK(calls[0][1] == 0.0);
  CHECK(calls[5][1] == 1.0);
  CHECK(calls[6][1] == -1.0);
  const std::vector<double>& at = calls[5];
  CHECK(at[2] == Approx(0.1));
  CHECK(at[3] == Approx(0.02));
  for (const int pitch : {4, 33, 34, 11}) CHECK(at[pitch] == Approx(0.25));
  CHECK(at[21] == Approx(speed));
  CHECK(at[20] == Approx(4.0 * speed));
  CHECK(at[23] == Approx(2.0));  // as it demands
  CHECK(at[15] == Approx(0.9 * 2.0 * 4.0 * speed));
  CHECK(at[14] == Approx(8.0 * speed));
  CHECK(at[60] == Approx(angle));
  CHECK(at[61] == 3.0);
  for (const int blade : {0, 1, 2}) {
    CHECK(at[30 + blade] == Approx(-0.5 * 10.0).epsilon(1e-3));  // upwards along the axis
    // What slows the vane: m r rotates with the hub, about its joint.
    CHECK(at[69 + blade] == Approx(at[69]));
  }
  CHECK(at[1001] == Approx(2.0 * kinetic));
  CHECK(at[129] >= 1001.0);
  CHECK(at[50] == Approx((folder / "DISCON.IN").string().size() + 1.0));
  CHECK(at[51] == Approx((folder / "records").string().size() + 1.0));
  CHECK(at[49] > 100.0);
}

TEST_CASE("simulations at the same time share no data of a library, nor do executors its bits") {
  const TemporaryFolder folder;
  const Scenario scenario = with_library(folder, "count");
  Simulation first(scenario, {.executor = ExecutorKind::serial});
  first.run_until(0.1);
  Simulation second(scenario, {.executor = ExecutorKind::flow_graph, .threads = {2, 1}});
  while (second.steps() < 20) second.step();
  CHECK(first.state_hash() == second.state_hash());
  first.run_until(0.2);
  second.run_until(0.2);
  CHECK(first.state_hash() == second.state_hash());
  CHECK(std::abs(first.sensor("hub.speed") - 2.0) > 1e-3);
}

TEST_CASE("a library demands pitch of each blade, yaw and the brake") {
  const TemporaryFolder folder;
  Simulation each(with_library(folder, "each", "joint = \"pitch\"\nindividual_pitch = true\n"));
  each.run_until(0.5);
  CHECK(each.sensor("vane1.pitch") == Approx(0.1));
  CHECK(each.sensor("vane2.pitch") == Approx(0.2));
  CHECK(each.sensor("vane3.pitch") == Approx(0.3));
  Simulation braked(with_library(folder, "brake", "brake_torque = 7.0\n"));
  braked.run_until(3.0);
  CHECK(braked.sensor("hub.speed") == Approx(2.0 - 7.0 * 3.0 / kVaneInertia).epsilon(1e-6));
  braked.run_until(10.0);
  CHECK(std::abs(braked.sensor("hub.speed")) < 1e-6);
  const std::string mast =
      "[support]\naxle = { body = \"mast\" }\n[[support.body]]\nname = \"mast\"\nkind = "
      "\"rigid\"\nmass = 5.0\ninertia = "
      "1.0\n[[support.joint]]\nname = \"yaw\"\nchild = \"mast\"\nkind = \"revolute\"\naxis = [1, "
      "0, 0]\nmotion = { constant = 0.0 }\n";
  Simulation yawed(with_library(folder, "yaw 0.1", "yaw_joint = \"yaw\"\nperiod = 0.01\n", mast));
  yawed.run_until(2.0);
  const float rate = 0.1F;
  CHECK(yawed.sensor("support.yaw") == Approx(static_cast<double>(rate) * 1.99).epsilon(1e-9));
}

TEST_CASE("a library that cannot be is refused at the start, by its key") {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& does, const std::string& file) {
    const Scenario scenario = parse_scenario(
        make_vanes(library_that(folder, does, "joint = \"pitch\"\n", file)), "vanes.toml");
    return message_of([&] { Simulation(scenario).step(); });
  };
  const std::string text = (folder / "text.so").string();
  std::ofstream(text) << "no library\n";
  CHECK(refusal("none", text)
            .starts_with("control.library.file: is \"" + text + "\", which cannot be loaded: "));
  CHECK(refusal("none", SPOKE_TEST_NO_DISCON) ==
        std::string("control.library.file: is \"") + SPOKE_TEST_NO_DISCON +
            "\", which has no function DISCON, expected a shared library with that");
  // A copy in a folder of its own: other tests load theirs beside the library at the same time.
  const std::string own = (folder / "own.so").string();
  std::filesystem::copy_file(SPOKE_TEST_DISCON, own);
  CHECK(refusal("fail 0.0", own) == "control.library.file: is \"" + own +
                                        "\", which fails at its first call: a failure of the "
                                        "library");
  CHECK(message_of([&] {
          Simulation(with_library(folder, "none",
                                  "[[control.library.record]]\nnumber = 1001\nsensor = "
                                  "\"hub.sped\"\n"));
        }) == "control.library.record.1.sensor: is \"hub.sped\", did you mean \"hub.speed\"?");
  int left = 0;  // no copy of a library stays
  for (const auto& file :
       std::filesystem::directory_iterator(std::filesystem::path(own).parent_path()))
    left += file.path().filename().string().starts_with("spoke-discon");
  CHECK(left == 0);
}

TEST_CASE("a library that fails in a run ends it as a divergence, with its message") {
  const TemporaryFolder folder;
  Simulation simulation(with_library(folder, "fail 0.05"), {.executor = ExecutorKind::serial});
  try {
    simulation.run_until(1.0);
    FAIL("it went on");
  } catch (const DivergenceError& error) {
    CHECK(std::string(error.what()) == std::string("diverged at t = 0.05 s: control.library \"") +
                                           SPOKE_TEST_DISCON +
                                           "\" fails: a failure of the library");
    CHECK(*error.divergence().time == Approx(0.05));
  }
  CHECK(simulation.steps() == 10);  // all steps before it are there
  Simulation strange(with_library(folder, "nan 0.05"));
  const std::string expected = std::string("diverged at t = 0.05 s, step 11: control.library \"") +
                               SPOKE_TEST_DISCON +
                               "\" demands a torque that is not finite, expected a number";
  CHECK_THROWS_WITH_AS(strange.run_until(1.0), expected.c_str(), DivergenceError);
  Simulation warned(with_library(folder, "warn"));
  warned.run_until(0.1);
  CHECK(warned.steps() == 20);
}

TEST_CASE("what a library keeps is not saved or cloned, and that is said") {
  const TemporaryFolder folder;
  Simulation simulation(with_library(folder, "count"));
  const std::string file = std::string("control.library \"") + SPOKE_TEST_DISCON + '"';
  CHECK(message_of([&] { simulation.save(); }) ==
        "the simulation cannot be saved: " + file +
            " keeps data of its own that it does not give, expected no checkpoints");
  CHECK(message_of([&] { simulation.clone(); }) ==
        "the simulation cannot be cloned: " + file + " gives no copy of itself");
}

TEST_CASE("a trace calls a library as a run does") {
  const TemporaryFolder folder;
  Simulation run(with_library(folder, "count")), traced(with_library(folder, "count"));
  run.run_until(0.1);
  CHECK(std::ssize(traced.trace(run.steps()).steps) == run.steps());
  CHECK(traced.state_hash() == run.state_hash());
}
