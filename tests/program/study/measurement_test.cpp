#include "program/study/measurement.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace spoke::study;

namespace {

/// Makes a response of 2 + 3 sin(2 pi t / 0.8), from 0 to 4 s.
Response of_kind(ResponseKind kind) {
  Response response;
  response.kind = kind;
  response.to = INFINITY;
  return response;
}

Measurement measure(const Response& response, double output_interval = 0.1) {
  Measurement measurement(response, output_interval);
  for (int i = 0; i <= 4000; ++i) {
    const double t = 1e-3 * i;
    measurement.add(t, 2.0 + 3.0 * std::sin(2.0 * std::numbers::pi * t / 0.8));
  }
  return measurement;
}

double result(const Response& response) { return measure(response).result(); }

}  // namespace

TEST_CASE("extremes, means and values of a sine are its own") {
  CHECK(std::abs(result(of_kind(ResponseKind::min)) + 1.0) < 1e-12);
  CHECK(std::abs(result(of_kind(ResponseKind::max)) - 5.0) < 1e-12);
  CHECK(std::abs(result(of_kind(ResponseKind::mean)) - 2.0) < 1e-12);
  CHECK(std::abs(result(of_kind(ResponseKind::rms)) - std::sqrt(4.0 + 4.5)) < 1e-12);
  CHECK(std::abs(result(of_kind(ResponseKind::final)) - 2.0) < 1e-12);
  Response at = of_kind(ResponseKind::at);
  at.time = 0.2005;  // between two steps, near the crest
  CHECK(std::abs(result(at) - 5.0) < 1e-4);
  at.time = 5.0;
  CHECK(std::isnan(result(at)));
}

TEST_CASE("a window leaves out what is before and behind it") {
  Response response = of_kind(ResponseKind::max);
  response.from = 0.41;
  response.to = 0.79;
  CHECK(result(response) < 2.0);
  response.from = 9.0;
  response.to = 10.0;
  CHECK(std::isnan(result(response)));
  response.kind = ResponseKind::mean;
  CHECK(std::isnan(result(response)));
}

TEST_CASE("crossings of a level are found between steps, in their direction") {
  Response response = of_kind(ResponseKind::first_crossing);
  response.level = 3.5;  // sin = 1/2
  CHECK(std::abs(result(response) - 0.8 / 12.0) < 1e-6);
  response.direction = Direction::down;
  CHECK(std::abs(result(response) - 5.0 * 0.8 / 12.0) < 1e-6);
  response.direction = Direction::up;
  response.from = 0.5;
  CHECK(std::abs(result(response) - 0.8 - 0.8 / 12.0) < 1e-6);
  response.level = 6.0;
  CHECK(std::isnan(result(response)));
}

TEST_CASE("a period is the mean time between upward crossings of the mean, or of a level") {
  Response response = of_kind(ResponseKind::period);
  CHECK(std::abs(result(response) - 0.8) < 1e-5);
  response.level = 4.0;
  CHECK(std::abs(result(response) - 0.8) < 1e-6);
  response.level = 7.0;
  CHECK(std::isnan(result(response)));
}

TEST_CASE("a history has the values at output times") {
  const Response response = of_kind(ResponseKind::history);  // measurements refer to it
  Measurement measurement = measure(response, 0.5);
  History history = measurement.take_history();
  REQUIRE(history.times.size() == 9);
  CHECK(std::abs(history.times[3] - 1.5) < 1e-12);
  CHECK(std::abs(history.values[2] - 5.0) < 1e-9);  // at 1 s, a crest
  CHECK(std::isnan(measurement.result()));
  Response often = of_kind(ResponseKind::history);
  often.every = 0.1;
  CHECK(measure(often, 0.5).take_history().times.size() == 41);
}
