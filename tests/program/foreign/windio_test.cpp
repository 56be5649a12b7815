// The blade of an ontology of WindIO against a second converter; what is refused.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tests/contains.h"
#include "tests/program/foreign/samples.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr const char* kOntology = "small_windio.yaml";

/// Returns the numbers of all lines with brackets, in order.
std::vector<std::vector<double>> arrays_of(const std::string& text) {
  std::vector<std::vector<double>> arrays;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t start = line.find('[');
    if (start == std::string::npos) continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line.substr(start + 1));
    std::vector<double>& numbers = arrays.emplace_back();
    for (double number = 0.0; words >> number;) numbers.push_back(number);
  }
  return arrays;
}

double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) {
  std::size_t k = 0;
  while (k + 2 < x.size() && at >= x[k + 1]) ++k;
  return y[k] + (y[k + 1] - y[k]) * (at - x[k]) / (x[k + 1] - x[k]);
}

Eigen::Matrix<double, 6, 6> symmetric(const std::vector<double>& upper) {
  Eigen::Matrix<double, 6, 6> m;
  std::size_t next = 0;
  for (int r = 0; r < 6; ++r)
    for (int c = r; c < 6; ++c) m(r, c) = m(c, r) = upper[next++];
  return rotate_from_beamdyn(m);
}

spatial::Sections convert_ontology() {
  // In the order of the file: chord, twist, x, y, z (grid and values each), then the matrices.
  const auto a = arrays_of(samples().at(kOntology));
  const std::vector<double> places = {0.0, 0.25, 0.4, 0.5, 0.75, 1.0};
  std::vector<double> x, sweep, prebend, twist;
  for (const double place : places) {
    x.push_back(interpolate(a[8], a[9], place));
    sweep.push_back(-interpolate(a[6], a[7], place));
    prebend.push_back(interpolate(a[4], a[5], place));
    twist.push_back(-interpolate(a[2], a[3], place));
  }
  const DenseSpline curve(x, {sweep, prebend, twist});
  const std::vector<double>& eta = a[10];
  const double whole = curve.arc_length(0.0, x.back());
  std::vector<double> stations = x;
  for (std::size_t i = 1; i + 1 < eta.size(); ++i) stations.push_back(curve.find_x(eta[i] * whole));
  std::sort(stations.begin(), stations.end());
  spatial::Sections s;
  s.station = stations;
  for (const double place : stations) {
    s.sweep.push_back(curve.at(0, place));
    s.prebend.push_back(curve.at(1, place));
    s.twist.push_back(curve.at(2, place));
    const double share = curve.arc_length(0.0, place) / whole;
    std::size_t k = 0;
    while (k + 2 < eta.size() && share >= eta[k + 1]) ++k;
    const double t = (share - eta[k]) / (eta[k + 1] - eta[k]);
    s.stiffness_6x6.push_back((1.0 - t) * symmetric(a[11 + k]) + t * symmetric(a[12 + k]));
    s.mass_6x6.push_back((1.0 - t) * symmetric(a[16 + k]) + t * symmetric(a[17 + k]));
  }
  return s;
}

}  // namespace

TEST_CASE("a blade of WindIO has the sections and frequencies of a second converter") {
  const auto imported = import_texts(samples(), {kOntology});
  const spatial::Model& model = *imported.scenario.space;
  REQUIRE(model.blades.size() == 3);
  CHECK(model.hub.radius == 1.2);
  CHECK(model.hub.axis.x() == 1.0);
  CHECK(model.blades[0].precone == -0.05);  // upwind
  Scenario expected = imported.scenario;
  for (spatial::Blade& blade : expected.space->blades) blade.beam.sections = convert_ontology();
  check_same(model.blades[1].beam.sections, expected.space->blades[1].beam.sections);
  check_same_frequencies(imported.scenario, expected, 5);
  CHECK(contains(imported.text, "# components.hub.diameter, small_windio.yaml:"));
}

TEST_CASE("version 2 gives the blade of version 1") {
  const auto second = import_texts(samples(), {"small_windio_2.yaml"});
  const auto first = import_texts(samples(), {kOntology});
  const spatial::Model &a = *first.scenario.space, &b = *second.scenario.space;
  check_same(b.blades.at(2).beam.sections, a.blades.at(2).beam.sections);
  CHECK(b.hub.radius == a.hub.radius);
  CHECK(b.blades[0].precone == doctest::Approx(a.blades[0].precone).epsilon(1e-12));
  CHECK(b.damping.directions.flap == 0.002);
  CHECK(a.damping.directions.is_zero());
}

TEST_CASE("faults of version 2 are refused") {
  constexpr const char* name = "small_windio_2.yaml";
  const std::string good = samples().at(name);
  check_refused(
      name, {name},
      {{replaced(good, "    structure:", "    parts:"), "has no key structure"},
       {replaced(good, "K44:", "K4:"), "has no key K44, expected it beside \"grid\", \"K11\""},
       {replaced(good, "K12: [", "K12: [1, "), "K12: has 5 elements, expected 4"},
       {replaced(good, "K33: [", "K33: [-"), "stiffness_matrix: section 1 has -"},
       {replaced(good, "i_flap: [", "i_flap: [-"), "inertia_matrix: section 1 has -"},
       {replaced(good, "mu: [0.002", "mu: [-0.002"), "mu: is -0.002, expected numbers"},
       {replaced(good, "mu: [0.002,", "mu: ["), "mu: has 5 elements, expected 6"},
       {replaced(good, "windIO_version: '2.0'", "windIO_version: '1.0'"),
        "has no key elastic_properties_mb"}});
}

TEST_CASE("a downwind rotor is coned downwind") {
  Texts texts = samples();
  texts[kOntology] = replaced(texts[kOntology], "Upwind", "Downwind");
  CHECK(import_texts(texts, {kOntology}).scenario.space->blades[0].precone == 0.05);
}

TEST_CASE("ontologies with faults are refused with file, line, key and what was expected") {
  const std::string good = samples().at(kOntology);
  check_refused(
      kOntology, {kOntology},
      {{"", "is no map"},
       {"a: [1, 2\nb: 3", "is no YAML"},
       {"a: \tb\n\t- c", "is no YAML"},
       {"- 1\n- 2", "is no map, expected one with the key components"},
       {replaced(good, "components:", "parts:"), "has no key components"},
       {replaced(good, "    blade:", "    wing:"), "components: has no key blade"},
       {replaced(good, "elastic_properties_mb", "elastic"),
        "components.blade: has no key elastic_properties_mb"},
       {replaced(good, "six_x_six", "four"), "has no key six_x_six"},
       {replaced(good, "stiff_matrix:", "stiff:"), "has no key stiff_matrix"},
       {replaced(good, "inertia_matrix:", "inertia:"), "has no key inertia_matrix"},
       {replaced(good, "reference_axis: *axis", "reference_axis: 3"), ":27: components.blade"},
       {replaced(good, "reference_axis: *axis", "reference_axis: *none"), "is no YAML"},
       {replaced(good, "twist: *twist", "twist: {grid: [0, 1]}"), "has no key values"},
       {replaced(good, "grid: [0.0, 0.4, 1.0]", "grid: [0.0, 1.4, 1.0]"),
        "grid: element 3 is 1, expected more than the one before, 1.4"},
       {replaced(good, "grid: [0.0, 0.4, 1.0]", "grid: [0.1, 0.4, 1.0]"), "the first 0"},
       {replaced(good, "grid: [0.0, 0.4, 1.0]", "grid: 7"), "is no array"},
       {replaced(good, "values: [0.2, 0.08, -0.01]", "values: [0.2, 0.08]"),
        ":14: components.blade.elastic_properties_mb.six_x_six.twist.values: has 2 elements, "
        "expected 3"},
       {replaced(good, "values: [0.2, 0.08, -0.01]", "values: [0.2, much, -0.01]"),
        "twist.values.2: is \"much\", expected a number"},
       {replaced(good, "values: [0.2, 0.08, -0.01]", "values: [0.2, .inf, -0.01]"), "is \".inf\""},
       {replaced(good, "values: [0.2, 0.08, -0.01]", "values: [0.2, [1], -0.01]"), "is no number"},
       {replaced(good, "values: [0.2, 0.08, -0.01]", "values: [0.2, 1e31, -0.01]"), "at most 1e30"},
       {replaced(good, "5.0, 10.0, 15.0", "5.0, 4.0, 15.0"), "reference_axis.z: is 4.4 at 0.4"},
       {replaced(good, "[0.0, 5.0, 10.0", "[1.0, 5.0, 10.0"), "does not begin at the root"},
       {replaced(good, "grid: [0, 0.3, 0.6, 1]", "grid: [0, 0.3, 1]"),
        "grid: differs, expected that"},
       {replaced(good, "4.3e+07, ", "-4.3e+07, "), "has -43000000 in row 1, column 1"},
       {replaced(good, "4.3e+07, ", ""), "has 20 numbers, expected the 21"},
       {replaced(good, "-  [68, ", "-  [60, "), "mass per length of row 3, 68"},
       {replaced(good, "diameter: 2.4", "diameter: -2.4"), "diameter: is -2.4"},
       {replaced(good, "number_of_blades: 3", "number_of_blades: 2.5"), "a whole number"}});
}

TEST_CASE("an ontology stands by itself") {
  check_refused("small_ElastoDyn_tower.dat", {kOntology, "small_ElastoDyn_tower.dat"},
                {{samples().at("small_ElastoDyn_tower.dat"), "expected an ontology by itself"}},
                {.tower_height = 3.0});
}
