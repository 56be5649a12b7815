#include "program/report/scale.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "tests/approx.h"

using namespace spoke::report;

namespace {

using Values = std::vector<double>;
using spoke::testing::approx;

std::string labels_of(const Scale& scale) {
  std::string text;
  for (const Tick& tick : scale.ticks()) text += (text.empty() ? "" : " ") + tick.label;
  return text;
}

Range range(double low, double high) {
  Range values;
  values.add(low);
  values.add(high);
  return values;
}

void check_equal(const Values& ticks, const Values& expected) {
  REQUIRE(ticks.size() == expected.size());
  for (std::size_t k = 0; k < ticks.size(); ++k)
    CHECK(std::abs(ticks[k] - expected[k]) < 1e-12 * std::abs(expected.back()));
}

}  // namespace

TEST_CASE("ticks stand at round numbers") {
  check_equal(round_ticks(0.0, 1.0, 6), {0.0, 0.2, 0.4, 0.6, 0.8, 1.0});
  check_equal(round_ticks(0.3, 1.9, 5), {0.5, 1.0, 1.5});
  check_equal(round_ticks(-7.0, 12.0, 5), {-5.0, 0.0, 5.0, 10.0});
  check_equal(round_ticks(1.01e-6, 1.99e-6, 3), {1.5e-6});
}

TEST_CASE("logarithmic ticks are 1 2 5 or powers of ten") {
  check_equal(log_ticks(1.0, 20.0, 8), {1.0, 2.0, 5.0, 10.0, 20.0});
  check_equal(log_ticks(0.01, 1e4, 8), {0.01, 0.1, 1.0, 10.0, 100.0, 1000.0, 10000.0});
  CHECK(log_ticks(1e-30, 1e30, 7).size() <= 8);
}

TEST_CASE("there is always a tick, and never too many") {
  for (const double low : {-1e6, -3.0, 0.0, 1e-9, 0.7, 123.0})
    for (const double width : {1e-6, 0.33, 1.0, 7.0, 1e4})
      for (const int most : {3, 5, 8}) {
        CAPTURE(low);
        CAPTURE(width);
        CAPTURE(most);
        const Scale scale({}, range(low, low + width), 0.0, 100.0, most);
        CHECK(scale.ticks().size() >= 2);
        CHECK(scale.ticks().size() <= static_cast<std::size_t>(most + 2));
        CHECK(scale.low() <= low + 1e-9 * width);
        CHECK(scale.high() >= low + width * (1.0 - 1e-9));
      }
}

TEST_CASE("labels have the decimals they need") {
  CHECK(labels_of(Scale({}, range(0.0, 1.9), 0.0, 1.0, 5)) == "0.0 0.5 1.0 1.5 2.0");
  CHECK(labels_of(Scale({}, range(0.0, 1900.0), 0.0, 1.0, 5)) == "0 500 1000 1500 2000");
  CHECK(labels_of(Scale({.kind = ScaleKind::log}, range(0.02, 3.0), 0.0, 1.0, 8)) ==
        "0.02 0.05 0.1 0.2 0.5 1 2 5");
  CHECK(labels_of(Scale({.ticks = {1, 2, 4, 8, 16}}, range(1.0, 8.0), 0.0, 1.0)) == "1 2 4 8");
}

TEST_CASE("nearly constant values have labels that are short, differ and hold them") {
  for (const double size : {1.27, 0.00123456, 84.1871, 5e6, 3.3e-7, 2e11})
    for (const double sign : {1.0, -1.0})
      for (const double spread : {0.0, 1e-15, 4e-8, 1e-5}) {
        CAPTURE(size);
        CAPTURE(spread);
        const double value = sign * size;
        const Scale scale({}, range(value - spread * size, value + spread * size), 0.0, 1.0);
        CHECK(scale.low() < value - spread * size);
        CHECK(scale.high() > value + spread * size);
        CHECK(scale.high() - scale.low() < 1e-3 * size);
        REQUIRE(scale.ticks().size() >= 2);
        for (std::size_t k = 0; k < scale.ticks().size(); ++k) {
          const Tick& tick = scale.ticks()[k];
          CHECK(std::stod(tick.label) == approx(tick.value).epsilon(1e-5));
          CHECK(tick.label.size() <= 12);
          if (k > 0) CHECK(tick.label != scale.ticks()[k - 1].label);
        }
      }
  CHECK(labels_of(Scale({}, range(1.27, 1.27), 0.0, 1.0)) ==
        "1.26990 1.26995 1.27000 1.27005 1.27010");
  CHECK(labels_of(Scale({.low = 0.0}, range(5.0, 5.0), 0.0, 1.0)) == "0 1 2 3 4 5");
}

TEST_CASE("a scale maps its ends and clamps what is beyond") {
  const Scale linear({.low = 0.0, .high = 10.0}, {}, 100.0, 200.0);
  CHECK(linear.position(0.0) == 100.0);
  CHECK(linear.position(5.0) == approx(150.0));
  CHECK(linear.position(99.0) == 200.0);
  CHECK(linear.position(-99.0) == 100.0);
  const Scale log({.kind = ScaleKind::log, .low = 1.0, .high = 100.0}, {}, 300.0, 100.0);
  CHECK(log.position(10.0) == approx(200.0));
  CHECK(log.position(100.0) == approx(100.0));
}

TEST_CASE("a scale without values or of a single one has a length") {
  for (const ScaleKind kind : {ScaleKind::linear, ScaleKind::log}) {
    const Scale empty({.kind = kind}, {}, 0.0, 1.0);
    CHECK(empty.high() > empty.low());
    CHECK(empty.ticks().size() >= 2);
    const Scale single({.kind = kind}, range(3.0, 3.0), 0.0, 1.0);
    CHECK(single.high() > single.low());
    CHECK(single.shows(3.0));
  }
  const Scale zero({}, range(0.0, 0.0), 0.0, 1.0);
  CHECK(zero.high() > 0.0);
}

TEST_CASE("an axis is logarithmic where a linear one would flatten the small values") {
  CHECK(scale_for(range(7.0, 172.0)) == ScaleKind::log);
  CHECK(scale_for(range(7.0, 17.0)) == ScaleKind::linear);
  CHECK(scale_for(range(0.0, 172.0)) == ScaleKind::linear);
  CHECK(scale_for(range(-1.0, 172.0)) == ScaleKind::linear);
  CHECK(scale_for({}) == ScaleKind::linear);
}

TEST_CASE("what an axis cannot show") {
  const Scale log({.kind = ScaleKind::log}, range(1.0, 10.0), 0.0, 1.0);
  CHECK_FALSE(log.shows(0.0));
  CHECK_FALSE(log.shows(-1.0));
  CHECK_FALSE(log.shows(std::nan("")));
  CHECK(log.shows(1e-9));
  Range values;
  values.add(std::nan(""));
  values.add(INFINITY);
  CHECK_FALSE(values.low);
}

TEST_CASE("an axis is titled with its unit") {
  CHECK(title_of({.title = "time", .unit = "s"}) == "time [s]");
  CHECK(title_of({.title = "speedup"}) == "speedup");
}
