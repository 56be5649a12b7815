// Aerodynamics of an ontology of WindIO against a second converter; what is refused.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "models/air/airfoil_reader.h"
#include "models/air/section_polar.h"
#include "tests/contains.h"
#include "tests/program/foreign/samples.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr const char* kAired = "small_windio_air.yaml";
constexpr double kTurn = std::numbers::pi;

using Table = std::vector<std::pair<double, double>>;

/// Linear between rows, of which the ends become half a turn.
double at(Table table, double x) {
  for (auto* end : {&table.front(), &table.back()})
    if (std::abs(std::abs(end->first) - kTurn) < 1e-3)
      end->first = std::copysign(kTurn, end->first);
  for (std::size_t k = 1; k < table.size(); ++k)
    if (x <= table[k].first)
      return std::lerp(table[k - 1].second, table[k].second,
                       (x - table[k - 1].first) / (table[k].first - table[k - 1].first));
  return table.back().second;
}

/// The file's coefficients at an angle: lift, drag, moment.
struct Values {
  double lift, drag, moment;
};
Values round_at(double) { return {0.0, 0.5, 0.0}; }
Values thick_at(double x) {
  return {
      at({{-3.1415, 0.01},  // the ends, 0 and 0.02, are the same angle
          {-1.6, 0.1},
          {-0.2, -0.7},
          {0.0, 0.4},
          {0.2, 1.2},
          {1.6, 0.05},
          {3.1415, 0.01}},
         x),
      at({{-3.1415, 0.02}, {-1.6, 1.7}, {-0.1, 0.016}, {0.1, 0.02}, {1.6, 1.8}, {3.1415, 0.02}}, x),
      at({{-3.1415, 0.0}, {0.0, -0.06}, {3.1415, 0.0}}, x)};
}
/// `level`: 0 at a Reynolds number of 1e6, 1 at 4e6.
Values thin_at(double x, double level) {
  const auto lift = [&](double low, double high, double top) {
    return at({{-3.1415, 0.0},
               {-1.6, 0.1},
               {-0.2, low},
               {0.0, high},
               {0.25, top},
               {1.6, 0.05},
               {3.1415, 0.0}},
              x);
  };
  return {std::lerp(lift(-0.8, 0.45, 1.3), lift(-0.85, 0.46, 1.4), level),
          at({{-3.1415, 0.03}, {0.0, std::lerp(0.01, 0.008, level)}, {3.1415, 0.03}}, x),
          at({{-3.1415, 0.0}, {0.0, std::lerp(-0.08, -0.09, level)}, {3.1415, 0.0}}, x)};
}
Values mix(const Values& a, const Values& b, double share) {
  return {std::lerp(a.lift, b.lift, share), std::lerp(a.drag, b.drag, share),
          std::lerp(a.moment, b.moment, share)};
}
/// What the blade has at a share of its length.
Values expected_at(double place, double angle, double level) {
  if (place <= 0.15) return round_at(angle);
  if (place <= 0.6) return mix(round_at(angle), thick_at(angle), (place - 0.15) / 0.45);
  return mix(thick_at(angle), thin_at(angle, level), (place - 0.6) / 0.4);
}

const spatial::Airfoil& find(const spatial::Air& air, const std::string& name) {
  for (const spatial::Airfoil& airfoil : air.airfoils)
    if (airfoil.name == name) return airfoil;
  FAIL("there is no aerofoil ", name);
  return air.airfoils.front();
}

/// The ontology in version 2 of the format: other keys, degrees, sets by Reynolds number.
std::string version_2() {
  std::string text = samples().at("small_windio_2.yaml");
  text = replaced(text, "        outer_shape:\n", R"(        outer_shape:
            chord:
                grid: [0.0, 0.3, 1.0]
                values: [1.0, 1.6, 0.5]
            section_offset_y:
                grid: [0.0, 1.0]
                values: [0.5, 0.15]
            airfoils:
              - name: round
                spanwise_position: 0.1
                configuration: [default]
                weight: [1.0]
              - name: thick
                spanwise_position: 0.9
                configuration: [clean, rough]
                weight: [0.75, 0.25]
)");
  text += R"(airfoils:
  - name: round
    aerodynamic_center: 0.5
    polars:
      - configuration: default
        re_sets:
          - re: 1.0e+06
            cl: {grid: [-180, 180], values: [0, 0]}
            cd: {grid: [-180, 180], values: [0.5, 0.5]}
            cm: {grid: [-180, 180], values: [0, 0]}
  - name: thick
    aerodynamic_center: 0.25
    polars:
      - configuration: clean
        re_sets:
          - re: 1.0e+06
            cl: {grid: [-180, 0, 10, 180], values: [0, 0.4, 1.2, 0]}
            cd: {grid: [-180, 0, 180], values: [0.1, 0.01, 0.1]}
          - re: 9.0e+06
            cl: {grid: [-180, 0, 10, 180], values: [0, 0.4, 1.4, 0]}
            cd: {grid: [-180, 0, 180], values: [0.1, 0.01, 0.1]}
      - configuration: rough
        re_sets:
          - re: 1.0e+06
            cl: {grid: [-180, 0, 10, 180], values: [0, 0.2, 0.8, 0]}
            cd: {grid: [-180, 0, 180], values: [0.1, 0.03, 0.1]}
)";
  return text;
}

}  // namespace

TEST_CASE("the outer shape of an ontology becomes stations of the blade") {
  const auto imported = import_texts(samples(), {kAired});
  const spatial::Model& model = *imported.scenario.space;
  const spatial::BladeAerodynamics& air = *model.blades.at(1).aerodynamics;
  const std::vector<double> places = {0.0, 0.15, 0.3, 0.4, 0.5, 0.6, 1.0};
  REQUIRE(air.station.size() == places.size());
  CHECK(air.twist.empty());  // the sections have the same
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double p = places[i];
    CHECK(air.station[i] == doctest::Approx(20.0 * p).epsilon(1e-14));
    const double chord = at({{0.0, 1.0}, {0.3, 1.6}, {1.0, 0.5}}, p);
    CHECK(air.chord[i] == doctest::Approx(chord).epsilon(1e-14));
    const double center = at({{0.0, 0.5}, {0.15, 0.5}, {0.6, 0.25}, {1.0, 0.25}}, p);
    const double axis = at({{0.0, 0.5}, {0.5, 0.4}, {1.0, 0.3}}, p);
    CHECK(std::abs(air.center[i] - (axis - center) * chord) < 1e-14);
  }
  CHECK(model.air->density == 1.2);
  CHECK(model.air->viscosity == doctest::Approx(1.8e-5 / 1.2));
  CHECK(imported.scenario.space->gravity == Eigen::Vector3d(0.0, 0.0, -9.80665));
  Texts with_gravity = samples();
  with_gravity[kAired] = replaced(with_gravity[kAired], "    air_density: 1.2",
                                  "    gravity: 9.7\n    air_density: 1.2");
  CHECK(import_texts(with_gravity, {kAired}).scenario.space->gravity.z() == -9.7);
  CHECK(contains(imported.text, "# shear_exponent = 0.15   # environment.shear_exp"));
  CHECK(contains(imported.text, "# reference_height = 25   # assembly.hub_height"));
  const Scenario bare = import_texts(samples(), {"small_windio.yaml"}).scenario;
  check_same(model.blades[1].beam.sections, bare.space->blades.at(1).beam.sections);
}

TEST_CASE("polars between two aerofoils are linear along the blade") {
  const auto imported = import_texts(samples(), {kAired});
  const spatial::Model& model = *imported.scenario.space;
  const spatial::BladeAerodynamics& blade = *model.blades[0].aerodynamics;
  const std::vector<double> places = {0.0, 0.15, 0.3, 0.4, 0.5, 0.6, 1.0};
  for (std::size_t i = 1; i < places.size(); ++i) {
    const spatial::Airfoil &a = find(*model.air, blade.airfoil[i - 1]),
                           &b = find(*model.air, blade.airfoil[i]);
    for (const double share : {0.25, 1.0}) {
      const air::SectionPolar section(a, b, share);
      const double place = std::lerp(places[i - 1], places[i], share);
      for (const double level : {0.0, 0.5, 1.0})
        for (double angle = -3.1; angle < 3.1; angle += 0.0413) {
          const auto found = section.values(section.level(1e6 * std::pow(4.0, level)), angle);
          const Values expected = expected_at(place, angle, level);
          CHECK(std::abs(found.lift - expected.lift) < 1e-10);
          CHECK(std::abs(found.drag - expected.drag) < 1e-10);
          CHECK(std::abs(found.moment - expected.moment) < 1e-10);
        }
    }
  }
  for (const foreign::SourceFile& table : imported.tables) {
    const std::string name = table.name.substr(9, table.name.size() - 13);
    CHECK(air::parse_airfoil(table.text, "t", name) == find(*model.air, name));
  }
}

TEST_CASE("a twist of the outer shape that is not the sections' is the aerofoil's own") {
  Texts texts = samples();
  texts[kAired] = replaced(texts[kAired], "                twist: *twist\n",
                           "                twist: {grid: [0, 1], values: [0.1, 0.0]}\n");
  const auto imported = import_texts(texts, {kAired});
  const spatial::BladeAerodynamics& air = *imported.scenario.space->blades[0].aerodynamics;
  REQUIRE(air.twist.size() == 7);
  CHECK(air.twist[0] == doctest::Approx(-0.2 + 0.1).epsilon(1e-12));
  CHECK(air.twist[6] == doctest::Approx(0.01).epsilon(1e-12));
}

TEST_CASE("version 2 sums sets of polars and has its own keys") {
  Texts texts = samples();
  texts["v2.yaml"] = version_2();
  const auto imported = import_texts(texts, {"v2.yaml"});
  const spatial::Model& model = *imported.scenario.space;
  const spatial::BladeAerodynamics& blade = *model.blades.at(0).aerodynamics;
  REQUIRE(blade.station.size() == 6);  // 0, 0.1, 0.3, 0.4, 0.9, 1
  CHECK(blade.airfoil[0] == blade.airfoil[1]);
  CHECK(blade.airfoil[4] == blade.airfoil[5]);
  CHECK(blade.center[0] == doctest::Approx(0.0));
  CHECK(blade.center[5] == doctest::Approx(0.15 - 0.25 * 0.5));
  CHECK(blade.twist.empty());
  const spatial::Airfoil& thick = find(*model.air, blade.airfoil[5]);
  const air::SectionPolar section(thick, thick, 0.0);
  const double angle = 10.0 * kTurn / 180.0;
  CHECK(section.values(section.level(1e6), angle).lift == doctest::Approx(0.75 * 1.2 + 0.25 * 0.8));
  CHECK(section.values(section.level(3e6), angle).lift == doctest::Approx(0.75 * 1.3 + 0.25 * 0.8));
  CHECK(section.values(section.level(9e6), 0.0).drag == doctest::Approx(0.75 * 0.01 + 0.25 * 0.03));
  CHECK(model.air->density == 1.225);
}

TEST_CASE("an ontology without positions of aerofoils has no air") {
  const auto bare = import_texts(samples(), {"small_windio.yaml"});
  CHECK_FALSE(bare.scenario.space->air);
  CHECK(bare.tables.empty());
  CHECK(contains(bare.left_out.back(), "airfoils"));
  const auto aired = import_texts(samples(), {kAired});
  CHECK(contains(aired.left_out.at(1), "sets of polars (configuration) but the first"));
}

TEST_CASE("ontologies with faults of aerodynamics are refused") {
  const std::string good = samples().at(kAired);
  const auto with = [&](std::string_view from, std::string_view to) {
    return replaced(good, from, to);
  };
  check_refused(
      kAired, {kAired},
      {{with("labels: [round, round, thick, thin]", "labels: [round, round, thick]"),
        ":12: components.blade.outer_shape_bem.airfoil_position.labels: has 3 elements, expected "
        "4"},
       {with("thick, thin]", "thick, thinner]"),
        "labels.4: is \"thinner\", expected the name of one of airfoils"},
       {with("labels:", "names:"), "has no key labels, expected it beside "},
       {with("grid: [0.0, 0.15, 0.6, 1.0]", "grid: [0.0, 0.6, 0.15, 1.0]"),
        "airfoil_position.grid: element 3 is 0.15, expected more"},
       {with("grid: [0.0, 0.15, 0.6, 1.0]", "grid: [0.0, 0.15, 0.6]"), "the last 1"},
       {with("            pitch_axis:", "            axis:"), "has no key pitch_axis"},
       {with("            chord:", "            width:"), "has no key chord"},
       {with("[1.0, 1.6, 0.5]", "[1.0, -1.6, 0.5]"), "chord.values: has -1.6, expected 0 or more"},
       {with("[1.0, 1.6, 0.5]", "[1.0, 0.5]"), "chord.values: has 2 elements, expected 3"},
       {with("air_density: 1.2", "air_density: 0"), "air_density: is 0, expected more than 0"},
       {with("air_dyn_viscosity: 1.8e-05", "air_dyn_viscosity: low"),
        "environment.air_dyn_viscosity: is \"low\", expected a number"},
       {with("hub_height: 25.0", "hub_height: -25"), "hub_height: is -25, expected more than 0"},
       {with("aerodynamic_center: 0.25", "aerodynamic_center: 25"),
        "aerodynamic_center: is 25, expected 0 to 1"},
       {with("    aerodynamic_center: 0.25\n", ""), "has no key aerodynamic_center"},
       {with("  - name: thin", "  - title: thin"), "airfoils.3: has no key name"},
       {with("re: 2.0e+06", "re: 0"), "re: is 0, expected more than 0"},
       {with("re: 4.0e+06", "re: 1.0e+06"), "polars.2: re is 1e+06, expected more than"},
       {with("re: 1.0e+06\n        c_l:\n            grid: [-3.1415",
             "c_l:\n            grid: [-3"),
        "polars.1"},
       {with("    polars:", "    tables:"), "has no key polars"},
       {with("-0.2, 0.0, 0.2, 1.6", "-0.2, 0.2, 0.0, 1.6"),
        "c_l.grid: element 5 is 0 degrees, expected more than the one before, 11.4"},
       {with("[-3.1415, -1.6, -0.2, 0.0, 0.2", "[-3.0, -1.6, -0.2, 0.0, 0.2"),
        "c_l.grid: goes from -171.88"},
       {with("values: [0.0, 0.1, -0.7", "values: [0.1, -0.7"),
        "c_l.values: has 6 elements, expected 7, one for each of grid"},
       {with("0.016, 0.02, 1.8", "-0.016, 0.02, 1.8"), "drag is -0.016, expected 0 to 100"},
       {with("values: [0.5, 0.5]", "values: [500, 500]"), "drag is 500, expected 0 to 100"},
       {with("values: [0.5, 0.5]", "values: [0.5, 0.9]"), "drag is 0.9 at 180 degrees, expected"},
       {with("values: [0.5, 0.5]", "values: [0.5, .nan]"), "is \".nan\", expected a number"},
       {with("            grid: [-3.141592653589793, 3.141592653589793]\n            values: [0.5, "
             "0.5]",
             "            grid: [0.0]\n            values: [0.5]"),
        "c_d.grid: expected two or more angles of attack"},
       {with("        c_d:", "        drag:"), "has no key c_d"}});
}

TEST_CASE("faults of aerodynamics in version 2 are refused") {
  const std::string good = version_2(), name = "small_windio_2.yaml";
  const auto with = [&](std::string_view from, std::string_view to) {
    return replaced(good, from, to);
  };
  check_refused(
      name, {name},
      {{with("spanwise_position: 0.1", "spanwise_position: 1.1"), "is 1.1, expected 0 to 1"},
       {with("spanwise_position: 0.9", "spanwise_position: 0.1"),
        "airfoils.2.spanwise_position: is 0.1, expected more than that of the one before"},
       {with("                spanwise_position: 0.1\n", ""), "has no key spanwise_position"},
       {with("weight: [0.75, 0.25]", "weight: [0.75, 0.2]"), "has the sum 0.95, expected 1"},
       {with("weight: [0.75, 0.25]", "weight: [1]"), "weight: has 1 elements, expected 2"},
       {with("weight: [0.75, 0.25]", "weight: [1.25, -0.25]"), "element 2 is -0.25, expected 0"},
       {with("[clean, rough]", "[clean, dirty]"), "no polars of the configuration \"dirty\""},
       {with("- re: 9.0e+06", "- re: 1.0e+05"), "re is 1e+05, expected more than in the polar"},
       {with("section_offset_y:", "offset_y:"), "has no key section_offset_y"},
       {with("            cl: {", "            lift: {"), "has no key cl"}});
}
