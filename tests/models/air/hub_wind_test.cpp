// Wind that is given at the hub, against the power law and against winds of descriptions.

#include "models/air/hub_wind.h"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "models/wind.h"
#include "tests/contains.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

using namespace spoke;
using Eigen::Vector3d;

namespace {

const WindCourse kCourse{2.0, 4.0, {8.0, 1.0, 0.0}, {12.0, -1.0, 0.5}};

Wind make_sheared(double reference_height) {
  Wind wind;
  wind.velocity = {8.0, 0.0, 0.0};
  wind.shear_exponent = 0.2;
  wind.reference_height = reference_height;
  return wind;
}

}  // namespace

TEST_CASE("a course is constant before and behind, and straight between") {
  CHECK(kCourse.at(-1.0) == kCourse.velocity);
  CHECK(kCourse.at(2.0) == kCourse.velocity);
  CHECK(kCourse.at(3.0) == Vector3d(10.0, 0.0, 0.25));
  CHECK(kCourse.at(4.0) == kCourse.target);
  CHECK(kCourse.at(1e9) == kCourse.target);
  const WindCourse at_once{2.0, 2.0, {8.0, 0.0, 0.0}, {9.0, 0.0, 0.0}};
  CHECK(at_once.at(2.0) == at_once.target);
}

TEST_CASE("the velocity at the hub is the one given, and shear goes by the hub's height") {
  const Vector3d hub(-5.0, 0.0, 90.0);
  // Whatever height the description's own speed is at.
  for (const double reference : {10.0, 90.0, 120.0}) {
    const Wind wind = make_sheared(reference);
    const air::HubWind given(wind, make_wind(wind), hub, kCourse);
    for (const double t : {0.0, 2.5, 3.7, 9.0}) {
      CHECK(given.velocity(hub, t) == kCourse.at(t));
      for (const double height : {0.5, 45.0, 150.0}) {
        const Vector3d expected = kCourse.at(t) * std::pow(height / 90.0, 0.2);
        CHECK((given.velocity({3.0, 40.0, height}, t) - expected).norm() <= 1e-12);
      }
      CHECK(given.velocity({0.0, 0.0, -1.0}, t) == Vector3d::Zero());
    }
  }
  // The same wind as one that is described: to the last bit.
  const Wind described = make_sheared(90.0);
  const air::HubWind given(described, make_wind(described), hub,
                           {0.0, 0.0, described.velocity, described.velocity});
  for (const double height : {1.0, 33.3, 90.0, 151.5})
    CHECK(given.velocity({1.0, 2.0, height}, 7.0) ==
          given.replaced()->velocity({1.0, 2.0, height}, 7.0));
}

TEST_CASE("linear shear goes by the distance from the hub, of whose velocity it is a share") {
  Wind wind = make_sheared(90.0);
  wind.vertical_shear = 0.004;
  wind.horizontal_shear = 0.001;
  const Vector3d hub(-5.0, 3.0, 80.0);
  const air::HubWind given(wind, make_wind(wind), hub, kCourse);
  CHECK(given.velocity(hub, 3.0) == kCourse.at(3.0));
  const double share = std::pow(100.0 / 80.0, 0.2) + 0.004 * 20.0 + 0.001 * 37.0;
  CHECK((given.velocity({0.0, 40.0, 100.0}, 3.0) - share * kCourse.at(3.0)).norm() <= 1e-12);
}

TEST_CASE("without shear the wind is equal everywhere, and another course is of the same hub") {
  const Wind still;
  const air::HubWind given(still, make_wind(still), Vector3d::Zero(), kCourse);
  CHECK(given.velocity({1e3, -1e3, -7.0}, 3.0) == kCourse.at(3.0));
  const WindCourse other{4.0, 5.0, kCourse.target, Vector3d::Zero()};
  CHECK(given.with(other)->velocity(Vector3d::Zero(), 6.0) == Vector3d::Zero());
  CHECK(given.velocity(Vector3d::Zero(), 6.0) == kCourse.target);
}

TEST_CASE("the shear of a table stays, with its course over time") {
  const test::TemporaryFolder folder;
  Wind wind;
  wind.file = (folder / "wind.txt").string();
  wind.reference_height = 50.0;
  std::ofstream(wind.file) << "time speed shear_exponent\n0 8 0.1\n10 30 0.3\n";
  const air::HubWind given(wind, make_wind(wind), {0.0, 0.0, 80.0}, kCourse);
  for (const auto& [t, exponent] : {std::pair{0.0, 0.1}, {5.0, 0.2}, {10.0, 0.3}}) {
    const Vector3d expected = kCourse.at(t) * std::pow(0.5, exponent);
    CHECK((given.velocity({0.0, 0.0, 40.0}, t) - expected).norm() <= 1e-12);
  }
}

TEST_CASE("where shear leaves no wind at the hub, none can be given there") {
  Wind wind = make_sheared(90.0);
  wind.ground = 2.0;
  const auto make = [&] { const air::HubWind given(wind, nullptr, {0.0, 0.0, 1.0}, kCourse); };
  CHECK(test::contains(test::message_of(make), "wind.ground: is 2, and the hub is at a height of"));
  CHECK(air::find_hub_wind_fault(wind, {0.0, 0.0, 1.0}));
  CHECK(!air::find_hub_wind_fault(wind, {0.0, 0.0, 3.0}));
  wind.shear_exponent = 0.0;
  CHECK(!air::find_hub_wind_fault(wind, {0.0, 0.0, 1.0}));
}
