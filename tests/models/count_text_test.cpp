#include "models/count_text.h"

#include <doctest/doctest.h>

using namespace spoke;

TEST_CASE("one is counted in the singular, all else in the plural") {
  CHECK(counted(1, "step") == "1 step");
  CHECK(counted(2, "step") == "2 steps");
  CHECK(counted(0, "step") == "0 steps");
  CHECK(counted(-1, "step") == "-1 steps");
  CHECK(counted(1, "body") == "1 body");
  CHECK(counted(12, "body") == "12 bodies");
  CHECK(counted(3, "way") == "3 ways");
  CHECK(counted(1, "pass") == "1 pass");
  CHECK(counted(31, "pass") == "31 passes");
  CHECK(counted(2, "untimed batch") == "2 untimed batches");
  CHECK(counted(5'000'000'000, "node") == "5000000000 nodes");
}

TEST_CASE("a range of indices never ends before it begins") {
  CHECK(range_text(0, 4) == "0 to 4");
  CHECK(range_text(0, 0) == "0");
  CHECK(range_text(0, -1) == "none");
}
