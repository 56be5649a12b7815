#pragma once

// Arithmetic that gives a parameter in a study file: "2 * blade.length + 0.5".

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace spoke::study {

/// A fault in the text of an expression: "expected a number ... at character 5".
class ExpressionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An expression of variables: numbers, names, + - * / ^, parentheses, pi, sqrt, exp, log, abs,
/// floor, round, min and max. Names may contain dots and digits, as keys do.
class Expression {
 public:
  Expression() = default;
  /// Parses a text. Throws ExpressionError, also at a name that is not among `names`.
  Expression(std::string_view text, std::span<const std::string> names);

  /// Returns the variables that it needs, as indices of `names`, each once.
  const std::vector<std::size_t>& variables() const { return variables_; }
  /// Returns the value; `variables` by index of `names`. It is not finite where the arithmetic is
  /// not.
  double value(std::span<const double> variables) const;

  enum class Operation {
    number,
    variable,
    add,
    subtract,
    multiply,
    divide,
    power,
    negate,
    sqrt,
    exp,
    log,
    abs,
    floor,
    round,
    min,
    max
  };
  /// One step of the calculation on a stack.
  struct Step {
    Operation operation;
    double number = 0.0;       ///< value of Operation::number
    std::size_t variable = 0;  ///< index of Operation::variable
  };

 private:
  std::vector<Step> steps_;  ///< steps, operands before their operation
  std::vector<std::size_t> variables_;
};

}  // namespace spoke::study
