#include <doctest/doctest.h>

#include "tests/program/cli/rank_kills.h"

TEST_CASE("a study whose ranks are killed 20 times ends in the bytes of one process") {
  check_rank_kills(20, 600);
}
