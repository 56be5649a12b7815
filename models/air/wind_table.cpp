// Reads tables line by line.

#include "models/air/wind_table.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "models/air/wind_rules.h"
#include "models/count_text.h"
#include "models/solid/mesh_text.h"
#include "models/support/quantity.h"

namespace spoke::air {
namespace {

struct WindColumn {
  std::string_view name;
  Quantity range;
};
/// The columns in their usual order.
constexpr std::array<WindColumn, 5> kWindColumns = {{{"time", kWindTime},
                                                     {"speed", kWindSpeed},
                                                     {"direction", Quantity::any("rad")},
                                                     {"vertical_speed", kWindSpeed},
                                                     {"shear_exponent", kShearExponent}}};
constexpr const char* kWindColumnsExpected =
    "time, speed, and perhaps direction, vertical_speed and shear_exponent";

/// A table that is read.
class TableReader {
 public:
  explicit TableReader(const std::string& file) : file_(file) {}

  void read_line(std::string_view line, int number) {
    line_ = number;
    line = line.substr(0, line.find_first_of("#!%"));
    split(line);
    if (words_.empty()) return;
    double ignored = 0.0;
    if (order_.empty() && !solid::read_number(words_[0], ignored)) {
      read_names();
      return;
    }
    if (order_.empty()) take_usual_order();
    read_row();
  }

  WindTable finish() const {
    const std::vector<double>& times = values_[0];
    if (times.empty())
      solid::refuse_mesh(
          file_, line_,
          "has no row, expected a table of wind: " + std::string(kWindColumnsExpected));
    WindTable table;
    table.speed = Curve(times, values_[1]);
    if (!values_[2].empty()) table.direction = Curve(times, values_[2]);
    if (!values_[3].empty()) table.vertical_speed = Curve(times, values_[3]);
    if (!values_[4].empty()) table.shear_exponent = Curve(times, values_[4]);
    return table;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    solid::refuse_mesh(file_, line_, what);
  }

  void split(std::string_view line) {
    words_.clear();
    constexpr const char* kBetween = " \t\r,;";
    for (std::size_t at = line.find_first_not_of(kBetween); at != std::string_view::npos;) {
      const std::size_t end = std::min(line.find_first_of(kBetween, at), line.size());
      words_.push_back(line.substr(at, end - at));
      at = line.find_first_not_of(kBetween, end);
    }
  }

  void read_names() {
    for (const std::string_view word : words_) {
      const auto* const found = std::find_if(kWindColumns.begin(), kWindColumns.end(),
                                             [&](const WindColumn& c) { return c.name == word; });
      if (found == kWindColumns.end())
        refuse("has the column " + solid::show_text(word) + ", expected " + kWindColumnsExpected);
      const auto column = static_cast<std::size_t>(found - kWindColumns.begin());
      if (std::find(order_.begin(), order_.end(), column) != order_.end())
        refuse("has the column " + solid::show_text(word) + " twice, expected it once");
      order_.push_back(column);
    }
    for (const std::size_t column : {std::size_t{0}, std::size_t{1}})
      if (std::find(order_.begin(), order_.end(), column) == order_.end())
        refuse("has no column " + solid::show_text(kWindColumns[column].name) + ", expected " +
               kWindColumnsExpected);
  }

  void take_usual_order() {
    if (words_.size() < 2 || words_.size() > kWindColumns.size())
      refuse("has " + counted(std::ssize(words_), "column") +
             ", expected 2 to 5: " + kWindColumnsExpected);
    for (std::size_t column = 0; column < words_.size(); ++column) order_.push_back(column);
  }

  void read_row() {
    if (words_.size() != order_.size())
      refuse("has " + counted(std::ssize(words_), "number") + ", expected " +
             std::to_string(order_.size()) + ", one for each column");
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const WindColumn& column = kWindColumns[order_[i]];
      double value = 0.0;
      if (!solid::read_number(words_[i], value))
        refuse(std::string(column.name) + " is " + solid::show_text(words_[i]) +
               ", expected a finite number" + in_parentheses(column.range.unit));
      const std::string expected = column.range.expectation_instead_of(value);
      if (!expected.empty())
        refuse(std::string(column.name) + " is " + describe(value) + ", expected " + expected);
      values_[order_[i]].push_back(value);
    }
    const std::vector<double>& times = values_[0];
    if (times.size() > 1 && !(times.back() > times[times.size() - 2]))
      refuse("time is " + describe(times.back()) + ", expected more than " +
             describe(times[times.size() - 2]) + " s, that of the row before");
  }

  const std::string& file_;
  int line_ = 0;
  std::vector<std::string_view> words_;
  std::vector<std::size_t> order_;  ///< by place in a row, index of its column
  std::array<std::vector<double>, kWindColumns.size()> values_;
};

}  // namespace

WindTable parse_wind_table(std::string_view text, const std::string& file) {
  TableReader reader(file);
  solid::MeshText lines(text, file);
  while (!lines.is_at_end()) {
    const int number = lines.line();
    reader.read_line(lines.rest_of_line(), number);
  }
  return reader.finish();
}

}  // namespace spoke::air
