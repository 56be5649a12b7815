// Blades, towers and aerodynamics written for ElastoDyn and AeroDyn, and read again.

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "models/error.h"
#include "program/foreign/export_aerodyn.h"
#include "program/foreign/export_elastodyn.h"
#include "program/foreign/mode_polynomials.h"
#include "tests/contains.h"
#include "tests/program/foreign/samples.h"
#include "tests/shipped.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// The samples with the files that were written in place of others of their names.
Texts with_files(const foreign::ExportedFiles& exported) {
  Texts texts = samples();
  for (const foreign::SourceFile& file : exported.files) texts[file.name] = file.text;
  return texts;
}

foreign::ExportedFiles write_elastodyn(const Scenario& scenario) {
  return foreign::export_elastodyn(scenario, 1, "small_ElastoDyn_blade.dat",
                                   "small_ElastoDyn_tower.dat");
}

foreign::ExportedFiles write_aerodyn(const Scenario& scenario) {
  return foreign::export_aerodyn(scenario, 1, "x.dat", "x_blade.dat",
                                 [](const std::string& name) { return "x_" + name + ".dat"; });
}

const spatial::Beam& first_of_support(const Scenario& scenario) {
  return std::get<spatial::Beam>(scenario.space->subsystems.back().bodies.at(0).shape);
}

/// Requires equal sections but for what ElastoDyn does without, which is the same to round-off.
void check_exact(const spatial::Sections& a, const spatial::Sections& b) {
  CHECK(a.mass_per_length == b.mass_per_length);
  CHECK(a.flap_stiffness == b.flap_stiffness);
  CHECK(a.lag_stiffness == b.lag_stiffness);
  CHECK(a.torsion_stiffness == b.torsion_stiffness);
  CHECK(a.axial_stiffness == b.axial_stiffness);
  check_same(a, b);
}

}  // namespace

TEST_CASE("the modes of polynomials are those of clamped beams") {
  constexpr double L = 30.0, m = 40.0, EI = 5e7;
  foreign::PlaneBeam beam{{0.0, 7.0, L}, {m, m, m}, {EI, EI, EI}, 0.0};
  const double scale = std::sqrt(EI / m) / (L * L);
  const auto modes = foreign::find_polynomial_modes(beam);
  CHECK(modes[0].frequency == doctest::Approx(3.5160153 * scale).epsilon(1e-6));
  CHECK(modes[1].frequency == doctest::Approx(22.0344916 * scale).epsilon(1e-3));
  for (const auto& mode : modes)
    CHECK(std::accumulate(mode.coefficient.begin(), mode.coefficient.end(), 0.0) ==
          doctest::Approx(1.0));
  // The shape of the first mode at half the length, 0.339523 of that at the tip.
  double half = 0.0;
  for (std::size_t i = 0; i < 5; ++i)
    half += modes[0].coefficient[i] * std::pow(0.5, static_cast<double>(i + 2));
  CHECK(half == doctest::Approx(0.339523).epsilon(1e-4));
  beam.tip_mass = 1e4 * m * L;  // a spring 3 EI/L^3 and a mass
  CHECK(foreign::find_polynomial_modes(beam)[0].frequency ==
        doctest::Approx(std::sqrt(3.0 * EI / (L * L * L) / (beam.tip_mass + 0.2357 * m * L)))
            .epsilon(1e-6));
}

TEST_CASE("blade and tower that are written for ElastoDyn are read as they were") {
  const Scenario first = import_texts(samples(), {"small_ElastoDyn.dat"}).scenario;
  const auto exported = write_elastodyn(first);
  REQUIRE(exported.files.size() == 2);
  const Scenario second = import_texts(with_files(exported), {"small_ElastoDyn.dat"}).scenario;
  check_exact(second.space->blades.at(0).beam.sections, first.space->blades.at(0).beam.sections);
  check_exact(first_of_support(second).sections, first_of_support(first).sections);
  const auto &a = first.space->damping.modes.ratios, &b = second.space->damping.modes.ratios;
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == doctest::Approx(b[i]));
}

TEST_CASE("the shipped turbine as ElastoDyn's files keeps its frequencies") {
  Scenario shipped = read_shipped("nrel_5mw_turbine");
  const auto exported = write_elastodyn(shipped);
  const Texts texts = with_files(exported);
  const auto check = [&](const Scenario& found, const spatial::Beam& beam) {
    const spatial::Beam* read =
        found.space->blades.empty() ? &first_of_support(found) : &found.space->blades[0].beam;
    spatial::Beam plain = beam;
    plain.bodies = read->bodies;
    plain.elements = read->elements;
    plain.geometric_stiffening = read->geometric_stiffening;
    plain.strain = read->strain;
    check_same_frequencies(held_blade(*read), held_blade(plain), 5);
  };
  check(import_texts(texts, {"small_ElastoDyn_blade.dat"}, {.blade_length = 61.5}).scenario,
        shipped.space->blades[0].beam);
  check(import_texts(texts, {"small_ElastoDyn_tower.dat"}, {.tower_height = 87.6}).scenario,
        first_of_support(shipped));
  // Damping of the shipped blades by their stiffness factor: half of it by the frequency.
  const auto lines = numbers_by_line(exported.files[0].text);
  const double ratio = 0.01 * lines.at(4).at(0);
  CHECK(2.0 * ratio / shipped.space->damping.stiffness_factor ==
        doctest::Approx(0.68 * 2.0 * 3.14159265).epsilon(0.03));
}

TEST_CASE("the aerodynamics of a blade that are written for AeroDyn are read as they were") {
  for (const bool is_shipped : {false, true}) {
    CAPTURE(is_shipped);
    const Scenario first = is_shipped ? read_shipped("nrel_5mw_in_wind")
                                      : import_texts(samples(), {"small_turbine.fst"}).scenario;
    Texts texts = with_files(write_elastodyn(first));
    for (const foreign::SourceFile& file : write_aerodyn(first).files) texts[file.name] = file.text;
    if (is_shipped) {
      texts["small_ElastoDyn.dat"] =
          replaced(replaced(texts["small_ElastoDyn.dat"], "19.5          TipRad", "62.5 TipRad"),
                   "25.0          TowerHt", "88.6 TowerHt");
    } else {
      texts["small_ElastoDyn.dat"] =
          replaced(texts["small_ElastoDyn.dat"], "19.5          TipRad", "21.0 TipRad");
    }
    const Scenario second = import_texts(texts, {"small_ElastoDyn.dat", "x.dat"}).scenario;
    const auto &a = *first.space->blades.at(0).aerodynamics,
               &b = *second.space->blades.at(0).aerodynamics;
    CHECK(a.station == b.station);
    CHECK(a.chord == b.chord);
    REQUIRE(a.center.size() == b.center.size());
    for (std::size_t i = 0; i < a.station.size(); ++i) {
      CHECK(std::abs((a.twist.empty() ? 0.0 : a.twist[i]) - (b.twist.empty() ? 0.0 : b.twist[i])) <
            1e-12);
      CHECK(a.center[i] == doctest::Approx(b.center[i]).epsilon(1e-12));
      const auto polars_of = [](const Scenario& scenario, const std::string& name) {
        for (const spatial::Airfoil& airfoil : scenario.space->air->airfoils)
          if (airfoil.name == name) return airfoil.polars;
        FAIL("no aerofoil " << name);
        return std::vector<spatial::Polar>();
      };
      const auto p = polars_of(first, a.airfoil[i]), q = polars_of(second, b.airfoil[i]);
      REQUIRE(p.size() == q.size());
      for (std::size_t k = 0; k < p.size(); ++k) {
        REQUIRE(p[k].angle.size() == q[k].angle.size());
        for (std::size_t r = 0; r < p[k].angle.size(); ++r)
          CHECK(p[k].angle[r] == doctest::Approx(q[k].angle[r]).epsilon(1e-14));
        CHECK(p[k].lift == q[k].lift);
        CHECK(p[k].drag == q[k].drag);
        if (p.size() > 1) CHECK(p[k].reynolds == doctest::Approx(q[k].reynolds));
      }
    }
    CHECK(second.space->air->density == first.space->air->density);
    CHECK(second.space->air->inflow == first.space->air->inflow);
    CHECK(second.space->air->stall == first.space->air->stall);
    const auto &of_first = first.space->subsystems.back().bodies.at(0).drag,
               &of_second = second.space->subsystems.back().bodies.at(0).drag;
    REQUIRE(of_first.has_value() == of_second.has_value());
    if (!of_first) continue;
    CHECK(of_second->potential == of_first->potential);
    CHECK(of_second->shadow == of_first->shadow);
    for (std::size_t i = 0; i < of_first->station.size(); ++i)
      CHECK(of_second->diameter.at(i) == doctest::Approx(of_first->diameter[i]));
  }
}

TEST_CASE("what ElastoDyn and AeroDyn do not know is said, and what they cannot have refused") {
  const Scenario bent = import_texts(samples(), {"small_BeamDyn.dat"}).scenario;
  const auto exported = write_elastodyn(bent);
  CHECK(exported.files.size() == 1);
  CHECK(contains(exported.left_out.at(0), "sweep and prebend of the blade"));
  CHECK(contains(exported.left_out.at(1), "couplings of the blade's matrices"));
  CHECK_THROWS_WITH_AS(write_aerodyn(bent),
                       "blade.aerodynamics: is missing, expected a blade with aerodynamics, and "
                       "[air]",
                       InputError);
  Scenario other = import_texts(samples(), {"small_turbine.fst"}).scenario;
  other.space->blades[0].aerodynamics->leads_backward = true;
  CHECK_THROWS_AS(write_aerodyn(other), InputError);
  CHECK_THROWS_WITH_AS(foreign::export_elastodyn(bent, 2, "a", "b"),
                       "--blade 2: expected a number from 1 to 1", InputError);
}
