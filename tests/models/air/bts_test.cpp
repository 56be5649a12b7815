// TurbSim's files, written here byte by byte, and what is read of them.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "models/air/bts_reader.h"
#include "models/air/bts_writer.h"
#include "models/air/wind_kept.h"
#include "tests/models/air/bts_bytes.h"
#include "tests/temporary_folder.h"

using namespace spoke;
using namespace spoke::air;
using Eigen::Vector3d;
using test::BtsBytes;

TEST_CASE("velocities are read as they were written, to the resolution of their whole numbers") {
  BtsBytes file;
  file.tower = 2;
  const auto true_speed = [](std::size_t t, std::size_t z, std::size_t y, std::size_t c) {
    const double phase =
        0.3 * static_cast<double>(t) + static_cast<double>(z) - 0.5 * static_cast<double>(y);
    return (c == 0 ? 11.0 : 0.0) + 3.0 * std::sin(phase + static_cast<double>(c));
  };
  file.speed_of = true_speed;
  const std::string bytes = file.make();
  const WindBox box = parse_bts(bytes, "w.bts");
  REQUIRE(box.n_t == file.n_t);
  REQUIRE(box.n_y == file.n_y);
  REQUIRE(box.n_z == file.n_z);
  CHECK(box.is_periodic);
  CHECK(box.bottom == 10.0);
  CHECK(box.speed == doctest::Approx(11.0));
  double largest = 0.0;
  for (std::size_t t = 0; t < box.n_t; ++t)
    for (std::size_t z = 0; z < box.n_z; ++z)
      for (std::size_t y = 0; y < box.n_y; ++y)
        for (std::size_t c = 0; c < 3; ++c)
          largest = std::max(largest,
                             std::abs(box.values[box.index(t, z, y) + c] - true_speed(t, z, y, c)));
  CHECK(largest <= 0.51 / file.slope);
  CHECK(largest > 0.1 / file.slope);
}

TEST_CASE("a box passes the rotor with its mean speed, by its axes") {
  const test::TemporaryFolder folder;
  BtsBytes file;  // components that tell place and time
  file.speed_of = [](std::size_t t, std::size_t z, std::size_t y, std::size_t c) {
    return static_cast<double>(c == 0 ? t : c == 1 ? y : z);
  };
  Wind wind;
  wind.velocity = {0.0, 5.0, 0.0};  // along y: the grid's own across is -x
  wind.file = (folder / "wind.bts").string();
  file.write(wind.file);
  const auto field = make_wind(wind);
  const double step = file.dt;
  const double half = 0.5 * file.dy * (static_cast<double>(file.n_y) - 1.0);
  const double tolerance = 1e-3;
  // At a point of the grid.
  Vector3d v = field->velocity({half, 0.0, 10.0}, 3.0 * step);
  CHECK(v.y() == doctest::Approx(3.0).epsilon(tolerance));  // along the wind
  CHECK(std::abs(v.x()) < tolerance);                       // across, at the right end: 0
  CHECK(std::abs(v.z()) < tolerance);                       // lowest row
  // Downwind the same wind arrives later.
  v = field->velocity({half, 11.0 * step, 10.0}, 4.0 * step);
  CHECK(v.y() == doctest::Approx(3.0).epsilon(tolerance));
  // Between points, and above the grid.
  v = field->velocity({half - 0.25 * file.dy, 0.0, 10.0 + 1.5 * file.dz}, 2.5 * step);
  CHECK(v.y() == doctest::Approx(2.5).epsilon(tolerance));
  CHECK(v.x() == doctest::Approx(-0.25).epsilon(tolerance));
  CHECK(v.z() == doctest::Approx(1.5).epsilon(tolerance));
  v = field->velocity({-10.0 * half, 0.0, 1e4}, 2.0 * step);
  CHECK(v.x() == doctest::Approx(-(static_cast<double>(file.n_y) - 1.0)).epsilon(tolerance));
  CHECK(v.z() == doctest::Approx(static_cast<double>(file.n_z) - 1.0).epsilon(tolerance));
  // It repeats, and its mean is that over all times.
  const double period = static_cast<double>(file.n_t) * step;
  const Vector3d place(1.0, 2.0, 12.0);
  CHECK((field->velocity(place, 1.25 * step) - field->velocity(place, 1.25 * step + 7 * period))
            .norm() < 1e-9);
  CHECK(field->mean(place).y() ==
        doctest::Approx(0.5 * (static_cast<double>(file.n_t) - 1.0)).epsilon(tolerance));
}

TEST_CASE("a file for one pass ends, and begins half its width ahead") {
  BtsBytes file;
  file.identifier = 7;
  const WindBox box = parse_bts(file.make(), "w.bts");
  CHECK_FALSE(box.is_periodic);
  const double passage = 2.0 * box.half_width() / box.speed;
  CHECK(box.end() == doctest::Approx(static_cast<double>(file.n_t - 1) * file.dt - passage));
  // The first wind of the file is half the width downwind at t = 0.
  CHECK((box.velocity(box.half_width(), 0.0, 12.0, 0.0) -
         box.velocity(box.half_width(), 0.0, 12.0, -1.0))
            .norm() == 0.0);
}

TEST_CASE("a box is written as a file that is read as the same box") {
  BtsBytes file;
  const WindBox box = parse_bts(file.make(), "w.bts");
  const WindBox again = parse_bts(make_bts(box, 90.0, "written by a test"), "again.bts");
  CHECK(again.n_t == box.n_t);
  CHECK(again.dy == box.dy);
  CHECK(again.bottom == box.bottom);
  CHECK(again.is_periodic == box.is_periodic);
  double largest = 0.0;
  for (std::size_t i = 0; i < box.values.size(); ++i)
    largest = std::max(largest, std::abs(static_cast<double>(again.values[i]) - box.values[i]));
  CHECK(largest < 20.0 / 65535.0);
}

TEST_CASE("turbulence written to a file with its mean wind blows as it does without") {
  const test::TemporaryFolder folder;
  Wind wind;
  wind.velocity = {0.0, 9.0, 0.0};
  wind.reference_height = 90.0;
  wind.ground = -90.0;
  wind.turbulence =
      WindTurbulence{.intensity = 0.2, .width = 60.0, .points = {4, 3}, .duration = 30.0};
  Wind from_file;
  from_file.velocity = {0.0, 1.0, 0.0};
  from_file.ground = -90.0;
  from_file.file = (folder / "wind.bts").string();
  std::ofstream(from_file.file, std::ios::binary)
      << make_bts(make_whole_box(KeptWind(wind)), 90.0, "written by a test");
  const auto field = make_wind(wind);
  const auto again = make_wind(from_file);
  for (const double t : {0.0, 3.14, 29.95, 100.0})
    for (const Vector3d& place :
         {Vector3d(0.0, 0.0, 0.0), Vector3d(13.0, -7.0, 21.0), Vector3d(-28.0, 3.0, -29.0)})
      CHECK((field->velocity(place, t) - again->velocity(place, t)).norm() < 2e-3);
  CHECK((again->mean({0.0, 0.0, 0.0}) - Vector3d(0.0, 9.0, 0.0)).norm() < 1e-3);
}
