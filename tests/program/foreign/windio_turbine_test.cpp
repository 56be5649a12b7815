// Tower, nacelle and drive train of an ontology against closed forms.

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tests/contains.h"
#include "tests/program/foreign/samples.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr const char* kWholeOntology = "small_windio.yaml";

/// A tower of two layers, whose wall is thick at its foot, a nacelle and a generator.
constexpr const char* kMore = R"(
        internal_structure_2d_fem:
            outfitting_factor: 1.1
            layers:
                - name: wall
                  material: steel
                  thickness:
                      grid: [0.0, 0.5, 1.0]
                      values: [0.04, 0.03, 0.02]
                - name: lining
                  material: wood
                  thickness:
                      grid: [0.0, 1.0]
                      values: [0.1, 0.05]
    nacelle:
        drivetrain:
            uptilt: 0.08
            distance_tt_hub: 2.5
            overhang: 4.0
            gear_ratio: 12.0
            elastic_properties_mb:
                system_mass: 12000.0
                yaw_mass: 300.0
                system_center_mass: [-0.5, 0.1, 1.2]
                system_inertia: [9000.0, 20000.0, 19000.0, 10.0, -400.0, 0.0]
                spring_constant: 3.0e+07
                damping_coefficient: 2.0e+05
        generator:
            elastic_properties_mb:
                rotor_inertia: [15.0, 9.0, 9.0]
materials:
    - name: wood
      E: 1.1e+10
      G: 7.0e+08
      rho: 500.0
    - name: steel
      E: 2.0e+11
      G: 7.9e+10
      rho: 7850.0
control:
    torque:
        VS_maxspd: 2.5
)";

/// The ontology of the samples with all of a turbine.
std::string turbine_text() {
  std::string text = samples().at(kWholeOntology);
  while (text.ends_with('\n')) text.pop_back();
  text = replaced(text, "            outer_diameter:",
                  "            reference_axis:\n"
                  "                x: {grid: [0.0, 1.0], values: [0.0, 0.0]}\n"
                  "                y: {grid: [0.0, 1.0], values: [0.0, 0.0]}\n"
                  "                z: {grid: [0.0, 1.0], values: [2.0, 32.0]}\n"
                  "            drag_coefficient: {grid: [0.0, 1.0], values: [0.5, 0.7]}\n"
                  "            outer_diameter:");
  text = replaced(text, "        cone_angle: 0.05\n",
                  "        cone_angle: 0.05\n"
                  "        elastic_properties_mb:\n"
                  "            system_mass: 2500.0\n"
                  "            system_inertia: [1500.0, 900.0, 900.0, 0.0, 0.0, 0.0]\n");
  return text + kMore;
}

foreign::Imported import_turbine(const std::string& text) {
  Texts texts = samples();
  texts[kWholeOntology] = text;
  return import_texts(texts, {kWholeOntology});
}

const spatial::Body& body_of(const foreign::Imported& imported, std::size_t number) {
  return imported.scenario.space->subsystems.back().bodies.at(number);
}

/// Returns the moment int f(r) 2 pi r dr over a ring, by the midpoint rule.
template <class F>
double over_ring(double outer, double thickness, const F& f) {
  constexpr int pieces = 20000;
  double sum = 0.0;
  for (int i = 0; i < pieces; ++i) {
    const double r = outer - thickness * (i + 0.5) / pieces;
    sum += f(r) * 2.0 * std::numbers::pi * r * thickness / pieces;
  }
  return sum;
}

}  // namespace

TEST_CASE("a tower of layers has the mass and the stiffness of its rings") {
  const auto imported = import_turbine(turbine_text());
  const auto& tower = std::get<spatial::Beam>(body_of(imported, 0).shape);
  const spatial::Sections& s = tower.sections;
  CHECK(tower.length == 30.0);
  REQUIRE(s.station == std::vector<double>{0.0, 15.0, 30.0});
  const double radius[] = {1.5, 1.25, 1.0}, steel[] = {0.04, 0.03, 0.02},
               wood[] = {0.1, 0.075, 0.05};
  const auto one = [](double) { return 1.0; };
  const auto half_square = [](double r) { return 0.5 * r * r; };
  for (std::size_t i = 0; i < 3; ++i) {
    CAPTURE(i);
    const double inner = radius[i] - steel[i];
    const double area_s = over_ring(radius[i], steel[i], one),
                 area_w = over_ring(inner, wood[i], one),
                 second_s = over_ring(radius[i], steel[i], half_square),
                 second_w = over_ring(inner, wood[i], half_square);
    CHECK(s.mass_per_length[i] ==
          doctest::Approx(1.1 * (7850.0 * area_s + 500.0 * area_w)).epsilon(1e-7));
    CHECK(s.axial_stiffness[i] == doctest::Approx(2e11 * area_s + 1.1e10 * area_w).epsilon(1e-7));
    const double bending = 2e11 * second_s + 1.1e10 * second_w;
    CHECK(s.flap_stiffness[i] == doctest::Approx(bending).epsilon(1e-7));
    CHECK(s.lag_stiffness[i] == s.flap_stiffness[i]);
    CHECK(s.torsion_stiffness[i] ==
          doctest::Approx(2.0 * (7.9e10 * second_s + 7e8 * second_w)).epsilon(1e-7));
  }
  CHECK(tower.point_masses.at(0).mass == 300.0);
  CHECK(tower.point_masses.at(0).position == 30.0);
}

TEST_CASE("nacelle, hub and shaft of an ontology stand on its tower") {
  const auto imported = import_turbine(turbine_text());
  const spatial::Model& model = *imported.scenario.space;
  const auto& nacelle = std::get<spatial::RigidBody>(body_of(imported, 1).shape);
  CHECK(nacelle.mass == 12000.0);
  CHECK((nacelle.center - Eigen::Vector3d(-0.5, 0.1, 1.2)).norm() == 0.0);
  CHECK(nacelle.inertia(0, 2) == -400.0);
  CHECK((model.support->axle.offset - Eigen::Vector3d(-4.0, 0.0, 2.5)).norm() == 0.0);
  // The axis points downwind, down by the tilt.
  const Eigen::Vector3d turn = model.support->axle.orientation;
  const Eigen::Vector3d axis =
      Eigen::AngleAxisd(turn.norm(), turn.normalized()) * Eigen::Vector3d::UnitX();
  CHECK((axis - Eigen::Vector3d(std::cos(0.08), 0.0, -std::sin(0.08))).norm() < 1e-14);
  REQUIRE(model.support->axle.train);
  CHECK(model.support->axle.train->stiffness == 3e7);
  CHECK(model.support->axle.train->damping == 2e5);
  CHECK(model.support->axle.train->gear_ratio == 12.0);
  CHECK(model.support->axle.train->generator_inertia == 15.0);
  CHECK(model.hub.mass == 2500.0);
  CHECK(model.hub.inertia(1, 1) == 900.0);
  CHECK(std::get<ConstantSpeed>(model.hub.drive).speed == 2.5);
  const auto downwind = import_turbine(replaced(turbine_text(), "Upwind", "Downwind"));
  const auto& axle = downwind.scenario.space->support->axle;
  CHECK(axle.offset.x() == 4.0);
  CHECK(axle.orientation.y() == -0.08);
  const auto bare = import_turbine(replaced(
      replaced(turbine_text(), "elastic_properties_mb:\n                system_mass",
               "other:\n                system_mass"),
      "elastic_properties_mb:\n            system_mass", "other:\n            system_mass"));
  CHECK(contains(bare.left_out.at(0), "the nacelle is without mass"));
  CHECK(contains(bare.left_out.at(1), "the hub is without mass"));
}

TEST_CASE("an ontology with aerofoils has its tower in the air") {
  const std::string aired = samples().at("small_windio_air.yaml");
  const std::string whole = turbine_text();
  const std::size_t tower = whole.find("    tower:"), materials = whole.find("materials:");
  std::string text = aired;
  text.erase(text.find("    tower:"), text.find("environment:") - text.find("    tower:"));
  text.insert(text.find("environment:"), whole.substr(tower, materials - tower));
  text += '\n' + whole.substr(materials);
  Texts texts = samples();
  texts["small_windio_air.yaml"] = text;
  const auto imported = import_texts(texts, {"small_windio_air.yaml"});
  REQUIRE(body_of(imported, 0).drag);
  CHECK(body_of(imported, 0).drag->diameter == std::vector<double>{3.0, 2.5, 2.0});
  CHECK(body_of(imported, 0).drag->coefficient.at(1) == doctest::Approx(0.6));
  CHECK(imported.scenario.space->air->wind.ground == -2.0);
}

TEST_CASE("faults of an ontology's tower and nacelle are refused") {
  const std::string good = turbine_text();
  check_refused(
      kWholeOntology, {kWholeOntology},
      {{replaced(good, "material: steel", "material: stone"),
        "material: is \"stone\", expected a name of materials"},
       {replaced(good, "E: 2.0e+11", "E: [2.0e+11, 1.0e+10]"), "E: is no number"},
       {replaced(good, "rho: 7850.0", "rho: 0.0"), "rho: is 0, expected"},
       {replaced(good, "values: [0.04, 0.03, 0.02]", "values: [0.04, 0.0, 0.02]"),
        "layers are 0 m thick at 0.5, expected more than 0"},
       {replaced(good, "values: [0.04, 0.03, 0.02]", "values: [2.0, 0.03, 0.02]"),
        "layers are 2 m thick at 0, expected more than 0 and less than the radius there, 1.5"},
       {replaced(good, "values: [2.0, 32.0]", "values: [2.0, 1.0]"), "z: does not rise, expected"},
       {replaced(good, "x: {grid: [0.0, 1.0], values: [0.0, 0.0]}",
                 "x: {grid: [0.0, 1.0], values: [0.0, 3.0]}"),
        "x: is 3, expected 0: a tower that stands upright"},
       {replaced(good, "outfitting_factor: 1.1", "outfitting_factor: -1"), "outfitting_factor: is"},
       {replaced(good, "system_mass: 12000.0", "system_mass: 0.0"), "system_mass: is 0, expected"},
       {replaced(good, "[-0.5, 0.1, 1.2]", "[-0.5, 0.1]"), "has 2 elements, expected 3"},
       {replaced(good, "[15.0, 9.0, 9.0]", "[15.0]"), "has 1 elements, expected 3 or 6"},
       {replaced(good, "[15.0, 9.0, 9.0]", "[0.0, 9.0, 9.0]"), "rotor_inertia: is 0, expected"},
       {replaced(good, "damping_coefficient: 2.0", "damping_coefficient: -2.0"),
        "damping_coefficient: is -2e+05, expected 0 or more"},
       {replaced(good, "VS_maxspd: 2.5", "VS_maxspd: 0"), "VS_maxspd: is 0, expected"},
       {replaced(good, "yaw_mass: 300.0", "yaw_mass: -3.0"), "yaw_mass: is -3, expected 0"}});
}
