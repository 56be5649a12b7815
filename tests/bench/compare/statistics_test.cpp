#include "bench/compare/statistics.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/approx.h"

using namespace spoke::compare;

using Values = std::vector<double>;
using spoke::testing::approx;

TEST_CASE("mean, median and quantiles") {
  const Values values{4.0, 1.0, 3.0, 2.0};
  CHECK(mean(values) == 2.5);
  CHECK(median(values) == 2.5);
  CHECK(quantile(values, 0.0) == 1.0);
  CHECK(quantile(values, 0.25) == approx(1.75));
  CHECK(quantile(values, 1.0) == 4.0);
  CHECK(median(Values{7.0}) == 7.0);
  CHECK(median(Values{3.0, 1.0, 100.0}) == 3.0);
}

TEST_CASE("quartiles are of all values, and say how many") {
  const Quartiles quartiles = quartiles_of(Values{5.0, 1.0, 3.0, 2.0, 4.0});
  CHECK(quartiles.low == 2.0);
  CHECK(quartiles.median == 3.0);
  CHECK(quartiles.high == 4.0);
  CHECK(quartiles.rounds == 5);
}

TEST_CASE("the standard deviation is that of a sample") {
  CHECK(*standard_deviation(Values{2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0}) ==
        approx(std::sqrt(32.0 / 7.0)));
  CHECK_FALSE(standard_deviation(Values{1.0}));
}

TEST_CASE("ratios reach as far as both") {
  CHECK(ratios(Values{4.0, 9.0, 1.0}, Values{2.0, 3.0}) == Values{2.0, 3.0});
  CHECK(ratios(Values{}, Values{2.0}).empty());
}
