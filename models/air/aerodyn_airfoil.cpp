// AeroDyn's aerofoils. Of what stands before a table only what is needed is read: the unsteady
// parameters, for another model of stall, may be there or not.

#include "models/air/aerodyn_airfoil.h"

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "models/solid/mesh_text.h"
#include "models/support/quantity.h"

namespace spoke::air {
namespace {

constexpr int kMostTables = 100;
constexpr int kMostRows = 100000;

bool is_same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

/// Goes through the lines that hold more than comments.
class Walk {
 public:
  Walk(std::string_view text, const std::string& file)
      : lines_(split_airfoil_lines(text, "!")), file_(file) {}

  /// Returns the next line of a value and `key`, and stands behind it.
  const AirfoilLine& find(std::string_view key) {
    for (; at_ < lines_.size(); ++at_)
      if (has_key(key)) return lines_[at_++];
    refuse_airfoil(file_, last_line(),
                   "the file ends here, expected a line of a value and " + std::string(key));
  }
  /// Returns whether the next line is of a value and `key`.
  bool is_next(std::string_view key) const { return at_ < lines_.size() && has_key(key); }

  double find_number(std::string_view key, const char* expected) {
    const AirfoilLine& line = find(key);
    double value = 0.0;
    if (!solid::read_number(line.words[0], value)) refuse_value(line, key, expected);
    return value;
  }
  int find_count(std::string_view key, int least, int most) {
    const AirfoilLine& line = find(key);
    const Count range{least, most};
    std::int64_t value = 0;
    if (!solid::read_number(line.words[0], value) || !range.holds(value))
      refuse_value(line, key, range.expectation());
    return static_cast<int>(value);
  }
  /// Returns the next line, a row of a table of so many.
  const AirfoilLine& row(int number, int rows) {
    if (at_ < lines_.size()) return lines_[at_++];
    refuse_airfoil(file_, last_line(),
                   "the file ends here, expected row " + std::to_string(number) + " of " +
                       std::to_string(rows) + " of the table");
  }
  /// Returns the number of the line taken last.
  int number() const { return at_ == 0 ? 0 : lines_[at_ - 1].number; }
  [[noreturn]] void refuse_value(const AirfoilLine& line, std::string_view key,
                                 const std::string& expected) const {
    refuse_airfoil(
        file_, line.number,
        std::string(key) + " is " + solid::show_text(line.words[0]) + ", expected " + expected);
  }

 private:
  bool has_key(std::string_view key) const {
    const auto& words = lines_[at_].words;
    return words.size() > 1 && is_same_word(words[1], key);
  }
  int last_line() const { return lines_.empty() ? 0 : lines_.back().number; }

  std::vector<AirfoilLine> lines_;
  const std::string& file_;
  std::size_t at_ = 0;
};

/// Reads one table; its control setting, 0 if none is given.
AerodynTable read_table(Walk& walk, const std::string& file, double& control) {
  AerodynTable table;
  const double millions = walk.find_number("Re", "the Reynolds number in millions");
  table.reynolds = 1e6 * millions;
  table.line = walk.number();
  if (!(millions > 0.0))
    refuse_airfoil(
        file, table.line,
        "Re is " + describe(millions) + ", expected the Reynolds number in millions, more than 0");
  control = 0.0;
  for (const char* key : {"UserProp", "Ctrl"})
    if (walk.is_next(key)) control = walk.find_number(key, "a control setting, a finite number");
  const int rows = walk.find_count("NumAlf", 3, kMostRows);
  for (int row = 1; row <= rows; ++row) {
    add_row(walk.row(row, rows), file, 3, 4, true, table.rows);
    if (table.rows.rows.back().size() != table.rows.rows.front().size())
      refuse_airfoil(file, walk.number(),
                     "row " + std::to_string(row) + " has " +
                         std::to_string(table.rows.rows.back().size()) + " columns, expected " +
                         std::to_string(table.rows.rows.front().size()) + " as in the first row");
  }
  return table;
}

}  // namespace

bool is_aerodyn_airfoil(std::string_view text) {
  const auto lines = split_airfoil_lines(text, "!");
  return std::any_of(lines.begin(), lines.end(), [](const AirfoilLine& line) {
    return line.words.size() > 1 && is_same_word(line.words[1], "NumTabs");
  });
}

std::vector<AerodynTable> read_aerodyn_airfoil(std::string_view text, const std::string& file) {
  Walk walk(text, file);
  const int count = walk.find_count("NumTabs", 1, kMostTables);
  const int line = walk.number();
  std::vector<AerodynTable> tables;
  for (int k = 0; k < count; ++k) {
    double control = 0.0;
    AerodynTable table = read_table(walk, file, control);
    if (count == 1 || control == 0.0) tables.push_back(std::move(table));
  }
  if (tables.empty())
    refuse_airfoil(file, line, "no table has UserProp 0, expected one with the control at rest");
  return tables;
}

}  // namespace spoke::air
