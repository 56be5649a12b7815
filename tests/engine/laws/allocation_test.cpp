// No step of any model allocates memory.

#include <doctest/doctest.h>

#include "tests/engine/counted_allocations.h"
#include "tests/engine/laws/zoo.h"

using namespace spoke;
using namespace spoke::test;

TEST_CASE("no step of any model allocates memory") {
  constexpr int kSteps = 8;
  for (const ZooModel& model : list_zoo()) {
    CAPTURE(model.name);
    const SimulationOptions options{Formulation::structured, ExecutorKind::serial, 1};
    CHECK(allocations_of_steps(model.read(3 + kSteps), options, kSteps) == 0);
  }
}
