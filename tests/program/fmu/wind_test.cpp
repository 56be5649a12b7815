// Wind as an input of FMUs, outputs of the air, and a controller of the importer's on a turbine.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "engine/courses.h"
#include "engine/simulation.h"
#include "models/error.h"
#include "program/fmu/make_fmu.h"
#include "program/fmu/resources.h"
#include "tests/contains.h"
#include "tests/file_text.h"
#include "tests/message_of.h"
#include "tests/models/air/bts_bytes.h"
#include "tests/program/fmu/importer.h"
#include "tests/program/fmu/unpacked_fmu.h"
#include "tests/shown_values.h"
#include "tests/temporary_folder.h"

using namespace spoke;
using namespace spoke::test;
using Eigen::Vector3d;
using Words = std::vector<std::string>;
namespace fs = std::filesystem;

namespace {

const Words kWindNames{"wind.x", "wind.y", "wind.z"};
constexpr double kStep = 1.0 / 64;  // of communication

/// Returns the wind at the end of communication step k.
Vector3d wind_behind(int k) {
  if (k < 2) return {8.0, 0.0, 0.0};
  return {8.0 + 0.25 * (k % 5), k < 8 ? 0.0 : 1.0, k < 12 ? 0.0 : -0.5};
}

std::vector<double> list(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

TEST_CASE("wind that an importer gives is the same wind as a function, bit for bit") {
  const UnpackedFmu unpacked(kBlownRotor, kWindNames);
  const LoadedFmu fmu(unpacked.folder());
  FmuInstance instance(fmu);
  CHECK(instance.initialize() == kOk);
  CHECK(instance.get(kWindNames) == std::vector<double>{8.0, 0.0, 0.0});
  Scenario scenario = parse_scenario(kBlownRotor, "rotor.toml");
  scenario.space->air->wind = Wind{};
  scenario.space->air->wind.field = make_wind_field([](const Vector3d& place, double t) {
    const int k = std::max(0, static_cast<int>(std::ceil(t / kStep)) - 1);
    const WindCourse course{k * kStep, (k + 1) * kStep, wind_behind(k - 1), wind_behind(k)};
    return Vector3d(course.at(t) * std::pow((place.z() + 10.0) / 10.0, 0.25));
  });
  Simulation simulation(scenario);
  REQUIRE(fmu.outputs() == simulation.sensor_names());
  for (int k = 0; k < 20; ++k) {
    CHECK(instance.set(kWindNames, list(wind_behind(k))) == kOk);
    CHECK(instance.step(k * kStep, kStep) == kOk);
    simulation.run_until((k + 1) * kStep);
    CHECK(instance.outputs() == values_of(simulation));
  }
  CHECK(instance.errors() == 0);
}

TEST_CASE(
    "wind that is given is the scenario's course of the speed, and a component is by itself") {
  // The speed of a scenario that rises evenly from the start on.
  const UnpackedFmu unpacked(kBlownRotor, {"wind.x"}, {"air", "hub.speed"});
  const LoadedFmu fmu(unpacked.folder());
  CHECK(fmu.outputs() == Words{"air.wind", "air.thrust", "air.torque", "air.power",
                               "air.thrust_coefficient", "air.power_coefficient", "hub.speed"});
  FmuInstance instance(fmu);
  CHECK(instance.initialize() == kOk);
  Simulation simulation = simulate(kBlownRotor, {"wind.time=[0,0.5,1]", "wind.speed=[8,12,16]"});
  for (int k = 0; k < 32; ++k) {
    CHECK(instance.set({"wind.x"}, {8.0 + (k + 1) / 8.0}) == kOk);
    CHECK(instance.step(k * kStep, kStep) == kOk);
    simulation.run_until((k + 1) * kStep);
    for (const std::string& name : fmu.outputs()) {
      CAPTURE(name);
      CHECK(instance.get({name})[0] == doctest::Approx(simulation.sensor(name)).epsilon(1e-9));
    }
  }
  CHECK(instance.get({"air.wind"})[0] == doctest::Approx(12.0).epsilon(1e-9));
}

TEST_CASE("turbulence blows until wind is given and then ends, and states go back to it") {
  const UnpackedFmu unpacked(kBlownRotor, kWindNames, {},
                             {"wind.turbulence={intensity=0.1,width=8.0,points=4,duration=4.0}"});
  const LoadedFmu fmu(unpacked.folder());
  FmuInstance instance(fmu);
  CHECK(instance.initialize() == kOk);
  CHECK(instance.get(kWindNames) == std::vector<double>{8.0, 0.0, 0.0});  // the mean
  CHECK(instance.step(0.0, 4 * kStep) == kOk);
  CHECK(std::abs(instance.get({"air.wind"})[0] - 8.0) > 1e-3);
  void* turbulent = nullptr;
  CHECK(instance.get_state(&turbulent) == kOk);
  CHECK(instance.step(4 * kStep, kStep) == kOk);
  const std::vector<double> expected = instance.outputs();
  CHECK(instance.set_state(turbulent) == kOk);
  CHECK(instance.set({"wind.x"}, {9.0}) == kOk);
  CHECK(instance.step(4 * kStep, kStep) == kOk);
  CHECK(instance.get({"air.wind"})[0] == doctest::Approx(9.0).epsilon(1e-12));
  CHECK(instance.step(5 * kStep, kStep) == kOk);
  CHECK(instance.get({"air.wind"})[0] == doctest::Approx(9.0).epsilon(1e-12));
  CHECK(instance.set_state(turbulent) == kOk);
  CHECK(instance.step(4 * kStep, kStep) == kOk);
  CHECK(instance.outputs() == expected);
}

TEST_CASE("files of wind and aerofoils go with the scenario, from wherever they are") {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "a");
  std::ofstream(folder / "wing.txt") << "-180 0 0.02\n-20 -1.2 0.1\n0 0.1 0.01\n20 1.4 0.1\n"
                                        "180 0 0.02\n";
  std::ofstream(folder / "wind.txt") << "0 8\n1 9\n";
  std::string text = kBlownRotor;
  const std::size_t first = text.find("angle = ["), end = text.find("[air]");
  text.replace(first, end - first, "file = \"../wing.txt\"\n");
  text.replace(text.find("velocity = [8.0, 0.0, 0.0]"), 26, "file = \"../wind.txt\"");
  const fs::path file = folder.path() / "a/rotor.toml";
  std::ofstream(file) << text;
  const fmu::PackedScenario packed = fmu::pack_scenario(file.string(), file_text(file), {});
  REQUIRE(packed.files.size() == 3);
  CHECK(packed.files[1].name == "files/1_wind.txt");
  CHECK(packed.files[2].name == "files/2_wing.txt");
  CHECK(packed.overrides ==
        Overrides{"wind.file=\"files/1_wind.txt\"", "airfoil.1.file=\"files/2_wing.txt\""});
  Simulation simulation(read_scenario(file.string()));
  const fmu::Fmu made = fmu::make_fmu(
      {file.string(), {}, "rotor", SPOKE_FMU_LIBRARY_FILE, {"wind.x"}, {}}, simulation);
  unpack(made.bytes, folder.path() / "fmu");
  fs::remove(file);
  const LoadedFmu fmu(folder.path() / "fmu");
  FmuInstance instance(fmu);
  CAPTURE(instance.last());
  REQUIRE(instance.handle());
  CHECK(instance.initialize() == kOk);
  CHECK(instance.step(0.0, 0.25) == kOk);
  simulation.run_until(0.25);
  CHECK(instance.outputs() == values_of(simulation));
}

TEST_CASE("a simulation goes on beyond its duration as long as its file has wind") {
  const TemporaryFolder folder;
  const std::string file = (folder / "wind.bts").string();
  BtsBytes{.identifier = 7, .n_t = 8}.write(file);  // of 2.05 s
  const UnpackedFmu unpacked(kBlownRotor, {"wind.x"}, {"air.wind"},
                             {"wind={file=\"" + file + "\",ground=-10}"});
  fs::remove(file);
  const LoadedFmu fmu(unpacked.folder());
  FmuInstance instance(fmu);
  CAPTURE(instance.last());
  REQUIRE(instance.handle());
  CHECK(instance.initialize() == kOk);
  CHECK(instance.step(0.0, 2.0) == kOk);
  CHECK(instance.step(2.0, kStep) == kError);
  CHECK(contains(instance.last(), "as many steps as it can"));
}

TEST_CASE("an importer's controller of torque and pitch works on a turbine in wind") {
  const fs::path turbine = fs::path(SPOKE_MODELS_DIR) / "nrel_5mw_in_wind.toml";
  const Overrides own{"control={}",
                      "blade.joint.1.motion={by=\"program\",initial=-0.067}",
                      "wind={velocity=[12,0,0],shear_exponent=0.2,reference_height=90}",
                      "blade.bodies=1",
                      "blade.elements=3",
                      "blade.strain=\"linear\"",
                      "support.body.1.elements=3",
                      "integration.step=0.01",
                      "integration.duration=2"};
  const Words pitches{"blade1.pitch.velocity", "blade2.pitch.velocity", "blade3.pitch.velocity"};
  Words inputs{"drive.torque", "wind.x"};
  inputs.insert(inputs.end(), pitches.begin(), pitches.end());
  Simulation simulation(read_scenario(turbine.string(), own));
  const TemporaryFolder folder;
  unpack(fmu::make_fmu({turbine.string(),
                        own,
                        "turbine",
                        SPOKE_FMU_LIBRARY_FILE,
                        inputs,
                        {"hub.speed", "air", "support.tower_top"}},
                       simulation)
             .bytes,
         folder.path() / "fmu");
  const LoadedFmu fmu(folder.path() / "fmu");
  FmuInstance instance(fmu);
  CAPTURE(instance.last());
  REQUIRE(instance.handle());
  CHECK(instance.initialize() == kOk);
  constexpr double kSample = 0.05;
  const double set_point = 1.26, power = 5296.6e3;
  double angle = 0.067, integral = 0.067, wind = wind_at_hub(simulation).x();
  for (int k = 0; k < 40; ++k) {
    // Torque for constant power, pitch by a proportional-integral law on the speed that is seen.
    const double speed = instance.get({"hub.speed"})[0], error = speed - set_point;
    CHECK(simulation.sensor("hub.speed") == speed);
    integral += 0.78 * error * kSample;
    const double demand = integral + 1.83 * error, rate = (demand - angle) / kSample;
    const double torque = -power / speed, next_wind = wind + (k < 20 ? 0.1 : 0.0);
    angle = demand;
    CHECK(instance.set(inputs, {torque, next_wind, -rate, -rate, -rate}) == kOk);
    CHECK(instance.step(k * kSample, kSample) == kOk);
    // The same on a simulation, in the order of the inputs.
    const double t = simulation.time();
    simulation.set_drive(TorqueDrive{Curve(torque), calc_initial_speed(simulation.drive())});
    const double end = static_cast<double>(simulation.steps() + 5) * simulation.step_size();
    set_wind(simulation, {t, end, {wind, 0.0, 0.0}, {next_wind, 0.0, 0.0}});
    for (int blade = 0; blade < 3; ++blade) {
      const int joint = simulation.joint_index(blade, "pitch");
      CoordinateMotion motion = simulation.joint_motion(blade, joint);
      motion.acceleration = (-rate - motion.velocity) / kSample;
      simulation.set_joint_motion(blade, joint, 0, motion);
    }
    simulation.run_until(end);
    wind = next_wind;
    for (const std::string& name : fmu.outputs()) {
      CAPTURE(name);
      REQUIRE(instance.get({name})[0] == simulation.sensor(name));
    }
  }
  CHECK(instance.get({"air.wind"})[0] == doctest::Approx(14.0).epsilon(0.05));
  CHECK(angle > 0.067);  // towards feather, as more wind asks for
  CHECK(instance.errors() == 0);
}

TEST_CASE("joints under the scenario's control are no inputs, and say so") {
  const fs::path turbine = fs::path(SPOKE_MODELS_DIR) / "nrel_5mw_in_wind.toml";
  const std::string calm = "wind={velocity=[12,0,0]}";
  const Simulation controlled(read_scenario(turbine.string(), {calm, "initial={}"}));
  const auto refused = [&](const std::string& name) {
    return message_of([&] { fmu::choose_inputs(controlled, {name}); });
  };
  CHECK(
      refused("blade1.pitch.velocity") ==
      "the input \"blade1.pitch.velocity\": [control.pitch] moves that joint, expected no control "
      "of it and motion = { by = \"program\" }");
  CHECK(
      refused("support.yaw.velocity") ==
      "the input \"support.yaw.velocity\": the scenario does not leave that joint to the program, "
      "expected motion = { by = \"program\" }");
  CHECK(contains(refused("wind.u"), "wind."));
  // Both at once.
  CHECK(contains(message_of([&] {
                   read_scenario(turbine.string(), {calm, "blade.joint.1.motion={by=\"program\"}"});
                 }),
                 "control.pitch.joints.1: names a joint that the program moves on blade 1"));
}
