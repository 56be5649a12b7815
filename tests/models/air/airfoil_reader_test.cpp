// Aerofoil files that are well.

#include "models/air/airfoil_reader.h"

#include <doctest/doctest.h>

#include <fstream>
#include <numbers>

#include "models/air/airfoil_check.h"
#include "tests/message_of.h"
#include "tests/models/air/airfoil_texts.h"
#include "tests/models/exchange.h"
#include "tests/temporary_folder.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr double kPi = std::numbers::pi;

spatial::Airfoil parse(const std::string& text) {
  const spatial::Airfoil airfoil = air::parse_airfoil(text, "a.dat", "made up");
  air::check_airfoil(airfoil);
  CHECK(airfoil.name == "made up");
  return airfoil;
}

}  // namespace

TEST_CASE("airfoil_reader: a plain table has columns by blanks, tabs or commas") {
  const spatial::Airfoil airfoil = parse(kPlainAirfoil);
  REQUIRE(airfoil.polars.size() == 1);
  const spatial::Polar& polar = airfoil.polars[0];
  CHECK(polar.reynolds == 0.0);
  REQUIRE(polar.angle.size() == 7);
  CHECK(polar.angle.front() == -kPi);
  CHECK(polar.angle[1] == doctest::Approx(-0.5 * kPi));
  CHECK(polar.angle.back() == kPi);
  CHECK(polar.lift == std::vector<double>{0.0, 0.1, -0.8, 0.3, 1.2, 0.05, 0.0});
  CHECK(polar.drag == std::vector<double>{0.02, 1.5, 0.03, 0.01, 0.02, 1.4, 0.02});
  CHECK(polar.moment == std::vector<double>{0.0, 0.4, 0.01, -0.05, -0.04, -0.4, 0.0});
}

TEST_CASE("airfoil_reader: a plain table may be without moments, and have other line ends") {
  const spatial::Polar polar = parse("-180 0 1\r\n0 0 1\r\n180 0 1\r\n").polars.at(0);
  CHECK(polar.moment.empty());
  CHECK(polar.drag == std::vector<double>{1.0, 1.0, 1.0});
  CHECK(parse("-180 0 1\n0 0 1\n180 0 1").polars.at(0) == polar);
}

TEST_CASE("airfoil_reader: AeroDyn's tables, with unsteady parameters or without") {
  const spatial::Airfoil airfoil = parse(kAerodynAirfoil);
  REQUIRE(airfoil.polars.size() == 2);
  CHECK(airfoil.polars[0].reynolds == doctest::Approx(0.5e6));
  CHECK(airfoil.polars[1].reynolds == doctest::Approx(2e6));
  CHECK(airfoil.polars[0].lift == std::vector<double>{0.0, -0.7, 0.4, 1.3, 0.0});
  CHECK(airfoil.polars[1].drag == std::vector<double>{0.05, 0.008, 0.015, 0.05});
  CHECK(airfoil.polars[1].moment == std::vector<double>{0.0, -0.05, -0.06, 0.0});
}

TEST_CASE("airfoil_reader: of AeroDyn's tables by control setting that at rest counts") {
  const std::string text =
      exchange(kAerodynAirfoil, "  0    UserProp\nFalse", " -5.5  Ctrl\nFalse");
  const spatial::Airfoil airfoil = parse(text);
  REQUIRE(airfoil.polars.size() == 1);
  CHECK(airfoil.polars[0].lift[2] == 0.4);
}

TEST_CASE("airfoil_reader: ends that nearly agree become equal") {
  std::string text = exchange(kPlainAirfoil, "180 0.0 0.02 0", "179.95 0.04 0.04 -0.02");
  text = exchange(text, "-180, 0.0", "-180.0004, 0.0");
  const spatial::Polar polar = parse(text).polars.at(0);
  CHECK(polar.angle.front() == -kPi);
  CHECK(polar.angle.back() == kPi);
  CHECK(polar.lift.front() == 0.02);
  CHECK(polar.lift.back() == 0.02);
  CHECK(polar.drag.back() == doctest::Approx(0.03));
  CHECK(polar.moment.front() == doctest::Approx(-0.01));
}

TEST_CASE("airfoil_reader: files are read as their text") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "made_up.dat";
  std::ofstream(file) << kAerodynAirfoil;
  CHECK(air::read_airfoil(file, "made up") == parse(kAerodynAirfoil));
  CHECK(message_of([&] {
          air::read_airfoil(folder.path() / "none", "x");
        }).ends_with("none: no such file, expected an aerofoil file"));
}
