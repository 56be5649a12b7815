// [damping] by direction and by mode: what is read, written, and refused.

#include "models/damping.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "models/reader/scenario_check.h"
#include "models/scenario.h"
#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using namespace spoke::test;

namespace {

Scenario with(const std::string& keys, const Overrides& overrides = {}) {
  return parse_scenario(
      edited(kBladeText, "[integration]\n", "[damping]\n" + keys + "[integration]\n"), "f.toml",
      overrides);
}

const std::string kPlanar = R"([hub]
[hub.drive]
kind = "constant"
speed = 1.0
[blade]
count = 1
length = 8.0
bodies = 1
elements = 2
density = 2766.67
area = 7.299e-5
second_moment = 8.214e-9
youngs_modulus = 6.895e10
[damping]
lag = 1e-3
[integration]
duration = 1.0
)";

/// A machine without beams.
const std::string kRigid = R"(world = "space"
[hub]
[hub.drive]
kind = "constant"
speed = 1.0
[[subsystem]]
name = "arm"
[[subsystem.body]]
name = "block"
kind = "rigid"
mass = 1.0
inertia = [1.0, 1.0, 1.0]
[[subsystem.joint]]
parent = "hub"
child = "block"
kind = "fixed"
[damping]
stiffness_factor = 1e-3
[integration]
duration = 1.0
)";

}  // namespace

TEST_CASE("damping by direction and by mode is read") {
  const Damping damping = with(
                              "stiffness_factor = 1e-4\nflap = 1e-3\ntorsion = 2e-3\n"
                              "lag_shear = 0\nratios = [0.01, 0]\nabove = 0.02\n")
                              .space->damping;
  CHECK(damping.stiffness_factor == 1e-4);
  CHECK(damping.directions == DirectionDamping{.flap = 1e-3, .torsion = 2e-3, .lag_shear = 0.0});
  CHECK(damping.modes == ModeDamping{.ratios = {0.01, 0.0}, .above = 0.02});
  CHECK(with("").space->damping.directions.is_zero());
  CHECK(with("ratios = [0.01]\n", {"damping.flap=0.5"}).space->damping.directions.flap == 0.5);
}

TEST_CASE("mu is BeamDyn's: two shears, stretch, bending in the edge and in flap, twist") {
  CHECK(with("mu = [1, 2, 3, 4, 5, 6]\n").space->damping.directions ==
        DirectionDamping{.flap = 5.0,
                         .lag = 4.0,
                         .axial = 3.0,
                         .torsion = 6.0,
                         .flap_shear = 1.0,
                         .lag_shear = 2.0});
}

TEST_CASE("damping is written as it is read") {
  const auto written = [](const Scenario& scenario) {
    std::string text = scenario.to_json();
    std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
    const auto from = text.find("\"damping\":{") + 10;
    return text.substr(from, text.find('}', from) + 1 - from);
  };
  CHECK(written(with("flap = 0.5\naxial = 0.25\nflap_shear = 0\nratios = [0.25, 0.5]\n")) ==
        R"({"mass_factor":0.0,"stiffness_factor":0.0,"flap":0.5,"axial":0.25,"flap_shear":0.0,)"
        R"("ratios":[0.25,0.5]})");
  CHECK(written(with("mu = [0, 2, 0, 4, 5, 0]\n")) ==
        R"({"mass_factor":0.0,"stiffness_factor":0.0,"flap":5.0,"lag":4.0,"flap_shear":0.0,)"
        R"("lag_shear":2.0})");
  CHECK(written(with("ratios = [0]\nabove = 0\n")) ==
        R"({"mass_factor":0.0,"stiffness_factor":0.0,"ratios":[0.0],"above":0.0})");
  CHECK(written(parse_scenario(kPlanar, "f.toml")) ==
        R"({"mass_factor":0.0,"stiffness_factor":0.0,"lag":0.001})");
  // Without these keys the text is that of before.
  CHECK(written(with("stiffness_factor = 1\n")) == R"({"mass_factor":0.0,"stiffness_factor":1.0})");
}

TEST_CASE("damping that cannot be is refused, in space") {
  const auto edit = [](const std::string& keys, const std::string& message) {
    return SpatialEdit{"[integration]\n", "[damping]\n" + keys + "[integration]\n", message};
  };
  check_edits(
      kBladeText,
      {edit("flap = -1e-3\n",
            "f.toml:34:8: damping.flap: is -0.001, expected a number of 0 or more (s)"),
       edit("lag = \"much\"\n",
            "f.toml:34:7: damping.lag: is \"much\", expected a number of 0 or more (s)"),
       edit("torsion = inf\n",
            "f.toml:34:11: damping.torsion: is inf, expected a finite number (s)"),
       edit("flapp = 1\n", "f.toml:34:1: damping.flapp: unknown key, did you mean \"flap\"?"),
       edit("mu = [1, 2, 3]\n",
            "f.toml:34:6: damping.mu: is an array (3), expected an array of 6 numbers (s)"),
       edit("mu = 1e-3\n", "f.toml:34:6: damping.mu: is 0.001, expected an array of 6 numbers (s)"),
       edit("mu = [1, 2, 3, 4, 5, -6]\n",
            "f.toml:34:22: damping.mu.6: is -6, expected a number of 0 or more (s)"),
       edit("mu = [1, 2, 3, 4, 5, 6]\nflap = 1\n",
            "f.toml:35:8: damping.flap: given along with mu, expected only one of them"),
       edit("mu = [1, 2, 3, 4, 5, 6]\nlag_shear = 0\n",
            "f.toml:35:13: damping.lag_shear: given along with mu, expected only one of them"),
       edit("ratios = 0.01\n",
            "f.toml:34:10: damping.ratios: is 0.01, expected an array of numbers"),
       edit("ratios = []\n",
            "f.toml:34:10: damping.ratios: is an empty array, expected an array of numbers"),
       edit("ratios = [0.01, -0.01]\n",
            "f.toml:34:17: damping.ratios.2: is -0.01, expected a number from 0 and less than 1"),
       edit("ratios = [0.01, 1.0]\n",
            "f.toml:34:17: damping.ratios.2: is 1.0, expected a number from 0 and less than 1"),
       edit("above = 0.01\n",
            "f.toml:34:9: damping.above: would be ignored, expected only along with ratios"),
       edit("ratios = [0.01]\nabove = 2\n",
            "f.toml:35:9: damping.above: is 2, expected a number from 0 and less than 1"),
       edit("ratios = [0.01]\nabove = [0.01]\n",
            "f.toml:35:9: damping.above: is an array (1), expected a number from 0 and less than "
            "1")});
  check_edits(kRigid, {{"stiffness_factor", "flap",
                        "f.toml:18:8: damping.flap: damps beams, of which there are none; expected "
                        "stiffness_factor, or damping of a solid"},
                       {"stiffness_factor = 1e-3", "mu = [0, 0, 0, 0, 1, 0]",
                        "f.toml:18:6: damping.mu: damps beams, of which there are none; expected "
                        "stiffness_factor, or damping of a solid"},
                       {"stiffness_factor = 1e-3", "ratios = [0.01]",
                        "f.toml:18:10: damping.ratios: damps beams, of which there are none; "
                        "expected stiffness_factor, or damping of a solid"}});
}

TEST_CASE("damping that cannot be is refused, in the plane") {
  check_edits(kPlanar, {{"lag = 1e-3", "flap = 1e-3",
                         "f.toml:15:8: damping.flap: belongs to models in space, expected lag "
                         "(bending) or axial of one in the plane"},
                        {"lag = 1e-3", "torsion = 1e-3",
                         "f.toml:15:11: damping.torsion: belongs to models in space, expected lag "
                         "(bending) or axial of one in the plane"},
                        {"lag = 1e-3", "lag_shear = 1e-3",
                         "f.toml:15:13: damping.lag_shear: belongs to models in space, expected "
                         "lag (bending) or axial of one in the plane"},
                        {"lag = 1e-3", "mu = [0, 0, 0, 0, 0, 0]",
                         "f.toml:15:6: damping.mu: belongs to models in space, expected lag "
                         "(bending) or axial of one in the plane"},
                        {"lag = 1e-3", "axial = -1",
                         "f.toml:15:9: damping.axial: is -1, expected a number of 0 or more (s)"},
                        {"lag = 1e-3", "ratios = [0, 0, 0, 0, 0, 0, 0]",
                         "f.toml:15:10: damping.ratios: has 7 values, expected at most 6, one for "
                         "each coordinate of the beam that has fewest"}});
}

TEST_CASE("damping of models made in code is checked alike") {
  const auto message = [](auto change) {
    Scenario scenario = parse_scenario(kPlanar, "f.toml");
    change(scenario.rotor.damping);
    return message_of([&] { check_scenario(scenario); });
  };
  CHECK(message([](Damping& d) { d.directions.axial = -1.0; }) ==
        "damping.axial: is -1, expected a number of 0 or more (s)");
  CHECK(message([](Damping& d) { d.directions.flap = 1.0; }) ==
        "damping.flap: belongs to models in space, expected lag (bending) or axial of one in the "
        "plane");
  CHECK(message([](Damping& d) {
          d.modes.ratios = {0.1, 2.0};
        }) == "damping.ratios.2: is 2, expected a number from 0 and less than 1");
  CHECK(message([](Damping& d) { d.modes.above = 0.1; }) ==
        "damping.above: would be ignored, expected only along with ratios");
  Scenario scenario = with("");
  scenario.space->damping.directions.lag_shear = -2.0;
  CHECK(message_of([&] { check_scenario(scenario); }) ==
        "damping.lag_shear: is -2, expected a number of 0 or more (s)");
}
