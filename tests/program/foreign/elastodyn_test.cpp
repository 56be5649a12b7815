// Blades, towers and turbines of ElastoDyn against a second converter and closed forms.

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "models/error.h"
#include "tests/contains.h"
#include "tests/program/foreign/samples.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Returns the rows of a table of so many columns, turned into columns.
std::vector<std::vector<double>> columns_of(const std::string& name, std::size_t count) {
  std::vector<std::vector<double>> columns(count);
  for (const auto& line : numbers_by_line(samples().at(name)))
    if (line.size() == count)
      for (std::size_t k = 0; k < count; ++k) columns[k].push_back(line[k]);
  return columns;
}

std::vector<double> times(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

/// The stiffnesses that ElastoDyn does without, by the rule of docs/files.md.
void add_rigid(spatial::Sections& s, double length, double largest) {
  s.axial_stiffness.assign(s.station.size(), largest / std::pow(length / 100.0, 2));
  s.torsion_stiffness.assign(s.station.size(), largest);
}

spatial::Sections convert_blade(double length) {
  const auto columns = columns_of("small_ElastoDyn_blade.dat", 6);
  spatial::Sections s;
  s.station = times(columns[0], length);
  s.twist = times(columns[2], -kDegree);
  s.mass_per_length = times(columns[3], 1.05);
  s.flap_stiffness = times(columns[4], 0.95);
  s.lag_stiffness = times(columns[5], 0.97);
  add_rigid(s, length, 5e7 * 0.97);
  return s;
}

spatial::Sections convert_tower(double height) {
  const auto columns = columns_of("small_ElastoDyn_tower.dat", 4);
  spatial::Sections s;
  s.station = times(columns[0], height);
  s.mass_per_length = times(columns[1], 1.02);
  s.flap_stiffness = times(columns[2], 0.98);
  s.lag_stiffness = times(columns[3], 0.96);
  add_rigid(s, height, 9e9 * 0.98);
  return s;
}

const spatial::Beam& tower_of(const Scenario& scenario) {
  return std::get<spatial::Beam>(scenario.space->subsystems.back().bodies.at(0).shape);
}

}  // namespace

TEST_CASE("a blade of ElastoDyn has the sections and frequencies of a second converter") {
  const auto imported =
      import_texts(samples(), {"small_ElastoDyn_blade.dat"}, {.blade_length = 18.5});
  Scenario expected = imported.scenario;
  expected.space->blades[0].beam.sections = convert_blade(18.5);
  check_same(imported.scenario.space->blades[0].beam.sections,
             expected.space->blades[0].beam.sections);
  check_same_frequencies(imported.scenario, expected, 5);
  const std::vector<double>& ratios = imported.scenario.space->damping.modes.ratios;
  REQUIRE(ratios.size() == 3);  // first flap, first edge, second flap
  CHECK(ratios[0] == doctest::Approx(0.005));
  CHECK(ratios[1] == doctest::Approx(0.006));
  CHECK(ratios[2] == doctest::Approx(0.007));
}

TEST_CASE("a uniform blade of ElastoDyn vibrates as a clamped beam does") {
  constexpr double L = 18.5, m = 20.0, flap = 2e6, edge = 6e6;
  std::string text = samples().at("small_ElastoDyn_blade.dat");
  for (const char* factor : {"1.05 ", "0.95 ", "0.97 "}) text = replaced(text, factor, "1.0 ");
  text = up_to_line(text, 16);
  for (const char* share : {"0", ".25", "0.5", "0.75", "1"})
    text += std::string(share) + " 0.25 0 20 2e6 6e6\n";
  Texts texts = samples();
  texts["small_ElastoDyn_blade.dat"] = text;
  const auto found = frequencies_of(
      import_texts(texts, {"small_ElastoDyn_blade.dat"}, {.blade_length = L}).scenario, 2);
  const double scale = 3.5160153 / (L * L) / (2.0 * std::numbers::pi);
  CHECK(found.at(0) == doctest::Approx(scale * std::sqrt(flap / m)).epsilon(1e-3));
  CHECK(found.at(1) == doctest::Approx(scale * std::sqrt(edge / m)).epsilon(1e-3));
}

TEST_CASE("a tower of ElastoDyn stands as a support, with the frequencies of a second converter") {
  const auto imported =
      import_texts(samples(), {"small_ElastoDyn_tower.dat"}, {.tower_height = 24.0});
  REQUIRE(imported.scenario.space->support);
  const spatial::Beam& tower = tower_of(imported.scenario);
  CHECK(tower.length == 24.0);
  spatial::Beam expected = tower;
  expected.sections = convert_tower(24.0);
  check_same(tower.sections, expected.sections);
  check_same_frequencies(held_blade(tower), held_blade(expected), 4);
  CHECK(imported.scenario.space->support->axle.body == "tower");
  const std::vector<double>& ratios = imported.scenario.space->damping.modes.ratios;
  REQUIRE(ratios.size() == 4);
  CHECK(ratios[2] == doctest::Approx(0.012));
}

TEST_CASE("a turbine of ElastoDyn has its rotor, nacelle, shaft and tower") {
  const auto imported = import_texts(samples(), {"small_ElastoDyn.dat"});
  const spatial::Model& model = *imported.scenario.space;
  REQUIRE(model.blades.size() == 3);
  check_same(model.blades[2].beam.sections, convert_blade(18.5));
  check_same(tower_of(imported.scenario).sections, convert_tower(24.0));
  CHECK(model.blades[0].precone == doctest::Approx(-2.0 * kDegree));
  CHECK(model.blades[0].beam.point_masses.at(0).mass == 5.0);
  CHECK(tower_of(imported.scenario).point_masses.at(0).mass == 150.0);
  CHECK(model.hub.radius == 1.0);
  CHECK(model.hub.mass == 2000.0);
  CHECK(model.hub.center.x() == 0.1);
  CHECK(model.hub.inertia(0, 0) == doctest::Approx(900.0 + 12.0 * 400.0));
  CHECK(std::get<ConstantSpeed>(model.hub.drive).speed == doctest::Approx(std::numbers::pi));
  const auto& nacelle = std::get<spatial::RigidBody>(model.subsystems.back().bodies.at(1).shape);
  CHECK(nacelle.mass == 9000.0);
  CHECK(nacelle.inertia(2, 2) == doctest::Approx(14000.0 - 9000.0 * 0.16));
  // The apex lies 2.5 m upwind along a shaft whose upwind end is tilted up by 4 degrees.
  const Eigen::AngleAxisd tilt(4.0 * kDegree, Eigen::Vector3d::UnitY());
  const Eigen::Vector3d apex = Eigen::Vector3d(0.0, 0.0, 1.1) + tilt * Eigen::Vector3d(-2.5, 0, 0);
  CHECK((model.support->axle.offset - apex).norm() < 1e-12);
  CHECK(apex.z() > 1.1);
  CHECK(model.support->axle.orientation.y() == doctest::Approx(4.0 * kDegree));
}

TEST_CASE("a shaft of ElastoDyn that twists is a drive train, one that is switched off is not") {
  const std::string shaft = "GBRatio     - Gearbox ratio (-)\n";
  const auto import_with = [&shaft](const std::string& more) {
    auto texts = samples();
    std::string& text = texts.at("small_ElastoDyn.dat");
    const auto at = text.find(shaft);
    REQUIRE(at != std::string::npos);
    text.insert(at + shaft.size(), more);
    return import_texts(texts, {"small_ElastoDyn.dat"});
  };
  const auto soft =
      import_with("True DrTrDOF - flag\n2.5e6 DTTorSpr - N m/rad\n3e4 DTTorDmp - N m s\n");
  const spatial::Model& model = *soft.scenario.space;
  REQUIRE(model.support->axle.train);
  CHECK(model.support->axle.train->stiffness == 2.5e6);
  CHECK(model.support->axle.train->damping == 3e4);
  CHECK(model.support->axle.train->gear_ratio == 20.0);
  CHECK(model.support->axle.train->generator_inertia == 12.0);
  CHECK(model.hub.inertia(0, 0) == 900.0);
  const auto rigid = import_with("False DrTrDOF - flag\n2.5e6 DTTorSpr - N m/rad\n");
  CHECK_FALSE(rigid.scenario.space->support->axle.train);
  CHECK(rigid.scenario.space->hub.inertia(0, 0) == doctest::Approx(900.0 + 12.0 * 400.0));
}

TEST_CASE("a blade of BeamDyn takes the place of ElastoDyn's in a turbine") {
  const auto imported = import_texts(samples(), {"small_ElastoDyn.dat", "small_BeamDyn.dat"});
  const auto blade = import_texts(samples(), {"small_BeamDyn.dat"});
  check_same(imported.scenario.space->blades.at(1).beam.sections,
             blade.scenario.space->blades[0].beam.sections);
  CHECK(imported.scenario.space->blades.size() == 3);
  CHECK_FALSE(contains(imported.text, "small_ElastoDyn_blade.dat"));
}

TEST_CASE("older blade files have columns and keys of other names") {
  std::string text = samples().at("small_ElastoDyn_blade.dat");
  text = replaced(text, "BldFlDmp1 ", "BldFlDmp(1)");
  text = replaced(text, "FlStTunr2 ", "FlStTunr(2)");
  text = up_to_line(replaced(text, "5                      NBlInpSt", "2  NBlInpSt"), 14);
  text += "BlFract AeroCent StrcTwst BMassDen FlpStff EdgStff GJStff EAStff\n(-) ...\n";
  text += "0 0 1 2 1e5 2e5 3e4 4e8\n1 0 1 2 1e5 2e5 5e4 6e8\n";
  Texts texts = samples();
  texts["small_ElastoDyn_blade.dat"] = text;
  const auto imported = import_texts(texts, {"small_ElastoDyn_blade.dat"}, {.blade_length = 9.0});
  const spatial::Sections& s = imported.scenario.space->blades[0].beam.sections;
  CHECK(s.torsion_stiffness == std::vector<double>{3e4, 5e4});
  CHECK(s.axial_stiffness == std::vector<double>{4e8, 6e8});
}

TEST_CASE("gravity acts down the tower, whose foot stands over the ground") {
  constexpr double standard = 9.80665;  // m/s^2
  for (const bool is_alone : {true, false}) {
    CAPTURE(is_alone);
    const auto imported =
        is_alone ? import_texts(samples(), {"small_ElastoDyn_tower.dat"}, {.tower_height = 24.0})
                 : import_texts(samples(),
                                {"small_ElastoDyn.dat", "small_BeamDyn.dat", "small_AeroDyn.dat"});
    const spatial::Model& model = *imported.scenario.space;
    const Eigen::Vector3d turn = model.subsystems.back().joints.at(0).joint.orientation;
    const Eigen::Vector3d up =
        Eigen::AngleAxisd(turn.norm(), turn.normalized()) * Eigen::Vector3d::UnitX();
    CHECK((model.gravity + standard * up).norm() < 1e-14 * standard);
    CHECK(contains(imported.text, "not in the files: standard gravity, down along the tower"));
  }
  // The base of the tower is 1 m above the ground, and the scenario's origin at the base.
  const auto imported =
      import_texts(samples(), {"small_ElastoDyn.dat", "small_BeamDyn.dat", "small_AeroDyn.dat"});
  CHECK(imported.scenario.space->air->wind.ground == -1.0);
  CHECK(imported.scenario.space->air->wind.velocity.isZero(0.0));
  CHECK(contains(imported.text, "ground = -1   # TowerBsHt, small_ElastoDyn.dat:"));
  const auto blade = import_texts(samples(), {"small_BeamDyn.dat"});
  CHECK(blade.scenario.space->gravity.isZero(0.0));
  CHECK(contains(blade.left_out.front(), "gravity"));
}

TEST_CASE("what a turbine has and the scenario has not is said") {
  const auto left_out = [](const std::string& more) {
    Texts texts = samples();
    std::string& text = texts["small_ElastoDyn.dat"];
    text = replaced(text, "30            RotSpeed", more + "30            RotSpeed");
    std::string all;
    for (const std::string& line : import_texts(texts, {"small_ElastoDyn.dat"}).left_out)
      all += line + '\n';
    return all;
  };
  const std::string plain = left_out("");
  for (const char* part : {"torque of the generator", "control of speed and pitch", "wind",
                           "foundation", "in other files of a turbine: the air"})
    CHECK(contains(plain, part));
  CHECK_FALSE(contains(plain, "TTDspFA"));
  CHECK(left_out("0 OoPDefl - deflection\n") == plain);
  CHECK(contains(left_out("0.5 TTDspFA - deflection\n"),
                 "TTDspFA, small_ElastoDyn.dat:12, which is 0.5: the tower starts undeformed"));
  CHECK(contains(left_out("1.5E+07 PtfmMass - platform\n"), "PtfmMass, small_ElastoDyn.dat:12"));
  CHECK(contains(left_out("3 BlPitch(1)\n3.5 BlPitch(2)\n3 BlPitch(3)\n"),
                 "BlPitch(2), small_ElastoDyn.dat:13, which is 3.5: all blades have that of "
                 "blade 1, 3"));
}
