// Wind at places and times against closed forms.

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>

#include "models/air/wind_kept.h"
#include "models/air/wind_table.h"
#include "models/wind.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

using namespace spoke;
using Eigen::Vector3d;

namespace {

void check_near(const Vector3d& found, const Vector3d& expected, double tolerance = 1e-12) {
  INFO("found " << found.transpose() << ", expected " << expected.transpose());
  CHECK((found - expected).norm() <= tolerance);
}

Wind make_sheared() {
  Wind wind;
  wind.velocity = {8.0, 0.0, 0.0};
  wind.shear_exponent = 0.2;
  wind.reference_height = 90.0;
  return wind;
}

std::shared_ptr<const WindField> make_from_table(const char* text, Wind wind = {}) {
  const test::TemporaryFolder folder;
  wind.file = (folder / "wind.txt").string();
  std::ofstream(wind.file) << text;
  return make_wind(wind);
}

}  // namespace

TEST_CASE("air is still unless it is told") {
  check_near(make_wind(Wind{})->velocity({1.0, 2.0, 3.0}, 4.0), Vector3d::Zero());
}

TEST_CASE("a uniform wind is equal everywhere and always and has no end") {
  Wind wind;
  wind.velocity = {8.0, -1.0, 0.5};
  const auto field = make_wind(wind);
  for (const Vector3d& place : {Vector3d(0, 0, 0), Vector3d(100, -50, -3), Vector3d(0, 0, 1e4)})
    for (const double t : {-1.0, 0.0, 1e5}) check_near(field->velocity(place, t), wind.velocity);
  CHECK(field->end() == std::numeric_limits<double>::infinity());
}

TEST_CASE("the power law goes by the height over the ground along up") {
  Wind wind = make_sheared();
  const auto speed_at = [](double height) { return 8.0 * std::pow(height / 90.0, 0.2); };
  const auto field = make_wind(wind);
  for (const double height : {1.0, 30.0, 90.0, 151.5})
    check_near(field->velocity({5.0, 7.0, height}, 1.0), {speed_at(height), 0.0, 0.0});
  check_near(field->velocity({0.0, 0.0, -1.0}, 0.0), Vector3d::Zero());
  // The hub at the origin, 90 m over the ground, in a frame whose y axis is up.
  wind.ground = -90.0;
  wind.up = {0.0, 2.0, 0.0};
  wind.velocity = {0.0, 0.0, -8.0};
  const auto turned = make_wind(wind);
  check_near(turned->velocity({3.0, 10.0, 4.0}, 0.0), {0.0, 0.0, -speed_at(100.0)});
  check_near(turned->mean({3.0, 10.0, 4.0}), {0.0, 0.0, -speed_at(100.0)});
}

TEST_CASE("the course of the speed is along the direction of the velocity") {
  Wind wind;
  wind.speed = Curve({0.0, 10.0, 20.0}, {4.0, 8.0, 12.0});
  check_near(make_wind(wind)->velocity({0, 0, 0}, 5.0), {6.0, 0.0, 0.0});
  wind.velocity = {0.0, -3.0, 4.0};  // only its direction counts
  const auto field = make_wind(wind);
  check_near(field->velocity({0, 0, 0}, 15.0), Vector3d(0.0, -6.0, 8.0));
  check_near(field->velocity({0, 0, 0}, 99.0), Vector3d(0.0, -7.2, 9.6));
  check_near(field->mean({0, 0, 0}), Vector3d(0.0, -2.4, 3.2));
}

TEST_CASE("gusts begin and end at rest") {
  Wind wind;
  wind.velocity = {0.0, 10.0, 0.0};
  wind.gusts = {WindGust{.amplitude = 4.0, .start = 2.0, .duration = 8.0}};
  const auto smooth = make_wind(wind);
  check_near(smooth->velocity({0, 0, 0}, 1.9), {0.0, 10.0, 0.0});
  check_near(smooth->velocity({0, 0, 0}, 4.0), {0.0, 12.0, 0.0});
  check_near(smooth->velocity({0, 0, 0}, 6.0), {0.0, 14.0, 0.0});
  check_near(smooth->velocity({0, 0, 0}, 10.0), {0.0, 10.0, 0.0});
  check_near(smooth->mean({0, 0, 0}), {0.0, 10.0, 0.0});
  // The dip of IEC's gust at a quarter, its peak in the middle.
  wind.gusts[0].shape = GustShape::operating;
  const auto operating = make_wind(wind);
  check_near(operating->velocity({0, 0, 0}, 4.0),
             {0.0, 10.0 - 0.37 * 4.0 * std::sin(0.75 * std::numbers::pi), 0.0});
  check_near(operating->velocity({0, 0, 0}, 6.0), {0.0, 10.0 + 0.74 * 4.0, 0.0});
  // int sin(3 pi s) (1 - cos 2 pi s) ds = 2/(3 pi) - 1/(5 pi) - 1/pi = -8/(15 pi)
  double sum = 0.0;
  constexpr int kParts = 4000;
  for (int k = 0; k < kParts; ++k)
    sum += operating->velocity({0, 0, 0}, 2.0 + 8.0 * (k + 0.5) / kParts).y() - 10.0;
  CHECK(sum / kParts ==
        doctest::Approx(0.37 * 4.0 * 8.0 / (15.0 * std::numbers::pi)).epsilon(1e-5));
}

TEST_CASE("linear shear grows upwards and across, and a gust of it grows and goes") {
  Wind wind = make_sheared();
  const auto speed_at = [](double height) { return std::pow(height / 90.0, 0.2); };
  wind.vertical_shear = 0.002;
  wind.horizontal_shear = -0.003;
  const auto field = make_wind(wind);
  for (const double height : {1.0, 90.0, 150.0})
    for (const double across : {-60.0, 0.0, 20.0}) {
      const double share = speed_at(height) + 0.002 * (height - 90.0) - 0.003 * across;
      check_near(field->velocity({7.0, across, height}, 1.0), {8.0 * share, 0.0, 0.0});
      check_near(field->mean({7.0, across, height}), {8.0 * share, 0.0, 0.0});
    }
  check_near(field->velocity({0.0, 0.0, -5.0}, 0.0), {-8.0 * 0.18, 0.0, 0.0});  // as on the ground
  wind.gusts = {{.amplitude = 0.01, .duration = 4.0, .of = GustOf::vertical_shear},
                {.amplitude = 0.02, .duration = 4.0, .of = GustOf::horizontal_shear}};
  const double share = speed_at(100.0) + 0.012 * 10.0 + 0.017 * 20.0;
  check_near(make_wind(wind)->velocity({0.0, 20.0, 100.0}, 2.0), {8.0 * share, 0.0, 0.0});
  check_near(make_wind(wind)->velocity({0.0, 20.0, 100.0}, 4.0),
             field->velocity({0.0, 20.0, 100.0}, 4.0));
  check_near(make_wind(wind)->mean({0.0, 20.0, 100.0}), field->mean({0.0, 20.0, 100.0}));
  // Of a course of the speed it is a share, too.
  wind.gusts.clear();
  wind.speed = Curve({0.0, 10.0}, {4.0, 8.0});
  check_near(make_wind(wind)->velocity({0.0, 20.0, 100.0}, 0.0),
             0.5 * field->velocity({0.0, 20.0, 100.0}, 0.0));
}

TEST_CASE(
    "a rise stays, changes add up, and a change of direction turns all of the wind about up") {
  Wind wind = make_sheared();
  wind.gusts = {{.amplitude = 3.0, .start = 1.0, .duration = 4.0, .shape = GustShape::rise},
                {.amplitude = 2.0, .start = 1.0, .duration = 4.0, .shape = GustShape::rise}};
  const auto risen = make_wind(wind);
  check_near(risen->velocity({0, 0, 90}, 1.0), {8.0, 0.0, 0.0});
  check_near(risen->velocity({0, 0, 90}, 3.0), {10.5, 0.0, 0.0});
  check_near(risen->velocity({0, 0, 90}, 99.0), {13.0, 0.0, 0.0});
  wind.gusts.push_back({.amplitude = std::numbers::pi / 2.0,
                        .duration = 1.0,
                        .shape = GustShape::rise,
                        .of = GustOf::direction});
  wind.gusts[0].amplitude = wind.gusts[1].amplitude = 0.0;
  wind.turbulence =
      WindTurbulence{.intensity = 0.1, .width = 20.0, .points = {3, 3}, .duration = 10.0};
  Wind straight = wind;
  straight.gusts.clear();
  for (const double t : {2.0, 5.5}) {
    const Vector3d before = make_wind(straight)->velocity({1, 2, 95}, t);
    check_near(make_wind(wind)->velocity({1, 2, 95}, t), {-before.y(), before.x(), before.z()});
  }
}

TEST_CASE("a table turns the wind, lifts it and changes its shear") {
  Wind wind;
  wind.velocity = {0.0, 1.0, 0.0};
  wind.reference_height = 50.0;
  const auto field = make_from_table(
      "# made up\n"
      "time speed direction vertical_speed shear_exponent\n"
      "0  6   0.0  0.0  0.0\n"
      "10, 10, 1.0, 2.0, 0.2 ! all at once\n",
      wind);
  check_near(field->velocity({0, 0, 25}, 0.0), {0.0, 6.0, 0.0});
  const double speed = 10.0 * std::pow(0.5, 0.2);
  // Towards -x from +y, about +z.
  const Vector3d expected(-speed * std::sin(1.0), speed * std::cos(1.0), 2.0);
  check_near(field->velocity({3, 4, 25}, 10.0), expected);
  check_near(field->velocity({3, 4, 25}, 100.0), expected);
  // Steady operation knows the mean over the table's time, where the speed rises evenly.
  const auto steady = make_from_table("0 6\n10 10\n");
  check_near(steady->mean({0, 0, 0}), {8.0, 0.0, 0.0}, 1e-9);
}

TEST_CASE("columns of a table have any order if they are named") {
  const air::WindTable table = air::parse_wind_table("speed;time\n5;0\n7;2\n", "w.txt");
  CHECK(table.speed.value(0.0) == 5.0);
  CHECK(table.speed.value(2.0) == 7.0);
  CHECK(table.direction.value(1.0) == 0.0);
  CHECK_FALSE(table.shear_exponent.has_value());
  const air::WindTable plain = air::parse_wind_table("0 5 0.25\r\n\r\n1 5 0.5", "w.txt");
  CHECK(plain.direction.value(1.0) == 0.5);
}

TEST_CASE("a wind of the program's own is a function or a class") {
  Wind wind;
  wind.field = make_wind_field([](const Vector3d& place, double t) { return place * t; });
  check_near(make_wind(wind)->velocity({1.0, 2.0, 3.0}, 2.0), {2.0, 4.0, 6.0});
  CHECK(make_wind(wind) == wind.field);
  CHECK(test::message_of([] { make_wind_field(nullptr); }) ==
        "there is no function of the wind, expected one");
}

TEST_CASE("what is made of a wind is kept for it and its copies until it changes") {
  Wind wind = make_sheared();
  wind.turbulence =
      WindTurbulence{.intensity = 0.1, .width = 20.0, .points = {3, 3}, .duration = 10.0};
  air::keep_wind(wind);
  Wind copy = wind;
  CHECK(copy == wind);
  CHECK(make_wind(copy) == make_wind(wind));
  copy.turbulence->seed = 2;
  CHECK_FALSE(copy == wind);
  CHECK(make_wind(copy) != make_wind(wind));
}

TEST_CASE("wind of a run must last as long as the run") {
  class Short final : public WindField {
   public:
    Vector3d velocity(const Vector3d&, double) const override { return Vector3d::Zero(); }
    double end() const override { return 10.5; }
  };
  Wind wind;
  CHECK_FALSE(air::find_end_fault(wind, 1e6));
  wind.field = std::make_shared<Short>();
  CHECK_FALSE(air::find_end_fault(wind, 10.0));
  const air::WindFault fault = air::find_end_fault(wind, 11.0);
  CHECK(fault.key == "by");
  CHECK(fault.text == "gives wind up to 10.5 s, expected some up to 11 s, the end of the run");
}

TEST_CASE("a place or time that is no number makes no harm") {
  Wind wind = make_sheared();
  wind.turbulence =
      WindTurbulence{.intensity = 0.1, .width = 20.0, .points = {3, 3}, .duration = 10.0};
  const auto field = make_wind(wind);
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double far = std::numeric_limits<double>::infinity();
  for (const double bad : {none, far, -far}) {
    field->velocity({bad, 0.0, 0.0}, 0.0);
    field->velocity({0.0, bad, bad}, 0.0);
    field->velocity({0.0, 0.0, 0.0}, bad);
  }
  CHECK(field->velocity({0.0, 0.0, 90.0}, 1.0).allFinite());
}
