#include "program/run_report/base64.h"

#include <doctest/doctest.h>

#include <vector>

using spoke::run_report::encode;

TEST_CASE("numbers are encoded least significant byte first, with padding") {
  CHECK(encode(std::vector<float>{}).empty());
  CHECK(encode(std::vector<float>{1.0F}) == "AACAPw==");  // 00 00 80 3f
  CHECK(encode(std::vector<float>{1.0F, -2.0F, 0.5F}) == "AACAPwAAAMAAAAA/");
  CHECK(encode(std::vector<std::int16_t>{-1}) == "//8=");
  CHECK(encode(std::vector<std::int16_t>{258, 0, 1}) == "AgEAAAEA");
}
