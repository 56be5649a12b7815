// Messages for winds that cannot be.

#include <doctest/doctest.h>

#include <cstdint>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "tests/models/air/bts_bytes.h"
#include "tests/models/reader/check_message.h"
#include "tests/models/reader/wind_texts.h"
#include "tests/temporary_folder.h"

using namespace spoke;
using spoke::test::check_message;
using spoke::test::message_of;
using spoke::test::read_wind_text;

namespace {

struct Case {
  std::string keys, message;
};

void check_keys(const std::vector<Case>& cases) {
  for (const Case& of : cases) {
    CAPTURE(of.keys);
    check_message(message_of([&] { read_wind_text("[wind]\n" + of.keys); }),
                  "f.toml:" + of.message);
  }
}

/// Checks the message for a file of this content, without the folder.
void check_file(const char* name, const std::string& content, const std::string& expected,
                const std::string& keys = "") {
  CAPTURE(expected);
  const test::TemporaryFolder folder;
  std::ofstream(folder / name, std::ios::binary) << content;
  std::string message = message_of([&] {
    read_wind_text("[wind]\n" + keys + "file = \"" + name + "\"\n", folder.path().string());
  });
  const std::string path = folder.path().string() + '/';
  for (std::size_t at; (at = message.find(path)) != std::string::npos;)
    message.erase(at, path.size());
  check_message(message, expected);
}

/// Returns a file of TurbSim with other bytes at a place.
template <class Value>
std::string bts_with(std::size_t place, Value value) {
  std::string bytes = test::BtsBytes().make();
  std::string put;
  test::BtsBytes::put(value, put);
  return bytes.replace(place, put.size(), put);
}

}  // namespace

TEST_CASE("mean winds that cannot be are refused") {
  check_keys({
      {"velocity = 8", "2:12: wind.velocity: is 8, expected an array of 3 numbers (m/s)"},
      {"velocity = [8, 0]",
       "2:12: wind.velocity: is an array (2), expected an array of 3 numbers (m/s)"},
      {"velocity = [inf, 0, 0]", "2:13: wind.velocity.1: is inf, expected a finite number (m/s)"},
      {"speeds = 8", "2:1: wind.speeds: unknown key, did you mean \"speed\"?"},
      {"time = [0, 1]", "1:1: wind.speed: is missing, expected an array of numbers (m/s)"},
      {"speed = [0, 1]", "1:1: wind.time: is missing, expected an array of numbers (s)"},
      {"time = [0, 1]\nspeed = [4]",
       "3:9: wind.speed: has 1 number, expected 2, one for each of wind.time"},
      {"time = [0, 0]\nspeed = [4, 5]",
       "2:12: wind.time.2: is 0, expected more than the value before it, 0"},
      {"velocity = [8, 0, 0]\nshear_exponent = 0.2",
       "1:1: wind.reference_height: is missing, expected the height at which velocity is (m), for "
       "shear_exponent"},
      {"velocity = [8, 0, 0]\nshear_exponent = 1.2\nreference_height = 90",
       "3:18: wind.shear_exponent: is 1.2, expected a number from 0 to 1"},
      {"velocity = [8, 0, 0]\nshear_exponent = -0.1\nreference_height = 90",
       "3:18: wind.shear_exponent: is -0.1, expected a number from 0 to 1"},
      {"velocity = [8, 0, 0]\nreference_height = 0",
       "3:20: wind.reference_height: is 0, expected a number greater than 0 (m)"},
      {"velocity = [0, 0, -8]\nshear_exponent = 0.2\nreference_height = 90",
       "2:12: wind.velocity: is along up, expected a wind across it, which has a profile of "
       "heights"},
      {"up = [0, 0, 0]", "2:6: wind.up: has length 0, expected a direction"},
      {"up = \"z\"", "2:6: wind.up: is \"z\", expected an array of 3 numbers"},
      {"ground = true", "2:10: wind.ground: is true, expected a number (m)"},
      {"by = \"me\"", "2:6: wind.by: is \"me\", expected \"program\""},
      {"by = \"program\"\nvelocity = [8, 0, 0]",
       "2:6: wind.by: is \"program\", which gives all of the wind, expected no other key"},
      {"gust = { start = 3 }", "2:8: wind.gust.amplitude: is missing, expected a number"},
      {"gust = { amplitude = 3, duration = 0 }",
       "2:36: wind.gust.duration: is 0, expected a number greater than 0 (s)"},
      {"gust = { amplitude = 3, shape = \"round\" }",
       "2:33: wind.gust.shape: is \"round\", expected \"one_minus_cosine\", \"operating\" or "
       "\"rise\""},
      {"velocity = [8, 0, 0]\nvertical_shear = 0.01",
       "1:1: wind.reference_height: is missing, expected the height at which velocity is (m), for "
       "vertical_shear"},
      {"velocity = [8, 0, 0]\ngust = { amplitude = 0.01, of = \"vertical_shear\" }",
       "1:1: wind.reference_height: is missing, expected the height at which velocity is (m), for "
       "a gust of vertical_shear"},
      {"velocity = [0, 0, 8]\nhorizontal_shear = 0.01",
       "2:12: wind.velocity: is along up, expected a wind across it, which has a profile of "
       "heights"},
      {"gust = [{ amplitude = 3 }, { amplitude = 3, duration = 0 }]",
       "2:56: wind.gust.2.duration: is 0, expected a number greater than 0 (s)"},
      {"gust = { amplitude = 3, of = \"height\" }",
       "2:30: wind.gust.of: is \"height\", expected \"speed\", \"direction\", "
       "\"vertical_shear\" or \"horizontal_shear\""},
      {"file = \"none.bts\"",
       "2:8: wind.file: is \"none.bts\", but there is no file ./none.bts, expected a file of "
       "TurbSim (.bts) or a table of wind"},
      {"file = 3", "2:8: wind.file: is 3, expected text in quotes"},
      {"file = \"\"",
       "2:8: wind.file: is \"\", but there is no file ./, expected a file of TurbSim (.bts) or a "
       "table of wind"},
  });
}

TEST_CASE("turbulence that cannot be is refused") {
  const std::string wind = "velocity = [8, 0, 0]\nreference_height = 90\n";
  check_keys({
      {"velocity = [8, 0, 0]\nturbulence = { intensity = 0.1, width = 100 }",
       "1:1: wind.reference_height: is missing, expected the height at which velocity is (m), for "
       "turbulence"},
      {"reference_height = 90\nturbulence = { intensity = 0.1, width = 100 }",
       "1:1: wind.velocity: is 0, and its turbulence would be, too; expected a wind (m/s)"},
      {"time = [0, 1]\nspeed = [4, 5]\nreference_height = 90\nturbulence = { intensity = 0.1, "
       "width = 100 }",
       "5:14: wind.turbulence: is of a wind whose speed has a course, expected a constant "
       "velocity"},
      {wind + "turbulence = true",
       "4:14: wind.turbulence: is true, expected a table [wind.turbulence]"},
      {wind + "turbulence = { width = 100 }",
       "4:14: wind.turbulence.intensity: is missing, expected a number greater than 0 and at most "
       "2"},
      {wind + "turbulence = { intensity = 0, width = 100 }",
       "4:28: wind.turbulence.intensity: is 0, expected a number greater than 0 and at most 2"},
      {wind + "turbulence = { intensity = 14, width = 100 }",
       "4:28: wind.turbulence.intensity: is 14, expected a number greater than 0 and at most 2"},
      {wind + "turbulence = { intensity = 0.1 }",
       "4:14: wind.turbulence.width: is missing, expected a number greater than 0 (m)"},
      {wind + "turbulence = { intensity = 0.1, width = -1 }",
       "4:41: wind.turbulence.width: is -1, expected a number greater than 0 (m)"},
      {wind + "turbulence = { intensity = 0.1, width = 200 }",
       "4:41: wind.turbulence.width: is 200, and the box around the reference height of 90 m "
       "reaches below the ground; expected a height of at most 180 (m)"},
      {wind + "turbulence = { intensity = 0.1, width = 100, height = 181 }",
       "4:55: wind.turbulence.height: is 181, and the box around the reference height of 90 m "
       "reaches below the ground; expected a height of at most 180 (m)"},
      {wind + "turbulence = { intensity = 0.1, width = 100, seed = -1 }",
       "4:53: wind.turbulence.seed: is -1, expected a whole number from 0 to 2147483647"},
      {wind + "turbulence = { intensity = 0.1, width = 100, seed = 1.5 }",
       "4:53: wind.turbulence.seed: is 1.5, expected a whole number from 0 to 2147483647"},
      {wind + "turbulence = { intensity = 0.1, width = 100, spectrum = \"mann\" }",
       "4:57: wind.turbulence.spectrum: is \"mann\", expected \"kaimal\""},
      {wind + "turbulence = { intensity = 0.1, width = 100, coherence = \"none\" }",
       "4:58: wind.turbulence.coherence: is \"none\", expected \"longitudinal\" or \"all\""},
      {wind + "turbulence = { intensity = 0.1, width = 100, coherence_decay = 0 }",
       "4:64: wind.turbulence.coherence_decay: is 0, expected a number from 1 to 100"},
      {wind + "turbulence = { intensity = 0.1, width = 100, length_scale = 0 }",
       "4:61: wind.turbulence.length_scale: is 0, expected a number greater than 0 (m)"},
      {wind + "turbulence = { intensity = 0.1, width = 100, deviation_ratio = [1, 0.8] }",
       "4:64: wind.turbulence.deviation_ratio: is an array (2), expected an array of 3 numbers"},
      {wind + "turbulence = { intensity = 0.1, width = 100, deviation_ratio = [2, 0.8, 0.5] }",
       "4:65: wind.turbulence.deviation_ratio.1: is 2, expected 1: the others are over that along "
       "the wind"},
      {wind + "turbulence = { intensity = 0.1, width = 100, points = 1 }",
       "4:55: wind.turbulence.points: is 1, expected a whole number from 2 to 100"},
      {wind + "turbulence = { intensity = 0.1, width = 100, points = [15, 101] }",
       "4:60: wind.turbulence.points.2: is 101, expected a whole number from 2 to 100"},
      {wind + "turbulence = { intensity = 0.1, width = 100, points = [15, 2.5] }",
       "4:60: wind.turbulence.points.2: is 2.5, expected a whole number from 2 to 100"},
      {wind + "turbulence = { intensity = 0.1, width = 100, points = [15] }",
       "4:55: wind.turbulence.points: is an array (1), expected an array of 2 numbers"},
      {wind + "turbulence = { intensity = 0.1, width = 100, time_step = 0 }",
       "4:58: wind.turbulence.time_step: is 0, expected a number greater than 0 (s)"},
      {wind + "turbulence = { intensity = 0.1, width = 100, time_step = 100 }",
       "4:14: wind.turbulence.duration: is 600, expected 16 time steps of 100 s or more"},
      {wind + "turbulence = { intensity = 0.1, width = 100, duration = 1e9 }",
       "4:14: wind.turbulence.points: make a box of 2250000 million velocities over time, expected "
       "at most 20; have fewer points, a longer time_step or a shorter duration"},
      {wind + "turbulence = { intensity = 0.1, width = 100, points = 50 }",
       "4:55: wind.turbulence.points: have a coherence that takes 977 thousand million operations, "
       "expected at most 100; have fewer points or a shorter duration"},
      {wind + "turbulence = { intensity = 0.1, width = 100, length = 3 }",
       "4:46: wind.turbulence.length: unknown key, did you mean \"height\"?"},
  });
}

TEST_CASE("points too close for their coherence are refused when turbulence is made") {
  const Wind wind = read_wind_text(
      "[wind]\nvelocity = [8, 0, 0]\nreference_height = 90\n"
      "turbulence = { intensity = 0.1, width = 1e-15 }\n");
  check_message(message_of([&] { make_wind(wind); }),
                "wind.turbulence.width: is 1e-15, and the points of the grid lie too close for "
                "their coherence; expected a wider box or fewer points");
}

TEST_CASE("tables of wind that are none are refused with their line") {
  const std::vector<Case> cases = {
      {"", "w.txt: is empty, expected a table of wind as text, or a file of TurbSim (.bts)"},
      {"# nothing\n",
       "w.txt:1: has no row, expected a table of wind: time, speed, and perhaps direction, "
       "vertical_speed and shear_exponent"},
      {"0 5\n1\n", "w.txt:2: has 1 number, expected 2, one for each column"},
      {"0\n",
       "w.txt:1: has 1 column, expected 2 to 5: time, speed, and perhaps direction, "
       "vertical_speed and shear_exponent"},
      {"1 2 3 4 0.5 6\n",
       "w.txt:1: has 6 columns, expected 2 to 5: time, speed, and perhaps direction, "
       "vertical_speed and shear_exponent"},
      {"0 5\n0 6\n", "w.txt:2: time is 0, expected more than 0 s, that of the row before"},
      {"0 5\n1 fast\n", "w.txt:2: speed is \"fast\", expected a finite number (m/s)"},
      {"0 5\n1 1e40\n",
       "w.txt:2: speed is 1e+40, expected 0 or a magnitude from 1e-40 to 1e+30 (m/s)"},
      {"0 5\n1 nan\n", "w.txt:2: speed is \"nan\", expected a finite number (m/s)"},
      {"0 5 0 0 2\n", "w.txt:1: shear_exponent is 2, expected a number from 0 to 1"},
      {"time velocity\n0 5\n",
       "w.txt:1: has the column \"velocity\", expected time, speed, and perhaps direction, "
       "vertical_speed and shear_exponent"},
      {"time speed time\n0 5 1\n", "w.txt:1: has the column \"time\" twice, expected it once"},
      {"time direction\n0 5\n",
       "w.txt:1: has no column \"speed\", expected time, speed, and perhaps direction, "
       "vertical_speed and shear_exponent"},
  };
  for (const Case& of : cases) check_file("w.txt", of.keys, of.message);
  check_file("w.txt", "0 5 0 0 0.2\n",
             "f.toml:1:1: wind.reference_height: is missing, expected the height of the table's "
             "speed (m), for its shear_exponent");
  check_file("w.txt", "0 5 0 0 0.2\n",
             "f.toml:2:18: wind.shear_exponent: given along with a table that has its own, "
             "expected one of them",
             "shear_exponent = 0.1\nreference_height = 90\n");
  check_file("w.txt", "0 5\n",
             "f.toml:3:9: wind.speed: given along with file, expected only one of them",
             "time = [0, 1]\nspeed = [4, 5]\n");
  check_file("w.txt", "0 5\n",
             "f.toml:2:12: wind.velocity: is inclined, expected a direction across up: the file "
             "has the vertical speed",
             "velocity = [1, 0, 0.1]\n");
  check_file("w.txt", "0 5\n",
             "f.toml:3:14: wind.turbulence: given along with file, expected only one of them",
             "reference_height = 90\nturbulence = { intensity = 0.1, width = 100 }\n");
}

TEST_CASE("files of TurbSim that are damaged are refused with the byte") {
  const std::string whole = test::BtsBytes().make();
  check_file("w.bts", "", "w.bts: is empty, expected a full-field file of TurbSim (.bts)");
  check_file(
      "w.bts", "T",
      "w.bts: byte 1: the file ends here, expected the identifier of TurbSim's files, 7 or 8");
  check_file("w.bts", bts_with(0, std::int16_t{6}),
             "w.bts: byte 0: is 6, expected the identifier of TurbSim's full-field files, 7 or 8");
  check_file("w.bts", whole.substr(0, 9),
             "w.bts: byte 9: the file ends here, expected the number of points across");
  check_file("w.bts", whole.substr(0, 60),
             "w.bts: byte 60: the file ends here, expected the slope of a scale");
  check_file("w.bts", whole.substr(0, 80),
             "w.bts: byte 80: the file ends here, expected a description of 14 bytes from byte 70");
  check_file(
      "w.bts", whole.substr(0, whole.size() - 1),
      "w.bts: byte 2963: the file ends here, expected 2964 bytes, for 40 times of 3 x 4 points");
  check_file(
      "w.bts", whole + '\0',
      "w.bts: byte 2964: the file goes on, expected its end: it has 40 times of 3 x 4 points");
  check_file(
      "w.bts", bts_with(2, std::int32_t{1}),
      "w.bts: byte 2: is 1, expected the number of points upwards, a whole number from 2 to 10000");
  check_file("w.bts", bts_with(6, std::int32_t{2000000000}),
             "w.bts: byte 6: is 2000000000, expected the number of points across, a whole number "
             "from 2 to 10000");
  check_file("w.bts", bts_with(10, std::int32_t{-1}),
             "w.bts: byte 10: is -1, expected the number of points of the tower, a whole number "
             "from 0 to 10000");
  check_file(
      "w.bts", bts_with(14, std::int32_t{0}),
      "w.bts: byte 14: is 0, expected the number of times, a whole number from 2 to 100000000");
  check_file("w.bts", bts_with(14, std::int32_t{99999999}),
             "w.bts: byte 2964: the file ends here, expected 7200000012 bytes, for 99999999 times "
             "of 3 x 4 points");
  check_file(
      "w.bts", bts_with(18, 0.0f),
      "w.bts: byte 18: is 0, expected the spacing of points upwards, a number greater than 0 (m)");
  check_file("w.bts", bts_with(26, std::numeric_limits<float>::quiet_NaN()),
             "w.bts: byte 26: is nan, expected the time step, a finite number (s)");
  check_file(
      "w.bts", bts_with(30, -11.0f),
      "w.bts: byte 30: is -11, expected the mean speed at the hub, a number greater than 0 (m/s)");
  check_file("w.bts", bts_with(42, 0.0f), "w.bts: byte 42: is 0, expected the slope of a scale");
  check_file("w.bts", bts_with(42, 1e-3f),
             "w.bts: byte 84: is a velocity of 5499999.73876403 m/s, expected one of at most 1000");
  check_file("w.bts", bts_with(66, std::int32_t{-5}),
             "w.bts: byte 66: is -5, expected the length of the description in bytes, a whole "
             "number from 0 to 100000");
  check_file("w.bts", whole,
             "f.toml:2:18: wind.shear_exponent: given along with a file of TurbSim, which has its "
             "own shear",
             "shear_exponent = 0.1\nreference_height = 90\n");
  test::BtsBytes one_pass;
  one_pass.identifier = 7;
  one_pass.n_t = 3;
  check_file("w.bts", one_pass.make(),
             "w.bts: byte 300: has wind of 1 s, expected more than the box takes to pass its "
             "width, 1.4545454545454546 s");
}
