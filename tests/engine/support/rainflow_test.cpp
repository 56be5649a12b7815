#include "engine/support/rainflow.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <vector>

#include "tests/approx.h"

using namespace spoke;
using spoke::testing::approx;

namespace {

/// Returns the number of cycles by range.
std::map<double, double> count_ranges(const std::vector<double>& values) {
  std::map<double, double> cycles;
  const auto count = [&](double range, double n) { cycles[range] += n; };
  Rainflow rainflow;
  for (const double value : values) rainflow.add(value, count);
  rainflow.finish(count);
  return cycles;
}

/// Counts the turning points of a whole history by the text of the standard: ranges are closed
/// wherever they are in the list, again from its start after each.
std::map<double, double> count_by_list(std::vector<double> points) {
  std::map<double, double> cycles;
  const auto range = [&](std::size_t k) { return std::abs(points[k + 1] - points[k]); };
  for (std::size_t k = 1; k + 1 < points.size();) {
    if (range(k) < range(k - 1)) {
      ++k;
      continue;
    }
    const bool has_start = k == 1;
    cycles[range(k - 1)] += has_start ? 0.5 : 1.0;
    const auto at = points.begin() + static_cast<std::ptrdiff_t>(k) - 1;
    points.erase(at, at + (has_start ? 1 : 2));
    k = 1;
  }
  for (std::size_t k = 0; k + 1 < points.size(); ++k) cycles[range(k)] += 0.5;
  return cycles;
}

double equivalent(const std::vector<double>& values, double exponent, double cycles) {
  EquivalentRange range(exponent);
  for (const double value : values) range.add(value);
  return range.calc(cycles);
}

}  // namespace

TEST_CASE("rainflow counts the example of ASTM E1049") {
  const std::map<double, double> expected = {
      {3.0, 0.5}, {4.0, 1.5}, {6.0, 0.5}, {8.0, 1.0}, {9.0, 0.5}};
  CHECK(count_ranges({-2, 1, -3, 5, -1, 3, -4, 4, -2}) == expected);
  // Values between turning points and repeated ones change nothing.
  CHECK(count_ranges({-2, -2, 0, 1, 1, 0, -3, 2, 4, 5, 5, -1, -1, 3, 1, -4, 0, 4, -2, -2}) ==
        expected);
}

TEST_CASE("rainflow finds no range in what does not turn, and half a cycle in a ramp") {
  CHECK(count_ranges({}).empty());
  CHECK(count_ranges({3.0}).empty());
  CHECK(count_ranges({3.0, 3.0, 3.0}).empty());
  CHECK(count_ranges({3.0, 4.0, 7.0}) == std::map<double, double>{{4.0, 0.5}});
  CHECK(equivalent({3.0, 3.0}, 10.0, 5.0) == 0.0);
}

TEST_CASE("rainflow with a stack counts as the standard's list does") {
  std::mt19937 random(1);
  for (int round = 0; round < 50; ++round) {
    std::vector<double> turning = {0.0};
    bool rises = true;
    for (int k = 0; k < 40; ++k, rises = !rises)
      turning.push_back(turning.back() +
                        (rises ? 1.0 : -1.0) * (1 + static_cast<int>(random() % 9)));
    CAPTURE(round);
    CHECK(count_ranges(turning) == count_by_list(turning));
  }
}

TEST_CASE("rainflow bounds its memory, and counts all ranges of a decay") {
  const int turns = 20000;
  double cycles = 0.0;
  const auto count = [&](double, double n) { cycles += n; };
  Rainflow rainflow;
  for (int k = 0; k <= turns; ++k) rainflow.add((k % 2 ? -1.0 : 1.0) / (1.0 + k), count);
  CHECK(cycles > 0.3 * turns);  // long before the end
  rainflow.finish(count);
  CHECK(cycles == 0.5 * turns);
}

TEST_CASE("the equivalent range of a sine is its own, by its number of cycles") {
  constexpr double amplitude = 3e6, seconds = 50.0;
  constexpr int cycles = 20, samples = 32;
  std::vector<double> values;
  for (int k = 0; k <= cycles * samples; ++k)
    values.push_back(7e6 + amplitude * std::cos(2.0 * std::numbers::pi * k / samples));
  for (const double exponent : {3.0, 4.0, 10.0})
    CHECK(equivalent(values, exponent, seconds) ==
          approx(2.0 * amplitude * std::pow(cycles / seconds, 1.0 / exponent)));
}

TEST_CASE("equivalent ranges add up by damage, grow with the signal, and do not overflow") {
  const std::vector<double> history = {-2, 1, -3, 5, -1, 3, -4, 4, -2};
  const double sum = 0.5 * std::pow(3.0, 10) + 1.5 * std::pow(4.0, 10) + 0.5 * std::pow(6.0, 10) +
                     std::pow(8.0, 10) + 0.5 * std::pow(9.0, 10);
  const double expected = std::pow(sum / 8.0, 0.1);
  CHECK(equivalent(history, 10.0, 8.0) == approx(expected));
  for (const double scale : {1e-100, 1e100}) {
    std::vector<double> scaled = history;
    for (double& value : scaled) value *= scale;
    CHECK(equivalent(scaled, 10.0, 8.0) == approx(scale * expected));
  }
  // Asking does not end the count.
  EquivalentRange range(10.0);
  for (const double value : history) {
    range.add(value);
    range.calc(8.0);
  }
  CHECK(range.calc(8.0) == approx(expected));
}
