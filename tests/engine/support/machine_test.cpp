#include "engine/support/machine.h"

#include <doctest/doctest.h>

#include "engine/support/machine_json.h"
#include "graph/executor.h"

using namespace spoke;

TEST_CASE("capacity: a bound has as many threads as it was measured for, or fewer") {
  const Capacity capacity{4, 2.0, 2.5};
  CHECK(capacity.bound(10.0, 1.0, 4) == 10.0 / 2.5);
  CHECK(capacity.bound(10.0, 1.0, 2) == 5.0);
  CHECK(capacity.bound(10.0, 6.0, 4) == 6.0);
  CHECK(capacity.text() == "4 threads do 2.50 times the work of one here");
  CHECK(describe(capacity).dump() == R"({"threads":4,"before":2.0,"after":2.5})");
}

TEST_CASE("capacity: of one processor there is none") {
  CHECK_FALSE(Capacity{}.is_known());
  CHECK_FALSE(Capacity{1, 1.0, 1.0}.is_known());
  CHECK(describe(Capacity{1, 1.0, 1.0}).dump() == "null");
}

TEST_CASE("capacity: all processors do at most their number of times the work of one") {
  const Capacity capacity = measure_capacity();
  CHECK(capacity.threads == graph::available_threads());
  CHECK(capacity.before > 0.0);
  CHECK(capacity.before <= capacity.threads);
}
