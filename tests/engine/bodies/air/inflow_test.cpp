// Filters of inflow: closed forms, order of convergence, and rates in all states of a rotor.

#include "engine/bodies/air/inflow.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <numbers>

#include "tests/approx.h"

using namespace spoke;
using spoke::testing::approx;

TEST_CASE("inflow: a step of the steady value is Oye's response, however time is divided") {
  constexpr double rate = 0.4, ratio = 0.25;
  constexpr double slow = 1.0 / rate, fast = ratio / rate;
  // w_int = 1 - (1 - k) exp(-t / slow), w + fast w' = w_int, w(0) = 0, of which the solution is:
  const auto closed = [&](double t) {
    return 1.0 - std::exp(-t / fast) -
           0.4 * slow / (slow - fast) * (std::exp(-t / slow) - std::exp(-t / fast));
  };
  for (const int steps : {1, 3, 50}) {
    air::InflowState state = air::rest_inflow(0.0);
    constexpr double end = 3.0;
    for (int k = 1; k <= steps; ++k) {
      state = air::advance_inflow(state, 1.0, 1.0, rate * end / steps, ratio);
      CHECK(state.induced == approx(closed(end * k / steps)));
      CHECK(state.own == approx(0.4 * (1.0 - std::exp(-end * k / steps / slow))));
    }
  }
}

TEST_CASE("inflow: a steady value that grows linearly is followed exactly") {
  constexpr double rate = 2.0, ratio = 0.3;
  air::InflowState once = air::rest_inflow(1.0), often = once;
  once = air::advance_inflow(once, 1.0, 3.0, rate, ratio);
  constexpr int steps = 64;
  for (int k = 0; k < steps; ++k)
    often = air::advance_inflow(often, 1.0 + 2.0 * k / steps, 1.0 + 2.0 * (k + 1) / steps,
                                rate / steps, ratio);
  CHECK(once.induced == approx(often.induced));
  CHECK(once.own == approx(often.own));
  // After long it lags by a constant time, (1 - k) / rate + ratio / rate.
  air::InflowState late = air::rest_inflow(0.0);
  late = air::advance_inflow(late, 0.0, 100.0, rate * 100.0, ratio);
  CHECK(late.induced == approx(100.0 - (0.4 + ratio) / rate));
}

TEST_CASE("inflow: equilibrium stays, and is reached") {
  const air::InflowState rest = air::rest_inflow(4.0);
  const air::InflowState stayed = air::advance_inflow(rest, 4.0, 4.0, 0.7, 0.2);
  CHECK(stayed.induced == approx(4.0));
  CHECK(stayed.own == approx(1.6));
  const air::InflowState late = air::advance_inflow({-3.0, 9.0}, 4.0, 4.0, 500.0, 0.2);
  CHECK(late.induced == approx(rest.induced));
  CHECK(late.own == approx(rest.own));
  const air::InflowState none = air::advance_inflow({-3.0, 9.0}, 4.0, 4.0, 0.0, 0.2);
  CHECK(none.own == approx(-3.0));
  CHECK(none.induced == approx(9.0));
  // A short time divides nothing by a small number.
  const air::InflowState brief = air::advance_inflow({-3.0, 9.0}, 4.0, 5.0, 1e-13, 0.2);
  CHECK(brief.induced == approx(9.0));
}

TEST_CASE("inflow: of second order in the step when steady value and rate vary") {
  const auto steady = [](double t) { return std::sin(2.0 * t); };
  const auto rate = [](double t) { return 1.0 + 0.5 * std::cos(3.0 * t); };
  constexpr double ratio = 0.3, end = 2.0;
  const auto run = [&](int steps) {
    air::InflowState state = air::rest_inflow(0.0);
    const double h = end / steps;
    for (int k = 0; k < steps; ++k) {
      const double t = k * h;
      state = air::advance_inflow(state, steady(t), steady(t + h),
                                  0.5 * h * (rate(t) + rate(t + h)), ratio);
    }
    return state.induced;
  };
  const double exact = run(200000);
  const double coarse = run(50) - exact, fine = run(100) - exact, finest = run(200) - exact;
  CHECK(coarse / fine == doctest::Approx(4.0).epsilon(0.05));
  CHECK(fine / finest == doctest::Approx(4.0).epsilon(0.05));
}

TEST_CASE("inflow: the rate of a turbine is that of Oye's time constant, 1.1 R / (U (1 - 1.3 a))") {
  constexpr double radius = 63.0, wind = 8.0;
  for (const double a : {-0.2, 0.0, 0.1, 0.33, 0.49})
    CHECK(1.0 / air::calc_inflow_rate(wind, 0.0, a * wind, 0.3 * wind, radius) ==
          approx(1.1 * radius / (wind * (1.0 - 1.3 * a))));
  CHECK(air::calc_inflow_ratio(0.0) == 0.39);
  CHECK(air::calc_inflow_ratio(1.0) == approx(0.13));
}

TEST_CASE("inflow: rates are bounded and continuous from windmill to hover and standstill") {
  double before = air::calc_inflow_rate(10.0, 0.0, 4.0, 4.0, 10.0);
  for (double axial = 10.0; axial > -10.0; axial -= 0.01) {
    const double rate = air::calc_inflow_rate(axial, 0.0, 4.0, 4.0, 10.0);
    CHECK(rate > 0.0);
    CHECK(std::abs(rate - before) < 2e-3);
    before = rate;
  }
  CHECK(air::calc_inflow_rate(0.0, 0.0, 4.0, 4.0, 10.0) == approx(1.3 * 4.0 / 11.0));  // hover
  CHECK(air::calc_inflow_rate(0.0, 0.0, 0.0, 0.0, 10.0) > 0.0);
  CHECK(air::calc_inflow_rate(0.0, 30.0, 0.0, 0.0, 10.0) == approx(30.0 / 11.0));
}

TEST_CASE("inflow: in a skewed wake induced velocity is larger downstream, its mean the same") {
  constexpr double pi = std::numbers::pi;
  CHECK(air::calc_skew_factor(5.0, 0.0, 0.0, 1.0) == 1.0);
  CHECK(air::calc_skew_factor(0.0, 0.0, 0.0, 1.0) == 1.0);
  double sum = 0.0;
  constexpr int places = 36;
  for (int k = 0; k < places; ++k) {
    const double azimuth = 2.0 * pi * k / places;
    const double factor = air::calc_skew_factor(4.0, 3.0, 3.0 * std::cos(azimuth), 0.5);
    // tan chi = 3 / 4, so tan(chi / 2) = 1 / 3.
    CHECK(factor == approx(1.0 + 15.0 * pi / 32.0 / 3.0 * 0.5 * std::cos(azimuth)));
    CHECK(factor == approx(air::calc_skew_factor(-4.0, 3.0, 3.0 * std::cos(azimuth), 0.5)));
    sum += factor;
  }
  CHECK(sum / places == approx(1.0));
  // Along the disc, as fast helicopters: Pitt and Peters' gain 15 pi / 32.
  CHECK(air::calc_skew_factor(0.0, 60.0, 60.0, 1.0) == approx(1.0 + 15.0 * pi / 32.0));
}

TEST_CASE("inflow: a filter follows its closed form and reaches its end") {
  CHECK(air::advance_filter(1.0, 0.0, 0.0, 0.5) == approx(std::exp(-0.5)));
  CHECK(air::advance_filter(2.0, 2.0, 3.0, 1.0) == approx(3.0 - (1.0 - std::exp(-1.0))));
  CHECK(air::advance_filter(2.0, 5.0, 3.0, 0.0) == approx(0.0 + 2.0));
  CHECK(air::advance_filter(2.0, 5.0, 3.0, INFINITY) == 3.0);
}
