#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "models/hints.h"
#include "models/scenario.h"

using namespace spoke;

namespace {

std::vector<std::string> tension_hints_at(const std::string& drive, const std::string& of_blade,
                                          const std::string& rest = "") {
  return find_hints(parse_scenario("world = \"space\"\n[hub.drive]\n" + drive +
                                       "[blade]\ncount = 1\nlength = 8.0\n" + of_blade +
                                       "[blade.sections]\nstation = [0.0, 8.0]\nmass_per_length = "
                                       "3.0\naxial_stiffness = 1e7\nflap_stiffness = "
                                       "1e3\nlag_stiffness = 9e3\ntorsion_stiffness = 1e3\n" +
                                       rest + "[integration]\nduration = 1.0\nstep = 0.01\n",
                                   "f.toml"));
}

constexpr const char* kTurningHub = "kind = \"constant\"\nspeed = 4.0\n";
constexpr const char* kLinearStrain = "strain = \"linear\"\n";

}  // namespace

TEST_CASE("linear strains are asked about where they miss tension") {
  CHECK(tension_hints_at(kTurningHub, kLinearStrain).empty());
  CHECK(tension_hints_at("kind = \"fixed\"\n", "").empty());
  CHECK(tension_hints_at("kind = \"fixed\"\n", "geometric_stiffening = false\n").empty());
  const std::string joint =
      "[[blade.joint]]\nname = \"flap\"\nstation = 0.5\nkind = \"revolute\"\naxis = [0, -1, 0]\n";
  CHECK(tension_hints_at(kTurningHub, "", joint).empty());
  CHECK(tension_hints_at(kTurningHub, kLinearStrain, joint) ==
        std::vector<std::string>{
            "the linear strains of blade 1 know the tension that rotation of the hub, gravity and "
            "loads put on the undeformed bodies, but joint flap moves it: give strain "
            "\"nonlinear\", or leave it to \"automatic\""});
  CHECK(tension_hints_at("kind = \"fixed\"\n", kLinearStrain).size() == 1);
  CHECK(tension_hints_at(kTurningHub, kLinearStrain, "mass_center = [[0.02, 0], [0.02, 0]]\n") ==
        std::vector<std::string>{
            "the sections of blade 1 have their centres beside its axis, where linear strains make "
            "torsion in rotation wrong: give strain \"nonlinear\", or leave it to \"automatic\""});
}

TEST_CASE("a solid that a joint moves is said to miss tension") {
  const auto hints = [](const std::string& joint) {
    Scenario scenario = parse_scenario(R"(world = "space"
[hub.drive]
kind = "constant"
speed = 4.0
[[subsystem]]
name = "s"
[[subsystem.body]]
name = "b"
kind = "rigid"
mass = 1.0
inertia = 1.0
[[subsystem.joint]]
parent = "hub"
child = "b"
)" + joint + "[integration]\nduration = 1.0\nstep = 0.01\n",
                                       "f.toml");
    scenario.space->subsystems[0].bodies[0].shape = spatial::SolidBody{};
    return find_hints(scenario);
  };
  CHECK(hints("kind = \"fixed\"\n").empty());
  CHECK(hints("kind = \"revolute\"\naxis = [0, 0, 1]\n") ==
        std::vector<std::string>{
            "the solid s / b knows the tension that rotation of the hub, gravity and loads put on "
            "the undeformed bodies, but a joint moves it: within it the tension by that is missed; "
            "cut it into several solids, or take a beam where it is slender"});
}
