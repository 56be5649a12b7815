// Aerofoil files that cannot be used: one located line each.

#include <doctest/doctest.h>

#include <limits>
#include <numbers>
#include <vector>

#include "models/air/airfoil_check.h"
#include "models/air/airfoil_reader.h"
#include "models/error.h"
#include "tests/message_of.h"
#include "tests/models/air/airfoil_texts.h"
#include "tests/models/exchange.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// A change of a text, the line named and what the message says of it.
struct Case {
  std::string from, to;
  int line;
  std::string message;
};

void check_cases(const std::string& text, const std::vector<Case>& cases) {
  for (const Case& bad : cases) {
    CAPTURE(bad.to);
    try {
      air::parse_airfoil(exchange(text, bad.from, bad.to), "a.dat", "a");
      FAIL_CHECK("no error, expected " << bad.message);
    } catch (const InputError& error) {
      const std::string place = bad.line > 0 ? "a.dat:" + std::to_string(bad.line) : "a.dat";
      CHECK(std::string(error.what()) == place + ": " + bad.message);
      CHECK(error.place().line == bad.line);
    }
  }
}

}  // namespace

TEST_CASE("airfoil_errors: plain tables") {
  check_cases(
      kPlainAirfoil,
      {{"10 1.2  0.02", "10 x1.2  0.02", 7,
        "is \"x1.2\", expected a lift coefficient, a finite number"},
       {"0  0.3  0.01", "0  nan  0.01", 6,
        "is \"nan\", expected a lift coefficient, a finite number"},
       {"90 0.05", "ninety 0.05", 8,
        "is \"ninety\", expected an angle of attack (degrees), a finite number"},
       {"90 0.05 1.4 -0.4", "90 0.05 1.4 -", 8,
        "is \"-\", expected a moment coefficient, a finite number"},
       {"90 0.05 1.4 -0.4", "90 0.05", 8, "the line ends here, expected a drag coefficient"},
       {"90 0.05 1.4 -0.4", "90", 8, "the line ends here, expected a lift coefficient"},
       {"90 0.05 1.4 -0.4", "90 0.05 1.4", 8, "has 3 columns, expected 4 as in the first row"},
       {"90 0.05 1.4 -0.4", "90 0.05 1.4 -0.4 1", 8,
        "has 5 columns, expected 3 or 4: angle of attack (degrees), lift, drag, moment"},
       {"10 1.2", "-20 1.2", 7,
        "angle of attack is -20 degrees, expected more than in the row before, 0"},
       {"10 1.2", "0 1.2", 7,
        "angle of attack is 0 degrees, expected more than in the row before, 0"},
       {"-180, 0.0", "-170, 0.0", 3,
        "angle of attack is -170 degrees, expected -180 in the first row"},
       {"180 0.0 0.02 0", "175 0.0 0.02 0", 9,
        "angle of attack is 175 degrees, expected 180 in the last row"},
       {"180 0.0 0.02 0", "360 0.0 0.02 0", 9,
        "angle of attack is 360 degrees, expected 180 in the last row"},
       {"10 1.2  0.02", "10 1.2  -0.02", 7, "drag is -0.02, expected 0 to 100"},
       {"10 1.2  0.02", "10 1e3  0.02", 7, "lift is 1000, expected -100 to 100"},
       {"10 1.2  0.02 -0.04", "10 1.2  0.02 -200", 7, "moment is -200, expected -100 to 100"},
       {"180 0.0 0.02 0", "180 0.5 0.02 0", 9,
        "lift is 0.5 at 180 degrees, expected 0 as at -180 degrees"},
       {"180 0.0 0.02 0", "180 0.0 0.2 0", 9,
        "drag is 0.2 at 180 degrees, expected 0.02 as at -180 degrees"},
       {"180 0.0 0.02 0", "180 0.0 0.02 0.3", 9,
        "moment is 0.3 at 180 degrees, expected 0 as at -180 degrees"}});
  const std::string two = "-180 0 1\n180 0 1\n";
  check_cases(two, {{"-180 0 1\n", "-180 0 1\n", 1, "has 2 angles of attack, expected 3 or more"},
                    {"-180 0 1\n180 0 1\n", "# nothing\n", 0,
                     "has no rows, expected angle of attack, lift and drag"},
                    {"180 0 1", "180; 0 1", 1,
                     "is \"-180;\", expected an angle of attack (degrees), a finite number"}});
}

TEST_CASE("airfoil_errors: AeroDyn's files") {
  check_cases(kAerodynAirfoil,
              {{"2           NumTabs", "0           NumTabs", 5,
                "NumTabs is \"0\", expected a whole number from 1 to 100"},
               {"2           NumTabs", "two         NumTabs", 5,
                "NumTabs is \"two\", expected a whole number from 1 to 100"},
               {"2           NumTabs", "3           NumTabs", 29,
                "the file ends here, expected a line of a value and Re"},
               {"  0.5  Re", "  DEFAULT  Re", 6,
                "Re is \"DEFAULT\", expected the Reynolds number in millions"},
               {"  0.5  Re", "  -1  Re", 6,
                "Re is -1, expected the Reynolds number in millions, more than 0"},
               {"  2.0  Re", "  0.5  Re", 22,
                "Re makes a Reynolds number of 5e+05, expected more than that of line 6, 5e+05"},
               {"  2.0  Re", "  0.4  Re", 22,
                "Re makes a Reynolds number of 4e+05, expected more than that of line 6, 5e+05"},
               {"  0    UserProp   !", "  off  UserProp   !", 7,
                "UserProp is \"off\", expected a control setting, a finite number"},
               {"  5    NumAlf", "  2    NumAlf", 14,
                "NumAlf is \"2\", expected a whole number from 3 to 100000"},
               {"  5    NumAlf", "  5.5  NumAlf", 14,
                "NumAlf is \"5.5\", expected a whole number from 3 to 100000"},
               {"  5    NumAlf", "  6    NumAlf", 22,
                "is \"Re\", expected a lift coefficient, a finite number"},
               {"  5    NumAlf", "  4    NumAlf", 19,
                "angle of attack is 10 degrees, expected 180 in the last row"},
               {"  4    NumAlf", "  5    NumAlf", 29,
                "the file ends here, expected row 5 of 5 of the table"},
               {"   10.00  1.300  0.0200 -0.0600", "   10.00  1.300  0.0200", 19,
                "row 4 has 3 columns, expected 4 as in the first row"},
               {"   10.00  1.300", "  -10.00  1.300", 19,
                "angle of attack is -10 degrees, expected more than in the row before, 0"},
               {"   10.00  1.500  0.0150", "   10.00  1.500  -0.0150", 28,
                "drag is -0.015, expected 0 to 100"},
               {"   10.00  1.500  0.0150", "   10.00  inf  0.0150", 28,
                "is \"inf\", expected a lift coefficient, a finite number"}});
  const std::string moved =
      exchange(exchange(kAerodynAirfoil, "  0    UserProp", "  1    UserProp"), "  0    UserProp",
               "  2    UserProp");
  check_cases(moved, {{"made up", "made up", 5,
                       "no table has UserProp 0, expected one with the control at rest"}});
}

TEST_CASE("airfoil_errors: aerofoils that a program makes") {
  constexpr double pi = std::numbers::pi;
  const spatial::Polar good{0.0, {-pi, 0.0, pi}, {0.0, 0.5, 0.0}, {1.0, 0.1, 1.0}, {}};
  const auto check = [&](const auto& change, const std::string& expected) {
    spatial::Airfoil airfoil{"a", {good, good}};
    airfoil.polars[0].reynolds = 1e6;
    airfoil.polars[1].reynolds = 2e6;
    change(airfoil);
    CHECK(message_of([&] { air::check_airfoil(airfoil); }) == expected);
  };
  const std::string first = "aerofoil \"a\": polar 1: ";
  check([](auto&) {}, "no error");
  check([](auto& a) { a.polars.resize(1), a.polars[0].reynolds = 0.0; }, "no error");
  check([](auto& a) { a.polars.clear(); }, "aerofoil \"a\": has no polars, expected one or more");
  check([](auto& a) { a.polars[0].reynolds = 0.0; },
        first + "Reynolds number is 0, expected a number greater than 0");
  check(
      [](auto& a) { a.polars[1].reynolds = 1e6; },
      "aerofoil \"a\": polar 2: Reynolds number is 1e+06, expected more than in the polar before");
  check([](auto& a) { a.polars[0].lift.pop_back(); },
        first + "has 2 values of lift, expected one for each of 3 angles of attack");
  check([](auto& a) { a.polars[0].moment = {0.0}; },
        first + "has 1 values of moment, expected one for each of 3 angles of attack");
  check([](auto& a) { a.polars[0].angle[1] = std::numeric_limits<double>::infinity(); },
        first + "row 2: angle of attack is inf degrees, expected a finite number");
  check([](auto& a) { a.polars[0].drag[2] = 0.5; },
        first + "row 3: drag is 0.5 at 180 degrees, expected 1 as at -180 degrees");
}
