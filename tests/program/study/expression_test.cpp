#include "program/study/expression.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace spoke::study;

namespace {

const std::vector<std::string> kNames = {"a", "blade.length", "blades.2.mass_1"};

double value(const std::string& text) {
  return Expression(text, kNames).value(std::array{3.0, 8.0, 0.5});
}

std::string fault(const std::string& text) {
  try {
    Expression(text, kNames);
  } catch (const ExpressionError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("expressions follow the rules of arithmetic") {
  CHECK(value("1 + 2 * 3") == 7.0);
  CHECK(value("(1+2)*3") == 9.0);
  CHECK(value("2^3^2") == 512.0);
  CHECK(value("-a^2") == -9.0);
  CHECK(value("2^-1") == 0.5);
  CHECK(value("8 / 4 / 2") == 1.0);
  CHECK(value("10 - 4 - 3") == 3.0);
  CHECK(value("1.5e1 - -1") == 16.0);
  CHECK(value("blade.length * blades.2.mass_1") == 4.0);
  CHECK(value("sqrt(16) + abs(-2) + floor(1.9) + round(2.5)") == 10.0);
  CHECK(value("max(a, min(blade.length, 5))") == 5.0);
  CHECK(std::abs(value("exp(log(a)) + pi") - 3.0 - 3.14159265358979) < 1e-14);
  CHECK(std::isinf(value("1 / 0")));
  CHECK(std::isnan(value("log(0 - 1)")));
}

TEST_CASE("an expression knows its variables") {
  CHECK(Expression("blade.length + a * blade.length", kNames).variables() ==
        std::vector<std::size_t>{0, 1});
  CHECK(Expression("2", kNames).variables().empty());
}

TEST_CASE("what is wrong with an expression is told with its place") {
  CHECK(fault("") == "expected a number, a name or ( at character 1");
  CHECK(fault("1 +") == "expected a number, a name or ( at character 4");
  CHECK(fault("(1 + 2") == "expected ) at character 7");
  CHECK(fault("1 2") == "expected an operator or the end at character 3");
  CHECK(fault("2 * blade.lenght") ==
        "\"blade.lenght\" is no other parameter, did you mean \"blade.length\"? at character 5");
  CHECK(fault("sin(a)") ==
        "\"sin\" is no function, expected sqrt, exp, log, abs, floor, round, min "
        "or max at character 1");
  CHECK(fault("min(a)") == "expected a comma and another argument at character 6");
  CHECK(fault(std::string(5000, '(')) == "expected fewer parentheses at character 101");
  CHECK(fault("1" + std::string(5000, '^') + "1") ==
        "expected a number, a name or ( at character 3");
}
