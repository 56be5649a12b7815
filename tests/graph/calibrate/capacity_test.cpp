#include "graph/calibrate/capacity.h"

#include <doctest/doctest.h>

#include "graph/executor.h"

using namespace spoke::graph;

TEST_CASE("capacity: one thread does the work of one, several no more than their number") {
  CHECK(measure_capacity(1) == 1.0);
  const int threads = available_threads();
  const double capacity = measure_capacity(threads);
  CHECK(capacity > 0.0);
  CHECK(capacity <= threads);
}
