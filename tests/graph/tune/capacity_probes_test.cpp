#include "graph/tune/capacity_probes.h"

#include <doctest/doctest.h>

#include "tests/approx.h"

using spoke::graph::CapacityProbes;
using spoke::graph::kTuningShare;
using spoke::testing::approx;

TEST_CASE("capacity probes: pauses become longer, but for a passing disturbance") {
  CapacityProbes probes(2, 1000.0);
  CHECK(probes.pause_left(0.0) <= 0.0);
  probes.begin_pause(1.0, false);
  CHECK(probes.pause_left(1.0) == approx(5e-3));
  CHECK(probes.pause_left(1.004) == approx(1e-3));
  probes.begin_pause(2.0, false);
  CHECK(probes.pause_left(2.0) == approx(15e-3));
  probes.begin_pause(3.0, true);
  CHECK(probes.pause_left(3.0) == approx(5e-3));
  probes.begin_pause(4.0, false);
  CHECK(probes.pause_left(4.0) == approx(15e-3));
}

TEST_CASE("capacity probes: a short run pays for two, a longer one for more") {
  for (const double seconds : {0.05, 10.0}) {
    CapacityProbes probes(1, seconds);  // one thread: never worth it
    CHECK_FALSE(probes.find_worth(0.0));
    CHECK(probes.pause_left(0.0) == approx(5e-3));
    CHECK_FALSE(probes.find_worth(0.0));
    const bool is_paid = seconds * kTuningShare > 0.1;
    CHECK(is_paid == (probes.pause_left(0.0) < 16e-3));
  }
}

TEST_CASE("capacity probes: where threads are worth nothing a pause begins") {
  CapacityProbes probes(2, 1000.0);
  const bool are_worth = probes.find_worth(5.0);
  CHECK(are_worth == (probes.pause_left(5.0) <= 0.0));
  CHECK(probes.describe().rfind("2 threads do ", 0) == 0);
}
