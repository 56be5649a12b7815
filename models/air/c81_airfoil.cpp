// Reads columns of fixed width, as cards had them.

#include "models/air/c81_airfoil.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "models/air/airfoil_lines.h"
#include "models/solid/mesh_text.h"
#include "models/support/quantity.h"

namespace spoke::air {
namespace {

using spatial::Polar;

constexpr std::size_t kTitle = 30;   // columns of the first line before its counts
constexpr std::size_t kCount = 2;    // columns of a count
constexpr std::size_t kField = 7;    // columns of a number
constexpr std::size_t kPerLine = 9;  // numbers of a line behind the first field
constexpr std::size_t kTables = 3;
constexpr std::array<const char*, kTables> kNames = {"lift", "drag", "moment"};

/// The size of a table.
struct Size {
  std::size_t machs = 0, angles = 0;
};

/// A table over angle [degrees] and Mach number.
struct Table {
  std::vector<double> machs, angles;
  std::vector<std::vector<double>> rows;  ///< by angle
};

std::optional<std::array<Size, kTables>> find_sizes(std::string_view line) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  constexpr std::size_t end = kTitle + 2 * kTables * kCount;
  if (line.size() != end) return std::nullopt;
  std::array<std::size_t, 2 * kTables> counts{};
  for (std::size_t k = 0; k < counts.size(); ++k) {
    double count = 0.0;
    if (!solid::read_number(solid::trim(line.substr(kTitle + k * kCount, kCount)), count) ||
        count != std::floor(count) || count < 1.0)
      return std::nullopt;
    counts[k] = static_cast<std::size_t>(count);
  }
  return std::array<Size, kTables>{Size{counts[0], counts[1]}, Size{counts[2], counts[3]},
                                   Size{counts[4], counts[5]}};
}

/// Takes the lines of a text one by one.
class Cards {
 public:
  Cards(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  int number() const { return number_; }
  std::string_view take(const std::string& what) {
    if (text_.empty()) refuse_airfoil(file_, number_, "the file ends here, expected " + what);
    const std::size_t end = text_.find('\n');
    std::string_view line = text_.substr(0, end);
    text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    ++number_;
    return line;
  }

  /// Takes `count` numbers behind the first field of a line and of those that go on, whose first
  /// field is blank; returns what stands in the first field of the first line.
  std::string_view take_row(std::size_t count, const std::string& what,
                            std::vector<double>& numbers) {
    std::string_view first;
    for (std::size_t k = 0; k < count; ++k) {
      if (k % kPerLine == 0) {
        line_ = take(what);
        const std::string_view field = solid::trim(line_.substr(0, kField));
        if (k == 0) first = field;
        if (k > 0 && !field.empty())
          refuse_airfoil(file_, number_,
                         "begins with " + solid::show_text(field) + ", expected " +
                             std::to_string(kField) +
                             " blanks and more numbers of the row before: " + what);
      }
      numbers.push_back(read_field(1 + k % kPerLine, what));
    }
    return first;
  }

  double read(std::string_view field, const std::string& what) const {
    double number = 0.0;
    if (!solid::read_number(field, number) || !std::isfinite(number))
      refuse_airfoil(file_, number_,
                     "found " + solid::show_text(field) + ", expected a number: " + what);
    return number;
  }

 private:
  double read_field(std::size_t index, const std::string& what) const {
    const std::size_t begin = index * kField;
    if (begin >= line_.size())
      refuse_airfoil(file_, number_,
                     "has " + std::to_string(index - 1) +
                         " numbers behind its first field, expected more: " + what);
    return read(solid::trim(line_.substr(begin, kField)), what);
  }

  std::string_view text_, line_;
  const std::string& file_;
  int number_ = 0;
};

Table read_table(const Size& size, const std::string& name, const std::string& file, Cards& cards) {
  Table table;
  const std::string_view blank = cards.take_row(size.machs, "Mach numbers of " + name, table.machs);
  if (!blank.empty())
    refuse_airfoil(file, cards.number(),
                   "begins with " + solid::show_text(blank) + ", expected " +
                       std::to_string(kField) + " blanks and the Mach numbers of " + name);
  for (std::size_t k = 0; k < size.machs; ++k)
    if (!(table.machs[k] >= 0.0) || (k > 0 && !(table.machs[k] > table.machs[k - 1])))
      refuse_airfoil(file, cards.number(),
                     "Mach number is " + describe(table.machs[k]) +
                         ", expected 0 or more, and more than the one "
                         "before");
  for (std::size_t i = 0; i < size.angles; ++i) {
    std::vector<double> row;
    const std::string what = "row " + std::to_string(i + 1) + " of " + name;
    const double angle = cards.read(cards.take_row(size.machs, what, row), "the angle of " + what);
    if (i > 0 && !(angle > table.angles.back()))
      refuse_airfoil(file, cards.number(),
                     "angle of attack is " + describe(angle) +
                         " degrees, expected more than in the row before, " +
                         describe(table.angles.back()));
    table.angles.push_back(angle);
    table.rows.push_back(std::move(row));
  }
  constexpr double end = 180.0;
  if (table.angles.front() != -end || table.angles.back() != end)
    refuse_airfoil(file, cards.number(),
                   name + " is given from " + describe(table.angles.front()) + " to " +
                       describe(table.angles.back()) + " degrees, expected -180 to 180");
  return table;
}

/// Returns the two neighbours of a place in an ascending list, and the share of the second.
struct Between {
  std::size_t low, high;
  double share;
  Between(const std::vector<double>& at, double place) {
    high = static_cast<std::size_t>(std::upper_bound(at.begin(), at.end(), place) - at.begin());
    low = high == 0 ? 0 : high - 1;
    high = std::min(high, at.size() - 1);
    share = low == high ? 0.0 : std::clamp((place - at[low]) / (at[high] - at[low]), 0.0, 1.0);
  }
};

double find_value(const Table& table, double angle, double mach) {
  const Between a(table.angles, angle), m(table.machs, mach);
  const auto in_row = [&](std::size_t row) {
    return std::lerp(table.rows[row][m.low], table.rows[row][m.high], m.share);
  };
  return std::lerp(in_row(a.low), in_row(a.high), a.share);
}

std::vector<double> unite(const std::array<Table, kTables>& tables,
                          const std::vector<double> Table::*places) {
  std::vector<double> all;
  for (const Table& table : tables)
    all.insert(all.end(), (table.*places).begin(), (table.*places).end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// Makes the ends of a column equal, which are the same angle.
void close(std::vector<double>& column) {
  column.front() = column.back() = 0.5 * (column.front() + column.back());
}

}  // namespace

bool is_c81_airfoil(std::string_view text) {
  return find_sizes(text.substr(0, text.find('\n'))).has_value();
}

std::vector<Polar> read_c81_airfoil(std::string_view text, const std::string& file) {
  Cards cards(text, file);
  const auto sizes = find_sizes(cards.take("a title and six counts"));
  if (!sizes)
    refuse_airfoil(file, 1, "expected a title of 30 columns and six counts of 2 columns each");
  std::array<Table, kTables> tables;
  for (std::size_t k = 0; k < kTables; ++k)
    tables[k] = read_table((*sizes)[k], kNames[k], file, cards);
  const std::vector<double> angles = unite(tables, &Table::angles);
  std::vector<Polar> polars;
  for (const double mach : unite(tables, &Table::machs)) {
    Polar& polar = polars.emplace_back();
    polar.mach = mach;
    for (const double angle : angles) {
      polar.angle.push_back(angle * (std::numbers::pi / 180.0));
      polar.lift.push_back(find_value(tables[0], angle, mach));
      polar.drag.push_back(find_value(tables[1], angle, mach));
      polar.moment.push_back(find_value(tables[2], angle, mach));
    }
    for (std::vector<double>* column : {&polar.lift, &polar.drag, &polar.moment}) close(*column);
  }
  return polars;
}

}  // namespace spoke::air
