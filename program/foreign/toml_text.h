#pragma once

// The text of a scenario that grows, with comments.

#include <Eigen/Core>
#include <string>
#include <vector>

namespace spoke::foreign {

/// Returns the shortest digits that give the same number. What scenarios refuse as too small is 0.
std::string digits(double number);
/// Return "[1, 2.5]".
std::string digits(const std::vector<double>& numbers);
std::string digits(const Eigen::Vector3d& v);
/// Returns a text as TOML has it, in quotes.
std::string quoted(const std::string& text);

/// A TOML text that grows. Comments may have any characters.
class Toml {
 public:
  void comment(const std::string& text);
  /// Adds lines of TOML as comments.
  void comment_out(const std::string& lines);
  /// Begins a table: "[blade]".
  void table(const std::string& head);
  void key(const std::string& name, const std::string& value, const std::string& from = {});
  /// An array, a value in a line of its own.
  void lines(const std::string& name, const std::vector<std::string>& values,
             const std::vector<std::string>& comments);
  /// An array in one line; none if it is empty.
  void numbers(const std::string& name, const std::vector<double>& values);
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace spoke::foreign
