// Aerodynamics of AeroDyn's files on blades of BeamDyn and ElastoDyn, against places and angles of
// the nodes that are found from the files by other ways.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "models/air/airfoil_reader.h"
#include "tests/contains.h"
#include "tests/program/foreign/samples.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr const char* kAero = "small_AeroDyn.dat";
constexpr const char* kAeroNodes = "small_AeroDyn_blade.dat";
constexpr double kDegrees = std::numbers::pi / 180.0;

const std::vector<std::string>& all_files() {
  static const std::vector<std::string> names = {"small_BeamDyn.dat", "small_ElastoDyn.dat", kAero};
  return names;
}

/// Rows of the blade file: span, curve, sweep, curve angle, twist, chord, aerofoil.
std::vector<std::vector<double>> node_rows() {
  auto rows = numbers_by_line(samples().at(kAeroNodes));
  return {rows.begin() + 6, rows.end()};
}

/// The axis of BeamDyn's blade in BeamDyn's axes: x and y over z.
DenseSpline key_points() {
  const auto rows = numbers_by_line(samples().at("small_BeamDyn.dat"));
  std::vector<double> z, x, y;
  for (std::size_t i = 24; i < 31; ++i) {
    x.push_back(rows[i][0]);
    y.push_back(rows[i][1]);
    z.push_back(rows[i][2]);
  }
  return {z, {x, y}};
}

/// The twist of sections at a station, by a search through all of them.
double section_twist(const spatial::Sections& s, double x) {
  for (std::size_t i = 1; i < s.station.size(); ++i)
    if (x <= s.station[i])
      return std::lerp(s.twist[i - 1], s.twist[i],
                       (x - s.station[i - 1]) / (s.station[i] - s.station[i - 1]));
  return s.twist.back();
}

/// Returns texts with one of the file of a name replaced.
Texts changed(const std::string& name, std::string_view from, std::string_view to) {
  Texts texts = samples();
  texts[name] = replaced(texts.at(name), from, to);
  return texts;
}

}  // namespace

TEST_CASE("nodes of AeroDyn have their places, chords and angles") {
  const auto imported = import_texts(samples(), all_files());
  const spatial::Model& model = *imported.scenario.space;
  REQUIRE(model.blades.size() == 3);
  const spatial::BladeAerodynamics& air = *model.blades[2].aerodynamics;
  const auto rows = node_rows();
  const DenseSpline axis = key_points();
  REQUIRE(air.station.size() == rows.size());
  CHECK_FALSE(air.leads_backward);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double>& row = rows[i];
    CHECK(air.station[i] == row[0]);
    CHECK(air.chord[i] == row[5]);
    const double twist = section_twist(model.blades[2].beam.sections, row[0]) + air.twist[i];
    CHECK(twist == doctest::Approx(-row[4] * kDegrees).epsilon(1e-12));
    // In the file's axes the chord points from the trailing edge, at y, to the leading one.
    const double beta = row[4] * kDegrees;
    const double x = row[1] - axis.at(0, row[0]), y = row[2] - axis.at(1, row[0]);
    CHECK(std::abs(air.center[i] - (-x * std::sin(beta) - y * std::cos(beta))) < 1e-10);
  }
}

TEST_CASE("polars of AeroDyn are those of its files") {
  const auto imported = import_texts(samples(), all_files());
  const spatial::Model& model = *imported.scenario.space;
  const auto rows = node_rows();
  const std::vector<std::string> files = {"small_AeroDyn_polar_round", "small_AeroDyn_polar_thick",
                                          "small_AeroDyn_polar_thin"};
  REQUIRE(model.air->airfoils.size() == files.size());
  for (std::size_t k = 0; k < files.size(); ++k) {
    const std::string file = files[k] + ".dat";
    auto own = air::parse_airfoil(samples().at(file), file, files[k]);
    if (own.polars.size() == 1) own.polars[0].reynolds = 0.0;  // that of a plain table
    CHECK(model.air->airfoils[k] == own);
    CHECK(imported.tables[k].name == "airfoils/" + files[k] + ".txt");
    CHECK(model.air->airfoils[k] == air::parse_airfoil(imported.tables[k].text, "table", files[k]));
    CHECK(contains(imported.text, "file = \"airfoils/" + files[k] + ".txt\"   # " + file));
  }
  CHECK(model.air->airfoils[2].polars.size() == 2);
  for (std::size_t i = 0; i < rows.size(); ++i)
    CHECK(model.blades[0].aerodynamics->airfoil[i] ==
          files[static_cast<std::size_t>(rows[i][6]) - 1]);
}

TEST_CASE("air and its models are AeroDyn's") {
  const auto air_of = [](const Texts& texts) {
    return *import_texts(texts, all_files()).scenario.space->air;
  };
  const spatial::Air air = air_of(samples());
  CHECK(air.density == 1.2);
  CHECK(air.viscosity == 1.6e-5);
  CHECK(air.induction == spatial::Induction::momentum);
  CHECK(air.inflow == spatial::Inflow::quasi_steady);
  CHECK(air.stall == spatial::Stall::dynamic);
  CHECK(air_of(changed(kAero, "1             WakeMod", "0 WakeMod")).induction ==
        spatial::Induction::none);
  CHECK(air_of(changed(kAero, "1             WakeMod", "2 WakeMod")).inflow ==
        spatial::Inflow::dynamic);
  // Of version 3.5: larger by 10 where momentum theory is that for cone and prebend.
  const auto by_wake = [&](const char* wake) {
    return air_of(changed(kAero, "1             WakeMod", std::string(wake) + " WakeMod"));
  };
  CHECK(by_wake("10").induction == spatial::Induction::none);
  CHECK(by_wake("11").induction == spatial::Induction::momentum);
  CHECK(by_wake("11").inflow == spatial::Inflow::quasi_steady);
  CHECK(by_wake("12").inflow == spatial::Inflow::dynamic);
  CHECK(air_of(changed(kAero, "2             AFAeroMod", "1 AFAeroMod")).stall ==
        spatial::Stall::steady);
  CHECK(air_of(changed(kAero, "1.2           AirDens", "\"DEFAULT\" AirDens")).density == 1.225);
  // The keys of later versions.
  Texts later = changed(kAero, "WakeMod ", "Wake_Mod ");
  later[kAero] = replaced(later[kAero], "2             AFAeroMod", "3 UA_Mod");
  CHECK(air_of(later).inflow == spatial::Inflow::quasi_steady);
  CHECK(air_of(later).stall == spatial::Stall::dynamic);
  later[kAero] = replaced(later[kAero], "3 UA_Mod", "2 DBEMT_Mod\n0 UA_Mod");
  CHECK(air_of(later).inflow == spatial::Inflow::dynamic);
  CHECK(air_of(later).stall == spatial::Stall::steady);
}

TEST_CASE("what AeroDyn's files ask for and the scenario has not is said") {
  const auto left_out = [](const Texts& texts) {
    std::string all;
    for (const std::string& text : import_texts(texts, all_files()).left_out) all += text + '\n';
    return all;
  };
  CHECK(contains(left_out(samples()), "small_AeroDyn.dat: drag in the induction"));
  CHECK(contains(left_out(changed(kAero, "1             WakeMod", "3 WakeMod")),
                 "WakeMod, small_AeroDyn.dat:6: the free vortex wake"));
  CHECK(contains(left_out(changed(kAero, "1             WakeMod", "12 WakeMod")),
                 "WakeMod, small_AeroDyn.dat:6: momentum theory for large cone and prebend"));
  CHECK(contains(left_out(changed(kAero, "True          HubLoss", "False HubLoss")),
                 "HubLoss False, small_AeroDyn.dat:15"));
  CHECK(contains(left_out(changed(kAero, "2             AFTabMod", "1 AFTabMod")),
                 "further tables of 1 aerofoils"));
  CHECK(contains(left_out(changed(kAeroNodes, "-9.96295E-02", "-3.0")), "off the chord"));
  CHECK_FALSE(contains(left_out(samples()), "off the chord"));
}

TEST_CASE("AFTabMod takes the first table, and UseBlCm no moment") {
  Texts texts = changed(kAero, "2             AFTabMod", "1 AFTabMod");
  texts[kAero] = replaced(texts[kAero], "True          UseBlCm", "F UseBlCm");
  const auto imported = import_texts(texts, all_files());
  const spatial::Airfoil& thin = imported.scenario.space->air->airfoils[2];
  const auto whole = air::parse_airfoil(samples().at("small_AeroDyn_polar_thin.dat"), "f", "f");
  REQUIRE(thin.polars.size() == 1);
  CHECK(thin.polars[0].lift == whole.polars[0].lift);
  CHECK(thin.polars[0].moment.empty());
  CHECK(air::parse_airfoil(imported.tables[2].text, "t", thin.name) == thin);
  Texts without = changed(kAero, "4             InCol_Cm", "0 InCol_Cm");
  CHECK(
      import_texts(without, all_files()).scenario.space->air->airfoils[1].polars[0].moment.empty());
}

TEST_CASE("blades of ElastoDyn and one of BeamDyn alone have aerodynamics, too") {
  const Texts texts = changed(kAeroNodes, " 2.00000E+01", " 1.85000E+01");
  const auto turbine = import_texts(texts, {"small_ElastoDyn.dat", kAero});
  const spatial::Blade& blade = turbine.scenario.space->blades.at(0);
  const auto rows = node_rows();
  REQUIRE(blade.aerodynamics->station.back() == 18.5);
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {  // the axis is straight
    const double beta = rows[i][4] * kDegrees;
    CHECK(std::abs(blade.aerodynamics->center[i] + rows[i][1] * std::sin(beta) +
                   rows[i][2] * std::cos(beta)) < 1e-12);
  }
  const auto alone = import_texts(samples(), {"small_BeamDyn.dat", kAero, kAeroNodes});
  CHECK(alone.scenario.space->blades.size() == 1);
  CHECK(alone.scenario.space->blades[0].aerodynamics->station.size() == rows.size());
}

TEST_CASE("blades that pitch stand at ElastoDyn's angle, and vibrate as without air") {
  const Texts texts = changed("small_ElastoDyn.dat", "30            RotSpeed",
                              "3.0 BlPitch(1) - degrees\n30 RotSpeed");
  const auto imported = import_texts(texts, all_files());
  CHECK(contains(imported.text, "motion = { constant = -0.052359877559829"));
  CHECK(contains(imported.text, "}   # BlPitch(1), small_ElastoDyn.dat:12, in rad"));
  CHECK_FALSE(contains(imported.text, "initial conditions, pitch"));
  const auto bare = import_texts(samples(), {"small_BeamDyn.dat"});
  const auto aired = import_texts(samples(), {"small_BeamDyn.dat", kAero});
  check_same_frequencies(aired.scenario, bare.scenario, 4);
}
