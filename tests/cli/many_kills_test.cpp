#include <doctest/doctest.h>

#include "tests/cli/kill_chain.h"

TEST_CASE("runs killed 50 times and resumed have the results of the unbroken run") {
  check_kills(50);
}
