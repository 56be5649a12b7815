// Messages for closed loops and anchors that cannot be.

#include <doctest/doctest.h>

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

const std::string kFrom = "from = { body = \"boom\", station = 3.0 }";
const std::string kTo = "to = { body = \"hub\", point = [1, 0, 0] }";
const std::string kKind = "kind = \"revolute\"\nfrom";
const std::string kAxis = "\naxis = [0, 1, 0]\n[integration]";
const std::string kEnd = "[integration]";

}  // namespace

TEST_CASE("names and kinds of closed loops that cannot be are refused") {
  check_edits(
      kLoopText,
      {
          {"name = \"rod\"\n", "",
           "f.toml:36:1: subsystem.1.loop.1.name: is missing, expected a name"},
          {"name = \"rod\"", "name = \"the rod\"",
           "f.toml:37:8: subsystem.1.loop.1.name: is \"the rod\", expected letters, digits, "
           "\"_\", \"-\" and \".\", 1 to 64 of them"},
          {kEnd,
           "[[subsystem.loop]]\nname = \"rod\"\nkind = \"distance\"\nfrom = { body = \"boom\" "
           "}\nto = \"hub\"\n[integration]",
           "f.toml:43:8: subsystem.1.loop.2.name: is \"rod\" as another loop's, expected a name "
           "of its own"},
          {kKind, "from",
           "f.toml:36:1: subsystem.1.loop.1.kind: is missing, expected \"fixed\", "
           "\"revolute\", \"prismatic\", \"universal\", \"spherical\", "
           "\"cylindrical\", \"bearing\" or \"distance\""},
          {kKind, "kind = \"hinge\"\nfrom",
           "f.toml:38:8: subsystem.1.loop.1.kind: is \"hinge\", expected \"fixed\", \"revolute\", "
           "\"prismatic\", \"universal\", \"spherical\", \"cylindrical\", \"bearing\" or "
           "\"distance\""},
          {"axis = [0, 1, 0]\n[integration]", "axes = [[0, 1, 0], [1, 0, 0]]\n[integration]",
           "f.toml:41:8: subsystem.1.loop.1.axes: does not belong to kind \"revolute\", expected "
           "only with kind \"universal\""},
          {kAxis, "\n[integration]",
           "f.toml:36:1: subsystem.1.loop.1.axis: is missing, expected an array of 3 numbers"},
          {kAxis, "\naxis = [0, 0, 0]\n[integration]",
           "f.toml:41:8: subsystem.1.loop.1.axis: has length 0, expected a direction"},
          {kAxis, "\naxis = [0, 1]\n[integration]",
           "f.toml:41:8: subsystem.1.loop.1.axis: is an array (2), expected an array of 3 "
           "numbers"},
          {kKind, "kind = \"spherical\"\nfrom",
           "f.toml:41:8: subsystem.1.loop.1.axis: does not belong to kind \"spherical\", expected "
           "only with kind \"revolute\", \"prismatic\", \"cylindrical\" or \"bearing\""},
          {kAxis, "\naxi = [0, 1, 0]\n[integration]",
           "f.toml:41:1: subsystem.1.loop.1.axi: unknown key, did you mean \"axis\"?"},
          {kAxis, kAxis.substr(0, 18) + "length = 1.0\n[integration]",
           "f.toml:42:10: subsystem.1.loop.1.length: does not belong to kind \"revolute\", "
           "expected only with kind \"distance\""},
      });
}

TEST_CASE("axes of a universal closure must be two that differ") {
  const std::string universal = edited(kLoopText, kKind, "kind = \"universal\"\nfrom");
  check_edits(
      universal,
      {
          {kAxis, "\naxes = [[0, 1, 0], [0, 2, 0]]\n[integration]",
           "f.toml:41:8: subsystem.1.loop.1.axes: are parallel, expected two directions "
           "that differ"},
          {kAxis, "\naxes = [[0, 1, 0], [0, 0, 0]]\n[integration]",
           "f.toml:41:20: subsystem.1.loop.1.axes.2: has length 0, expected a direction"},
          {kAxis, "\naxes = [[0, 1, 0]]\n[integration]",
           "f.toml:41:8: subsystem.1.loop.1.axes: is an array (1), expected 2 arrays of 3 "
           "numbers"},
          {kAxis, "\n[integration]",
           "f.toml:36:1: subsystem.1.loop.1.axes: is missing, expected an array of arrays of "
           "3 numbers"},
      });
}

TEST_CASE("places of closed loops that cannot be are refused") {
  check_edits(
      kLoopText,
      {
          {kFrom + "\n", "",
           "f.toml:36:1: subsystem.1.loop.1.from: is missing, expected \"hub\", "
           "\"mount\", or a table with body or anchor"},
          {kTo + "\n", "",
           "f.toml:36:1: subsystem.1.loop.1.to: is missing, expected \"hub\", "
           "\"mount\", or a table with body or anchor"},
          {kTo, "to = \"boom\"",
           "f.toml:40:6: subsystem.1.loop.1.to: is \"boom\", expected \"hub\", \"mount\", or a "
           "table with body or anchor"},
          {kTo, "to = [1, 0, 0]",
           "f.toml:40:6: subsystem.1.loop.1.to: is an array (3), expected \"hub\", \"mount\", or "
           "a table with body or anchor"},
          {kTo, "to = { bodi = \"crank\" }",
           "f.toml:40:8: subsystem.1.loop.1.to.bodi: unknown key, did you mean \"body\"?"},
          {kTo, "to = { point = [1, 0, 0] }",
           "f.toml:40:6: subsystem.1.loop.1.to.body: is missing, expected the name of a body, "
           "\"hub\" or \"mount\", or anchor"},
          {kTo, "to = { body = \"crnk\" }",
           "f.toml:40:15: subsystem.1.loop.1.to.body: is \"crnk\", did you mean \"crank\"?"},
          {kTo, "to = { body = \"mast\" }",
           "f.toml:40:15: subsystem.1.loop.1.to.body: is \"mast\", expected \"hub\", \"mount\", "
           "\"crank\" or \"boom\""},
          {kTo, "to = { body = \"table\" }",
           "f.toml:40:15: subsystem.1.loop.1.to.body: is \"table\", expected \"hub\", \"mount\", "
           "\"crank\" or \"boom\""},
          {kTo, "to = { anchor = \"swashplat\" }",
           "f.toml:40:17: subsystem.1.loop.1.to.anchor: is \"swashplat\", did you mean "
           "\"swashplate\"?"},
          {kTo, "to = { body = \"crank\", anchor = \"swashplate\" }",
           "f.toml:40:33: subsystem.1.loop.1.to.anchor: given along with body, expected only one "
           "of them"},
          {kTo, "to = { body = \"crank\", station = 0.5 }",
           "f.toml:40:34: subsystem.1.loop.1.to.station: would be ignored, expected only on a "
           "beam: give point"},
          {kTo, "to = { body = \"hub\", station = 0.5 }",
           "f.toml:40:32: subsystem.1.loop.1.to.station: would be ignored, expected only on a "
           "beam: give point"},
          {kTo, "to = { anchor = \"swashplate\", station = 0.5 }",
           "f.toml:40:41: subsystem.1.loop.1.to.station: would be ignored, expected only on a "
           "beam: give point"},
          {kTo, "to = { body = \"crank\", point = 1 }",
           "f.toml:40:32: subsystem.1.loop.1.to.point: is 1, expected an array of 3 numbers (m)"},
          {kTo, "to = { body = \"crank\", orientation = [1, nan, 0] }",
           "f.toml:40:42: subsystem.1.loop.1.to.orientation.2: is nan, expected a finite number "
           "(rad)"},
          {kFrom, "from = { body = \"boom\", station = 4.5 }",
           "f.toml:39:35: subsystem.1.loop.1.from.station: is 4.5, expected a number from 0 to 4 "
           "(m, from root to tip)"},
          {kFrom, "from = { body = \"boom\", station = -1 }",
           "f.toml:39:35: subsystem.1.loop.1.from.station: is -1, expected a number of 0 or more "
           "(m)"},
          {kFrom, "from = { body = \"boom\", point = [4.5, 0, 0.1] }",
           "f.toml:39:34: subsystem.1.loop.1.from.point.1: is 4.5, expected a number from 0 to 4 "
           "(m, from root to tip)"},
          {kFrom, "from = \"hub\"",
           "f.toml:39:8: subsystem.1.loop.1.from: is on no body, expected a place on one; what "
           "carries the other end belongs to \"to\""},
          {kFrom, "from = { anchor = \"swashplate\" }",
           "f.toml:39:8: subsystem.1.loop.1.from: is on no body, expected a place on one; what "
           "carries the other end belongs to \"to\""},
          {kTo, "to = { body = \"boom\", station = 3 }",
           "f.toml:40:6: subsystem.1.loop.1.to: is at the same station of the same beam as from, "
           "expected another place"},
          {kFrom + "\n" + kTo,
           "from = { body = \"crank\" }\nto = { body = \"crank\", point = [0, 0, 1] }",
           "f.toml:40:6: subsystem.1.loop.1.to: is on the same rigid body as from, expected a "
           "place that moves against it"},
      });
}

TEST_CASE("orientations and lengths that would be ignored are refused") {
  const std::string axis = "\naxis = [0, 1, 0]\n[integration]";
  const std::string distance =
      edited(edited(kLoopText, kKind, "kind = \"distance\"\nfrom"), axis, "\n[integration]");
  check_edits(
      distance,
      {
          {kFrom, "from = { body = \"boom\", orientation = [0, 0, 1] }",
           "f.toml:39:39: subsystem.1.loop.1.from.orientation: would be ignored, since kind "
           "\"distance\" lets its places turn; expected none"},
          {kTo, "to = { body = \"hub\", orientation = [0, 0, 1] }",
           "f.toml:40:36: subsystem.1.loop.1.to.orientation: would be ignored, since kind "
           "\"distance\" lets its places turn; expected none"},
          {kTo, "to = \"hub\"\nlength = 0",
           "f.toml:41:10: subsystem.1.loop.1.length: is 0, expected a number greater than 0 (m)"},
          {kTo, "to = \"hub\"\nlength = \"long\"",
           "f.toml:41:10: subsystem.1.loop.1.length: is \"long\", expected a number greater than "
           "0 (m)"},
      });
  check_edits(
      edited(edited(kLoopText, kKind, "kind = \"spherical\"\nfrom"), axis, "\n[integration]"),
      {{kFrom, "from = { body = \"boom\", orientation = [0, 0, 1] }",
        "f.toml:39:39: subsystem.1.loop.1.from.orientation: would be ignored, since kind "
        "\"spherical\" lets its places turn; expected none"}});
}

TEST_CASE("springs and dampers of closed loops that cannot be are refused") {
  check_edits(
      kLoopText,
      {
          {kEnd, "stiffness = -1\n[integration]",
           "f.toml:42:13: subsystem.1.loop.1.stiffness: is -1, expected a number of 0 or more "
           "(N/m, N m/rad)"},
          {kEnd, "stiffness = [1, 1, 1]\n[integration]",
           "f.toml:42:13: subsystem.1.loop.1.stiffness: is an array (3), expected an array of 5 "
           "numbers (N/m, N m/rad)"},
          {kEnd, "stiffness = [1, 1, 1, 1, -2]\n[integration]",
           "f.toml:42:26: subsystem.1.loop.1.stiffness.5: is -2, expected a number of 0 or more "
           "(N/m, N m/rad)"},
          {kEnd, "damping = 5\n[integration]",
           "f.toml:42:11: subsystem.1.loop.1.damping: is given without stiffness, expected both "
           "or none"},
          {kEnd, "stiffness = 0\ndamping = 5\n[integration]",
           "f.toml:43:11: subsystem.1.loop.1.damping: is given without stiffness, expected both "
           "or none"},
          {kEnd, "stiffness = [1, 0, 1, 1, 1]\ndamping = [1, 2, 1, 1, 1]\n[integration]",
           "f.toml:43:15: subsystem.1.loop.1.damping.2: is 2 in a direction without stiffness, "
           "which is rigid; expected 0"},
          {kEnd, "stiffness = 1\ndamping = \"much\"\n[integration]",
           "f.toml:43:11: subsystem.1.loop.1.damping: is \"much\", expected a number of 0 or more "
           "(N s/m, N m s/rad)"},
      });
}

TEST_CASE("a body that a loop names may not be called as what holds the axle") {
  std::string text = edited(kLoopText, "name = \"crank\"", "name = \"mount\"");
  text = edited(text, "child = \"crank\"", "child = \"mount\"");
  text = edited(text, "parent = \"crank\"", "parent = \"mount\"");
  CHECK_NOTHROW(parse_scenario(text, "f.toml"));
  check_edits(text, {{kTo, "to = { body = \"mount\" }",
                      "f.toml:40:6: subsystem.1.loop.1.to: is \"mount\", the name of a body and of "
                      "what holds the axle; expected another name of the body"}});
}

TEST_CASE("closed loops of a blade that cannot be are refused") {
  const std::string from = "from = { station = 0.5, point = [0, 0.2, 0] }";
  check_edits(
      kPitchLinkText,
      {
          {from, "from = { body = \"horn\" }",
           "f.toml:26:17: blade.loop.1.from.body: is \"horn\", but bodies of a blade have no "
           "names; expected station, a distance from the root, or \"hub\" or \"mount\""},
          {from, "from = { station = 9 }",
           "f.toml:26:20: blade.loop.1.from.station: is 9, expected a number from 0 to 8 (m, from "
           "root to tip)"},
          {"anchor = \"swashplate\", ", "anchor = \"plate\", ",
           "f.toml:27:17: blade.loop.1.to.anchor: is \"plate\", did you mean \"swashplate\"?"},
          {"[[anchor]]\nname = \"swashplate\"\nturns_with_hub = true\nmotion = { translation = { "
           "constant = [0, 0, -0.2] } }\n",
           "",
           "f.toml:23:17: blade.loop.1.to.anchor: is \"swashplate\", but there is no [[anchor]]"},
          {from, "from = 0.5",
           "f.toml:26:8: blade.loop.1.from: is 0.5, expected \"hub\", \"mount\", or a table with "
           "body, anchor or station"},
          {"[integration]", "[[blades]]\n[[blades]]\nloop = [{}]\n[integration]",
           "f.toml:10:9: blade.count: given along with [[blades]], expected only one of them"},
      });
  std::string own = edited(kPitchLinkText, "count = 3\n", "");
  own +=
      "[[blades]]\n[[blades]]\n[[blades.loop]]\nname = \"link\"\nkind = \"distance\"\n"
      "from = { station = -1 }\nto = \"hub\"\n";
  CHECK(test::message_of([&] { parse_scenario(own, "f.toml"); }) ==
        "f.toml:34:20: blades.2.loop.1.from.station: is -1, expected a number of 0 or more (m)");
}

TEST_CASE("closed loops of the plane that cannot be are refused") {
  const std::string from = "from = { station = 4.0 }", kind = "kind = \"prismatic\"";
  check_edits(
      kPlaneLoopText,
      {
          {kind, "kind = \"spherical\"",
           "f.toml:17:8: blade.loop.1.kind: is \"spherical\", expected \"fixed\", \"revolute\", "
           "\"prismatic\" or \"distance\""},
          {from, "from = { station = 3.0 }",
           "f.toml:18:20: blade.loop.1.from.station: is 3, expected 2 or a multiple of it up to 8 "
           "(m), where a body ends"},
          {from, "from = { station = 0 }",
           "f.toml:18:20: blade.loop.1.from.station: is 0, expected 2 or a multiple of it up to 8 "
           "(m), where a body ends"},
          {from, "from = { point = [3.0, 0.1] }",
           "f.toml:18:19: blade.loop.1.from.point.1: is 3, expected 2 or a multiple of it up to 8 "
           "(m), where a body ends"},
          {from, "from = { station = 10 }",
           "f.toml:18:20: blade.loop.1.from.station: is 10, expected a number from 0 to 8 (m, from "
           "root to tip)"},
          {"point = [1, 2]", "point = [1, 2, 0]",
           "f.toml:19:33: blade.loop.1.to.point: is an array (3), expected an array of 2 numbers "
           "(m)"},
          {"orientation = 0.5", "orientation = [0, 0, 0.5]",
           "f.toml:19:55: blade.loop.1.to.orientation: is an array (3), expected a number (rad)"},
          {"axis = [1, 0]", "axis = [0, 0]",
           "f.toml:20:8: blade.loop.1.axis: has length 0, expected a direction"},
          {"axis = [1, 0]\n", "",
           "f.toml:15:1: blade.loop.1.axis: is missing, expected an array of 2 numbers"},
          {kind, "kind = \"revolute\"",
           "f.toml:20:8: blade.loop.1.axis: does not belong to kind \"revolute\", expected only "
           "with kind \"prismatic\""},
          {"axis = [1, 0]", "axes = [[1, 0], [0, 1]]",
           "f.toml:20:1: blade.loop.1.axes: unknown key, did you mean \"axis\"?"},
          {"axis = [1, 0]", "axis = [1, 0]\nstiffness = [1, 2, 3]",
           "f.toml:21:13: blade.loop.1.stiffness: is an array (3), expected an array of 2 numbers "
           "(N/m, N m/rad)"},
          {"rotation = { constant = 0.2 }", "rotation = { constant = [0, 0, 0.2] }",
           "f.toml:7:71: anchor.1.motion.rotation.constant: is an array (3), expected a number "
           "(rad)"},
          {"rate = [0.1, 0]", "rate = [0.1, 0, 0]",
           "f.toml:7:35: anchor.1.motion.translation.rate: is an array (3), expected an array of 2 "
           "numbers (m/s)"},
          {"support = \"axle\"", "support = \"free\"\nmass = 1",
           "f.toml:6:1: anchor.1.frame: is \"mount\", which a free hub has not; expected \"hub\""},
      });
}
