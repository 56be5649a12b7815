// Blades of BeamDyn against a second converter, closed forms and what the files say.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/error.h"
#include "tests/contains.h"
#include "tests/program/foreign/samples.h"

using namespace spoke;
using namespace spoke::test;

namespace {

using Matrix = Eigen::Matrix<double, 6, 6>;

struct Rows {
  std::vector<double> kx, ky, kz, twist, eta;
  std::vector<Matrix> K, M;
};

/// Collects the tables by the number of numbers in a line: four of a key point, one of eta, six of
/// a matrix.
Rows read_rows() {
  Rows rows;
  for (const auto& line : numbers_by_line(samples().at("small_BeamDyn.dat")))
    if (line.size() == 4) {
      rows.kx.push_back(line[0]);
      rows.ky.push_back(-line[1]);
      rows.kz.push_back(line[2]);
      rows.twist.push_back(-line[3] / 180.0 * std::numbers::pi);
    }
  std::vector<std::vector<double>> six;
  const auto lines = numbers_by_line(samples().at("small_BeamDyn_blade.dat"));
  for (std::size_t i = 10; i < lines.size(); ++i) {
    if (lines[i].size() == 1) rows.eta.push_back(lines[i][0]);
    if (lines[i].size() == 6) six.push_back(lines[i]);
  }
  for (std::size_t i = 0; i < six.size(); i += 6) {
    Matrix m;
    for (std::size_t r = 0; r < 6; ++r)
      for (std::size_t c = 0; c < 6; ++c)
        m(static_cast<int>(r), static_cast<int>(c)) = six[i + r][c];
    const Matrix symmetric = 0.5 * (m + m.transpose());
    (i % 12 == 0 ? rows.K : rows.M).push_back(rotate_from_beamdyn(symmetric));
  }
  return rows;
}

/// Makes the sections by splines and quadrature of this test's own.
spatial::Sections convert() {
  const Rows rows = read_rows();
  const DenseSpline curve(rows.kz, {rows.ky, rows.kx, rows.twist});
  const double whole = curve.arc_length(0.0, rows.kz.back());
  std::vector<double> stations = rows.kz;
  for (std::size_t i = 1; i + 1 < rows.eta.size(); ++i)
    stations.push_back(curve.find_x(rows.eta[i] * whole));
  std::sort(stations.begin(), stations.end());
  spatial::Sections s;
  for (const double x : stations) {
    s.station.push_back(x);
    s.sweep.push_back(curve.at(0, x));
    s.prebend.push_back(curve.at(1, x));
    s.twist.push_back(curve.at(2, x));
    const double eta = curve.arc_length(0.0, x) / whole;
    std::size_t k = 0;
    while (k + 2 < rows.eta.size() && eta >= rows.eta[k + 1]) ++k;
    const double t = (eta - rows.eta[k]) / (rows.eta[k + 1] - rows.eta[k]);
    s.stiffness_6x6.push_back(rows.K[k] + t * (rows.K[k + 1] - rows.K[k]));
    s.mass_6x6.push_back(rows.M[k] + t * (rows.M[k + 1] - rows.M[k]));
  }
  return s;
}

}  // namespace

TEST_CASE("a blade of BeamDyn has the sections and frequencies of a second converter") {
  const foreign::Imported imported = import_texts(samples(), {"small_BeamDyn.dat"});
  const spatial::Beam& beam = imported.scenario.space->blades.at(0).beam;
  Scenario expected = imported.scenario;
  expected.space->blades[0].beam.sections = convert();
  CHECK(beam.length == 20.0);
  check_same(beam.sections, expected.space->blades[0].beam.sections);
  DirectionDamping damping;
  damping.flap_shear = 2.0e-3;
  damping.lag_shear = 1.5e-3;
  damping.axial = 1.0e-3;
  damping.lag = 1.5e-3;
  damping.flap = 2.0e-3;
  damping.torsion = 8.0e-4;
  CHECK(imported.scenario.space->damping.directions == damping);
  check_same_frequencies(imported.scenario, expected, 6);
}

TEST_CASE("a uniform straight blade of BeamDyn vibrates as a clamped beam does") {
  constexpr double L = 20.0, m = 10.0, flap = 2e5, edge = 8e5;
  std::string blade = up_to_line(samples().at("small_BeamDyn_blade.dat"), 10);
  blade = replaced(blade, "7   station_total", "2   station_total");
  for (const char* eta : {"0", "1"})
    blade += std::string(eta) +
             "\n1e9 0 0 0 0 0\n0 1e9 0 0 0 0\n0 0 1e9 0 0 0\n0 0 0 8d5 0 0\n0 0 0 0 2D+5 0\n"
             "0,0,0,0,0,1e6\n\n10 0 0 0 0 0\n0 10 0 0 0 0\n0 0 10 0 0 0\n0 0 0 8e-4 0 0\n"
             "0 0 0 0 2e-4 0\n0 0 0 0 0 1e-3\n\n";
  std::string primary = up_to_line(samples().at("small_BeamDyn.dat"), 24);
  primary = replaced(primary, "7   kp_total", "3   kp_total");
  primary = replaced(primary, "1      7 ", "1 3 ");
  primary += "0 0 0 0\n0 0 10 0\n0 0 20 0\n'small_BeamDyn_blade.dat' BldFile\n";
  Texts texts = samples();
  texts["small_BeamDyn_blade.dat"] = blade;
  texts["small_BeamDyn.dat"] = primary;
  const auto found = frequencies_of(import_texts(texts, {"small_BeamDyn.dat"}).scenario, 2);
  const double scale = 3.5160153 / (L * L) / (2.0 * std::numbers::pi);
  CHECK(found.at(0) == doctest::Approx(scale * std::sqrt(flap / m)).epsilon(2e-4));
  CHECK(found.at(1) == doctest::Approx(scale * std::sqrt(edge / m)).epsilon(5e-4));
}

TEST_CASE("a scenario says where its values came from, what was read and what is left out") {
  const foreign::Imported imported = import_texts(samples(), {"small_BeamDyn.dat"});
  for (const char* part :
       {"# Written by spoke import from", "#   small_BeamDyn.dat: BeamDyn, primary file",
        "#   small_BeamDyn_blade.dat: BeamDyn, blade file", "# Not carried over, worst first:",
        "title = \"A blade of 20 m, made up for the tests of Spoke\"", "kind = \"fixed\"",
        "length = 20   # kp_zr of key point 7, small_BeamDyn.dat:31",
        "   # key point 1, small_BeamDyn.dat:25; section 1, small_BeamDyn_blade.dat:11",
        "   # section 2, small_BeamDyn_blade.dat:26",
        "mu = [0.002, 0.0015, 0.001, 0.0015, 0.002, 0.0008]   # mu1 to mu6, "
        "small_BeamDyn_blade.dat:9",
        "made symmetric"}) {
    CAPTURE(part);
    CHECK(contains(imported.text, part));
  }
  CHECK(imported.sources.size() == 2);
  CHECK(imported.left_out.size() == 2);  // with gravity
}

TEST_CASE("a blade file that is given stands in for the one that the primary file names") {
  Texts texts = samples();
  texts["other.dat"] =
      replaced(texts["small_BeamDyn_blade.dat"], " 1   damp_type", " 0   damp_type");
  const auto imported = import_texts(texts, {"other.dat", "small_BeamDyn.dat"});
  CHECK(imported.scenario.space->damping.directions.is_zero());
  CHECK(contains(imported.text, "other.dat: BeamDyn, blade file"));
}

TEST_CASE("newer blade files may damp modes, and a root may be off by round-off") {
  Texts texts = samples();
  std::string& blade = texts["small_BeamDyn_blade.dat"];
  blade =
      replaced(blade, "---------------------- DISTRIBUTED",
               "------ Modal Damping [used only if damp_type=2] ------\n"
               "2   n_modes  - Number of coefficients\n0.01, 0.02, 0.5 zeta\n------ DISTRIBUTED");
  texts["small_BeamDyn.dat"] = with_line(texts["small_BeamDyn.dat"], 25, " 0 0 -8.1e-28 12.0");
  const auto by_factors = import_texts(texts, {"small_BeamDyn.dat"});
  CHECK(by_factors.scenario.space->damping.directions.flap == 2e-3);
  blade = replaced(blade, " 1   damp_type", " 2   damp_type");
  const auto by_modes = import_texts(texts, {"small_BeamDyn.dat"});
  CHECK(by_modes.scenario.space->damping.directions.is_zero());
  CHECK(by_modes.scenario.space->damping.modes.ratios == std::vector<double>{0.01, 0.02});
  CHECK(by_modes.scenario.space->blades[0].beam.sections ==
        import_texts(samples(), {"small_BeamDyn.dat"}).scenario.space->blades[0].beam.sections);
}

TEST_CASE("a file that is named is looked for beside the one that names it") {
  Texts texts;
  texts["a/primary.dat"] =
      replaced(samples().at("small_BeamDyn.dat"), "small_BeamDyn_blade.dat", "../b/blade.dat");
  texts["b/blade.dat"] = samples().at("small_BeamDyn_blade.dat");
  CHECK(import_texts(texts, {"a/primary.dat"}).sources.at(1) == "b/blade.dat: BeamDyn, blade file");
}

TEST_CASE("members share key points, and lines may end as Windows has them") {
  std::string primary = samples().at("small_BeamDyn.dat");
  primary = replaced(primary, "1   member_total", "2   member_total");
  primary = replaced(primary, "     1      7 ", "     1      3\n     2      5 ");
  std::string windows;
  for (const char c : primary) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  Texts texts = samples();
  texts["small_BeamDyn.dat"] = windows;
  const auto imported = import_texts(texts, {"small_BeamDyn.dat"});
  const auto whole = import_texts(samples(), {"small_BeamDyn.dat"});
  check_same(imported.scenario.space->blades[0].beam.sections,
             whole.scenario.space->blades[0].beam.sections);
  CHECK(imported.left_out.size() == 3);
}
