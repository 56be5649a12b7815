// Torque of generators by their speed against closed forms and against the smooth curve of a drive.

#include "program/foreign/generator_curve.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "models/curve.h"

using namespace spoke;
using foreign::InductionGenerator;
using foreign::TheveninGenerator;
using foreign::TorqueCurve;
using foreign::VariableSpeed;

namespace {

/// Returns the largest difference of the curve through the points from a law, over speeds.
template <class Law>
double find_difference(const TorqueCurve& points, double from, double to, const Law& law) {
  const Curve curve(points.speed, points.torque);
  constexpr int count = 5000;
  double largest = 0.0;
  for (int i = 0; i <= count; ++i) {
    const double w = from + (to - from) * i / count;
    largest = std::max(largest, std::abs(curve.value(w) - law(w)));
  }
  return largest;
}

}  // namespace

TEST_CASE("variable speed brakes by the square of the speed, by a line, and by a constant") {
  const double rated_torque = 43093.55, rated_speed = 122.9096;
  for (const double slip : {0.0, 0.02, 0.1}) {
    for (const double share : {0.0, 0.5, 0.9, 1.0}) {
      CAPTURE(slip);
      CAPTURE(share);
      const VariableSpeed law{rated_speed, rated_torque,
                              share * rated_torque / (rated_speed * rated_speed), slip};
      const double from = law.transition();
      CHECK(from <= rated_speed);
      if (slip > 0.0) {  // both branches meet there
        const double synchronous = rated_speed / (1.0 + slip);
        const double line = rated_torque * (from - synchronous) / (rated_speed - synchronous);
        CHECK(law.square * from * from == doctest::Approx(line).epsilon(1e-9));
      }
      CHECK(law.torque_at(0.5 * from) == doctest::Approx(0.25 * law.square * from * from));
      CHECK(law.torque_at(1.5 * rated_speed) == rated_torque);
      // Where there is a step, the curve goes there within a hundredth of a piece.
      const double end = slip > 0.0 ? 1.2 * rated_speed : 0.999 * rated_speed;
      CHECK(find_difference(law.points(), 0.0, end, [&](double w) { return law.torque_at(w); }) <
            2e-3 * rated_torque);
      const Curve curve(law.points().speed, law.points().torque);
      CHECK(curve.value(1.001 * rated_speed) == doctest::Approx(rated_torque));
    }
  }
}

TEST_CASE("an induction generator brakes above its synchronous speed and drives below") {
  const InductionGenerator generator{60.0, 5000.0, 0.015, 2.0};
  const auto law = [](double w) {
    const double slip = (w - 60.0) / (0.015 * 60.0);
    return 5000.0 * std::clamp(slip, -2.0, 2.0);
  };
  CHECK(find_difference(generator.points(), 50.0, 70.0, law) < 1e-2 * 5000.0);
  const Curve curve(generator.points().speed, generator.points().torque);
  for (const double slip : {-1.5, -1.0, 0.0, 0.5, 1.0, 1.9})
    CHECK(curve.value(60.0 + 0.9 * slip) == doctest::Approx(5000.0 * slip));
}

TEST_CASE("a generator after Thevenin has the power of its circuit") {
  const TheveninGenerator generator{50.0, 10, 0.02, 0.03, 690.0, 0.1, 0.12, 5.0};
  const double synchronous = 2.0 * std::numbers::pi * 50.0 / 5.0;
  // Kloss: with no stator resistance and next to no magnetizing current the torque is
  // 2 T_max/(s/s_k + s_k/s), s_k = R2/(X1 + X2), T_max = U^2/(2 w_s (X1 + X2)).
  TheveninGenerator plain = generator;
  plain.stator_resistance = 1e-12;
  plain.magnetizing_reactance = 1e9;
  const double bend = 0.03 / 0.22, most = 690.0 * 690.0 / (2.0 * synchronous * 0.22);
  for (const double slip : {0.01, 0.05, bend, 0.4}) {
    const double expected = 2.0 * most / (slip / bend + bend / slip);
    CHECK(plain.torque_at(synchronous * (1.0 + slip)) == doctest::Approx(expected));
    CHECK(plain.torque_at(synchronous * (1.0 - slip)) == doctest::Approx(-expected));
  }
  CHECK(generator.torque_at(synchronous) == 0.0);
  CHECK(generator.torque_at(1.02 * synchronous) > 0.0);
  CHECK(find_difference(generator.points(), 0.1 * synchronous, 1.9 * synchronous,
                        [&](double w) { return generator.torque_at(w); }) < 2e-3 * most);
}
