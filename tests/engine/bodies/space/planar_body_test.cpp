// Compares a straight body in space that moves in its plane with the body of the plane.

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "engine/bodies/kernels/space/dense_body.h"
#include "models/plane/beam_elements.h"
#include "tests/engine/bodies/space/bodies.h"

// Within the namespace: the plane's types have the same names.
namespace spoke::space::test {
namespace {

/// Returns the places of the planar coordinates (u, v, psi), axial before bending, among the
/// spatial ones.
std::vector<int> find_places(const plane::FlexibleBody& planar, const FlexibleBody& body) {
  std::vector<int> places(static_cast<std::size_t>(planar.coordinates()));
  for (int node = 0; node <= planar.elements; ++node)
    for (const auto& [c, spatial] : {std::pair{0, 0}, {1, 1}, {2, 5}})
      if (const int at = planar.coordinate(node, c); at >= 0)
        places[static_cast<std::size_t>(at)] = body.coordinate(node, spatial);
  return places;
}

SectionProperties make_section(double m, double EA, double EI) {
  SectionProperties section{m, EA, EI, 0.4 * EI, 0.0, 100.0};
  section.lag_inertia = section.flap_inertia = 1e-12;
  return section;
}

}  // namespace

TEST_CASE("a straight body that moves in its plane has the mass and forces of the planar body") {
  std::mt19937 random(26);
  const double m = 0.7, EA = 5e5, EI = 300.0, L = 2.0;
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord}) {
    const int E = 4;
    const plane::FlexibleBody planar = plane::make_beam_body({L, E, m, EA, EI, frame});
    SectionProperties section{m, EA, EI, 0.4 * EI, 0.0, 100.0};
    section.lag_inertia = section.flap_inertia = 1e-12;
    TestBody test(
        make_beam_body(make_uniform_beam(section, L), equal_stations(0.0, L, E), frame, {0, E}));
    test.model.tension = nullptr;
    const double w = 2.3;
    test.motion.w = {0.0, 0.0, w};
    const std::vector<int> places = find_places(planar, test.body);
    for (const int place : places) {
      test.q[place] = draw_vector(0.1, random).x();
      test.v[place] = draw_vector(1.0, random).x();
    }
    test.follow();
    test.calc_terms();
    Eigen::MatrixXd mass(dense_size(test.body), dense_size(test.body));
    Eigen::VectorXd force(dense_size(test.body));
    calc_dense_mass(test.body, test.terms, test.work,
                    make_dense_elastic_block(test.body, kExplicit), mass);
    calc_dense_force(test.body, test.terms, test.work, force);

    // The integrals are those of docs/formulation.md, section 2.
    const int n = planar.coordinates(), axial = planar.axial();
    const Eigen::VectorXd q = test.q(places), v = test.v(places);
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n, n), K = M, G = M, S = Eigen::MatrixXd::Zero(2, n);
    M.topLeftCorner(axial, axial) = planar.M_axial.to_dense();
    M.bottomRightCorner(n - axial, n - axial) = planar.M_bending.to_dense();
    K.topLeftCorner(axial, axial) = planar.K_axial.to_dense();
    K.bottomRightCorner(n - axial, n - axial) = planar.K_bending.to_dense();
    S.row(0).head(axial) = planar.S_axial.head(axial);
    S.row(1).tail(n - axial) = planar.S_bending;
    Eigen::VectorXd d0 = Eigen::VectorXd::Zero(n), c0 = d0;
    d0.head(axial) = planar.d_axial.head(axial);
    c0.tail(n - axial) = planar.c_bending;
    for (int i = 0; i < axial; ++i)
      for (int k = 0; k < plane::AxialBendingCoupling::kWidth; ++k) {
        const int column = 2 * i + planar.H.offset + k;
        if (column < 0 || column >= n - axial) continue;
        G(i, axial + column) = planar.H.rows[i * plane::AxialBendingCoupling::kWidth + k];
        G(axial + column, i) = -G(i, axial + column);
      }
    const Eigen::Vector2d first = planar.S0 + S * q, first_rate = S * v;
    const Eigen::Vector2d Q_t =
        w * w * first - 2.0 * w * Eigen::Vector2d(-first_rate.y(), first_rate.x());
    const Eigen::VectorXd Q_f = w * w * (d0 + M * q) + 2.0 * w * G * v - K * q;
    const double tolerance = 1e-9;
    CHECK((force.head<2>() - Q_t).norm() < tolerance * Q_t.norm());
    CHECK(force[5] == doctest::Approx(-2.0 * w * (d0 + M * q).dot(v)).epsilon(tolerance));
    std::vector<int> rows;
    for (const int place : places) rows.push_back(kTwist + place);
    CHECK((force(rows) - Q_f).norm() < tolerance * Q_f.norm());
    CHECK((mass(rows, rows) - M).norm() < tolerance * M.norm());
    CHECK((mass(std::vector{0, 1}, rows) - S).norm() < tolerance * S.norm());
    const Eigen::VectorXd c = c0 + G.transpose() * q;
    CHECK((mass(rows, std::vector{5}) - c).norm() < tolerance * c.norm());
    CHECK(mass(5, 5) == doctest::Approx(planar.I0 + (2.0 * d0 + M * q).dot(q)).epsilon(tolerance));
    CHECK((mass.block<1, 2>(5, 0) - Eigen::RowVector2d(-first.y(), first.x())).norm() < tolerance);
    // Nothing leads out of the plane.
    const double out = std::abs(force[2]) + std::abs(force[3]) + std::abs(force[4]);
    CHECK(out < 1e-9 * force.norm());
  }
}

TEST_CASE("tension stiffens a straight body in its plane as it does the planar body") {
  std::mt19937 random(28);
  const double m = 0.7, EA = 5e5, EI = 300.0, L = 2.0, distance = 1.3, outboard = 4.0, w0 = 3.0;
  const int E = 3;
  for (const double inertia : {0.0, 0.2}) {
    // A small mass within an element, one at a node and one at the tip.
    plane::BeamProperties planar_beam{L, E, m, EA, EI, ReferenceFrame::clamped};
    Beam beam = make_uniform_beam(make_section(m, EA, EI), L);
    double begin = 0.0;
    for (const double x : {0.5, 2.0 * L / E, L}) {
      planar_beam.pieces.push_back({begin, x, {m, m}, {EA, EA}, {EI, EI}});
      planar_beam.masses.push_back({x, 0.6, inertia});
      MassMoments moments{0.6, Position::Zero(), Matrix3::Zero()};
      // Along the axis an extent turns with the slope of the cubics, as in the plane; across it,
      // with axes that are linear between the nodes.
      moments.second(0, 0) = inertia;
      beam.masses.push_back({x, moments});
      begin = x;
    }
    const plane::FlexibleBody planar = plane::make_beam_body(planar_beam);
    TestBody test(make_beam_body(beam, equal_stations(0.0, L, E), ReferenceFrame::clamped, {0, E}));
    test.tension.origin = {distance, 0.0, 0.0};
    test.tension.carried = {{E, {outboard, 0.0, 0.0}, 0.0}};
    test.motion.hub_w = {0.0, 0.0, w0};
    const std::vector<int> places = find_places(planar, test.body);
    for (const int place : places) test.q[place] = draw_vector(0.1, random).x();
    Eigen::VectorXd force = test.deformation_force();
    const Matrix3 Lambda = test.terms.stiffening.inertia;
    test.model.tension = nullptr;
    force -= test.deformation_force();
    const Eigen::MatrixXd KG =
        plane::make_centrifugal_stiffness(planar_beam, distance, outboard).to_dense();
    const Eigen::VectorXd v = Eigen::VectorXd(test.q(places)).tail(planar.bending());
    const Eigen::VectorXd expected = -w0 * w0 * KG * v;
    const Eigen::VectorXd found = Eigen::VectorXd(force(places)).tail(planar.bending());
    CHECK((found - expected).norm() < 1e-11 * expected.norm());
    CHECK(Lambda(2, 2) == doctest::Approx(v.dot(KG * v)).epsilon(1e-11));
    // The mass matrices agree, too.
    const Eigen::MatrixXd M = make_dense_elastic_block(test.body, kExplicit)(places, places)
                                  .bottomRightCorner(planar.bending(), planar.bending());
    CHECK((M - planar.M_bending.to_dense()).norm() < 1e-9 * M.norm());
  }
}

}  // namespace spoke::space::test
