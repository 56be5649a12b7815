// Values that the reader makes of air, and the files that it makes of these again.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "models/scenario.h"
#include "tests/models/inline_toml.h"
#include "tests/models/reader/air_texts.h"
#include "tests/models/reader/spatial_texts.h"

using namespace spoke;
using spoke::test::document_of;
using spoke::test::edited;
using spoke::test::kAirText;

TEST_CASE("air is read as it stands, and written as it is read") {
  const Scenario scenario = parse_scenario(kAirText, "f.toml");
  const spatial::Model& model = *scenario.space;
  REQUIRE(model.air.has_value());
  CHECK(model.air->density == 1.2);
  CHECK(model.air->viscosity == 1.5e-5);
  CHECK(model.air->wind.velocity == Eigen::Vector3d(0.0, 0.0, 8.0));
  REQUIRE(model.air->airfoils.size() == 2);
  CHECK(model.air->airfoils[0].polars[0].moment.empty());
  CHECK(model.air->airfoils[1].polars[1].reynolds == 1e6);
  CHECK(model.air->airfoils[1].polars[1].lift[3] == 1.2);
  REQUIRE(model.blades.size() == 3);
  const spatial::BladeAerodynamics& blade = model.blades[2].aerodynamics.value();
  CHECK(blade.station == std::vector<double>{1.0, 4.0, 8.0});
  CHECK(blade.chord[1] == 0.5);
  CHECK(blade.twist[0] == 0.2);
  CHECK(blade.center[2] == 0.02);
  CHECK(blade.airfoil[0] == "thick");
  CHECK(!blade.leads_backward);
  const std::string json = scenario.to_json();
  const Scenario again = parse_scenario(document_of(json), "f");
  CHECK(again.to_json() == json);
  CHECK(again.space->air->airfoils == model.air->airfoils);
  CHECK(again.space->blades[0].aerodynamics == model.blades[0].aerodynamics);
}

TEST_CASE("what is left out of air has its documented values") {
  std::string text = kAirText;
  text = edited(text, "density = 1.2\nviscosity = 1.5e-5\n", "");
  text = edited(
      text, "[aerodynamics]\ninduction = \"momentum\"\ninflow = \"dynamic\"\nstall = \"dynamic\"\n",
      "");
  text = edited(text, "[wind]\nvelocity = [0.0, 0.0, 8.0]\n", "");
  text = edited(text, "twist = [0.2, 0.1, 0.0]\n", "");
  text = edited(text, "chord = [0.6, 0.5, 0.3]", "chord = 0.5");
  const spatial::Model model = *parse_scenario(text, "f.toml").space;
  CHECK(model.air->density == 1.225);
  CHECK(model.air->viscosity == 1.5e-5);
  CHECK(model.air->induction == spatial::Induction::momentum);
  CHECK(model.air->inflow == spatial::Inflow::dynamic);
  CHECK(model.air->stall == spatial::Stall::dynamic);
  CHECK(model.air->inflow_factor == 1.0);
  CHECK(model.air->wind.velocity.isZero(0.0));
  CHECK(model.blades[0].aerodynamics->twist.empty());
  CHECK(model.blades[0].aerodynamics->chord == std::vector<double>(3, 0.5));
}

TEST_CASE("an aerofoil that no table names is a file beside the scenario") {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / "spoke_air_reader_test";
  std::filesystem::create_directories(folder / "polars");
  std::ofstream(folder / "polars/plate.txt")
      << "# angle lift drag\n-180 0 0.02\n0 0 0.01\n90 0.5 1\n180 0 "
         "0.02\n";
  const std::string text = edited(kAirText, "airfoil = [\"thick\", \"plate\", \"plate\"]",
                                  "airfoil = \"polars/plate.txt\"");
  const spatial::Model model = *parse_scenario(text, (folder / "f.toml").string()).space;
  REQUIRE(model.air->airfoils.size() == 3);
  CHECK(model.air->airfoils[2].name == "polars/plate.txt");
  CHECK(model.air->airfoils[2].polars[0].drag[2] == 1.0);
  std::filesystem::remove_all(folder);
}

TEST_CASE("aerodynamics of blades without air is kept, and does nothing") {
  std::string text = kAirText;
  text.erase(text.find("[air]"), text.find("[[sensor]]") - text.find("[air]"));
  text.erase(text.find("[[sensor]]"), text.find("[integration]") - text.find("[[sensor]]"));
  text.erase(text.find("[[airfoil]]"), text.find("[integration]") - text.find("[[airfoil]]"));
  const spatial::Model model = *parse_scenario(text, "f.toml").space;
  CHECK(!model.air.has_value());
  CHECK(model.blades[0].aerodynamics.has_value());
}
