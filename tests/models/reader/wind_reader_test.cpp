// [wind] as it is read and written.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "models/air/wind_kept.h"
#include "models/reader/spatial/wind_json.h"
#include "tests/models/air/bts_bytes.h"
#include "tests/models/inline_toml.h"
#include "tests/models/reader/wind_texts.h"
#include "tests/temporary_folder.h"

using namespace spoke;
using spoke::test::read_wind_text;

namespace {

/// Reads what was written, in another folder.
Wind reread(const Wind& wind) {
  const std::string json = spatial::wind_to_json(wind).dump();
  return read_wind_text("wind = " + test::to_toml(nlohmann::ordered_json::parse(json)),
                        "/elsewhere");
}

}  // namespace

TEST_CASE("a wind reads what it is told and has defaults") {
  const Wind wind = read_wind_text("[wind]\nvelocity = [8, 0, 0.5]\n");
  CHECK(wind.velocity == Eigen::Vector3d(8.0, 0.0, 0.5));
  CHECK(wind.shear_exponent == 0.0);
  CHECK(wind.up == Eigen::Vector3d::UnitZ());
  CHECK_FALSE(wind.speed);
  CHECK(reread(wind) == wind);
}

TEST_CASE("every key of a wind is read and written as the same wind") {
  const Wind wind = read_wind_text(
      "[wind]\n"
      "velocity = [0.1, 12.3, 0]\n"
      "shear_exponent = 0.14\n"
      "reference_height = 119.0\n"
      "up = [0, 0, 2.0]\n"
      "ground = -3.0\n"
      "gust = { amplitude = 3.5, start = 20, duration = 10.5, shape = \"operating\" }\n"
      "[wind.turbulence]\n"
      "intensity = 0.16\nseed = 42\nspectrum = \"kaimal\"\nlength_scale = 40.0\n"
      "deviation_ratio = [1, 0.7, 0.45]\ncoherence = \"all\"\ncoherence_decay = 10.0\n"
      "width = 120.0\nheight = 100.0\npoints = [5, 4]\ntime_step = 0.5\nduration = 60\n");
  REQUIRE(wind.turbulence);
  CHECK(wind.turbulence->seed == 42);
  CHECK(wind.turbulence->points == std::array<int, 2>{5, 4});
  CHECK(wind.turbulence->coherence == Coherence::all);
  CHECK(wind.turbulence->deviation_ratio == std::array<double, 3>{1.0, 0.7, 0.45});
  CHECK(wind.gusts.at(0).shape == GustShape::operating);
  CHECK(reread(wind) == wind);
  // The turbulence is made when it is asked for, once.
  CHECK(make_wind(wind) == make_wind(wind));
}

TEST_CASE("linear shear and several gusts are read and written") {
  const Wind wind = read_wind_text(
      "[wind]\nvelocity = [8, 0, 0]\nvertical_shear = 0.01\nhorizontal_shear = -0.02\n"
      "reference_height = 90\n"
      "gust = [{ amplitude = 0.5, of = \"direction\", shape = \"rise\" },\n"
      "        { amplitude = 0.01, of = \"vertical_shear\", start = 4 },\n"
      "        { amplitude = 0.02, of = \"horizontal_shear\", duration = 12 }]\n");
  CHECK(wind.vertical_shear == 0.01);
  CHECK(wind.horizontal_shear == -0.02);
  CHECK(wind.gusts == std::vector<WindGust>{
                          {.amplitude = 0.5, .shape = GustShape::rise, .of = GustOf::direction},
                          {.amplitude = 0.01, .start = 4.0, .of = GustOf::vertical_shear},
                          {.amplitude = 0.02, .duration = 12.0, .of = GustOf::horizontal_shear}});
  CHECK(reread(wind) == wind);
}

TEST_CASE("a wind's course over time is read and written") {
  const Wind wind =
      read_wind_text("[wind]\nvelocity = [0, 1, 0]\ntime = [0, 10, 30]\nspeed = [5, 12.5, 11]\n");
  REQUIRE(wind.speed);
  CHECK(make_wind(wind)->velocity({0, 0, 0}, 10.0).y() == 12.5);
  CHECK(reread(wind) == wind);
}

TEST_CASE("one number of points is that of both sides") {
  const Wind wind = read_wind_text(
      "[wind]\nvelocity = [9, 0, 0]\nreference_height = 80\n"
      "turbulence = { intensity = 0.1, width = 100, points = 9 }\n");
  CHECK(wind.turbulence->points == std::array<int, 2>{9, 9});
}

TEST_CASE("files of wind are found beside the scenario and written with their whole name") {
  const test::TemporaryFolder folder;
  test::BtsBytes().write((folder / "box.bts").string());
  std::ofstream(folder / "course.txt") << "0 5\n10 7\n";
  for (const char* name : {"box.bts", "course.txt"}) {
    const Wind wind =
        read_wind_text(std::string("[wind]\nfile = \"") + name + "\"\n", folder.path().string());
    REQUIRE(wind.kept);
    CHECK(wind.file == (folder / name).string());
    const Wind again = reread(wind);
    CHECK(again == wind);
    CHECK(again.kept->content() == wind.kept->content());
    CHECK(make_wind(again)->velocity({0, 0, 12}, 3.0) ==
          make_wind(wind)->velocity({0, 0, 12}, 3.0));
  }
}

TEST_CASE("the content of a file of wind tells files of one name apart") {
  const test::TemporaryFolder folder;
  const auto content_of = [&](const char* text) {
    std::ofstream(folder / "course.txt") << text;
    const Wind wind = read_wind_text("[wind]\nfile = \"course.txt\"\n", folder.path().string());
    return wind.kept->content();
  };
  CHECK(content_of("0 5\n") != content_of("0 6\n"));
}

TEST_CASE("a wind by the program is written as such and needs one") {
  Wind wind = read_wind_text("[wind]\nby = \"program\"\n");
  CHECK(wind.by_program);
  CHECK(reread(wind) == wind);
  CHECK(test::message_of([&] { make_wind(wind); }) ==
        "wind.by: is \"program\", but the program gives no wind, expected Wind::field");
  wind.field = make_wind_field(
      [](const Eigen::Vector3d& place, double) { return Eigen::Vector3d(place.z(), 0.0, 0.0); });
  CHECK(make_wind(wind)->velocity({0.0, 0.0, 3.0}, 0.0).x() == 3.0);
  CHECK(reread(wind).by_program);
}
