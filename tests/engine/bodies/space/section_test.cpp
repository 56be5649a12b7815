#include "engine/bodies/space/section.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>

#include "engine/bodies/kinds/beam/beam_energies.h"
#include "engine/bodies/kinds/beam/deformation_limits.h"
#include "tests/engine/bodies/space/bodies.h"
#include "tests/models/space/beam_equations.h"

namespace spoke::space::test {
namespace {

/// A clamped body of a random beam, bent by a wrench at its tip.
struct BentBody {
  Beam beam;
  TestBody test;
  Twist wrench;

  BentBody(int elements, std::mt19937& random)
      : beam(make_random_beam({true, true, false}, random)),
        test(make_beam_body(beam, make_unequal_stations(beam, elements, random),
                            ReferenceFrame::clamped, {0, elements})) {
    wrench = make_twist(draw_vector(3.0, random), draw_vector(2.0, random));
    Eigen::VectorXd force = Eigen::VectorXd::Zero(test.q.size());
    force.tail<kTwist>() = wrench;
    test.q = to_dense(test.body, test.body.K).ldlt().solve(force);
  }
};

}  // namespace

TEST_CASE("sections bear what stands in equilibrium with the wrench at the tip") {
  std::mt19937 random(41);
  BentBody bent(3, random);
  const FlexibleBody& body = bent.test.body;
  for (const double part : {0.0, 0.21, 0.6, 0.99}) {
    const double station = part * bent.beam.station.back();
    const Section section = make_section(bent.beam, body, station);
    const Position arm = body.nodes.back() - section.s0;
    const Rotation to_section = section.axes.inverse();
    const Twist expected = to_section * translate(arm, bent.wrench);
    const SectionLoad load = calc_section_load(body, section, bent.test.q.data());
    CHECK((load.resultants - expected).norm() < 1e-9 * expected.norm());
    const TwistMatrix compliance = bent.beam.section(station).compliance;
    CHECK((load.strains - compliance * expected).norm() < 1e-9 * load.strains.norm());
  }
}

TEST_CASE(
    "a section at a node moves as the node, and between as a rigid body does if that is one") {
  std::mt19937 random(42);
  for (const bool is_bent : {false, true}) {
    const Beam beam = make_random_beam({is_bent, true, false}, random);
    TestBody test(make_beam_body(beam, make_unequal_stations(beam, 3, random),
                                 ReferenceFrame::clamped, {0, 1, 3}));
    randomize_state(random, test);
    calc_handles(test.body, test.q.data(), test.v.data(), test.work.handles);
    for (std::size_t h = 0; h < 3; ++h) {
      const auto node = static_cast<std::size_t>(test.body.handles[h]);
      const Section section = make_section(beam, test.body, test.body.stations[node]);
      const HandleMotion found =
          calc_section_motion(test.body, section, test.q.data(), test.v.data());
      const HandleMotion& expected = test.work.handles[h];
      CHECK((found.s - expected.s).norm() < 1e-13);
      CHECK((found.twist() - expected.twist()).norm() < 1e-12);
      CHECK((found.turn.R.axes - expected.turn.R.axes).norm() < 1e-13);
    }
    // The outer elements are in a small rigid motion.
    const Position u(0.1, -0.2, 0.3), th(0.02, -0.04, 0.03);
    for (int node = 1; node <= 3; ++node)
      test.q.segment<kTwist>(kTwist * (node - 1))
          << u + cross(th, test.body.nodes[static_cast<std::size_t>(node)]),
          th;
    const double station = 0.5 * (test.body.stations[1] + test.body.stations[2]);
    const Section section = make_section(beam, test.body, station);
    const HandleMotion motion =
        calc_section_motion(test.body, section, test.q.data(), test.v.data());
    CHECK((motion.s - section.s0 - u - cross(th, section.s0)).norm() < 1e-13);
    CHECK((motion.turn.R.axes - exponential(th).axes).norm() < 1e-13);
  }
}

TEST_CASE("a wrench on a section has the power that its motion says") {
  std::mt19937 random(43);
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord}) {
    const Beam beam = make_random_beam({true, true, false}, random);
    TestBody test(make_beam_body(beam, make_unequal_stations(beam, 3, random), frame, {0, 3}));
    randomize_state(random, test);
    const Eigen::VectorXd before = test.deformation_force();
    const Twist Q = test.terms.Q;
    const Section section = make_section(beam, test.body, 0.43 * beam.station.back());
    const HandleMotion motion =
        calc_section_motion(test.body, section, test.q.data(), test.v.data());
    const Twist wrench = make_twist(draw_vector(3.0, random), draw_vector(2.0, random));
    test.calc_terms();
    add_section_wrench(section, motion, wrench, test.terms, test.work);
    const Twist frame_twist = make_twist(draw_vector(1.0, random), test.motion.w);
    const Twist section_twist =
        make_twist(linear(frame_twist) + cross(test.motion.w, motion.s), test.motion.w) +
        motion.twist();
    Eigen::VectorXd added(test.q.size());
    for (int k = 0; k < test.body.node_count(); ++k)
      for (int c = 0; c < kTwist; ++c)
        if (const int at = test.body.coordinate(k, c); at >= 0)
          added[at] = test.work.rows[kNodeRows * k + 4 * c + 3] - before[at];
    const double power = frame_twist.dot(test.terms.Q - Q) + added.dot(test.v);
    CHECK(power == doctest::Approx(wrench.dot(section_twist)).epsilon(1e-9));
  }
}

TEST_CASE("the tip of a bent cantilever moves inward by its foreshortening") {
  SectionProperties section{1.0, 1e8, 300.0, 300.0, 0.0, 200.0};
  section.lag_inertia = section.flap_inertia = 1e-3;
  const double L = 2.0;
  TestBody test(make_beam_body(make_uniform_beam(section, L), equal_stations(0.0, L, 4),
                               ReferenceFrame::clamped, {0, 4}));
  // v = a x^2 / 2 and w = b x^2 / 2: 1/2 int (a^2 + b^2) x^2 dx.
  const double a = 0.02, b = -0.03;
  for (int node = 1; node <= 4; ++node) {
    const double x = L * node / 4;
    test.q.segment<kTwist>(kTwist * (node - 1)) << 0.0, a * x * x / 2, b * x * x / 2, 0.0, -b * x,
        a * x;
  }
  CHECK(calc_foreshortening(test.model, test.q.data(), test.work) ==
        doctest::Approx((a * a + b * b) * L * L * L / 6.0).epsilon(1e-12));
  test.model.tension = nullptr;
  CHECK(calc_foreshortening(test.model, test.q.data(), test.work) == 0.0);
}

TEST_CASE("large and impossible deformations are found where they are") {
  SectionProperties section{1.0, 1e5, 300.0, 100.0, 0.0, 80.0};
  section.lag_inertia = section.flap_inertia = 1e-3;
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord}) {
    const FlexibleBody body =
        make_beam_body(make_uniform_beam(section, 2.0), equal_stations(0.0, 2.0, 4), frame, {0, 4});
    Eigen::VectorXd q = Eigen::VectorXd::Zero(body.coordinates());
    CHECK(find_largest_deflection(body, q.data()) == 0.0);
    CHECK(find_limit_violation(body, q.data()).node == -1);
    q[body.coordinate(2, 1)] = 0.3;
    q[body.coordinate(2, 2)] = -0.4;
    CHECK(find_largest_deflection(body, q.data()) == doctest::Approx(0.25));
    // An arch between nodes 1 and 2 alone: slopes 1 and -1 of the cubic over 0.5 m.
    q.setZero();
    q[body.coordinate(1, 4)] = -1.0;
    q[body.coordinate(2, 4)] = 1.0;
    CHECK(find_largest_deflection(body, q.data()) == doctest::Approx(0.125 * 0.5 * 2.0 / 2.0));
    q[body.coordinate(3, 5)] = 4.0;
    q[body.coordinate(4, 0)] = -9.0;
    const LimitViolation worst = find_limit_violation(body, q.data());
    CHECK(worst.node == 4);
    CHECK(worst.component == 0);
    CHECK(worst.value == -9.0);
    CHECK(worst.limit == 2.0);
    q[body.coordinate(1, 3)] = std::nan("");
    CHECK(find_limit_violation(body, q.data()).node == 1);
    CHECK(find_limit_violation(body, q.data()).component == 3);
  }
}

}  // namespace spoke::space::test
