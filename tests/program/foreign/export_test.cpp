// Blades written for BeamDyn, and read again.

#include <doctest/doctest.h>

#include "models/error.h"
#include "program/foreign/export_beamdyn.h"
#include "tests/contains.h"
#include "tests/program/foreign/samples.h"

using namespace spoke;
using namespace spoke::test;

namespace {

foreign::Imported read_again(const Scenario& scenario) {
  const foreign::BeamDynFiles files = foreign::export_beamdyn(scenario, 1, "x_blade.dat");
  return import_texts({{"x.dat", files.primary}, {"x_blade.dat", files.blade}}, {"x.dat"});
}

spatial::Beam make_beam() {
  spatial::Beam beam;
  beam.length = 8.0;
  beam.sections.station = {0.0, 3.0, 8.0};
  beam.sections.mass_per_length = {5.0, 4.0, 2.0};
  beam.sections.axial_stiffness = {4e7, 3e7, 1e7};
  beam.sections.flap_stiffness = {5e4, 3e4, 1e4};
  beam.sections.lag_stiffness = {2e5, 1e5, 5e4};
  beam.sections.torsion_stiffness = {4e4, 2e4, 1e4};
  beam.sections.flap_shear_stiffness = {5e6, 4e6, 3e6};
  beam.sections.lag_shear_stiffness = {9e6, 8e6, 7e6};
  beam.sections.twist = {0.1, 0.07, -0.02};
  return beam;
}

}  // namespace

TEST_CASE("a blade of BeamDyn that is written and read again has the same numbers") {
  const Scenario first = import_texts(samples(), {"small_BeamDyn.dat"}).scenario;
  const Scenario second = read_again(first).scenario;
  const spatial::Sections &a = first.space->blades[0].beam.sections,
                          &b = second.space->blades[0].beam.sections;
  CHECK(a.station == b.station);
  CHECK(a.sweep == b.sweep);
  CHECK(a.prebend == b.prebend);
  CHECK(a.stiffness_6x6 == b.stiffness_6x6);
  CHECK(a.mass_6x6 == b.mass_6x6);
  REQUIRE(a.twist.size() == b.twist.size());
  for (std::size_t i = 0; i < a.twist.size(); ++i)
    CHECK(a.twist[i] == doctest::Approx(b.twist[i]).epsilon(1e-15));
  CHECK(first.space->damping.directions == second.space->damping.directions);
}

TEST_CASE("the second time a blade is written the files are the same") {
  const Scenario first = import_texts(samples(), {"small_BeamDyn.dat"}).scenario;
  const auto files = foreign::export_beamdyn(first, 1, "x_blade.dat");
  const Scenario second = read_again(first).scenario;
  CHECK(foreign::export_beamdyn(second, 1, "x_blade.dat").blade == files.blade);
}

TEST_CASE("a blade given by stiffnesses and offsets keeps its frequencies") {
  Scenario scenario = held_blade(make_beam());
  spatial::Sections& s = scenario.space->blades[0].beam.sections;
  s.mass_center.assign(3, spatial::Offset(0.05, -0.02));
  s.tension_center.assign(3, spatial::Offset(0.03, 0.01));
  s.shear_center.assign(3, spatial::Offset(-0.04, 0.02));
  scenario.space->damping.stiffness_factor = 1e-3;
  Scenario again = read_again(scenario).scenario;
  again.space->blades[0].beam.bodies = scenario.space->blades[0].beam.bodies;
  const auto a = frequencies_of(scenario, 6), b = frequencies_of(again, 6);
  // Between stations the one is linear in the properties, the other in the matrices.
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == doctest::Approx(b[i]).epsilon(5e-3));
  CHECK(again.space->damping.directions.flap == 1e-3);
  CHECK(again.space->damping.directions.torsion == 1e-3);
}

TEST_CASE("a uniform blade keeps its frequencies to round-off") {
  spatial::Beam beam = make_beam();
  const auto level = [](std::vector<double>& values) { values.assign(3, values[0]); };
  for (auto* values : {&beam.sections.mass_per_length, &beam.sections.axial_stiffness,
                       &beam.sections.flap_stiffness, &beam.sections.lag_stiffness,
                       &beam.sections.torsion_stiffness, &beam.sections.flap_shear_stiffness,
                       &beam.sections.lag_shear_stiffness})
    level(*values);
  const Scenario scenario = held_blade(beam);
  Scenario again = read_again(scenario).scenario;
  again.space->blades[0].beam.bodies = beam.bodies;
  check_same_frequencies(again, scenario, 6);
}

TEST_CASE("what BeamDyn does not know is said") {
  spatial::Beam beam = make_beam();
  beam.sections.flap_shear_stiffness.clear();
  beam.point_masses.push_back({8.0, 1.0});
  const auto files = foreign::export_beamdyn(held_blade(beam), 1, "b.dat");
  REQUIRE(files.left_out.size() == 3);
  CHECK(contains(files.left_out[0], "shear"));
  CHECK(contains(files.left_out[1], "point masses"));
}

TEST_CASE("a blade of two stations gets the third key point that BeamDyn needs") {
  spatial::Beam beam = make_beam();
  beam.sections = {};
  beam.sections.station = {0.0, 8.0};
  for (auto* values : {&beam.sections.axial_stiffness, &beam.sections.flap_stiffness,
                       &beam.sections.lag_stiffness, &beam.sections.torsion_stiffness,
                       &beam.sections.flap_shear_stiffness, &beam.sections.lag_shear_stiffness})
    *values = {1e6, 1e6};
  beam.sections.mass_per_length = {1.0, 1.0};
  const Scenario again = read_again(held_blade(beam)).scenario;
  CHECK(again.space->blades[0].beam.sections.station == std::vector<double>{0.0, 4.0, 8.0});
}

TEST_CASE("a scenario without such a blade is refused") {
  const Scenario scenario = held_blade(make_beam());
  CHECK_THROWS_WITH_AS(foreign::export_beamdyn(scenario, 2, "b.dat"),
                       "--blade 2: expected a number from 1 to 1", InputError);
  CHECK_THROWS_AS(foreign::export_beamdyn(Scenario(), 1, "b.dat"), InputError);
  Scenario bent = scenario;
  bent.space->blades[0].beam.sections.prebend = {0.1, 0.2, 0.3};
  CHECK_THROWS_AS(foreign::export_beamdyn(bent, 1, "b.dat"), InputError);
}
