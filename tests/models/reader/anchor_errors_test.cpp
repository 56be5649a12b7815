// Messages for anchors that cannot be, and for what else a scenario says of closed loops.

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "tests/models/reader/loop_texts.h"
#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using spoke::test::check_edits;
using spoke::test::edited;
using spoke::test::kLoopText;
using spoke::test::kPitchLinkText;
using spoke::test::kPlaneLoopText;

namespace {

const std::string kToHub = "to = { body = \"hub\", point = [1, 0, 0] }";
const std::string kIntegration = "[integration]";

}  // namespace

TEST_CASE("anchors that cannot be are refused") {
  const std::string name = "name = \"swashplate\"\n";
  const std::string motion = "motion = { rotation = { constant = [0.1, 0, 0] } }";
  check_edits(
      kLoopText,
      {
          {name, "", "f.toml:7:1: anchor.1.name: is missing, expected a name"},
          {name, "name = \"a b\"\n",
           "f.toml:8:8: anchor.1.name: is \"a b\", expected letters, digits, \"_\", \"-\" and "
           "\".\", 1 to 64 of them"},
          {name, name + "frame = \"inertial\"\n",
           "f.toml:9:9: anchor.1.frame: is \"inertial\", expected \"mount\", \"hub\", \"axle\", or "
           "the name of a body along with subsystem"},
          {name, name + "frame = \"axle\"\n",
           "f.toml:9:9: anchor.1.frame: is \"axle\", which belongs to a hub on a support; expected "
           "\"mount\" or \"hub\""},
          {name, name + "rotor = \"tail\"\n",
           "f.toml:9:9: anchor.1.rotor: is \"tail\", but there is no [[rotor]]"},
          {name, name + "frame = \"hub\"\nturns_with_hub = true\n",
           "f.toml:10:18: anchor.1.turns_with_hub: is true in the frame \"hub\", which turns with "
           "the hub itself; expected it only with frame = \"mount\" or \"axle\""},
          {name, name + "turns_with_hub = 1\n",
           "f.toml:9:18: anchor.1.turns_with_hub: is 1, expected true or false"},
          {name, name + "turn_with_hub = true\n",
           "f.toml:9:1: anchor.1.turn_with_hub: unknown key, did you mean \"turns_with_hub\"?"},
          {motion, "motion = {}",
           "f.toml:9:10: anchor.1.motion: has none of translation, rotation and by, expected one "
           "or more"},
          {motion, "motion = { by = \"hand\" }",
           "f.toml:9:17: anchor.1.motion.by: is \"hand\", expected \"program\""},
          {motion, "motion = { by = \"program\", translation = [0, 1] }",
           "f.toml:9:42: anchor.1.motion.translation: is an array (2), expected an array of 3 "
           "numbers (m)"},
          {motion, "motion = { rotation = [0, 1, 0] }",
           "f.toml:9:23: anchor.1.motion.rotation: is an array (3), expected a table "
           "[anchor.1.motion.rotation]"},
          {motion, "motion = { rotation = { amplitude = [0.1, 0, 0] } }",
           "f.toml:9:23: anchor.1.motion.rotation.frequency: is missing, expected a number "
           "(rad/s)"},
          {motion, "motion = { translation = { time = [0, 1], z = [0, 1, 2] } }",
           "f.toml:9:47: anchor.1.motion.translation.z: has 3 numbers, expected 2, one for each of "
           "anchor.1.motion.translation.time"},
          {"[[subsystem]]", "[[anchor]]\nname = \"swashplate\"\n[[subsystem]]",
           "f.toml:11:8: anchor.2.name: is \"swashplate\" as another anchor's, expected a name of "
           "its own"},
          {"[[anchor]]\n", "[anchor]\n",
           "f.toml:7:1: anchor: is a table, expected tables headed [[anchor]]"},
      });
}

TEST_CASE("a free hub has no mount that loops could close on") {
  const std::string hub = "radius = 0.1\n[hub.drive]\nkind = \"constant\"\nspeed = 4.0\n";
  const std::string free = edited(kLoopText, hub, "support = \"free\"\nmass = 1\ninertia = 1\n");
  check_edits(free,
              {{"motion", "motion",
                "f.toml:6:1: anchor.1.frame: is \"mount\", which a free hub has not; expected "
                "\"hub\""}});
  const std::string on_hub =
      edited(free, "name = \"swashplate\"\n", "name = \"swashplate\"\nframe = \"hub\"\n");
  CHECK_NOTHROW(parse_scenario(on_hub, "f.toml"));
  check_edits(on_hub, {{kToHub, "to = \"mount\"",
                        "f.toml:40:6: subsystem.1.loop.1.to: is \"mount\", which a free hub has "
                        "not; expected \"hub\" or a body"},
                       {kToHub, "to = { body = \"mount\", point = [1, 0, 0] }",
                        "f.toml:40:6: subsystem.1.loop.1.to: is \"mount\", which a free hub has "
                        "not; expected \"hub\" or a body"}});
}

TEST_CASE("a spectral radius at which forces of rigid closures oscillate is refused") {
  const std::string told =
      "expected at most 0.95 with rigid closed loops, whose forces oscillate from step to step "
      "above it";
  const std::string duration = "duration = 20.0";
  for (const std::string& text : {kLoopText, kPitchLinkText, kPlaneLoopText}) {
    CHECK_NOTHROW(
        parse_scenario(edited(text, duration, duration + "\nspectral_radius = 0.95"), "f"));
    CHECK_NOTHROW(parse_scenario(
        edited(text, duration, duration + "\nspectral_radius = 1\nmethod = \"rk4\""), "f"));
    const auto line = std::to_string(std::count(text.begin(), text.end(), '\n') + 1);
    check_edits(text, {{duration, duration + "\nspectral_radius = 0.96",
                        "f.toml:" + line + ":19: integration.spectral_radius: is 0.96, " + told}});
  }
  const std::string soft = edited(kLoopText, kIntegration, "stiffness = 1e5\n[integration]");
  CHECK_NOTHROW(parse_scenario(edited(soft, duration, duration + "\nspectral_radius = 1"), "f"));
  check_edits(edited(soft, "stiffness = 1e5", "stiffness = [1e5, 0, 1e5, 1e3, 1e3]"),
              {{duration, duration + "\nspectral_radius = 1",
                "f.toml:45:19: integration.spectral_radius: is 1, " + told}});
}

TEST_CASE("the share at which rows of loops are redundant lies between 0 and 1") {
  check_edits(kLoopText,
              {{"duration = 20.0", "duration = 20.0\nloop_redundancy = 0",
                "f.toml:44:19: integration.loop_redundancy: is 0, expected a number greater than 0 "
                "and less than 1"},
               {"duration = 20.0", "duration = 20.0\nloop_redundancy = 1.0",
                "f.toml:44:19: integration.loop_redundancy: is 1.0, expected a number greater than "
                "0 and less than 1"}});
}

TEST_CASE("sensors of closed loops that cannot be are refused") {
  const auto with = [](const std::string& keys) {
    return "[[sensor]]\nquantity = \"loop_reaction\"\n" + keys + "\n[integration]";
  };
  const std::string arm = "subsystem = \"arm\"\n";
  check_edits(kLoopText,
              {{kIntegration, with(arm),
                "f.toml:42:1: sensor.1.loop: is missing, expected the name of a loop"},
               {kIntegration, with(arm + "loop = \"rad\""),
                "f.toml:45:8: sensor.1.loop: is \"rad\", did you mean \"rod\"?"},
               {kIntegration, with(arm + "loop = \"rod\"\nbody = \"boom\""),
                "f.toml:46:8: sensor.1.body: does not belong to quantity \"loop_reaction\", "
                "expected the subsystem alone"},
               {kIntegration, with(arm + "loop = \"rod\"\nposition = 1"),
                "f.toml:46:12: sensor.1.position: does not belong to quantity \"loop_reaction\", "
                "expected only with quantity \"displacement\", \"velocity\", \"acceleration\", "
                "\"section_force\", \"air_flow\", \"air_load\" or \"wind\""},
               {kIntegration, with(arm + "loop = \"rod\"\nframe = \"section\""),
                "f.toml:46:9: sensor.1.frame: is \"section\", expected \"loop\", \"blade\", "
                "\"hub\" or \"inertial\""},
               {kIntegration, "[[sensor]]\nquantity = \"velocity\"\nloop = \"rod\"\n[integration]",
                "f.toml:44:8: sensor.1.loop: does not belong to quantity \"velocity\", expected "
                "only with quantity \"loop_reaction\" or \"loop_opening\""}});
  check_edits(kPitchLinkText,
              {{kIntegration, with("loop = \"pitch_lnk\""),
                "f.toml:30:8: sensor.1.loop: is \"pitch_lnk\", did you mean \"pitch_link\"?"}});
  check_edits(kPlaneLoopText,
              {{kIntegration, with(""),
                "f.toml:21:1: sensor.1.loop: is missing, expected the name of a "
                "loop"},
               {kIntegration, with("loop = \"slide\"\nblade = 2"),
                "f.toml:23:8: sensor.1.loop: is \"slide\", did you mean \"slider\"?"}});
  check_edits(test::kBladeText,
              {{kIntegration, with("loop = \"rod\""),
                "f.toml:35:8: sensor.1.loop: is \"rod\", but the sensor is where there is no "
                "[[blade.loop]]"}});
}

TEST_CASE("an anchor in the plane is beside no rotor") {
  check_edits(kPlaneLoopText,
              {{"name = \"cart\"\n", "name = \"cart\"\nrotor = \"tail\"\n",
                "f.toml:7:9: anchor.1.rotor: names a rotor in space, expected none in the plane"}});
}
