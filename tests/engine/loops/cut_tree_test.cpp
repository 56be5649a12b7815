// A tree that is cut and closed again moves as the whole one.

#include <doctest/doctest.h>

#include <random>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/samples.h"
#include "tests/engine/bodies/space/system/random_model.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/loops/mechanisms.h"

using namespace spoke;
using namespace spoke::test;
using spatial::testing::RandomHub;

namespace {

/// Largest distance of the places of bodies and of the axes of their frames.
double compare(Run<Space>& a, Run<Space>& b) {
  double most = (a.context.data.hub.p - b.context.data.hub.p).norm();
  for (std::size_t i = 0; i < a.context.data.subsystems.size(); ++i) {
    auto& x = a.context.data.subsystems[i];
    auto& y = b.context.data.subsystems[i];
    update_kinematics(a.context.system.subsystems[i], x);
    update_kinematics(b.context.system.subsystems[i], y);
    calc_poses(a.context.system.subsystems[i], x, x.poses);
    calc_poses(b.context.system.subsystems[i], y, y.poses);
    REQUIRE(x.poses.size() == y.poses.size());
    for (std::size_t j = 0; j < x.poses.size(); ++j) {
      most = std::max(most, (x.poses[j].p - y.poses[j].p).norm());
      most = std::max(most, (x.poses[j].R.axes - y.poses[j].R.axes).norm());
    }
  }
  return most;
}

}  // namespace

TEST_CASE("a random tree cut and closed again moves as the whole one") {
  int loops = 0;
  for (const RandomHub hub :
       {RandomHub::fixed, RandomHub::driven, RandomHub::torque, RandomHub::free})
    for (unsigned seed = 1; seed <= 4; ++seed) {
      CAPTURE(static_cast<int>(hub));
      CAPTURE(seed);
      std::mt19937 random(seed);
      const spatial::Model tree = spatial::testing::make_random_model(hub, random);
      const spatial::Model closed = cut(tree, random);
      for (const Method& method : {Method(make_generalized_alpha(0.8, 1e-4)), Method(Rk4{1e-4})}) {
        Run<Space> whole(make_system(tree), {method});
        Run<Space> cut_run(make_system(closed), {method});
        for (const auto& subsystem : cut_run.context.system.subsystems)
          loops += static_cast<int>(subsystem.loops.size());
        whole.advance(100);
        cut_run.advance(100);
        CAPTURE(method.index());
        CHECK(compare(whole, cut_run) < 1e-9);
      }
    }
  CHECK(loops > 30);
}
