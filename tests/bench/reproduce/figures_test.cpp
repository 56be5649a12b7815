#include "bench/reproduce/figures.h"

#include <doctest/doctest.h>

#include <cmath>

#include "models/paper_rotor.h"
#include "tests/approx.h"

using namespace spoke;
using namespace spoke::reproduce;
using spoke::testing::approx;

TEST_CASE("the built-in rotor is the paper's") {
  const Scenario scenario = paper_rotor({"blade.elements=2"});
  REQUIRE(scenario.rotor.blades.size() == 3);
  CHECK(scenario.rotor.blades[0].bodies == 4);
  CHECK(scenario.rotor.blades[0].elements == 2);
  CHECK(scenario.integration.duration == 20.0);
}

TEST_CASE("the drive begins and ends at rest of acceleration, and its derivatives agree") {
  const auto points = sample_drive(paper_rotor().rotor.hub.drive, 20.0, 2000);
  REQUIRE(points.size() == 2001);
  CHECK(points.front().motion.speed == 0.0);
  CHECK(points.back().motion.angle == approx(50.0));
  CHECK(points.back().motion.speed == approx(4.0));
  const double h = points[1].t;
  for (std::size_t k = 1; k + 1 < points.size(); ++k) {
    const auto rate = [&](auto of) {
      return (of(points[k + 1].motion) - of(points[k - 1].motion)) / (2.0 * h);
    };
    CHECK(std::abs(rate([](const DriveMotion& m) { return m.angle; }) - points[k].motion.speed) <
          1e-4);
    CHECK(std::abs(rate([](const DriveMotion& m) { return m.speed; }) -
                   points[k].motion.acceleration) < 1e-3);
  }
}

TEST_CASE("deflections are those of the references") {
  const Deflection paper = simulate_deflection("paper", paper_rotor(), 0.01);
  CHECK(paper.lag == approx(-0.5558675).epsilon(1e-4));
  CHECK(paper.points.size() == 401);
  const Deflection stiffened =
      simulate_deflection("stiffened", paper_rotor({"blade.geometric_stiffening=true"}), 0.01);
  CHECK(stiffened.lag == approx(exact::kLag).epsilon(1e-4));
  CHECK(std::abs(stiffened.lag_time - exact::kLagTime) < 0.02);
  CHECK(stiffened.residual == approx(exact::kResidual).epsilon(0.01));
  for (const auto& point : exact::points()) {
    CAPTURE(point.t);
    const auto at = static_cast<std::size_t>(std::lround(point.t / 0.05));
    CHECK(std::abs(stiffened.points[at].y - point.y) < 1e-4);
  }
}
