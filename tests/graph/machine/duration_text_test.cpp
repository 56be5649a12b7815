#include "graph/machine/duration_text.h"

#include <doctest/doctest.h>

using spoke::graph::duration_text;

TEST_CASE("times have three digits and the unit that suits them") {
  CHECK(duration_text(0.0) == "0 us");
  CHECK(duration_text(13.06e-6) == "13.1 us");
  CHECK(duration_text(2.04e-3) == "2.04 ms");
  CHECK(duration_text(7.5) == "7.5 s");
  CHECK(duration_text(12345.0) == "12345 s");
}
