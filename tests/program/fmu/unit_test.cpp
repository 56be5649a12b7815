#include "program/fmu/unit.h"

#include <doctest/doctest.h>

#include <string>

using spoke::fmu::parse_unit;
using spoke::fmu::Unit;

TEST_CASE("units are products of powers of kg, m, s and rad") {
  const auto is = [](const char* text, int kg, int m, int s, int rad) {
    CAPTURE(text);
    CHECK(parse_unit(text) == Unit{{kg, m, s, rad}});
  };
  is("1", 0, 0, 0, 0);
  is("m", 0, 1, 0, 0);
  is("rad/s^2", 0, 0, -2, 1);
  is("N m", 1, 2, -2, 0);
  is("N m/rad", 1, 2, -2, -1);
  is("kg m^2/s", 1, 2, -1, 0);
  is("Pa", 1, -1, -2, 0);
  is("N s^2/m^2", 1, -1, 0, 0);
  is("J", 1, 2, -2, 0);
  CHECK(!parse_unit("furlong"));
  CHECK(!parse_unit("m^"));
  CHECK(!parse_unit("m^2x"));
}
