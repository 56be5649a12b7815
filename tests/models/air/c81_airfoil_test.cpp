// Tables in the form C81: three grids, columns of fixed width, rows that go on, and polars that are
// chosen by the Mach number.

#include "models/air/c81_airfoil.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "models/air/airfoil_reader.h"
#include "models/air/section_polar.h"
#include "models/scenario.h"
#include "tests/contains.h"
#include "tests/message_of.h"

using namespace spoke;
using doctest::Approx;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// A coefficient over angle [degrees] and Mach number.
using Law = std::function<double(double, double)>;

std::string field(double number) {
  char text[16];
  std::snprintf(text, sizeof text, "%7.4g", number);
  return text;
}

/// Writes a table, nine numbers to a line.
std::string write_table(const std::vector<double>& machs, const std::vector<double>& angles,
                        const Law& law) {
  std::string text;
  const auto row = [&](const std::string& first, const std::function<double(double)>& number) {
    for (std::size_t k = 0; k < machs.size(); ++k) {
      if (k % 9 == 0) text += k == 0 ? first : "\n       ";
      text += field(number(machs[k]));
    }
    text += '\n';
  };
  row("       ", [](double mach) { return mach; });
  for (const double angle : angles)
    row(field(angle), [&](double mach) { return law(angle, mach); });
  return text;
}

const std::vector<double> kFewMachs = {0.0, 0.6};
const std::vector<double> kManyMachs = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0};
const std::vector<double> kAngles = {-180.0, -20.0, -10.0, 0.0, 10.0, 20.0, 180.0};
const std::vector<double> kOtherAngles = {-180.0, -15.0, 15.0, 180.0};

// Linear in each of both between the points of its own grid, but for their ends.
double lift_law(double angle, double mach) {
  return std::abs(angle) > 90.0 ? 0.0 : 0.1 * angle * (1.0 + 0.5 * mach);
}
double drag_law(double angle, double mach) { return 0.01 + 0.0005 * std::abs(angle) + 0.02 * mach; }
double moment_law(double, double mach) { return -0.01 - 0.02 * mach; }

std::string counts(const char* numbers) {
  std::string title = "NACA 0012, of the tests";
  title.resize(30, ' ');
  return title + numbers + '\n';
}

std::string sample() {
  return counts(" 2 711 4 2 4") + write_table(kFewMachs, kAngles, lift_law) +
         write_table(kManyMachs, kOtherAngles, drag_law) +
         write_table(kFewMachs, kOtherAngles, moment_law);
}

}  // namespace

TEST_CASE("C81: each table is linear between the points of its own grid") {
  REQUIRE(air::is_c81_airfoil(sample()));
  const spatial::Airfoil airfoil = air::parse_airfoil(sample(), "a.c81", "a");
  CHECK(airfoil.polars.size() == kManyMachs.size());
  CHECK(air::find_choice(airfoil) == air::ChosenBy::mach);
  const air::SectionPolar section(airfoil, airfoil, 0.0);
  for (const double mach : {0.0, 0.05, 0.3, 0.45, 0.6, 0.75, 1.0, 1.4})
    for (const double angle : {-20.0, -13.0, 0.0, 4.0, 12.5, 20.0}) {
      CAPTURE(mach);
      CAPTURE(angle);
      const air::PolarValues values = section.values(section.level(1e6, mach), angle * kDegree);
      CHECK(values.lift == Approx(lift_law(angle, std::min(mach, 0.6))).epsilon(1e-12));
      const double of_drag = std::min(mach, 1.0);
      const double at_15 = drag_law(15.0, of_drag);
      const double drag = std::abs(angle) <= 15.0 ? at_15
                                                  : at_15 + (std::abs(angle) - 15.0) / 165.0 *
                                                                (drag_law(180.0, of_drag) - at_15);
      CHECK(values.drag == Approx(drag).epsilon(1e-12));
      CHECK(values.moment == Approx(moment_law(0.0, std::min(mach, 0.6))).epsilon(1e-12));
    }
}

TEST_CASE("C81: what is not as it must be is refused with its line") {
  const auto refusal = [](std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    text.replace(at, from.size(), to);
    return test::message_of([&] { air::parse_airfoil(text, "a.c81", "a"); });
  };
  const std::string text = sample();
  CHECK(test::contains(
      refusal(text, "      0    0.6\n", "      0      0\n"),
      "a.c81:2: Mach number is 0, expected 0 or more, and more than the one before"));
  CHECK(test::contains(refusal(text, "    -20     -2", "    -20      x"),
                       "a.c81:4: found \"x\", expected a number: row 2 of lift"));
  CHECK(test::contains(refusal(text, "    -20     -2", "   -200     -2"),
                       "a.c81:4: angle of attack is -200 degrees, expected more than"));
  CHECK(test::contains(refusal(text, "   -180", "   -170"),
                       "lift is given from -170 to 180 degrees, expected -180 to 180"));
  CHECK(test::contains(
      test::message_of([&] { air::parse_airfoil(text.substr(0, text.size() - 40), "a.c81", "a"); }),
      "expected"));
}

TEST_CASE("polars by Mach number stand in scenarios as those by Reynolds number") {
  const auto polars = [](const std::string& first, const std::string& second) {
    const std::string rest =
        "angle = [-3.141592653589793, 0.0, 3.141592653589793]\nlift = [0.0, 0.1, 0.0]\ndrag = "
        "[0.1, 0.01, 0.1]\n";
    return "world = \"space\"\n[hub]\nradius = 0.5\n[hub.drive]\nkind = \"constant\"\nspeed = "
           "4.0\n[blade]\ncount = 1\nlength = 8.0\n[blade.sections]\nmass_per_length = 3.0\n"
           "axial_stiffness = 3e7\nflap_stiffness = 3e4\nlag_stiffness = 3e4\n"
           "torsion_stiffness = 3e4\n[blade.aerodynamics]\nstation = [1.0, 8.0]\nchord = 0.3\n"
           "airfoil = \"a\"\n[air]\nsound_speed = 330.0\n[[airfoil]]\nname = "
           "\"a\"\n[[airfoil.polar]]\n" +
           first + rest + "[[airfoil.polar]]\n" + second + rest + "[integration]\nduration = 1.0\n";
  };
  const Scenario scenario = parse_scenario(polars("mach = 0.0\n", "mach = 0.5\n"), "f.toml");
  CHECK(scenario.space->air->sound_speed == 330.0);
  CHECK(*scenario.space->air->airfoils.front().polars.at(1).mach == 0.5);
  const auto refusal = [&](const std::string& first, const std::string& second) {
    return test::message_of([&] { parse_scenario(polars(first, second), "f.toml"); });
  };
  CHECK(test::contains(refusal("mach = 0.5\n", "mach = 0.5\n"),
                       "airfoil.1.polar.2.mach: is 0.5, expected more than in the polar before"));
  CHECK(test::contains(refusal("mach = 0.5\n", "reynolds = 1e6\n"),
                       "airfoil.1.polar.2.mach: is missing, expected one, as of the first polar"));
  CHECK(test::contains(refusal("reynolds = 1e6\n", "mach = 0.5\n"),
                       "airfoil.1.polar.2.mach: is 0.5, expected none, as of the first polar"));
  CHECK(test::contains(refusal("mach = 0.1\nreynolds = 1e6\n", "mach = 0.5\n"),
                       "airfoil.1.polar.1.mach: is 0.1, given along with a Reynolds number"));
}
