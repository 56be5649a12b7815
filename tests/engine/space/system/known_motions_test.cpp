// Motions whose course is known: a top, and a beam that vibrates while it turns.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/engine/space/system/models.h"
#include "tests/engine/space/system/runs.h"

using namespace spoke;
using namespace spoke::test;

namespace {

// By a general solver of order 8 to 1e-8.
const Eigen::Vector3d kCentreAt1{0.17334396, 0.64008859, -0.74849079};

double top_error(const Method& method) {
  Run<Space> run(make_system(*read_model("heavy_top.toml").space), {method});
  run.advance_for(1.0);
  const space::Position centre =
      space::Position(run.sample(0).tip) + run.context.system.subsystems[0].tip;
  return (centre - space::Position(kCentreAt1)).norm();
}

}  // namespace

TEST_CASE("a heavy top moves as it should") {
  const double whole = top_error(Rk4{1e-3}), half = top_error(Rk4{5e-4});
  CHECK(half < 1e-5);
  CHECK(whole / half > 13.0);
  const double alpha = top_error(make_generalized_alpha(1.0, 1e-3));
  const double alpha_half = top_error(make_generalized_alpha(1.0, 5e-4));
  CHECK(alpha_half < 0.1);
  CHECK(alpha / alpha_half > 3.5);
}
