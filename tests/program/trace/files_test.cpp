#include "program/trace/files.h"

#include <doctest/doctest.h>

#include <string>

using namespace spoke::trace;

TEST_CASE("a trace of more than a million slices is remarked on") {
  CHECK(remark_on_size(1'000'000).empty());
  const std::string remark = remark_on_size(1'000'001);
  CHECK(remark.starts_with("1000001 slices: "));
  CHECK(remark.find('\n') == std::string::npos);
}
