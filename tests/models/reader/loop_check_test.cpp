// Closed loops and anchors that are filled in code are refused for the faults for which a file is.

#include <doctest/doctest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "models/reader/scenario_check.h"
#include "tests/message_of.h"
#include "tests/models/reader/loop_texts.h"

using namespace spoke;
using spatial::Vector;
using spoke::test::message_of;

namespace {

struct LoopCase {
  std::function<void(Scenario&)> change;
  std::string message;
};

void check_changes(const std::string& text, const std::vector<LoopCase>& cases) {
  const Scenario sound = parse_scenario(text, "f");
  CHECK_NOTHROW(check_scenario(sound));
  for (const LoopCase& c : cases) {
    Scenario scenario = sound;
    c.change(scenario);
    CHECK(message_of([&] { check_scenario(scenario); }) == c.message);
  }
}

Loop& rod(Scenario& s) { return s.space->subsystems[0].loops[0]; }
Loop& link(Scenario& s) { return s.space->blades[1].loops[0]; }
Loop& slider(Scenario& s) { return s.rotor.blades[1].loops[0]; }

}  // namespace

TEST_CASE("closed loops of subsystems that are filled in code are checked") {
  const std::string at = "subsystem.1.loop.1.";
  check_changes(
      test::kLoopText,
      {
          {[](Scenario& s) { rod(s).name.clear(); },
           at + "name: is \"\", expected letters, digits, \"_\", \"-\" and \".\", 1 to 64 of them"},
          {[](Scenario& s) {
             Loop other = rod(s);
             other.from.station = 2.0;
             s.space->subsystems[0].loops.push_back(other);
           },
           "subsystem.1.loop.2.name: is \"rod\" as another loop's, expected a name of its own"},
          {[](Scenario& s) { rod(s).from.carrier = LoopPlace::Carrier::mount; },
           at + "from: is on no body, expected a place on one; what carries the other end belongs "
                "to \"to\""},
          {[](Scenario& s) { rod(s).from.name = "bom"; },
           at + "from.body: is \"bom\", did you mean \"boom\"?"},
          {[](Scenario& s) { rod(s).from.station = -1.0; },
           at + "from.station: is -1, expected a number from 0 to 4 (m, from root to tip)"},
          {[](Scenario& s) { rod(s).to.point.x() = std::numeric_limits<double>::infinity(); },
           at + "to.point.1: is inf, expected a finite number (m)"},
          {[](Scenario& s) { rod(s).axes[0].setZero(); },
           at + "axis: has length 0, expected a direction"},
          {[](Scenario& s) { rod(s).length = 1.0; },
           at + "length: does not belong to kind \"revolute\", expected only with kind "
                "\"distance\""},
          {[](Scenario& s) {
             rod(s).stiffness = {1.0, 2.0};
           },
           at + "stiffness: has 2 numbers, expected 5, one for each direction that is locked"},
          {[](Scenario& s) {
             rod(s).stiffness = {1.0, 2.0, 0.0, 3.0, -4.0};
           },
           at + "stiffness.5: is -4, expected a number of 0 or more (N m/rad)"},
          {[](Scenario& s) {
             rod(s).stiffness = {1.0, 2.0, 0.0, 3.0, 4.0};
             rod(s).damping = {0.0, 0.0, 1.0, 0.0, 0.0};
           },
           at + "damping.3: is 1 in a direction without stiffness, which is rigid; expected 0"},
          {[](Scenario& s) {
             rod(s).kind = LoopKind::spherical;
             rod(s).from.orientation = Vector(0, 0, 1);
           },
           at +
               "from.orientation: would be ignored, since kind \"spherical\" lets its places turn; "
               "expected none"},
          {[](Scenario& s) { s.integration.spectral_radius = 1.0; },
           "integration.spectral_radius: is 1, expected at most 0.95 with rigid closed loops, "
           "whose forces oscillate from step to step above it"},
          {[](Scenario& s) { s.integration.loop_redundancy = 0.0; },
           "integration.loop_redundancy: is 0, expected a number greater than 0 and less than 1"},
      });
}

TEST_CASE("closed loops of blades and anchors that are filled in code are checked") {
  check_changes(
      test::kPitchLinkText,
      {
          {[](Scenario& s) { link(s).from.name = "horn"; },
           "blades.2.loop.1.from.body: is \"horn\", but bodies of a blade have no names; expected "
           "station, a distance from the root, or \"hub\" or \"mount\""},
          {[](Scenario& s) { link(s).to.name = "plate"; },
           "blades.2.loop.1.to.anchor: is \"plate\", did you mean \"swashplate\"?"},
          {[](Scenario& s) { s.space->anchors.push_back(s.space->anchors[0]); },
           "anchor.2.name: is \"swashplate\" as another anchor's, expected a name of its own"},
          {[](Scenario& s) { s.space->anchors[0].frame = Anchor::Frame::hub; },
           "anchor.1.turns_with_hub: is true in the frame \"hub\", which turns with the hub "
           "itself; expected it only with frame = \"mount\" or \"axle\""},
          {[](Scenario& s) {
             ProgramAnchorMotion motion;
             motion.rotation.y() = 1e99;
             s.space->anchors[0].motion = motion;
           },
           "anchor.1.motion.rotation.2: is 1e+99, expected 0 or a magnitude from 1e-40 to 1e+30 "
           "(rad)"},
      });
}

TEST_CASE("closed loops of the plane that are filled in code stay in it") {
  const std::string at = "blades.2.loop.1.";
  check_changes(
      test::kPlaneLoopText,
      {
          {[](Scenario& s) { slider(s).kind = LoopKind::universal; },
           at + "kind: is \"universal\", which is none in the plane; expected \"fixed\", "
                "\"revolute\", \"prismatic\" or \"distance\""},
          {[](Scenario& s) { slider(s).from.station = 5.0; },
           at + "from.station: is 5, expected 2 or a multiple of it up to 8 (m), where a body "
                "ends"},
          {[](Scenario& s) { slider(s).to.point.z() = 1.0; },
           at + "to.point: leaves the plane, expected z = 0"},
          {[](Scenario& s) { slider(s).to.orientation = Vector(1, 0, 0); },
           at + "to.orientation: leaves the plane, expected a rotation about z"},
          {[](Scenario& s) { slider(s).axes[0] = Vector(0, 0, 1); },
           at + "axis: leaves the plane, expected z = 0"},
          {[](Scenario& s) {
             std::get<spatial::VectorHarmonic>(
                 std::get<spatial::MountMotion>(s.rotor.anchors[0].motion).translation)
                 .constant.z() = 1.0;
           },
           "anchor.1.motion.translation: leaves the plane, expected z = 0"},
          {[](Scenario& s) {
             s.rotor.anchors[0].motion = ProgramAnchorMotion{Vector(0, 0, 0), Vector(1, 0, 0)};
           },
           "anchor.1.motion.rotation: leaves the plane, expected a rotation about z"},
          {[](Scenario& s) {
             s.rotor.hub.support = HubSupport::free;
             s.rotor.hub.mass = 1.0;
           },
           "anchor.1.frame: is \"mount\", which a free hub has not; expected \"hub\""},
      });
}
