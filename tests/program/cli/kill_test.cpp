#include <doctest/doctest.h>

#include "tests/program/cli/kill_chain.h"

TEST_CASE("runs killed a few times and resumed have the results of the unbroken run") {
  check_kills(6);
}
