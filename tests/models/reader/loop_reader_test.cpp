// Values that the reader makes of closed loops and anchors, and how they are written back.

#include <doctest/doctest.h>

#include <string>

#include "models/reader/angle_hints.h"
#include "tests/models/inline_toml.h"
#include "tests/models/reader/loop_texts.h"
#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using doctest::Approx;
using spatial::Vector;
using spoke::test::document_of;
using spoke::test::edited;
using spoke::test::kBladeText;
using spoke::test::kLoopText;
using spoke::test::kPitchLinkText;
using spoke::test::kPlaneLoopText;
using Carrier = LoopPlace::Carrier;

namespace {

const std::string kFromBoom = "from = { body = \"boom\", station = 3.0 }";
const std::string kToHubPoint = "to = { body = \"hub\", point = [1, 0, 0] }";
const std::string kClosure =
    "kind = \"revolute\"\n" + kFromBoom + "\n" + kToHubPoint + "\naxis = [0, 1, 0]\n";

/// Reads kLoopText with other keys in place of those of its loop, but for the name.
Loop read_loop(const std::string& keys, const Overrides& overrides = {}) {
  const Scenario scenario =
      parse_scenario(edited(kLoopText, kClosure, keys + "\n"), "f.toml", overrides);
  return scenario.space.value().subsystems.at(0).loops.at(0);
}

/// Reads kLoopText with another motion of its anchor.
Anchor read_anchor(const std::string& keys) {
  const std::string motion = "motion = { rotation = { constant = [0.1, 0, 0] } }";
  return parse_scenario(edited(kLoopText, motion, keys), "f.toml").space.value().anchors.at(0);
}

const std::string kBodyPlaces = "from = { body = \"boom\" }\nto = { body = \"crank\" }\n";

/// Checks that what is written of a scenario is read as the same scenario.
void check_written(const std::string& text) {
  const std::string json = parse_scenario(text, "f").to_json();
  CAPTURE(json);
  std::string text_again = document_of(json);
  // Files have no empty lists of tables.
  for (const std::string empty : {"load = []\n", "sensor = []\n"})
    if (const auto at = text_again.find(empty); at != std::string::npos)
      text_again.erase(at, empty.size());
  CHECK(parse_scenario(text_again, "f").to_json() == json);
}

}  // namespace

TEST_CASE("a closed loop of a subsystem is read") {
  const Loop loop = read_loop(kClosure);
  CHECK(loop.name == "rod");
  CHECK(loop.kind == LoopKind::revolute);
  CHECK(loop.from.carrier == Carrier::body);
  CHECK(loop.from.name == "boom");
  CHECK(loop.from.station == 3.0);
  CHECK(loop.from.point == Vector(0, 0, 0));
  CHECK_FALSE(loop.from.orientation.has_value());
  CHECK(loop.to.carrier == Carrier::hub);
  CHECK(loop.to.name.empty());
  CHECK(loop.to.point == Vector(1, 0, 0));
  CHECK(loop.axes[0] == Vector(0, 1, 0));
  CHECK_FALSE(loop.length.has_value());
  CHECK(loop.stiffness.empty());
  CHECK(loop.damping.empty());
}

TEST_CASE("each kind of closure is read with its axes and springs") {
  struct Kind {
    const char* name;
    LoopKind kind;
    const char* axes;
    std::size_t locked;
  };
  const std::string axis = "axis = [0, 0, 2]";
  for (const Kind& kind :
       {Kind{"fixed", LoopKind::fixed, "", 6},
        Kind{"revolute", LoopKind::revolute, axis.c_str(), 5},
        Kind{"prismatic", LoopKind::prismatic, axis.c_str(), 5},
        Kind{"universal", LoopKind::universal, "axes = [[0, 0, 2], [0, 1, 0]]", 4},
        Kind{"spherical", LoopKind::spherical, "", 3},
        Kind{"cylindrical", LoopKind::cylindrical, axis.c_str(), 4},
        Kind{"bearing", LoopKind::bearing, axis.c_str(), 2},
        Kind{"distance", LoopKind::distance, "", 1}}) {
    CAPTURE(kind.name);
    const std::string keys =
        "kind = \"" + std::string(kind.name) + "\"\n" + kBodyPlaces + kind.axes;
    const Loop loop = read_loop(keys + "\nstiffness = 3e5\ndamping = 20");
    CHECK(loop.kind == kind.kind);
    if (count_axes(kind.kind) > 0) CHECK(loop.axes[0] == Vector(0, 0, 2));
    CHECK(loop.axes[1] == (count_axes(kind.kind) > 1 ? Vector(0, 1, 0) : Vector(0, 0, 0)));
    CHECK(loop.stiffness == std::vector<double>(kind.locked, 3e5));
    CHECK(loop.damping == std::vector<double>(kind.locked, 20.0));
    check_written(edited(kLoopText, kClosure, keys + "\nstiffness = 3e5\ndamping = 20\n"));
    check_written(edited(kLoopText, kClosure, keys + "\n"));
  }
}

TEST_CASE("a stiffness of 0 is a rigid closure, and dampers are beside springs") {
  const std::string spherical = "kind = \"spherical\"\n" + kBodyPlaces;
  CHECK(read_loop(spherical + "stiffness = 0\ndamping = 0").stiffness.empty());
  CHECK(read_loop(spherical + "stiffness = [0, 0, 0]").stiffness.empty());
  const Loop loop = read_loop(spherical + "stiffness = [1e5, 0, 2e5]\ndamping = 7");
  CHECK(loop.stiffness == std::vector<double>{1e5, 0, 2e5});
  CHECK(loop.damping == std::vector<double>{7, 0, 7});
  CHECK(read_loop(spherical + "stiffness = 1\ndamping = [1, 2, 3]").damping ==
        std::vector<double>{1, 2, 3});
}

TEST_CASE("places of loops are on bodies, the hub, the mount or an anchor") {
  const auto to = [](const std::string& text) {
    return read_loop("kind = \"spherical\"\nfrom = { body = \"boom\" }\nto = " + text).to;
  };
  CHECK(to("\"hub\"").carrier == Carrier::hub);
  CHECK(to("\"mount\"").carrier == Carrier::mount);
  CHECK(to("{ body = \"mount\", point = [0, 0, 1] }").carrier == Carrier::mount);
  CHECK(to("{ body = \"mount\", point = [0, 0, 1] }").point == Vector(0, 0, 1));
  const LoopPlace anchor = to("{ anchor = \"swashplate\", orientation = [0, 0, 0.5] }");
  CHECK(anchor.carrier == Carrier::anchor);
  CHECK(anchor.name == "swashplate");
  CHECK(anchor.orientation == Vector(0, 0, 0.5));
  const LoopPlace rigid = to("{ body = \"crank\", point = [0.5, 0, 1] }");
  CHECK(rigid.name == "crank");
  CHECK_FALSE(rigid.station.has_value());
  CHECK(rigid.point == Vector(0.5, 0, 1));
}

TEST_CASE("a point on a beam says its station, unless that is given") {
  const auto from = [](const std::string& text) {
    return read_loop("kind = \"spherical\"\nfrom = { body = \"boom\"" + text + " }\nto = \"hub\"")
        .from;
  };
  CHECK_FALSE(from("").station.has_value());
  CHECK(from(", point = [2.5, 0.1, 0.2]").station == 2.5);
  CHECK(from(", point = [2.5, 0.1, 0.2]").point == Vector(0, 0.1, 0.2));
  CHECK(from(", station = 2.5, point = [0.3, 0.1, 0.2]").station == 2.5);
  CHECK(from(", station = 2.5, point = [0.3, 0.1, 0.2]").point == Vector(0.3, 0.1, 0.2));
  for (const char* place : {"", ", point = [2.5, 0.1, 0.2]", ", station = 1, point = [1, 2, 3]"})
    check_written(
        edited(kLoopText, kFromBoom, "from = { body = \"boom\"" + std::string(place) + " }"));
}

TEST_CASE("a place at the tip of a beam and off its axis is written with its station") {
  Scenario scenario = parse_scenario(kLoopText, "f");
  LoopPlace& from = scenario.space->subsystems[0].loops[0].from;
  from.station.reset();
  from.point = {0.0, 0.1, 0.2};
  const Scenario read = parse_scenario(document_of(scenario.to_json()), "f");
  CHECK(read.space->subsystems[0].loops[0].from.station == 4.0);
  CHECK(read.space->subsystems[0].loops[0].from.point == Vector(0.0, 0.1, 0.2));
}

TEST_CASE("blades have the loops of their common table, or their own") {
  const Scenario alike = parse_scenario(kPitchLinkText, "f");
  REQUIRE(alike.space->blades.size() == 3);
  for (const spatial::Blade& blade : alike.space->blades) {
    REQUIRE(blade.loops.size() == 1);
    CHECK(blade.loops[0].from.name.empty());
    CHECK(blade.loops[0].from.station == 0.5);
    CHECK(blade.loops[0].from.point == Vector(0, 0.2, 0));
  }
  std::string own = edited(kPitchLinkText, "count = 3\n", "");
  own +=
      "[[blades]]\n[[blades]]\n[[blades.loop]]\nname = \"stay\"\nkind = \"distance\"\n"
      "length = 2.5\nfrom = {}\nto = \"hub\"\n";
  const Scenario apart = parse_scenario(own, "f");
  CHECK(apart.space->blades[0].loops[0].name == "pitch_link");
  REQUIRE(apart.space->blades[1].loops.size() == 1);
  CHECK(apart.space->blades[1].loops[0].name == "stay");
  CHECK(apart.space->blades[1].loops[0].length == 2.5);
  check_written(kPitchLinkText);
  check_written(own);
}

TEST_CASE("closed loops of the plane have two components and angles") {
  const Scenario scenario = parse_scenario(kPlaneLoopText, "f");
  REQUIRE(scenario.rotor.blades.size() == 2);
  REQUIRE(scenario.rotor.blades[1].loops.size() == 1);
  const Loop& loop = scenario.rotor.blades[1].loops[0];
  CHECK(loop.kind == LoopKind::prismatic);
  CHECK(loop.from.station == 4.0);
  CHECK(loop.to.point == Vector(1, 2, 0));
  CHECK(loop.to.orientation == Vector(0, 0, 0.5));
  CHECK(loop.axes[0] == Vector(1, 0, 0));
  const auto& motion = std::get<spatial::MountMotion>(scenario.rotor.anchors.at(0).motion);
  CHECK(std::get<spatial::VectorHarmonic>(motion.translation).rate == Vector(0.1, 0, 0));
  CHECK(std::get<spatial::VectorHarmonic>(motion.rotation).constant == Vector(0, 0, 0.2));
  check_written(kPlaneLoopText);
  const std::string kind = "kind = \"prismatic\"", axis = "axis = [1, 0]\n";
  for (const char* other : {"fixed", "revolute", "distance"}) {
    const std::string text =
        edited(edited(kPlaneLoopText, kind, "kind = \"" + std::string(other) + '"'), axis,
               "stiffness = 5\n");
    const std::string placed =
        other == std::string("distance") ? edited(text, ", orientation = 0.5", "") : text;
    const Loop read = parse_scenario(placed, "f").rotor.blades[0].loops.at(0);
    CHECK(name_of(read.kind) == other);
    CHECK(static_cast<int>(read.stiffness.size()) == count_locked_in_plane(read.kind));
    check_written(placed);
  }
  const Loop off =
      parse_scenario(edited(kPlaneLoopText, "station = 4.0", "point = [6.0, 0.1]"), "f")
          .rotor.blades[0]
          .loops[0];
  CHECK(off.from.station == 6.0);
  CHECK(off.from.point == Vector(0, 0.1, 0));
}

TEST_CASE("anchors move as mounts do, or as the program says") {
  const Anchor still = read_anchor("");
  CHECK(still.name == "swashplate");
  CHECK(still.frame == Anchor::Frame::mount);
  CHECK_FALSE(still.turns_with_hub);
  CHECK(std::holds_alternative<spatial::MountMotion>(still.motion));
  const std::string table = "motion = { translation = { time = [0, 1, 2], z = [0, 0.1, 0.1] } }";
  const auto moved = std::get<spatial::MountMotion>(read_anchor(table).motion);
  CHECK(std::get<spatial::VectorTable>(moved.translation).components[2].value(1.0) == 0.1);
  const Anchor said = read_anchor(
      "frame = \"hub\"\nmotion = { by = \"program\", translation = [1, 2, 3], rotation = [0, 0, "
      "0.5] "
      "}");
  CHECK(said.frame == Anchor::Frame::hub);
  CHECK(std::get<ProgramAnchorMotion>(said.motion).translation == Vector(1, 2, 3));
  CHECK(std::get<ProgramAnchorMotion>(said.motion).rotation == Vector(0, 0, 0.5));
  CHECK(
      std::get<ProgramAnchorMotion>(read_anchor("motion = { by = \"program\" }").motion).rotation ==
      Vector(0, 0, 0));
  const std::string motion = "motion = { rotation = { constant = [0.1, 0, 0] } }";
  for (const std::string& other :
       {std::string(), table, std::string("motion = { by = \"program\", rotation = [0, 0.1, 0] }"),
        std::string(
            "frame = \"hub\"\nmotion = { rotation = { amplitude = [1, 0, 0], frequency = 2 } "
            "}")})
    check_written(edited(kLoopText, motion, other));
  const std::string plane =
      "motion = { translation = { rate = [0.1, 0] }, rotation = { constant = 0.2 } }";
  for (const char* other : {"motion = { rotation = { time = [0, 1], value = [0, 0.5] } }",
                            "motion = { translation = { time = [0, 1], y = [0, 0.5] } }",
                            "motion = { by = \"program\", translation = [1, 2], rotation = 0.5 }"})
    check_written(edited(kPlaneLoopText, plane, other));
}

TEST_CASE("overrides reach into loops and anchors") {
  const Scenario scenario = parse_scenario(
      kPitchLinkText, "f",
      {"blade.loop.1.length=0.3", "blade.loop.1.from.point.2=0.25", "blade.loop.1.stiffness=1e6",
       "anchor.1.motion={by='program'}", "integration.loop_redundancy=1e-7"});
  const Loop& loop = scenario.space->blades[2].loops[0];
  CHECK(loop.length == 0.3);
  CHECK(loop.from.point.y() == 0.25);
  CHECK(loop.stiffness == std::vector<double>{1e6});
  CHECK(std::holds_alternative<ProgramAnchorMotion>(scenario.space->anchors[0].motion));
  CHECK(scenario.integration.loop_redundancy == 1e-7);
  CHECK(test::message_of(
            [] { parse_scenario(kPitchLinkText, "f", {"blade.loop.1.to.anchor=swashplat"}); }) ==
        "--set blade.loop.1.to.anchor=swashplat: blade.loop.1.to.anchor: is \"swashplat\", did you "
        "mean \"swashplate\"?");
  CHECK(parse_scenario(kLoopText, "f", {"subsystem.1.loop.1.to=mount"})
            .space->subsystems[0]
            .loops[0]
            .to.carrier == Carrier::mount);
}

TEST_CASE("what is said of loops is written only where there are some") {
  const std::string with = parse_scenario(kLoopText, "f").to_json();
  for (const char* key : {"\"loop\"", "\"anchor\"", "\"loop_redundancy\": 1e-09"})
    CHECK(with.find(key) != std::string::npos);
  const std::string without = parse_scenario(kBladeText, "f").to_json();
  for (const char* key : {"loop", "anchor"}) CHECK(without.find(key) == std::string::npos);
}

TEST_CASE("an anchor that no loop closes on is one to come") {
  const std::string text =
      edited(kLoopText, "[[subsystem]]", "[[anchor]]\nname = \"b\"\n[[subsystem]]");
  CHECK(parse_scenario(text, "f").space->anchors.size() == 2);
}

TEST_CASE("sensors name their loop, and are written back") {
  const std::string keys =
      "[[sensor]]\nquantity = \"loop_reaction\"\nname = \"link\"\nloop = \"pitch_link\"\n"
      "frame = \"hub\"\n[[sensor]]\nquantity = \"loop_opening\"\nblade = 2\nloop = "
      "\"pitch_link\"\n";
  const Scenario scenario = parse_scenario(kPitchLinkText + keys, "f");
  REQUIRE(scenario.sensors.size() == 2);
  CHECK(scenario.sensors[0].quantity == SensorQuantity::loop_reaction);
  CHECK(scenario.sensors[0].loop == "pitch_link");
  CHECK(frame_of(scenario.sensors[0]) == SensorFrame::hub);
  CHECK(frame_of(scenario.sensors[1]) == SensorFrame::loop);
  CHECK(prefix_of(scenario.sensors[1], 1) == "blade2.loop_opening");
  check_written(kPitchLinkText + keys);
  const std::string arm =
      "[[sensor]]\nquantity = \"loop_opening\"\nsubsystem = \"arm\"\nloop = \"rod\"\n";
  CHECK(parse_scenario(kLoopText + arm, "f").sensors[0].subsystem == "arm");
  check_written(kLoopText + arm);
  const std::string plane = "[[sensor]]\nquantity = \"loop_reaction\"\nloop = \"slider\"\n";
  CHECK(parse_scenario(kPlaneLoopText + plane, "f").sensors[0].loop == "slider");
  check_written(kPlaneLoopText + plane);
}

TEST_CASE("angles of loops and anchors beyond a turn are asked about") {
  const auto hints = [](const std::string& text) {
    return find_angle_hints(parse_scenario(text, "f"));
  };
  using Texts = std::vector<std::string>;
  CHECK(hints(kLoopText).empty());
  CHECK(hints(kPlaneLoopText).empty());
  CHECK(hints(edited(kLoopText, "point = [1, 0, 0]", "orientation = [0, 0, 90]")) ==
        Texts{"the orientation of loop \"rod\" of subsystem \"arm\" is 90 rad, beyond a turn of 2 "
              "pi: degrees?"});
  CHECK(hints(edited(kPlaneLoopText, "orientation = 0.5", "orientation = 45")) ==
        Texts{"the orientation of loop \"slider\" of blade 1 is 45 rad, beyond a turn of 2 pi: "
              "degrees?"});
  CHECK(hints(edited(kLoopText, "constant = [0.1, 0, 0]", "constant = [10, 0, 0]")) ==
        Texts{"the constant of the rotation of anchor \"swashplate\" is 10 rad, beyond a turn of 2 "
              "pi: degrees?"});
  CHECK(hints(edited(kLoopText, "{ rotation = { constant = [0.1, 0, 0] } }",
                     "{ by = \"program\", rotation = [0, 8, 0] }")) ==
        Texts{"the rotation of anchor \"swashplate\" is 8 rad, beyond a turn of 2 pi: degrees?"});
}
