// Cantilevers whose mass and stiffness change along them, against closed forms: deflection under a
// tip force, frequencies of a linear taper (power series) and of a wedge (Bessel functions).

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/simulation.h"
#include "models/plane/beam_elements.h"
#include "models/system/system.h"
#include "tests/approx.h"
#include "tests/closed_forms/beams.h"
#include "tests/engine/lagrangian.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

constexpr double kLength = 2.0, kMass = 0.3, kStiffness = 40.0, kAxial = 1e7;

/// Makes a blade whose mass and stiffness go linearly from root to tip, where the fraction `rest`
/// of both is left.
Blade linear_taper(double rest, int bodies, int elements) {
  Blade blade;
  blade.length = kLength;
  blade.bodies = bodies;
  blade.elements = elements;
  blade.sections = {{0.0, kLength},
                    {kMass, rest * kMass},
                    {kAxial, rest * kAxial},
                    {kStiffness, rest * kStiffness}};
  return blade;
}

Rotor rotor_of(const Blade& blade, int count = 1) {
  Rotor rotor = make_rotor(blade, count);
  rotor.hub.drive = SpinUp{4.0, 0.5};
  return rotor;
}

/// Returns the second and third derivative at s = 1 of the solution of ((1 - c s) w'')'' = lambda
/// (1 - c s) w that begins as s^first, by its power series. The series converges where c s < 1.
std::array<double, 2> series_end(double c, double lambda, int first) {
  std::vector<double> a(4, 0.0);
  a[static_cast<std::size_t>(first)] = 1.0;
  for (int n = 0; n < 400; ++n) {
    const auto k = static_cast<std::size_t>(n);
    const double before = n > 0 ? a[k - 1] : 0.0;
    a.push_back((c * (n + 3.0) * (n + 2.0) * (n + 2.0) * (n + 1.0) * a[k + 3] +
                 lambda * (a[k] - c * before)) /
                ((n + 4.0) * (n + 3.0) * (n + 2.0) * (n + 1.0)));
  }
  std::array<double, 2> derivatives{};
  for (std::size_t k = a.size(); k-- > 2;) {
    const auto n = static_cast<double>(k);
    derivatives[0] += n * (n - 1.0) * a[k];
    derivatives[1] += n * (n - 1.0) * (n - 2.0) * a[k];
  }
  return derivatives;
}

/// Returns the first frequencies of linear_taper(rest) [rad/s]. At the free end w'' = w''' = 0.
std::vector<double> linear_taper_frequencies(double rest) {
  const auto determinant = [&](double root_lambda) {
    const double lambda = root_lambda * root_lambda;
    const auto two = series_end(1.0 - rest, lambda, 2), three = series_end(1.0 - rest, lambda, 3);
    return two[0] * three[1] - three[0] * two[1];
  };
  const double unit = std::sqrt(kStiffness / kMass) / (kLength * kLength);
  std::vector<double> frequencies;
  double at = 0.5;
  for (int k = 0; k < 3; ++k) {
    at = find_next_root(determinant, at, 0.5);
    frequencies.push_back(at * unit);
    at += 1e-6;
  }
  return frequencies;
}

/// Returns w, w', w'' and w''' at z of a solution z^(-1/2) C_1(2 q sqrt(z)) of (z^3 w'')'' = q^4 z
/// w, where z w'' + 2 w' = sign q^2 w: J_1 and Y_1 have sign -1, I_1 and K_1 have 1.
std::array<double, 4> bessel_solution(double z, double q, double C_1, double C_2_signed,
                                      double sign) {
  const double w = C_1 / std::sqrt(z), slope = q * C_2_signed / z;
  const double second = (sign * q * q * w - 2.0 * slope) / z;
  return {w, slope, second, (sign * q * q * slope - 3.0 * second) / z};
}

/// Returns a determinant of the wedge that is clamped at z = 1 and ends at z = rest: zero at its
/// frequencies.
double wedge_determinant(double rest, double q) {
  const auto solutions = [q](double z) {
    const double x = 2.0 * q * std::sqrt(z);
    return std::array{
        bessel_solution(z, q, std::cyl_bessel_j(1, x), -std::cyl_bessel_j(2, x), -1.0),
        bessel_solution(z, q, std::cyl_neumann(1, x), -std::cyl_neumann(2, x), -1.0),
        bessel_solution(z, q, std::cyl_bessel_i(1, x), std::cyl_bessel_i(2, x), 1.0),
        bessel_solution(z, q, std::cyl_bessel_k(1, x), -std::cyl_bessel_k(2, x), 1.0)};
  };
  const auto root = solutions(1.0), tip = solutions(rest);
  Eigen::Matrix4d conditions;
  for (int k = 0; k < 4; ++k) conditions.col(k) << root[k][0], root[k][1], tip[k][2], tip[k][3];
  return conditions.determinant();
}

/// Makes the wedge: height and mass go linearly to `rest` at the tip, stiffness with the third
/// power, by `count` stations.
Blade wedge(double rest, int count) {
  Blade blade;
  blade.length = kLength;
  blade.bodies = 3;
  blade.elements = 5;
  for (int k = 0; k < count; ++k) {
    const double s = k / (count - 1.0), z = 1.0 - (1.0 - rest) * s;
    blade.sections.station.push_back(kLength * s);
    blade.sections.mass_per_length.push_back(kMass * z);
    blade.sections.axial_stiffness.push_back(kAxial * z);
    blade.sections.bending_stiffness.push_back(kStiffness * z * z * z);
  }
  return blade;
}

}  // namespace

TEST_CASE("a tip force bends a linear taper as the logarithmic closed form says") {
  constexpr double rest = 0.25, c = 1.0 - rest;
  // F L^3 / EI_0 int_0^1 (1 - s)^2 / (1 - c s) ds
  const double flexibility = kLength * kLength * kLength / kStiffness *
                             (0.5 - 2.0 * rest + 1.5 * rest * rest - rest * rest * std::log(rest)) /
                             (c * c * c);
  double before = 0.0;
  for (const int elements : {2, 4, 8, 16}) {
    const plane::FlexibleBody body =
        make_beam_body(plane::make_beam_properties(linear_taper(rest, 1, elements), 0));
    Eigen::VectorXd force = Eigen::VectorXd::Zero(body.bending());
    force[body.bending() - 2] = 1.0;
    const double deflection = body.K_bending.to_dense().ldlt().solve(force)[body.bending() - 2];
    const double error = std::abs(deflection / flexibility - 1.0);
    CAPTURE(elements);
    if (elements == 4) CHECK(error < 1e-3);
    if (elements > 4) CHECK(std::log2(before / error) > 3.5);
    before = error;
  }
  CHECK(before < 1e-5);
}

TEST_CASE("a simulation of a tapered cantilever comes to rest where the closed form says") {
  constexpr double rest = 0.25, c = 1.0 - rest;
  Scenario scenario;
  scenario.rotor = rotor_of(linear_taper(rest, 3, 4));
  scenario.rotor.hub.drive = SpeedTable{Curve(0.0)};
  scenario.rotor.damping.stiffness_factor = 0.3;
  PointLoad load;
  load.blade = BladeChoice::number(1);
  load.position = kLength;
  load.force = Position{0.0, 1e-3};
  load.factor = Curve({0.0, 1.0}, {0.0, 1.0});
  scenario.rotor.loads = {load};
  scenario.integration.step = 0.01;
  scenario.integration.duration = 12.0;
  Simulation simulation(scenario, {.executor = ExecutorKind::serial});
  simulation.run_until(12.0);
  const double expected = 1e-3 * kLength * kLength * kLength / kStiffness *
                          (0.5 - 2.0 * rest + 1.5 * rest * rest - rest * rest * std::log(rest)) /
                          (c * c * c);
  CHECK(simulation.sensor("blade1.tip.y") == approx(expected).epsilon(2e-5));
  // Moment and shear force in the middle of an element follow from strains, to 1 %.
  const Wrench section = simulation.section_force({0, 1, 0.4});
  const double arm = kLength * (1.0 - 1.4 / 3.0);
  CHECK(section.moment.z() == approx(1e-3 * arm).epsilon(0.01));
  CHECK(section.force.y() == approx(1e-3).epsilon(0.05));
}

TEST_CASE("frequencies of a linear taper are those of its power series, to fourth order") {
  for (const double rest : {0.3, 0.7}) {
    const std::vector<double> exact = linear_taper_frequencies(rest);
    for (int k = 0; k < 3; ++k) {
      CAPTURE(k);
      const auto error = [&](int bodies, int elements) {
        return natural_frequency(linear_taper(rest, bodies, elements), k + 1) / exact[k] - 1.0;
      };
      CHECK(std::abs(error(4, 4)) < (k == 2 ? 1e-4 : 1e-5));
      CHECK(std::log2(error(1, 4) / error(2, 4)) > 3.6);
      CHECK(error(1, 8) == approx(error(2, 4)).epsilon(1e-4));  // however it is cut
    }
  }
}

TEST_CASE("frequencies of a wedge are those of its Bessel functions") {
  constexpr double rest = 0.3;
  double q = 0.5;
  for (int number = 1; number <= 3; ++number) {
    q = find_next_root([](double at) { return wedge_determinant(rest, at); }, q + 1e-6, 0.1);
    // (z^3 w'')'' = q^4 z w, with z = 1 - (1 - rest) x/L.
    const double unit = kLength / (1.0 - rest);
    const double expected = q * q * std::sqrt(kStiffness / kMass) / (unit * unit);
    CAPTURE(number);
    CHECK(natural_frequency(wedge(rest, 301), number) == approx(expected).epsilon(1e-4));
  }
}

TEST_CASE("a table of constants is the uniform blade") {
  const Blade uniform = wu_haug_blade(3, 4);
  Blade table = uniform;
  table.density = table.area = table.second_moment = table.youngs_modulus = 0.0;
  const double rhoA = uniform.density * uniform.area, EA = uniform.youngs_modulus * uniform.area,
               EI = uniform.youngs_modulus * uniform.second_moment;
  // Stations within elements and at the ends of bodies.
  table.sections.station = {0.0, 1.0, uniform.length / 3, 3.3, uniform.length};
  table.sections.mass_per_length.assign(5, rhoA);
  table.sections.axial_stiffness.assign(5, EA);
  table.sections.bending_stiffness.assign(5, EI);
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord}) {
    Rotor one = rotor_of(uniform), other = rotor_of(table);
    one.blades[0].reference_frame = other.blades[0].reference_frame = frame;
    const System<Plane> a = make_system(one), b = make_system(other);
    const auto near = [](const auto& x, const auto& y) {
      return (x - y).template lpNorm<Eigen::Infinity>() <=
             1e-13 * x.template lpNorm<Eigen::Infinity>();
    };
    for (std::size_t j = 0; j < 3; ++j) {
      const plane::FlexibleBody &x = *a.subsystems[0].bodies[j].body,
                                &y = *b.subsystems[0].bodies[j].body;
      CHECK(x.mass == approx(y.mass).epsilon(1e-14));
      CHECK(x.I0 == approx(y.I0).epsilon(1e-14));
      CHECK(near(x.S0, y.S0));
      CHECK(near(x.S_axial, y.S_axial));
      CHECK(near(x.S_bending, y.S_bending));
      CHECK(near(x.d_axial, y.d_axial));
      CHECK(near(x.c_bending, y.c_bending));
      CHECK(near(x.M_axial.to_dense(), y.M_axial.to_dense()));
      CHECK(near(x.M_bending.to_dense(), y.M_bending.to_dense()));
      CHECK(near(x.K_axial.to_dense(), y.K_axial.to_dense()));
      CHECK(near(x.K_bending.to_dense(), y.K_bending.to_dense()));
      CHECK(near(x.H.rows, y.H.rows));
      CHECK(near(x.H.pairs, y.H.pairs));
      CHECK(near(a.subsystems[0].bodies[j].stiffening.centrifugal->to_dense(),
                 b.subsystems[0].bodies[j].stiffening.centrifugal->to_dense()));
    }
    CHECK(natural_frequency(one.blades[0], 2) == approx(natural_frequency(other.blades[0], 2)));
  }
}

TEST_CASE("bodies share constants if and only if they are equal") {
  Blade blade = linear_taper(1.0, 4, 3);
  const auto distinct = [](const Rotor& rotor) {
    std::vector<const plane::FlexibleBody*> bodies;
    for (const Subsystem<Plane>& subsystem : make_system(rotor).subsystems)
      for (const TreeBody<Plane>& member : subsystem.bodies) bodies.push_back(member.body.get());
    std::sort(bodies.begin(), bodies.end());
    return std::unique(bodies.begin(), bodies.end()) - bodies.begin();
  };
  CHECK(distinct(rotor_of(blade, 2)) == 1);
  CHECK(distinct(rotor_of(linear_taper(0.5, 4, 3), 2)) == 4);
  blade.point_masses = {{kLength, 0.1, 0.0}};
  CHECK(distinct(rotor_of(blade, 2)) == 2);
}

TEST_CASE("mass, first moment and inertia of tapered bodies are those of the polynomials") {
  const Blade blade = linear_taper(0.25, 3, 2);
  const System<Plane> system = make_system(rotor_of(blade));
  double mass = 0.0, moment = 0.0, inertia = 0.0;
  for (int j = 0; j < 3; ++j) {
    const plane::FlexibleBody& body =
        *system.subsystems[0].bodies[static_cast<std::size_t>(j)].body;
    const double x = j * body.length;
    mass += body.mass;
    moment += body.S0.x() + x * body.mass;
    inertia += body.I0 + 2.0 * x * body.S0.x() + x * x * body.mass;
  }
  const double L = kLength, c = 0.75;
  CHECK(mass == approx(kMass * L * (1.0 - c / 2)).epsilon(1e-13));
  CHECK(moment == approx(kMass * L * L * (1.0 / 2 - c / 3)).epsilon(1e-13));
  CHECK(inertia == approx(kMass * L * L * L * (1.0 / 3 - c / 4)).epsilon(1e-13));
}

TEST_CASE("a boundary between sections within an element is integrated exactly") {
  Blade blade = linear_taper(0.5, 1, 2);
  blade.sections = {{0.0, 0.37, 1.3, kLength},
                    {0.3, 0.1, 0.5, 0.2},
                    {4e6, 9e6, 1e6, 2e6},
                    {40.0, 10.0, 90.0, 20.0}};
  // Stations between the others, with the values that they have anyway, and elements that begin at
  // them: the integrals are equal, but cut otherwise.
  Blade finer = blade;
  BladeSections& sections = finer.sections;
  sections = {};
  for (int k = 0; k <= 200; ++k) sections.station.push_back(0.01 * k);
  sections.station.back() = kLength;
  const auto at = [&](const std::vector<double>& values, double x) {
    std::size_t i = 1;
    while (i + 1 < blade.sections.station.size() && blade.sections.station[i] < x) ++i;
    const double a = blade.sections.station[i - 1], b = blade.sections.station[i];
    return values[i - 1] + (values[i] - values[i - 1]) * (x - a) / (b - a);
  };
  for (const double x : sections.station) {
    sections.mass_per_length.push_back(at(blade.sections.mass_per_length, x));
    sections.axial_stiffness.push_back(at(blade.sections.axial_stiffness, x));
    sections.bending_stiffness.push_back(at(blade.sections.bending_stiffness, x));
  }
  const System<Plane> a = make_system(rotor_of(blade)), b = make_system(rotor_of(finer));
  const TreeBody<Plane>&x = a.subsystems[0].bodies[0], &y = b.subsystems[0].bodies[0];
  const auto near = [](const Eigen::MatrixXd& one, const Eigen::MatrixXd& other) {
    return (one - other).lpNorm<Eigen::Infinity>() <= 1e-12 * one.lpNorm<Eigen::Infinity>();
  };
  CHECK(near(x.body->M_bending.to_dense(), y.body->M_bending.to_dense()));
  CHECK(near(x.body->K_bending.to_dense(), y.body->K_bending.to_dense()));
  CHECK(near(x.body->M_axial.to_dense(), y.body->M_axial.to_dense()));
  CHECK(near(x.body->K_axial.to_dense(), y.body->K_axial.to_dense()));
  CHECK(near(x.body->H.rows, y.body->H.rows));
  CHECK(near(x.stiffening.centrifugal->to_dense(), y.stiffening.centrifugal->to_dense()));
}
