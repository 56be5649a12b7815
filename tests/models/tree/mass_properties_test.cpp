#include "models/tree/mass_properties.h"

#include <doctest/doctest.h>

#include "models/space/rotation_vector.h"
#include "models/tree/space_beam.h"

using doctest::Approx;
using namespace spoke::spatial;

namespace {

/// Makes a beam of 3 m and 2 kg/m, with the inertias of its sections.
Beam uniform_beam() {
  Beam beam;
  beam.length = 3.0;
  Sections& s = beam.sections;
  s.station = {0.0, 3.0};
  s.mass_per_length = {2.0, 2.0};
  s.axial_stiffness = {1e6, 1e6};
  s.flap_stiffness = {1e3, 1e3};
  s.lag_stiffness = {4e3, 4e3};
  s.torsion_stiffness = {1e3, 1e3};
  s.flap_inertia = {0.01, 0.01};
  s.lag_inertia = {0.05, 0.05};
  return beam;
}

/// Makes a general beam: tapered, twisted, bent, with offsets.
Beam general_beam() {
  Beam beam = uniform_beam();
  Sections& s = beam.sections;
  s.station = {0.0, 1.0, 3.0};
  s.mass_per_length = {3.0, 2.0, 0.5};
  for (auto* values : {&s.axial_stiffness, &s.flap_stiffness, &s.lag_stiffness,
                       &s.torsion_stiffness, &s.flap_inertia, &s.lag_inertia})
    values->push_back(0.5 * values->back());
  s.mass_center = {Offset(0.1, 0.02), Offset(0.05, 0.0), Offset(0.0, -0.03)};
  s.twist = {0.4, 0.1, -0.2};
  s.sweep = {0.0, 0.1, 0.5};
  s.prebend = {0.0, 0.05, 0.4};
  return beam;
}

MassProperties mass_of(const Beam& beam, double from, double to) {
  return calc_mass_properties(make_space_beam(beam), from, to);
}

void check_equal(const MassProperties& a, const MassProperties& b) {
  CHECK(a.mass == Approx(b.mass).epsilon(1e-13));
  CHECK(a.first_moment.isApprox(b.first_moment, 1e-12));
  CHECK(a.inertia.isApprox(b.inertia, 1e-12));
}

}  // namespace

TEST_CASE("a uniform beam has the closed form's mass, first moment and inertia") {
  const MassProperties m = mass_of(uniform_beam(), 0.0, 3.0);
  CHECK(m.mass == Approx(6.0));
  CHECK(m.first_moment.isApprox(Vector(9.0, 0.0, 0.0), 1e-14));
  CHECK(m.inertia(0, 0) == Approx(3.0 * 0.06));
  CHECK(m.inertia(1, 1) == Approx(2.0 * 27.0 / 3.0 + 3.0 * 0.01));
  CHECK(m.inertia(2, 2) == Approx(2.0 * 27.0 / 3.0 + 3.0 * 0.05));
  CHECK(std::abs(m.inertia(0, 1)) < 1e-14);
}

TEST_CASE("a beam of linear mass has the closed form's moments") {
  Beam beam = uniform_beam();
  beam.sections.mass_per_length = {4.0, 1.0};  // 4 - x
  const MassProperties m = mass_of(beam, 0.0, 3.0);
  CHECK(m.mass == Approx(7.5));
  CHECK(m.first_moment.x() == Approx(4.0 * 9.0 / 2.0 - 27.0 / 3.0));
  CHECK(m.inertia(1, 1) == Approx(4.0 * 27.0 / 3.0 - 81.0 / 4.0 + 0.03));
}

TEST_CASE("a beam with a straight oblique axis is the turned straight one, of more length") {
  Beam oblique = uniform_beam();
  oblique.sections.sweep = {0.0, 4.0};  // 5 m long
  Beam straight = uniform_beam();
  straight.length = 5.0;
  straight.sections.station = {0.0, 5.0};
  const Tensor turn = spoke::space::smallest_rotation(Vector::UnitX(), Vector(0.6, 0.8, 0.0)).axes;
  check_equal(mass_of(oblique, 0.0, 3.0),
              mass_of(straight, 0.0, 5.0).seen_from_outside({Vector::Zero(), turn}));
}

TEST_CASE("parts of a beam make up the whole, wherever it is cut") {
  const Beam beam = general_beam();
  MassProperties sum = mass_of(beam, 0.0, 0.3);
  sum += mass_of(beam, 0.3, 1.7);
  sum += mass_of(beam, 1.7, 3.0);
  const MassProperties whole = mass_of(beam, 0.0, 3.0);
  // The axis is a cubic: the rule of six points is almost exact for it.
  CHECK(sum.mass == Approx(whole.mass).epsilon(1e-9));
  CHECK(sum.first_moment.isApprox(whole.first_moment, 1e-9));
  CHECK(sum.inertia.isApprox(whole.inertia, 1e-9));
}

TEST_CASE("a body seen from elsewhere and back is the same") {
  const MassProperties body =
      make_mass_properties(2.0, Vector(0.1, -0.4, 0.3), Vector(1.0, 2.0, 2.5).asDiagonal());
  const Tensor R = spoke::space::exponential(Vector(0.3, -1.0, 0.6)).axes;
  const Vector p(4.0, 5.0, -6.0);
  check_equal(
      body.seen_from_outside({p, R}).seen_from_outside({-(R.transpose() * p), R.transpose()}),
      body);
}
