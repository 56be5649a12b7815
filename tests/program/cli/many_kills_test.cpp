#include <doctest/doctest.h>

#include "tests/program/cli/kill_chain.h"
#include "tests/program/cli/study_folder.h"

TEST_CASE("runs killed 50 times and resumed have the results of the unbroken run") {
  check_kills(50);
}

TEST_CASE("studies killed 20 times and resumed have the bytes of the unbroken one") {
  check_study_kills(20);
}
