// Matrices of bearings as files and code have them: read, written again and refused.

#include "models/reader/bearing_reader.h"

#include <doctest/doctest.h>

#include <limits>
#include <string>

#include "models/reader/scenario_check.h"
#include "tests/message_of.h"
#include "tests/models/inline_toml.h"
#include "tests/models/reader/loop_texts.h"
#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using spoke::test::check_edits;
using spoke::test::document_of;
using spoke::test::edited;
using spoke::test::kLoopText;
using spoke::test::message_of;

namespace {

// Keys are on line 42.
const std::string kEndOfLoop = "[integration]\nduration";
std::string make_borne() {
  return edited(kLoopText, "kind = \"revolute\"\nfrom", "kind = \"bearing\"\nfrom");
}

std::string with(const std::string& keys) {
  return edited(make_borne(), kEndOfLoop, keys + "\n" + kEndOfLoop);
}

Loop read_bearing(const std::string& keys) {
  return parse_scenario(with(keys), "f.toml").space.value().subsystems.at(0).loops.at(0);
}

Eigen::Matrix2d rows_of(double xx, double xy, double yx, double yy) {
  Eigen::Matrix2d matrix;
  matrix << xx, xy, yx, yy;
  return matrix;
}

const std::string kConstant = "stiffness = [[5e7, -2], [3.5, 1e7]]\ndamping = [[0, 1], [-1, 0]]";
const std::string kDampingAlone = "damping = [[4, 0], [0, 0]]";
const std::string kByTable =
    "speed = [-10, 0.0, 100]\n"
    "stiffness = [[[1, 2], [3, 4]], [[5, 6], [7, 8]], [[9, 0], [0, -9]]]\n"
    "damping = [[[1, 0], [0, 1]], [[2, 0], [0, 2]], [[3, 0], [0, 3]]]";

}  // namespace

TEST_CASE("a bearing with numbers is rigid or sprung as other closures are") {
  CHECK(read_bearing("").kind == LoopKind::bearing);
  CHECK_FALSE(read_bearing("").matrices.has_value());
  const Loop sprung = read_bearing("stiffness = [1e6, 2e6]\ndamping = 30");
  CHECK(sprung.stiffness == std::vector<double>{1e6, 2e6});
  CHECK(sprung.damping == std::vector<double>{30, 30});
  CHECK_FALSE(sprung.matrices.has_value());
}

TEST_CASE("matrices of a bearing are read") {
  const BearingMatrices constant = read_bearing(kConstant).matrices.value();
  CHECK(constant.speed.empty());
  REQUIRE(constant.stiffness.size() == 1);
  CHECK(constant.stiffness[0] == rows_of(5e7, -2, 3.5, 1e7));
  REQUIRE(constant.damping.size() == 1);
  CHECK(constant.damping[0] == rows_of(0, 1, -1, 0));
  const BearingMatrices damped = read_bearing(kDampingAlone).matrices.value();
  CHECK(damped.stiffness.empty());
  CHECK(damped.damping.at(0) == rows_of(4, 0, 0, 0));
  const BearingMatrices table = read_bearing(kByTable).matrices.value();
  CHECK(table.speed == std::vector<double>{-10, 0, 100});
  REQUIRE(table.stiffness.size() == 3);
  CHECK(table.stiffness[1] == rows_of(5, 6, 7, 8));
  CHECK(table.stiffness[2] == rows_of(9, 0, 0, -9));
  CHECK(table.damping.at(2) == rows_of(3, 0, 0, 3));
}

TEST_CASE("what is written of a bearing is read as the same one") {
  for (const std::string& keys :
       {std::string(), std::string("stiffness = [1e6, 0]"), kConstant, kDampingAlone, kByTable,
        std::string("stiffness = [[0,0],[0,0]]")}) {
    const std::string json = parse_scenario(with(keys), "f").to_json();
    CAPTURE(json);
    CHECK(parse_scenario(document_of(json), "f").to_json() == json);
  }
}

TEST_CASE("matrices of a shape that cannot be are refused") {
  const std::string at = "f.toml:42:13: subsystem.1.loop.1.stiffness";
  const auto refused = [](const std::string& keys) {
    return message_of([&] { parse_scenario(with(keys), "f.toml"); });
  };
  const std::string expected = "expected a matrix [[xx, xy], [yx, yy]] (N/m)";
  CHECK(refused("stiffness = [[1, 2, 3], [4, 5, 6]]") == at + ": is an array (2), " + expected);
  CHECK(refused("stiffness = [[1, 2]]") == at + ": is an array (1), " + expected);
  CHECK(refused("stiffness = [[1, 2], 3]") == at + ": is an array (2), " + expected);
  CHECK(refused("stiffness = [[[1, 2], [3, 4]]]") == at + ": is an array (1), " + expected);
  CHECK(refused("stiffness = [[1, 2], [3, \"4\"]]") ==
        "f.toml:42:26: subsystem.1.loop.1.stiffness.2.2: is \"4\", expected a number (N/m)");
  CHECK(refused("stiffness = [[1, nan], [3, 4]]") ==
        "f.toml:42:18: subsystem.1.loop.1.stiffness.1.2: is nan, expected a finite number (N/m)");
  CHECK(refused("damping = [[1, 2], [inf, 4]]") ==
        "f.toml:42:21: subsystem.1.loop.1.damping.2.1: is inf, expected a finite number (N s/m)");
  CHECK(refused("stiffness = []") ==
        at + ": is an empty array, expected an array of 2 numbers (N/m)");
  CHECK(refused("stiffness = [[1, 2], [3, 4]]\ndamping = 5") ==
        "f.toml:43:11: subsystem.1.loop.1.damping: is given as numbers beside matrices, expected a "
        "matrix");
  CHECK(refused("stiffness = [5, 5]\ndamping = [[1, 2], [3, 4]]") ==
        at + ": is given as numbers beside matrices, expected a matrix");
}

TEST_CASE("tables of matrices that cannot be are refused") {
  const std::string two = "\nstiffness = [[[1, 2], [3, 4]], [[5, 6], [7, 8]]]";
  const auto refused = [](const std::string& keys) {
    return message_of([&] { parse_scenario(with(keys), "f.toml"); });
  };
  const std::string speed = "f.toml:42:9: subsystem.1.loop.1.speed: ";
  const std::string stiffness = "f.toml:43:13: subsystem.1.loop.1.stiffness: ";
  CHECK(refused("speed = [0, 100]") ==
        speed + "is given without matrices, expected stiffness, damping or both");
  CHECK(refused("speed = [0]\nstiffness = [[[1, 2], [3, 4]]]") ==
        speed + "has 1 number, expected 2 or more");
  CHECK(refused("speed = 5" + two) == speed + "is 5, expected an array of numbers (rad/s)");
  CHECK(refused("speed = [0, 0]" + two) ==
        "f.toml:42:13: subsystem.1.loop.1.speed.2: is 0, expected more than the value before it, "
        "0");
  CHECK(refused("speed = [0, inf]" + two) ==
        "f.toml:42:13: subsystem.1.loop.1.speed.2: is inf, expected a finite number (rad/s)");
  CHECK(refused("speed = [0, 1, 2]" + two) ==
        stiffness + "has 2 matrices, expected 3, one for each speed");
  CHECK(refused("speed = [0, 1]\nstiffness = [[1, 2], [3, 4]]") ==
        "f.toml:43:14: subsystem.1.loop.1.stiffness.1: is an array (2), expected a matrix "
        "[[xx, xy], [yx, yy]] (N/m)");
  CHECK(refused("speed = [0, 1]\nstiffness = 7") ==
        stiffness + "is 7, expected an array of matrices [[xx, xy], [yx, yy]] (N/m)");
  CHECK(refused("speed = [0, 1]\nstiffness = [[[1, 2, 3, 4]], [[5, 6], [7, 8]]]") ==
        "f.toml:43:14: subsystem.1.loop.1.stiffness.1: is an array (1), expected a matrix "
        "[[xx, xy], [yx, yy]] (N/m)");
}

TEST_CASE("matrices and speeds belong to bearings, whose place from has no orientation") {
  check_edits(
      kLoopText,
      {{kEndOfLoop, "stiffness = [[1, 2], [3, 4]]\n" + kEndOfLoop,
        "f.toml:42:13: subsystem.1.loop.1.stiffness: is a matrix, expected one only with kind "
        "\"bearing\""},
       {kEndOfLoop, "speed = [1, 2]\n" + kEndOfLoop,
        "f.toml:42:9: subsystem.1.loop.1.speed: does not belong to kind \"revolute\", expected "
        "only with kind \"bearing\""}});
  check_edits(make_borne(),
              {{"station = 3.0 }", "station = 3.0, orientation = [0, 0, 1] }",
                "f.toml:39:54: subsystem.1.loop.1.from.orientation: would be ignored, "
                "since kind \"bearing\" lets its places turn; expected none"}});
  check_edits(test::kPlaneLoopText,
              {{"kind = \"prismatic\"", "kind = \"bearing\"",
                "f.toml:17:8: blade.loop.1.kind: is \"bearing\", expected \"fixed\", "
                "\"revolute\", \"prismatic\" or \"distance\""}});
}

TEST_CASE("bearings that are filled in code are checked") {
  const Scenario sound = parse_scenario(with(kByTable), "f");
  CHECK_NOTHROW(check_scenario(sound));
  const auto refused = [&sound](auto change) {
    Scenario scenario = sound;
    change(scenario.space->subsystems[0].loops[0]);
    return message_of([&] { check_scenario(scenario); });
  };
  const std::string at = "subsystem.1.loop.1.";
  CHECK(refused([](Loop& loop) { loop.kind = LoopKind::cylindrical; }) ==
        at + "stiffness: is a matrix, expected one only with kind \"bearing\"");
  CHECK(refused([](Loop& loop) { loop.matrices->speed[1] = 200.0; }) ==
        at + "speed.3: is 100, expected more than the value before it, 200");
  CHECK(refused([](Loop& loop) { loop.matrices->damping.pop_back(); }) ==
        at + "damping: has 2 matrices, expected 3, one for each speed");
  CHECK(refused([](Loop& loop) { loop.matrices->speed.clear(); }) ==
        at + "stiffness: has 3 matrices, expected one, or speed with a value for each");
  CHECK(refused([](Loop& loop) {
          loop.matrices->stiffness[2](0, 1) = std::numeric_limits<double>::quiet_NaN();
        }) == at + "stiffness.3.1.2: is nan, expected a finite number (N/m)");
  CHECK(refused([](Loop& loop) { loop.matrices = BearingMatrices{}; }) ==
        at + "stiffness: has no matrix, nor has damping; expected one");
}
