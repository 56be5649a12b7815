// A parser by recursive descent to steps on a stack, and their calculation.

#include "program/study/expression.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "models/support/nearest_name.h"
#include "program/study/portable_math.h"

namespace spoke::study {
namespace {

using Operation = Expression::Operation;

constexpr int kDeepest = 100;  // deepest nesting of parentheses

struct Function {
  std::string_view name;
  Operation operation;
  int arguments;
};
constexpr std::array<Function, 8> kFunctions = {{{"sqrt", Operation::sqrt, 1},
                                                 {"exp", Operation::exp, 1},
                                                 {"log", Operation::log, 1},
                                                 {"abs", Operation::abs, 1},
                                                 {"floor", Operation::floor, 1},
                                                 {"round", Operation::round, 1},
                                                 {"min", Operation::min, 2},
                                                 {"max", Operation::max, 2}}};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

class Parser {
 public:
  Parser(std::string_view text, std::span<const std::string> names) : text_(text), names_(names) {}

  std::vector<Expression::Step> parse() {
    parse_sum();
    if (at_ < text_.size()) fail("expected an operator or the end");
    return std::move(steps_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw ExpressionError(what + " at character " + std::to_string(at_ + 1));
  }

  /// Returns the next character that is no blank; 0 at the end.
  char next() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }
  void add(Operation operation) { steps_.push_back({operation}); }

  void parse_sum() {
    if (++depth_ > kDeepest) fail("expected fewer parentheses");
    parse_product();
    while (true) {
      if (take('+')) {
        parse_product();
        add(Operation::add);
      } else if (take('-')) {
        parse_product();
        add(Operation::subtract);
      } else {
        break;
      }
    }
    --depth_;
  }

  void parse_product() {
    parse_signed();
    while (true) {
      if (take('*')) {
        parse_signed();
        add(Operation::multiply);
      } else if (take('/')) {
        parse_signed();
        add(Operation::divide);
      } else {
        return;
      }
    }
  }

  /// Signs bind less than powers: -x^2 is -(x^2).
  void parse_signed() {
    int minuses = 0;
    for (char c = next(); c == '-' || c == '+'; c = next()) {
      if (c == '-') ++minuses;
      ++at_;
    }
    parse_power();
    if (minuses % 2 == 1) add(Operation::negate);
  }

  void parse_power() {
    parse_operand();
    if (!take('^')) return;
    if (++depth_ > kDeepest) fail("expected fewer powers");
    parse_signed();  // from the right, since 2^3^2 is 2^9
    --depth_;
    add(Operation::power);
  }

  void parse_operand() {
    const char c = next();
    if (take('(')) {
      parse_sum();
      if (!take(')')) fail("expected )");
    } else if (is_digit(c) || c == '.') {
      parse_number();
    } else if (is_letter(c)) {
      parse_name();
    } else {
      fail("expected a number, a name or (");
    }
  }

  void parse_number() {
    double number = 0.0;
    const char* begin = text_.data() + at_;
    const auto [end, fault] = std::from_chars(begin, text_.data() + text_.size(), number);
    if (fault != std::errc{}) fail("expected a number");
    at_ += static_cast<std::size_t>(end - begin);
    steps_.push_back({Operation::number, number});
  }

  void parse_name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() &&
           (is_letter(text_[at_]) || is_digit(text_[at_]) || text_[at_] == '.'))
      ++at_;
    const std::string_view name = text_.substr(begin, at_ - begin);
    if (next() == '(') return parse_call(name, begin);
    if (name == "pi") {
      steps_.push_back({Operation::number, std::numbers::pi});
      return;
    }
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) fail_unknown(name, begin);
    steps_.push_back({Operation::variable, 0.0, static_cast<std::size_t>(found - names_.begin())});
  }

  void parse_call(std::string_view name, std::size_t begin) {
    const auto* function = std::find_if(kFunctions.begin(), kFunctions.end(),
                                        [&](const Function& f) { return f.name == name; });
    if (function == kFunctions.end()) {
      at_ = begin;
      fail("\"" + std::string(name) +
           "\" is no function, expected sqrt, exp, log, abs, floor, round, min or max");
    }
    take('(');
    for (int argument = 0; argument < function->arguments; ++argument) {
      if (argument > 0 && !take(',')) fail("expected a comma and another argument");
      parse_sum();
    }
    if (!take(')')) fail("expected )");
    add(function->operation);
  }

  [[noreturn]] void fail_unknown(std::string_view name, std::size_t begin) {
    at_ = begin;
    const std::vector<std::string_view> known(names_.begin(), names_.end());
    const auto nearest = nearest_name(name, known);
    fail("\"" + std::string(name) + "\" is no other parameter" +
         (nearest ? ", did you mean \"" + std::string(*nearest) + "\"?" : std::string()));
  }

  std::string_view text_;
  std::span<const std::string> names_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::vector<Expression::Step> steps_;
};

double apply(Operation operation, double a) {
  switch (operation) {
    case Operation::negate:
      return -a;
    case Operation::sqrt:
      return std::sqrt(a);
    case Operation::exp:
      return portable_exp(a);
    case Operation::log:
      if (a > 0.0 && std::isfinite(a)) return portable_log(a);
      return std::numeric_limits<double>::quiet_NaN();
    case Operation::abs:
      return std::abs(a);
    case Operation::floor:
      return std::floor(a);
    default:
      return std::floor(a + 0.5);
  }
}

double apply(Operation operation, double a, double b) {
  switch (operation) {
    case Operation::add:
      return a + b;
    case Operation::subtract:
      return a - b;
    case Operation::multiply:
      return a * b;
    case Operation::divide:
      return a / b;
    case Operation::power:
      return portable_power(a, b);
    case Operation::min:
      return std::min(a, b);
    default:
      return std::max(a, b);
  }
}

bool has_two_operands(Operation operation) {
  return (Operation::add <= operation && operation <= Operation::power) ||
         operation == Operation::min || operation == Operation::max;
}

}  // namespace

Expression::Expression(std::string_view text, std::span<const std::string> names)
    : steps_(Parser(text, names).parse()) {
  for (const Step& step : steps_)
    if (step.operation == Operation::variable) variables_.push_back(step.variable);
  std::sort(variables_.begin(), variables_.end());
  variables_.erase(std::unique(variables_.begin(), variables_.end()), variables_.end());
}

double Expression::value(std::span<const double> variables) const {
  std::vector<double> stack;
  for (const Step& step : steps_) {
    if (step.operation == Operation::number) {
      stack.push_back(step.number);
    } else if (step.operation == Operation::variable) {
      stack.push_back(variables[step.variable]);
    } else if (has_two_operands(step.operation)) {
      const double b = stack.back();
      stack.pop_back();
      stack.back() = apply(step.operation, stack.back(), b);
    } else {
      stack.back() = apply(step.operation, stack.back());
    }
  }
  return stack.back();
}

}  // namespace spoke::study
