// Hints at angles that look like degrees.

#include "models/reader/angle_hints.h"

#include "tests/models/reader/air_texts.h"
#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using spoke::test::edited;
using spoke::test::kAirText;
using spoke::test::kBladeText;
using spoke::test::kTreeText;

namespace {

std::vector<std::string> hints_of(const std::string& text) {
  return find_angle_hints(parse_scenario(text, "f.toml"));
}

using Hints = std::vector<std::string>;

/// Reads the blade's text with other keys in place of its twist, or of the damping of its hinge.
Hints with_twist(const std::string& keys) {
  return hints_of(edited(kBladeText, "twist = [0.2, 0.1, 0.0]\n", keys));
}
Hints with_hinge(const std::string& keys) {
  return hints_of(edited(kBladeText, "damping = 10.0\n", keys));
}

}  // namespace

TEST_CASE("angles of a usual size are not asked about") {
  CHECK(hints_of(kBladeText).empty());
  CHECK(hints_of(kTreeText).empty());
  CHECK(hints_of(edited(kBladeText, "count = 3\n", "count = 3\nprecone = -1.57\n")).empty());
  CHECK(with_twist("twist = [3.14, -3.14, 0.0]\n").empty());
  CHECK(with_hinge("rest = -6.28\ninitial = 6.28\norientation = [3, 3, 3]\n").empty());
}

TEST_CASE("each kind of angle beyond what it can be is asked about once, as of degrees") {
  CHECK(hints_of(edited(kBladeText, "count = 3\n", "count = 3\nprecone = -2.5\nazimuth = 90\n")) ==
        Hints{"the azimuth of blade 1 is 90 rad, beyond a turn of 2 pi: degrees?",
              "the precone of blade 1 is -2.5 rad, beyond a right angle, pi/2: degrees?"});
  CHECK(with_twist("twist = [3, 11, 12]\n") ==
        Hints{"the twist of blade 1 is 11 rad, beyond half a turn, pi: degrees?"});
  CHECK(with_hinge("rest = 7\ninitial = -8\norientation = [0, 30, 40]\nstop = { lower = -20, "
                   "upper = 20, stiffness = 1, width = 0.1 }\n") ==
        Hints{"the orientation of joint \"flap\" of blade 1 is 50 rad, beyond a turn of 2 pi: "
              "degrees?",
              "the rest of joint \"flap\" of blade 1 is 7 rad, beyond a turn of 2 pi: degrees?",
              "the initial of joint \"flap\" of blade 1 is -8 rad, beyond a turn of 2 pi: degrees?",
              "the stop.lower of joint \"flap\" of blade 1 is -20 rad, beyond a turn of 2 pi: "
              "degrees?",
              "the stop.upper of joint \"flap\" of blade 1 is 20 rad, beyond a turn of 2 pi: "
              "degrees?"});
  CHECK(hints_of(edited(kBladeText, "mean = 0.1", "mean = 8, cosine = 4, sine = -5")) ==
        Hints{"the mean of joint \"pitch\" of blade 1 is 8 rad, beyond half a turn, pi: degrees?",
              "the cosine of joint \"pitch\" of blade 1 is 4 rad, beyond half a turn, pi: degrees?",
              "the sine of joint \"pitch\" of blade 1 is -5 rad, beyond half a turn, pi: "
              "degrees?"});
  CHECK(hints_of(edited(kBladeText, "[gravity]\n",
                        "[hub.mount]\nrotation = { constant = [0, 0, 45] }\n[gravity]\n")) ==
        Hints{"the constant of the rotation of the hub's mount is 45 rad, beyond a turn of 2 pi: "
              "degrees?"});
}

TEST_CASE("a motion of several turns is asked about if it is in whole numbers") {
  const auto motion = [](const std::string& value) {
    return hints_of(edited(kBladeText, "motion = { mean = 0.1 }",
                           "motion = { time = [0, 1, 2], value = " + value + " }"));
  };
  CHECK(motion("[0, 45, 90]") ==
        Hints{"the motion of joint \"pitch\" of blade 1 is 45 rad, beyond a turn of 2 pi: "
              "degrees?"});
  CHECK(motion("[0, 15.7, 31.4]").empty());
  CHECK(motion("[0, 1, 2]").empty());
}

TEST_CASE("angles of subsystems are asked about by their names, ways of joints are not") {
  CHECK(hints_of(edited(kTreeText, "torsion_stiffness = 1e3\n",
                        "torsion_stiffness = 1e3\ntwist = 20\n")) ==
        Hints{"the twist of body \"boom\" of subsystem \"arm\" is 20 rad, beyond half a turn, pi: "
              "degrees?"});
  const std::string spherical = "kind = \"spherical\"\n";
  CHECK(hints_of(edited(kTreeText, spherical, spherical + "initial = [0, 90, 0]\n")) ==
        Hints{"the initial of joint 2 of subsystem \"arm\" is 90 rad, beyond a turn of 2 pi: "
              "degrees?"});
  const std::string prismatic = "kind = \"prismatic\"\naxis = [1, 0, 0]\ninitial = 90\n";
  CHECK(hints_of(edited(kTreeText, spherical, prismatic)).empty());
}

TEST_CASE("the twist of aerofoils and the limits of pitch are asked about") {
  CHECK(hints_of(kAirText).empty());
  CHECK(hints_of(edited(kAirText, "twist = [0.2, 0.1, 0.0]", "twist = [13.3, 5.0, 0.0]")) ==
        Hints{"the aerodynamics.twist of blade 1 is 13.3 rad, beyond half a turn, pi: degrees?"});
  Scenario scenario = parse_scenario(kAirText, "f.toml");
  scenario.space->pitch_control = PitchControl{.minimum = -0.1, .maximum = 1.57};
  CHECK(find_angle_hints(scenario).empty());
  scenario.space->pitch_control->maximum = 90.0;
  CHECK(find_angle_hints(scenario) ==
        Hints{"the maximum of [control.pitch] is 90 rad, beyond half a turn, pi: degrees?"});
}
