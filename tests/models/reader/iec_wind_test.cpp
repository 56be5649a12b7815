// Wind conditions of IEC 61400-1 against the standard's formulas, written out for their values at
// times and places.

#include "models/air/iec_wind.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "models/air/wind_kept.h"
#include "tests/message_of.h"
#include "tests/models/reader/check_message.h"
#include "tests/models/reader/wind_texts.h"

using namespace spoke;
using Eigen::Vector3d;
using spoke::test::check_message;
using spoke::test::message_of;
using spoke::test::read_wind_text;

namespace {

constexpr double kHalfTurn = std::numbers::pi;
constexpr double kHubHeight = 90.0, kRotorDiameter = 126.0;

Wind make_condition(const IecWind& iec) {
  Wind along;
  along.reference_height = kHubHeight;
  return make_iec_wind(iec, along);
}

IecWind of_case(IecCase condition, double speed) {
  return {.turbine = IecClass::i_b,
          .condition = condition,
          .speed = speed,
          .rotor_diameter = kRotorDiameter};
}

/// Returns the speed along x of a condition at a place above and beside the hub.
double speed_of(const Wind& wind, double t, double up = 0.0, double across = 0.0) {
  return make_wind(wind)->velocity({0.0, across, kHubHeight + up}, t).x();
}

double deviation_of(const Wind& wind) { return wind.turbulence->intensity * wind.velocity.norm(); }

}  // namespace

TEST_CASE("normal and extreme turbulence have the standard's deviations") {
  // By hand of class IB: 0.14 (0.75 14 + 5.6), and 2 0.14 (0.072 (10/2 + 3) (14/2 - 4) + 10).
  CHECK(deviation_of(make_condition(of_case(IecCase::ntm, 14.0))) == doctest::Approx(2.254));
  CHECK(deviation_of(make_condition(of_case(IecCase::etm, 14.0))) == doctest::Approx(3.28384));
  // I_ref is the mean intensity at 15 m/s; the deviation in force is its quantile of 90 %, by the
  // standard's own statement of the mean plus 1.28 deviations of 1.4 m/s I_ref.
  for (const auto& [turbine, intensity] :
       {std::pair{IecClass::i_a, 0.16}, {IecClass::ii_b, 0.14}, {IecClass::iii_c, 0.12}}) {
    IecWind iec = of_case(IecCase::ntm, 15.0);
    iec.turbine = turbine;
    const double mean = intensity * 15.0, spread = 1.4 * intensity;
    CHECK(deviation_of(make_condition(iec)) == doctest::Approx(mean + 1.28 * spread).epsilon(0.01));
  }
  const Wind wind = make_condition(of_case(IecCase::etm, 14.0));
  CHECK(wind.turbulence->width > kRotorDiameter);
  CHECK(wind.shear_exponent == 0.2);
  CHECK(wind.gusts.empty());
}

TEST_CASE("a box of extreme turbulence has that deviation at the hub") {
  IecWind iec = of_case(IecCase::etm, 14.0);
  iec.seed = 7;
  Wind wind = make_condition(iec);
  wind.turbulence->points = {5, 5};
  wind.turbulence->duration = 100.0;
  const auto field = make_wind(wind);
  double sum = 0.0, square = 0.0;
  const int steps = static_cast<int>(air::find_wind(wind)->box()->n_t);
  for (int k = 0; k < steps; ++k) {
    const double v = field->velocity({0.0, 0.0, kHubHeight}, 0.1 * k).x();
    sum += v / steps;
    square += v * v / steps;
  }
  CHECK(sum == doctest::Approx(14.0).epsilon(1e-6));
  CHECK(std::sqrt(square - sum * sum) == doctest::Approx(3.28384).epsilon(1e-4));
}

TEST_CASE("the extreme operating gust dips, peaks and dips as in the standard") {
  IecWind iec = of_case(IecCase::eog, 14.0);
  iec.start = 5.0;
  const Wind wind = make_condition(iec);
  const double by_turbulence = 3.3 * 2.254 / (1.0 + 0.1 * kRotorDiameter / 42.0);
  const auto in_gust = [](double t, double size) {
    return 14.0 - 0.37 * size * std::sin(3 * kHalfTurn * t / 10.5) *
                      (1 - std::cos(2 * kHalfTurn * t / 10.5));
  };
  for (const double t : {0.5, 2.0, 2.625, 5.25, 8.0, 10.0})
    CHECK(speed_of(wind, 5.0 + t) == doctest::Approx(in_gust(t, by_turbulence)));
  for (const double t : {0.0, 5.0, 15.5, 100.0}) CHECK(speed_of(wind, t) == 14.0);
  CHECK(speed_of(wind, 10.25) == doctest::Approx(14.0 + 0.74 * by_turbulence));
  // Near the extreme speed of a year, 0.8 1.4 50 m/s, that bounds it.
  CHECK(speed_of(make_condition(of_case(IecCase::eog, 55.0)), 5.25) ==
        doctest::Approx(55.0 + 0.74 * 1.35));
}

TEST_CASE("extreme changes of direction turn the wind and leave it turned") {
  const double turn = 4.0 * std::atan(2.254 / (14.0 * (1.0 + 0.1 * kRotorDiameter / 42.0)));
  for (const int sign : {1, -1}) {
    IecWind iec = of_case(IecCase::edc, 14.0);
    iec.sign = sign;
    const auto field = make_wind(make_condition(iec));
    for (const double t : {0.0, 1.0, 3.0, 5.0, 6.0, 60.0}) {
      const double angle = t < 6.0 ? 0.5 * turn * (1.0 - std::cos(kHalfTurn * t / 6.0)) : turn;
      const Vector3d expected(14.0 * std::cos(angle), sign * 14.0 * std::sin(angle), 0.0);
      CHECK((field->velocity({0, 0, kHubHeight}, t) - expected).norm() < 1e-12);
    }
  }
}

TEST_CASE("the coherent gust rises by 15 m/s while it turns") {
  const auto field = make_wind(make_condition(of_case(IecCase::ecd, 14.0)));
  for (const double t : {0.0, 2.0, 5.0, 10.0, 40.0}) {
    const double share = t < 10.0 ? 0.5 * (1.0 - std::cos(kHalfTurn * t / 10.0)) : 1.0;
    const double speed = 14.0 + 15.0 * share, angle = share * 720.0 / 14.0 * kHalfTurn / 180.0;
    const Vector3d expected(speed * std::cos(angle), speed * std::sin(angle), 0.0);
    CHECK((field->velocity({0, 0, kHubHeight}, t) - expected).norm() < 1e-12);
  }
  // Below 4 m/s it turns by half a turn.
  const auto slow = make_wind(make_condition(of_case(IecCase::ecd, 3.0)));
  CHECK((slow->velocity({0, 0, kHubHeight}, 10.0) - Vector3d(-18.0, 0.0, 0.0)).norm() < 1e-12);
}

TEST_CASE("extreme shear grows and goes, upwards or across") {
  const double size = 2.5 + 0.2 * 6.4 * 2.254 * std::pow(kRotorDiameter / 42.0, 0.25);
  for (const int sign : {1, -1})
    for (const IecShear shear : {IecShear::vertical, IecShear::horizontal}) {
      IecWind iec = of_case(IecCase::ews, 14.0);
      iec.sign = sign;
      iec.shear = shear;
      const Wind wind = make_condition(iec);
      for (const double t : {0.0, 3.0, 6.0, 9.0, 12.0, 20.0}) {
        const double rise = t < 12.0 ? 1.0 - std::cos(2 * kHalfTurn * t / 12.0) : 0.0;
        for (const double z : {-63.0, 0.0, 40.0})
          for (const double y : {-63.0, 10.0}) {
            const double share = (shear == IecShear::vertical ? z : y) / kRotorDiameter;
            const double expected =
                14.0 * std::pow((kHubHeight + z) / kHubHeight, 0.2) + sign * share * size * rise;
            CHECK(speed_of(wind, t, z, y) == doctest::Approx(expected));
          }
      }
    }
}

TEST_CASE("extreme wind speeds are those of the class, at all heights") {
  IecWind iec{
      .turbine = IecClass::ii_a, .condition = IecCase::ewm, .rotor_diameter = kRotorDiameter};
  const Wind steady = make_condition(iec);
  for (const double z : {-60.0, 0.0, 60.0})
    CHECK(speed_of(steady, 3.0, z) ==
          doctest::Approx(1.4 * 42.5 * std::pow((kHubHeight + z) / kHubHeight, 0.11)));
  iec.period = 1;
  CHECK(speed_of(make_condition(iec), 3.0) == doctest::Approx(0.8 * 1.4 * 42.5));
  iec.turbulent = true;
  const Wind turbulent = make_condition(iec);
  CHECK(turbulent.velocity.x() == doctest::Approx(0.8 * 42.5));
  CHECK(turbulent.turbulence->intensity == doctest::Approx(0.11));
}

TEST_CASE("a condition is read in one line, of the model's heights or of those given") {
  const std::string heights = "reference_height = 90\n";
  const auto read = [&](const std::string& iec, const std::string& other = "") {
    return read_wind_text("[wind]\n" + heights + other + "iec = { " + iec + " }\n");
  };
  const std::string etm = "class = \"IB\", case = \"ETM\", speed = 14, rotor_diameter = 126";
  CHECK(read(etm) == make_condition(of_case(IecCase::etm, 14.0)));
  // The velocity's direction counts, and what is given of the box and the profile.
  const Wind own = read(etm + ", seed = 4",
                        "velocity = [0, 1, 0]\nshear_exponent = 0.1\n"
                        "turbulence = { points = 21, scale = \"none\" }\n");
  CHECK(own.velocity == Vector3d(0.0, 14.0, 0.0));
  CHECK(own.shear_exponent == 0.1);
  CHECK(own.turbulence->points == std::array<int, 2>{21, 21});
  CHECK(own.turbulence->scale == TurbulenceScale::none);
  CHECK(own.turbulence->seed == 4);
  CHECK(deviation_of(own) == doctest::Approx(3.28384));
  // A low hub has a box that ends on the ground.
  const Wind low = read_wind_text("[wind]\nreference_height = 70\niec = { " + etm + " }\n");
  CHECK(low.turbulence->height == 140.0);
}

TEST_CASE("conditions that cannot be are refused") {
  const auto refused = [](const std::string& keys, const std::string& expected) {
    CAPTURE(keys);
    check_message(message_of([&] { read_wind_text("[wind]\n" + keys); }), "f.toml:" + expected);
  };
  const std::string height = "reference_height = 90\n";
  refused("iec = { class = \"IB\", case = \"NWP\", speed = 14 }",
          "1:1: wind.reference_height: is missing, expected the height of the hub over the ground "
          "(m), for iec");
  refused(height + "iec = { class = \"IB\", case = \"ETM\", speed = 14 }",
          "3:7: wind.iec.rotor_diameter: is missing, expected one (m), as the model has no blades "
          "that tell it");
  refused(height + "iec = { class = \"IB\", case = \"NWP\" }",
          "3:7: wind.iec.speed: is missing, expected the mean speed at the hub (m/s)");
  refused(height + "iec = { class = \"IB\", case = \"EWM\", speed = 14 }",
          "3:45: wind.iec.speed: given along with case \"EWM\", whose speed is that of the class");
  refused(height + "iec = { case = \"NWP\", speed = 14 }",
          "3:7: wind.iec.class: is missing, expected \"IA\", \"IB\", \"IC\", \"IIA\", \"IIB\", "
          "\"IIC\", \"IIIA\", \"IIIB\" or \"IIIC\"");
  refused(height + "iec = { class = \"IB\", case = \"NTM\", speed = 14, start = 3 }",
          "3:57: wind.iec.start: does not belong to case \"NTM\", expected only with case \"EOG\", "
          "\"EDC\", \"ECD\" or \"EWS\"");
  refused(height + "iec = { class = \"IB\", case = \"EDC\", speed = 14, sign = 0 }",
          "3:56: wind.iec.sign: is 0, expected 1 or -1");
  refused(height + "iec = { class = \"IB\", case = \"EWM\", period = 10 }",
          "3:46: wind.iec.period: is 10, expected 1 or 50 years");
  refused(
      height + "iec = { class = \"IIB\", case = \"EOG\", speed = 48, rotor_diameter = 126 }",
      "3:46: wind.iec.speed: is 48, expected less than 47.6 (m/s), the extreme speed of a year");
  refused(height + "iec = { class = \"IB\", case = \"NWP\", speed = 14 }\ngust = { amplitude = 3 }",
          "4:8: wind.gust: given along with iec, which gives the wind; expected only one of them");
  refused(
      height + "iec = { class = \"IB\", case = \"NWP\", speed = 14 }\nturbulence = { seed = 3 }",
      "4:14: wind.turbulence: given along with case \"NWP\" of iec, which has none; expected "
      "none");
  // Filled in code.
  CHECK(message_of([] { make_condition({.condition = IecCase::nwp, .speed = -1.0}); }) ==
        "is -1, expected a number greater than 0 (m/s)");
  CHECK(message_of([] { make_condition({.condition = IecCase::edc, .speed = 9.0, .sign = 2}); }) ==
        "is 2, expected a whole number from -1 to 1");
}
