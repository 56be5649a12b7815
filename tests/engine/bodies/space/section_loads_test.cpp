#include "engine/bodies/space/section_loads.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "engine/bodies/space/section.h"
#include "tests/engine/bodies/space/bodies.h"

namespace spoke::space::test {
namespace {

/// A load at random sections all over a body, in no order.
struct LoadedBody {
  std::unique_ptr<TestBody> test;
  std::vector<Section> sections;
  std::vector<double> weights;
  std::vector<LoadedSections> loaded;

  LoadedBody(bool is_bent, ReferenceFrame frame, double size, std::mt19937& random) {
    const Beam beam = make_random_beam({is_bent, true, false}, random);
    test = std::make_unique<TestBody>(
        make_beam_body(beam, make_unequal_stations(beam, 3, random), frame, {0, 3}));
    randomize_state(random, *test);
    test->q *= size;
    std::uniform_real_distribution<double> draw(0.0, 1.0);
    for (int k = 0; k < 17; ++k) {
      sections.push_back(make_section(beam, test->body, draw(random) * beam.station.back()));
      weights.push_back(draw(random) - 0.3);
    }
    std::sort(sections.begin(), sections.begin() + 12,
              [](const Section& a, const Section& b) { return a.element < b.element; });
    loaded = make_loaded_sections(test->body, sections, weights);
  }
};

/// Effect of a load on a body, expected and found.
struct Effect {
  Eigen::VectorXd rows;
  Twist Q;
  double power = 0.0;
  Angular on_hub = Angular::Zero();
  Position force = Position::Zero();  ///< sum of the forces, in B
};

/// Adds to the terms by `add(tension)` and returns what was added.
template <class Add>
Effect find_effect(TestBody& test, bool has_tension, const Add& add) {
  test.calc_terms();
  const BodyTerms before = test.terms;
  const int count = kNodeRows * test.body.node_count();
  const Eigen::VectorXd rows = Eigen::Map<Eigen::VectorXd>(test.work.rows, count);
  Effect effect;
  if (has_tension) {
    AppliedTension tension(test.model, test.state(), test.work);
    add(&tension, effect);
    effect.on_hub = tension.add_to(test.terms);
  } else {
    add(nullptr, effect);
  }
  effect.rows = Eigen::Map<Eigen::VectorXd>(test.work.rows, count) - rows;
  effect.Q = test.terms.Q - before.Q;
  effect.power = test.terms.load_power - before.load_power;
  return effect;
}

/// Returns the expected effect, one section after another.
Effect find_expected(LoadedBody& body, const LoadInstant& load, const Twist& twist,
                     bool has_tension, const Rotation& turn) {
  TestBody& test = *body.test;
  return find_effect(test, has_tension, [&](AppliedTension* tension, Effect& effect) {
    for (std::size_t k = 0; k < body.sections.size(); ++k) {
      const Section& section = body.sections[k];
      const HandleMotion motion =
          calc_section_motion(test.body, section, test.q.data(), test.v.data());
      Twist wrench = body.weights[k] * load.wrench;
      if (load.follows) wrench = motion.turn.R * (section.axes * wrench);
      add_section_wrench(section, motion, wrench, test.terms, test.work);
      test.terms.load_power += wrench.dot(motion.carry(twist) + motion.twist());
      if (tension) tension->add_at(section, turn * Position(linear(wrench)));
      effect.force += linear(wrench);
    }
  });
}

Effect find_found(LoadedBody& body, const LoadInstant& load, const Twist& twist, bool has_tension,
                  const Rotation& turn) {
  TestBody& test = *body.test;
  return find_effect(test, has_tension, [&](AppliedTension* tension, Effect& effect) {
    add_load(test.body, body.loaded, load, test.state(), twist, tension, turn, test.terms,
             test.work);
    effect.force = sum_load_forces(test.body, body.loaded, load, test.q.data());
  });
}

void compare(const Effect& found, const Effect& expected) {
  CHECK((found.rows - expected.rows).norm() < 1e-11 * expected.rows.norm());
  CHECK((found.Q - expected.Q).norm() < 1e-11 * expected.Q.norm());
  CHECK((found.force - expected.force).norm() < 1e-12 * expected.force.norm() + 1e-15);
  CHECK((found.on_hub - expected.on_hub).norm() <= 1e-11 * expected.on_hub.norm());
  CHECK(found.power == doctest::Approx(expected.power).epsilon(1e-10));
}

}  // namespace

TEST_CASE("a load does to sections side by side what its wrenches do to each of them") {
  std::mt19937 random(71);
  for (const bool is_bent : {false, true})
    for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
      for (const double size : {1.0, 25.0}) {  // sections turn by less than a radian, and by more
        LoadedBody body(is_bent, frame, size, random);
        REQUIRE(body.test->body.is_straight == !is_bent);
        const Twist twist = make_twist(draw_vector(2.0, random), draw_vector(3.0, random));
        const Rotation turn = exponential(draw_vector(1.0, random));
        for (const bool follows : {false, true})
          for (const bool has_moment : {false, true})
            for (const bool has_tension : {false, true}) {
              CAPTURE(is_bent);
              CAPTURE(size);
              CAPTURE(follows);
              CAPTURE(has_moment);
              CAPTURE(has_tension);
              LoadInstant load{follows, make_twist(draw_vector(3.0, random), Angular::Zero())};
              if (has_moment) angular(load.wrench) = draw_vector(2.0, random);
              compare(find_found(body, load, twist, has_tension, turn),
                      find_expected(body, load, twist, has_tension, turn));
            }
      }
}

}  // namespace spoke::space::test
