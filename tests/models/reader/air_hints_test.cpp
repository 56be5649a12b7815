// Drag slightly below zero, which real files have: read, and told.

#include "models/reader/spatial/air_hints.h"

#include "models/air/airfoil_reader.h"
#include "tests/message_of.h"
#include "tests/models/reader/air_texts.h"
#include "tests/models/reader/check_message.h"

using namespace spoke;
using spoke::test::kAirText;
using spoke::test::message_of;

TEST_CASE("a polar whose drag dips below zero is read, and told with its angle") {
  CHECK(find_air_hints(parse_scenario(kAirText, "f.toml")).empty());
  std::string text = kAirText;
  const std::string good = "drag = [0.02, 1.0, 0.01, 1.0, 0.02]";
  text.replace(text.rfind(good), good.size(), "drag = [0.02, 1.0, -0.0035, 1.0, 0.02]");
  CHECK(find_air_hints(parse_scenario(text, "f.toml")) ==
        std::vector<std::string>{
            "aerofoil \"plate\": drag is -0.0035 at 0 degrees, expected 0 or more"});
}

TEST_CASE("a file's drag is told likewise, and refused where it cannot be an extrapolation") {
  const auto table = [](const std::string& drag) {
    return "-180 0 0.01\n0 0 0.01\n175 -0.3 " + drag + "\n180 0 0.01\n";
  };
  Scenario scenario = parse_scenario(kAirText, "f.toml");
  scenario.space->air->airfoils[0] = air::parse_airfoil(table("-0.0035"), "polar.txt", "thick");
  CHECK(find_air_hints(scenario) ==
        std::vector<std::string>{
            "aerofoil \"thick\": drag is -0.0035 at 175 degrees, expected 0 or more"});
  CHECK(message_of([&] { air::parse_airfoil(table("-0.35"), "polar.txt", "thick"); }) ==
        "polar.txt:3: drag is -0.35, expected 0 to 100");
}
