// Whole turbines of OpenFAST's main file.

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "models/curve.h"
#include "program/foreign/toml_text.h"
#include "tests/contains.h"
#include "tests/program/foreign/samples.h"
#include "tests/shipped.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr const char* kTurbineMain = "small_turbine.fst";
constexpr const char* kTurbinePrimary = "small_turbine_ElastoDyn.dat";
constexpr const char* kTurbineServo = "small_turbine_ServoDyn.dat";
constexpr const char* kTurbineInflow = "small_turbine_InflowWind.dat";
constexpr const char* kTurbineAir = "small_turbine_AeroDyn.dat";
constexpr double kPerDegreeOfTurbine = std::numbers::pi / 180.0;
constexpr double kPerMinute = std::numbers::pi / 30.0;

/// A change of one of the files.
struct Change {
  std::string file, from, to;
};

foreign::Imported import_changed(const std::vector<Change>& changes,
                                 foreign::ImportOptions options = {}) {
  Texts texts = samples();
  for (const Change& change : changes)
    texts[change.file] = replaced(texts.at(change.file), change.from, change.to);
  return import_texts(texts, {kTurbineMain}, options);
}

/// Options with which all files are there.
foreign::ImportOptions with_all_files() {
  foreign::ImportOptions options;
  options.is_there = [](const std::string&) { return true; };
  return options;
}

const spatial::Model& model_of(const foreign::Imported& imported) {
  return *imported.scenario.space;
}

/// The joint between tower and nacelle.
const spatial::JointCoordinate& yaw_of(const foreign::Imported& imported) {
  const spatial::Joint& joint = model_of(imported).subsystems.back().joints.at(1).joint;
  REQUIRE(joint.name == "yaw");
  return joint.coordinates.at(0);
}

const Curve& pitch_of(const foreign::Imported& imported) {
  const auto& coordinate = model_of(imported).blades.at(0).joints.at(0).joint.coordinates.at(0);
  return std::get<spatial::MotionTable>(*coordinate.motion).value;
}

/// Whether one sentence on what is left out contains both texts.
bool leaves_out(const foreign::Imported& imported, const std::string& a,
                const std::string& b = {}) {
  for (const std::string& line : imported.left_out)
    if (contains(line, a) && contains(line, b)) return true;
  return false;
}

}  // namespace

TEST_CASE("a main file makes a whole turbine, as its modules do when they are given") {
  const auto imported = import_changed({});
  CHECK(imported.scenario.title == "A whole small turbine, made up for the tests of Spoke");
  const spatial::Model& model = model_of(imported);
  CHECK(model.gravity.z() == -9.81);
  CHECK(model.air->density == 1.21);  // AeroDyn says "default"
  CHECK(model.air->viscosity == 1.5e-5);
  CHECK(imported.scenario.integration.duration == 20.0);
  CHECK(imported.scenario.output.interval == 0.05);
  CHECK(model.blades.at(0).azimuth == doctest::Approx(30.0 * kPerDegreeOfTurbine));
  REQUIRE(model.support->axle.train);
  CHECK(model.support->axle.train->stiffness == 2.5e6);
  const auto modules =
      import_texts(samples(), {kTurbinePrimary, kTurbineAir, kTurbineInflow, kTurbineServo});
  Scenario whole = imported.scenario, parts = modules.scenario;
  for (Scenario* scenario : {&whole, &parts}) {  // what the main file alone says
    scenario->space->gravity.setZero();
    scenario->space->hub.drive = FixedDrive{};
    scenario->space->blades = {};
  }
  check_same_frequencies(whole, parts, 6);
  CHECK(model_of(modules).gravity.z() == -9.80665);
}

TEST_CASE("BeamDyn's blades take the place of ElastoDyn's where the main file says so") {
  const auto imported = import_changed({{kTurbineMain, "1             CompElast", "2 CompElast"}});
  check_same(
      model_of(imported).blades.at(2).beam.sections,
      import_texts(samples(), {"small_BeamDyn.dat"}).scenario.space->blades[0].beam.sections);
  CHECK_FALSE(contains(imported.text, "small_ElastoDyn_blade.dat"));
}

TEST_CASE("the generator brakes the hub by its curve and the gearbox") {
  const auto imported = import_changed({});
  const auto& drive = std::get<TorqueBySpeed>(model_of(imported).hub.drive);
  CHECK(drive.initial_speed == doctest::Approx(28.0 * kPerMinute));
  // VS_Rgn2K is of 1/min: 0.013 400^2 N m at 400/min, 20 times as much at 20/min of the hub.
  CHECK(drive.torque.value(20.0 * kPerMinute) ==
        doctest::Approx(-20.0 * 0.013 * 400.0 * 400.0).epsilon(2e-3));
  CHECK(drive.torque.value(31.0 * kPerMinute) == doctest::Approx(-20.0 * 6000.0));
  // The line leads from the synchronous speed, 600/1.08, to the rated one.
  const double synchronous = 600.0 / 1.08, between = 595.0;
  CHECK(drive.torque.value(between / 20.0 * kPerMinute) ==
        doctest::Approx(-20.0 * 6000.0 * (between - synchronous) / (600.0 - synchronous))
            .epsilon(2e-3));
  const auto induction = import_changed({{kTurbineServo, "1             VSContrl", "0 VSContrl"}});
  const auto& line = std::get<TorqueBySpeed>(model_of(induction).hub.drive).torque;
  CHECK(line.value(590.0 / 20.0 * kPerMinute) == doctest::Approx(0.0).scale(1e5));
  CHECK(line.value(590.0 * 1.015 / 20.0 * kPerMinute) == doctest::Approx(-20.0 * 5500.0));
  const auto thevenin = import_changed({{kTurbineServo, "1             VSContrl", "0 VSContrl"},
                                        {kTurbineServo, "1             GenModel", "2 GenModel"}});
  const auto& circuit = std::get<TorqueBySpeed>(model_of(thevenin).hub.drive).torque;
  CHECK(circuit.value(600.0 / 20.0 * kPerMinute) == doctest::Approx(0.0).scale(1e5));
  CHECK(circuit.value(610.0 / 20.0 * kPerMinute) < -1e4);
}

TEST_CASE("without control the rotor turns freely, with a held generator at one speed") {
  const auto free = import_changed({{kTurbineMain, "1             CompServo", "0 CompServo"}});
  CHECK(std::get<FreeDrive>(model_of(free).hub.drive).initial_speed ==
        doctest::Approx(28.0 * kPerMinute));
  const auto held = import_changed({{kTurbinePrimary, "True          GenDOF", "False GenDOF"}});
  CHECK(std::get<ConstantSpeed>(model_of(held).hub.drive).speed ==
        doctest::Approx(28.0 * kPerMinute));
}

TEST_CASE("pitch and yaw go from their angles to those of the maneuvers") {
  const auto imported = import_changed({});
  const Curve& pitch = pitch_of(imported);
  for (const auto& [t, angle] : {std::pair{0.0, 2.0}, {11.9, 2.0}, {13.0, 6.0}, {14.1, 10.0}})
    CHECK(pitch.value(t) == doctest::Approx(-angle * kPerDegreeOfTurbine));
  CHECK(pitch.derivative(13.0) == doctest::Approx(-4.0 * kPerDegreeOfTurbine));
  const auto still =
      import_changed({{kTurbineServo, "12.0          TPitManS(1)", "30.0 TPitManS(1)"}});
  CHECK(pitch_of(still).value(19.0) == doctest::Approx(-2.0 * kPerDegreeOfTurbine));
  const spatial::JointCoordinate& yaw = yaw_of(imported);
  CHECK(yaw.stiffness == 3e7);
  CHECK(yaw.damping == 1e5);
  CHECK(yaw.rest == doctest::Approx(1.0 * kPerDegreeOfTurbine));
  CHECK(yaw.initial == doctest::Approx(5.0 * kPerDegreeOfTurbine));
  const auto turned = import_changed({{kTurbineServo, "9999.9        TYawManS", "1.0 TYawManS"}});
  const auto& course = std::get<spatial::MotionTable>(*yaw_of(turned).motion).value;
  CHECK(course.value(0.5) == doctest::Approx(5.0 * kPerDegreeOfTurbine));
  CHECK(course.value(3.5) == doctest::Approx(10.0 * kPerDegreeOfTurbine));
  CHECK(course.value(7.0) == doctest::Approx(15.0 * kPerDegreeOfTurbine));
  CHECK(leaves_out(turned, "YawSpr"));
  const auto fixed = import_changed({{kTurbinePrimary, "True          YawDOF", "False YawDOF"}});
  CHECK(std::get<spatial::MotionTable>(*yaw_of(fixed).motion).value.value(0.0) ==
        doctest::Approx(5.0 * kPerDegreeOfTurbine));
  const auto ahead = import_changed({{kTurbinePrimary, "True          YawDOF", "False YawDOF"},
                                     {kTurbinePrimary, "5.0           NacYaw", "0 NacYaw"}});
  CHECK(model_of(ahead).subsystems.back().joints.at(1).joint.kind == spatial::JointKind::fixed);
}

TEST_CASE("winds go along x towards -y and up, and a table has its columns converted") {
  const auto steady =
      import_changed({{kTurbineInflow, "2             WindType", "1 WindType"},
                      {kTurbineInflow, "0             PropagationDir", "20 PropagationDir"},
                      {kTurbineInflow, "0             VFlowAng", "8 VFlowAng"}});
  const Wind& wind = model_of(steady).air->wind;
  const Eigen::Vector3d expected =
      9.0 * (Eigen::AngleAxisd(-20.0 * kPerDegreeOfTurbine, Eigen::Vector3d::UnitZ()) *
             Eigen::AngleAxisd(-8.0 * kPerDegreeOfTurbine, Eigen::Vector3d::UnitY()) *
             Eigen::Vector3d::UnitX());
  CHECK((wind.velocity - expected).norm() < 1e-12);
  CHECK(wind.shear_exponent == 0.2);
  CHECK(wind.reference_height == 26.0);
  CHECK(wind.ground == -1.0);  // TowerBsHt
  CHECK(steady.tables.size() == 3);
  const auto uniform = import_changed({});
  CHECK(model_of(uniform).air->wind.vertical_shear == doctest::Approx(0.05 / 40.0));
  CHECK(model_of(uniform).air->wind.horizontal_shear == doctest::Approx(0.1 / 40.0));
  REQUIRE(uniform.tables.size() == 4);
  const foreign::SourceFile& table = uniform.tables.back();
  CHECK(table.name == "wind.txt");
  CHECK(contains(uniform.text, "file = \"wind.txt\""));
  const auto rows = numbers_by_line(table.text);
  REQUIRE(rows.size() == 5);
  CHECK(rows.at(3).at(0) == 15.0);
  CHECK(rows.at(3).at(1) == 10.0);
  CHECK(rows.at(3).at(2) == doctest::Approx(-8.0 * kPerDegreeOfTurbine));
  CHECK(rows.at(3).at(3) == 0.5);
  CHECK(rows.at(3).at(4) == 0.14);
  const auto still = import_changed({{kTurbineMain, "1             CompInflow", "0 CompInflow"}});
  CHECK(model_of(still).air->wind.velocity.isZero(0.0));
  const auto vacuum = import_changed({{kTurbineMain, "2             CompAero", "0 CompAero"}});
  CHECK_FALSE(model_of(vacuum).air);
  CHECK(pitch_of(vacuum).value(0.0) == doctest::Approx(-2.0 * kPerDegreeOfTurbine));
}

TEST_CASE("a file of TurbSim is named by a path from the scenario's folder") {
  const std::vector<Change> changes = {
      {kTurbineInflow, "2             WindType", "3 WindType"},
      {kTurbineInflow, "\"unused\"      FileName_BTS", "\"../wind/w.bts\" FileName_BTS"}};
  foreign::ImportOptions options = with_all_files();
  options.folder = "out/deep";
  CHECK(contains(import_changed(changes, options).text, "file = \"../../../wind/w.bts\""));
}

TEST_CASE("the tower in the air is cut to the tower's length, with what it does to the wind") {
  const auto imported = import_changed({});
  const spatial::Body& tower = model_of(imported).subsystems.back().bodies.at(0);
  REQUIRE(tower.drag);
  CHECK(tower.drag->station == std::vector<double>{0.0, 9.0, 19.0, 24.0});
  CHECK(tower.drag->diameter.front() == doctest::Approx(1.98));  // 1 m above the ground
  CHECK(tower.drag->diameter.at(1) == 1.8);
  CHECK(tower.drag->diameter.back() == doctest::Approx(1.35));
  CHECK(tower.drag->coefficient.back() == 0.5);
  CHECK(tower.drag->potential == spatial::TowerPotential::bak);
  CHECK(tower.drag->shadow == spatial::TowerShadow::powles);
  const auto eames = import_changed({{kTurbineAir, "1             TwrShadow", "2 TwrShadow"}});
  CHECK(leaves_out(eames, "TwrShadow, small_turbine_AeroDyn.dat:8", "Eames"));
  const auto flow = import_changed({{kTurbineAir, "2             TwrPotent", "1 TwrPotent"},
                                    {kTurbineAir, "1             TwrShadow", "False TwrShadow"},
                                    {kTurbineAir, "True          TwrAero", "False TwrAero"}});
  const auto& body = model_of(flow).subsystems.back().bodies.at(0);
  CHECK(body.drag->coefficient == std::vector<double>(4, 0.0));
  CHECK(body.drag->potential == spatial::TowerPotential::cylinder);
  const auto none = import_changed({{kTurbineAir, "2             TwrPotent", "0 TwrPotent"},
                                    {kTurbineAir, "1             TwrShadow", "0 TwrShadow"},
                                    {kTurbineAir, "True          TwrAero", "False TwrAero"}});
  CHECK_FALSE(model_of(none).subsystems.back().bodies.at(0).drag);
}

TEST_CASE("a library takes generator, pitch and yaw, where it is there") {
  const std::vector<Change> changes = {{kTurbineServo, "1             VSContrl", "5 VSContrl"},
                                       {kTurbineServo, "0             PCMode", "5 PCMode"},
                                       {kTurbineServo, "0             YCMode", "5 YCMode"},
                                       {kTurbineServo, "0             HSSBrMode", "5 HSSBrMode"},
                                       {kTurbineServo, "\"default\"     DLL_DT", "0.02 DLL_DT"}};
  const auto imported = import_changed(changes, with_all_files());
  for (const char* line :
       {"\n[control.library]\nfile = \"small_turbine.so\"", "\ninput = \"small_turbine.IN\"",
        "\nefficiency = 0.95 ", "\nindividual_pitch = true", "\njoint = \"pitch\"",
        "\nyaw_joint = \"yaw\"", "\nbrake_torque = 24000 ", "\nperiod = 0.02 "}) {
    CAPTURE(line);
    CHECK(contains(imported.text, line));
  }
  // What is checked has a controller of the program's in its place.
  REQUIRE(model_of(imported).outer_control);
  CHECK(model_of(imported).outer_control->initial == doctest::Approx(2.0 * kPerDegreeOfTurbine));
  CHECK(std::get<TorqueDrive>(model_of(imported).hub.drive).initial_speed ==
        doctest::Approx(28.0 * kPerMinute));
  CHECK(pitch_of(imported).value(0.0) == 0.0);
  const auto missing = import_changed(changes);
  CHECK(contains(missing.text, "\n# [control.library]\n# file = \"small_turbine.so\""));
  CHECK(leaves_out(missing, "names small_turbine.so, which is not there"));
  CHECK(leaves_out(missing, "TPitManS(1)", "the override of the controlled pitch"));
  CHECK(std::holds_alternative<ConstantSpeed>(model_of(missing).hub.drive));
  const auto pitch_alone = import_changed({changes.at(1)}, with_all_files());
  CHECK(leaves_out(pitch_alone, "the library, which does not have the torque"));
}

TEST_CASE("what is left out is listed worst first") {
  const auto imported =
      import_changed({{kTurbineMain, "0             CompHydro", "1 CompHydro"},
                      {kTurbinePrimary, "False         PtfmSgDOF", "True PtfmSgDOF"},
                      {kTurbinePrimary, "0             IPDefl", "0.3 IPDefl"}});
  const auto place = [&](const char* part) {
    for (std::size_t i = 0; i < imported.left_out.size(); ++i)
      if (contains(imported.left_out[i], part)) return static_cast<int>(i);
    FAIL("is not there: " << part);
    return -1;
  };
  CHECK(place("CompHydro, small_turbine.fst:14, which is 1: water") < place("IPDefl"));
  CHECK(place("PtfmSgDOF True") < place("IPDefl"));
  CHECK(place("IPDefl") < place("drag in the induction"));
  CHECK(place("drag in the induction") < place("mode shapes"));
  const std::size_t first = imported.text.find("CompHydro, small_turbine.fst");
  CHECK(first < imported.text.find("mode shapes"));
}

TEST_CASE("a title is no line of a value and its key") {
  const auto imported =
      import_changed({{kTurbineMain, "A whole small turbine", "Floating MHK turbine"},
                      {kTurbinePrimary, "A small turbine", "Large NumBl"},
                      {kTurbineServo, "Control of", "Pitch VSContrl of"},
                      {kTurbineAir, "Aerodynamics of", "No TwrPotent of"},
                      {kTurbineInflow, "A wind that", "A WindType that"}});
  CHECK(imported.scenario.title.starts_with("Floating MHK turbine"));
}

TEST_CASE("heave of the platform is height over the ground") {
  const auto imported =
      import_changed({{kTurbinePrimary, "0             PtfmHeave", "0.5 PtfmHeave"}});
  CHECK(model_of(imported).air->wind.ground == -1.5);
  CHECK(model_of(imported).subsystems.back().bodies.at(0).drag->diameter.front() ==
        doctest::Approx(2.0 - 0.02 * 1.5));
}

namespace {

std::string row_of(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += foreign::digits(number) + ' ';
  return text + '\n';
}

/// The files of the shipped turbine of 5 MW as ElastoDyn has them, by the values of its report.
Texts files_of_shipped_turbine(const spatial::Model& shipped) {
  Texts texts = samples();
  std::string primary = texts.at(kTurbinePrimary);
  const std::vector<std::pair<std::string, std::string>> values = {
      {"TipRad", "63"},        {"HubRad", "1.5"},       {"PreCone(1)", "-2.5"},
      {"PreCone(2)", "-2.5"},  {"PreCone(3)", "-2.5"},  {"HubCM", "0"},
      {"OverHang", "-5.0191"}, {"ShftTilt", "-5"},      {"NacCMxn", "1.9"},
      {"NacCMzn", "1.75"},     {"Twr2Shft", "1.96256"}, {"TowerHt", "87.6"},
      {"TowerBsHt", "0"},      {"TipMass(1)", "0"},     {"TipMass(2)", "0"},
      {"TipMass(3)", "0"},     {"HubMass", "56780"},    {"HubIner", "115926"},
      {"GenIner", "534.116"},  {"NacMass", "240000"},   {"NacYIner", "2607890"},
      {"YawBrMass", "0"},      {"GBRatio", "97"},       {"DTTorSpr", "867.637E6"},
      {"DTTorDmp", "6.215E6"}, {"RotSpeed", "12.1"},    {"Azimuth", "0"},
      {"NacYaw", "0"},         {"BlPitch(1)", "0"},     {"BlPitch(2)", "0"},
      {"BlPitch(3)", "0"}};
  for (const auto& [key, value] : values) {
    const std::size_t at = primary.find(' ' + key + ' ');
    REQUIRE(at != std::string::npos);
    const std::size_t begin = primary.rfind('\n', at) + 1;
    primary.replace(begin, at - begin, value);
  }
  texts[kTurbinePrimary] = primary;
  const spatial::Sections& blade = shipped.blades[0].beam.sections;
  std::string text = up_to_line(texts.at("small_ElastoDyn_blade.dat"), 14);
  for (const char* factor : {"1.05 ", "0.95 ", "0.97 "}) text = replaced(text, factor, "1.0 ");
  text = replaced(text, "5                      NBlInpSt",
                  std::to_string(blade.station.size()) + " NBlInpSt");
  text += "BlFract StrcTwst BMassDen FlpStff EdgStff GJStff EAStff FlpIner EdgIner\n(-) ...\n";
  for (std::size_t i = 0; i < blade.station.size(); ++i)
    text += row_of({blade.station[i] / 61.5, -blade.twist[i] / kPerDegreeOfTurbine,
                    blade.mass_per_length[i], blade.flap_stiffness[i], blade.lag_stiffness[i],
                    blade.torsion_stiffness[i], blade.axial_stiffness[i], blade.flap_inertia[i],
                    blade.lag_inertia[i]});
  texts["small_ElastoDyn_blade.dat"] = text;
  const auto& tower =
      std::get<spatial::Beam>(shipped.subsystems.back().bodies.at(0).shape).sections;
  text = up_to_line(texts.at("small_ElastoDyn_tower.dat"), 17);
  for (const char* factor : {"1.02 ", "0.98 ", "0.96 "}) text = replaced(text, factor, "1.0 ");
  text = replaced(text, "4                      NTwInpSt",
                  std::to_string(tower.station.size()) + " NTwInpSt");
  text += "HtFract TMassDen TwFAStif TwSSStif TwGJStif TwEAStif TwFAIner TwSSIner\n(-) ...\n";
  for (std::size_t i = 0; i < tower.station.size(); ++i)
    text += row_of({tower.station[i] / 87.6, tower.mass_per_length[i], tower.flap_stiffness[i],
                    tower.lag_stiffness[i], tower.torsion_stiffness[i], tower.axial_stiffness[i],
                    tower.flap_inertia[i], tower.lag_inertia[i]});
  texts["small_ElastoDyn_tower.dat"] = text;
  texts[kTurbineServo] =
      replaced(texts.at(kTurbineServo), "3.0E+07       YawSpr", "9.02832E9 YawSpr");
  texts[kTurbineServo] =
      replaced(texts.at(kTurbineServo), "1.0E+05       YawDamp", "1.916E7 YawDamp");
  texts[kTurbineServo] = replaced(texts.at(kTurbineServo), "1.0           YawNeut", "0 YawNeut");
  texts[kTurbineServo] =
      replaced(texts.at(kTurbineServo), "12.0          TPitManS(1)", "9999.9 TPitManS(1)");
  texts[kTurbineMain] = replaced(texts.at(kTurbineMain), "2             CompAero", "0 CompAero");
  return texts;
}

/// The two as they can be compared: held at the generator, with the same elements.
void prepare(Scenario& scenario) {
  spatial::Model& model = *scenario.space;
  model.hub.drive = FixedDrive{};
  model.damping = {};
  for (spatial::Blade& blade : model.blades) blade.beam.bodies = blade.beam.elements = 3;
  auto& tower = std::get<spatial::Beam>(model.subsystems.back().bodies.at(0).shape);
  tower.bodies = 1;
  tower.elements = 8;
}

}  // namespace

TEST_CASE("files with the values of the report make the shipped turbine of 5 MW") {
  Scenario shipped = read_shipped("nrel_5mw_turbine");
  spatial::Model& model = *shipped.space;
  auto imported = import_texts(files_of_shipped_turbine(model), {kTurbineMain}).scenario;
  // The shipped one has a rigid shaft, and a nacelle that is as inert about every axis.
  model.support->axle.train = spatial::DriveTrain{867.637e6, 6.215e6, 97.0, 534.116};
  model.hub.inertia = Eigen::Vector3d(115926.0, 57963.0, 57963.0).asDiagonal();
  auto& nacelle = std::get<spatial::RigidBody>(model.subsystems.back().bodies.at(1).shape);
  nacelle.inertia = Eigen::Vector3d(870745.0, 870745.0, 1741490.0).asDiagonal();
  model.gravity = imported.space->gravity;
  model.distributed_loads.clear();
  prepare(shipped);
  prepare(imported);
  const auto found = frequencies_of(imported, 12), expected = frequencies_of(shipped, 12);
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CAPTURE(i);
    CHECK(found[i] == doctest::Approx(expected[i]).epsilon(1e-5));
  }
}
