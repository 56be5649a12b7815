// Steady states of several rotors by the program: speeds by name, and what is printed and written.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/program/cli/program.h"

using nlohmann::json;

namespace {

const char* const kTwoRotors = R"(world = "space"
[integration]
duration = 1.0
[support]
from = "ground"
[[support.body]]
name = "frame"
kind = "rigid"
mass = 20.0
inertia = 5.0
[[support.joint]]
child = "frame"
kind = "revolute"
name = "foot"
axis = [0.0, 1.0, 0.0]
stiffness = 9e3
[[rotor]]
name = "main"
hub = { mass = 2.0, inertia = 0.3, drive = { kind = "constant", speed = 30.0 } }
axle = { body = "frame", offset = [1.0, 0.0, 0.5] }
[rotor.blade]
count = 3
length = 1.5
bodies = 1
elements = 2
[rotor.blade.sections]
mass_per_length = 1.0
axial_stiffness = 1e6
flap_stiffness = 500.0
lag_stiffness = 4e3
torsion_stiffness = 500.0
[[rotor]]
name = "tail"
hub = { axis = [0.0, 1.0, 0.0], mass = 1.0, inertia = 0.1, drive = { kind = "constant", speed = 90.0 } }
axle = { body = "frame", offset = [-2.0, 0.0, 0.0] }
[[hub_load]]
rotor = "tail"
frame = "inertial"
force = [0.0, 0.0, 45.0]
)";

}  // namespace

TEST_CASE("static and modes take several rotors, each at its own speed") {
  const WorkFolder folder;
  folder.write("two.toml", kTwoRotors);
  const Ended still = run_spoke(
      {"static", "two.toml", "--speed", "20", "--speed", "tail=-80", "--out", "s"}, folder);
  CHECK(still.status == 0);
  for (const char* part : {"Rotors: hubs from the support's base", "  main", "  tail", "-80"})
    CHECK(still.out.find(part) != std::string::npos);
  const json all = json::parse(file_text(folder.path() / "s" / "static.json"));
  CHECK(all["speed_rad_per_s"] == 20.0);
  REQUIRE(all["rotors"].size() == 2);
  CHECK(all["rotors"][1]["name"] == "tail");
  CHECK(all["rotors"][1]["speed_rad_per_s"] == -80.0);
  // The force at x = -2 turns the foot: 9000 times the angle is 2 x 45 times its cosine.
  double angle = 0.01;
  for (int k = 0; k < 5; ++k) angle = 0.01 * std::cos(angle);
  CHECK(std::abs(all["rotors"][1]["position_m"][2].get<double>() - 2.0 * std::sin(angle)) < 1e-9);
  const Ended modes = run_spoke({"modes", "two.toml", "--count", "8", "--out", "m"}, folder);
  CHECK(modes.status == 0);
  for (const char* part : {"main 30, tail 90 rad/s", "main: flap 1 collective"})
    CHECK(modes.out.find(part) != std::string::npos);
  const json found = json::parse(file_text(folder.path() / "m" / "modes.json"));
  CHECK(found["rotors"][0]["speed_rad_per_s"] == 30.0);
  CHECK(file_text(folder.path() / "m" / "modes.html").find("main 30, tail 90 rad/s") !=
        std::string::npos);
  const auto refused = [&](std::vector<std::string> speeds, const std::string& message) {
    std::vector<std::string> arguments = {"static", "two.toml"};
    for (const std::string& speed : speeds) arguments.insert(arguments.end(), {"--speed", speed});
    const Ended ended = run_spoke(arguments, folder);
    CHECK(ended.status == 2);
    CHECK(ended.err.find(message) != std::string::npos);
    CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
  };
  refused({"nose=3"}, "a speed is for the rotor \"nose\", expected one of \"main\", \"tail\"");
  refused({"tail=3", "tail=4"},
          "--speed: expected one speed of the rotor \"tail\", got another: tail=4");
  refused({"3", "4"}, "--speed: expected one speed without a name, got another: 4");
  refused({"tail="}, "--speed: expected a number from -1e30 to 1e30 [rad/s], got \"tail=\"");
  refused({"=4"}, "--speed: expected NAME=RAD_PER_S, got =4");
  refused({"3", "main=4"}, "a speed without a name and one for \"main\" are given");
}

TEST_CASE("linearize names signals of several rotors by theirs") {
  const WorkFolder folder;
  folder.write("two.toml", kTwoRotors);
  const Ended ended =
      run_spoke({"linearize", "two.toml", "--speed", "tail=-80", "--out", "l"}, folder);
  CHECK(ended.status == 0);
  CHECK(ended.out.find("main 30, tail -80 rad/s") != std::string::npos);
  const json all = json::parse(file_text(folder.path() / "l" / "linear.json"));
  CHECK(all["frame"] == "fixed");
  CHECK(all["rotors"][1] == json({{"name", "tail"}, {"speed_rad_per_s", -80.0}}));
  const auto has = [&](const char* list, const std::string& name) {
    return std::any_of(all[list].begin(), all[list].end(),
                       [&](const json& signal) { return signal["name"] == name; });
  };
  CHECK(has("inputs", "hub / force x"));
  CHECK(has("inputs", "tail.hub / force x"));
  CHECK(has("inputs", "tail.hub / hub_load.1"));
  CHECK(has("outputs", "rate of tail.hub / angle"));
  CHECK(has("outputs", "blades 1 to 3 / tip.z cosine"));
}
