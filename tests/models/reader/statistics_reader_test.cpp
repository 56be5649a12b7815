// Exponents of Woehler's curves: read, checked, written, and what holds without them.

#include "models/reader/statistics_reader.h"

#include "tests/contains.h"
#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using spoke::test::contains;
using spoke::test::kBladeText;
using spoke::test::message_of;

namespace {

constexpr const char* kTower = R"([support]
from = "ground"
[[support.body]]
name = "tower"
kind = "rigid"
mass = 10.0
inertia = 5.0
[[support.joint]]
child = "tower"
kind = "revolute"
axis = [0, 1, 0]
stiffness = 1e4
[support.axle]
body = "tower"
)";

Scenario with(const std::string& exponents) {
  return parse_scenario(kBladeText + kTower + "[statistics]\nexponents = {" + exponents + "}\n",
                        "f.toml");
}

}  // namespace

TEST_CASE("blades are of composite and supports of steel unless the scenario says otherwise") {
  const Scenario plain = with("");
  CHECK(find_wohler_exponent(plain, "blade1") == 10.0);
  CHECK(find_wohler_exponent(plain, "support") == 4.0);
  CHECK_FALSE(contains(plain.to_json(), "statistics"));
  const Scenario given = with("blades = 9, blade2 = 12.5, support = 3");
  CHECK(find_wohler_exponent(given, "blade1") == 9.0);
  CHECK(find_wohler_exponent(given, "blade2") == 12.5);
  CHECK(find_wohler_exponent(given, "support") == 3.0);
  CHECK(contains(given.to_json(), "\"blade2\": 12.5"));
  CHECK(find_wohler_exponent(with("blades = 8"), "support") == 4.0);
}

TEST_CASE("exponents of what is not there, or that no material has, are refused") {
  CHECK(contains(message_of([] { with("tower = 4"); }), "statistics.exponents.tower: unknown key"));
  CHECK(contains(message_of([] { with("blade4 = 4"); }), "statistics.exponents.blade4: unknown"));
  CHECK(contains(message_of([] { with("blades = 0"); }),
                 "statistics.exponents.blades: is 0, expected a number from 1 to 100"));
  Scenario scenario = with("");
  check_statistics(scenario);
  scenario.statistics.exponents["blade4"] = 4.0;
  CHECK(contains(message_of([&] { check_statistics(scenario); }),
                 "statistics.exponents.blade4: is \"blade4\", did you mean \"blade"));
  scenario.statistics.exponents = {{"support", 0.5}};
  CHECK(message_of([&] { check_statistics(scenario); }) ==
        "statistics.exponents.support: is 0.5, expected a number from 1 to 100");
}
