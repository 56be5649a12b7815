#pragma once

// Tables of numbers under the names of their columns.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "program/foreign/input_lines.h"

namespace spoke::foreign {

/// A table of numbers under a line with the names of its columns.
struct NamedTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
  std::vector<int> lines;  ///< of the rows in the file

  /// Returns the index of a column, or the number of columns.
  std::size_t find(std::string_view name) const;
  bool has(std::string_view name) const { return find(name) < names.size(); }
  /// Returns a column, which must be there.
  std::vector<double> column(std::string_view name) const;
};

/// Whether rows may end behind the last column that is needed.
enum class LastColumns { needed, may_be_missing };

/// Reads the heads, the units and so many rows. Refuses tables without the columns that are needed.
NamedTable read_named_table(InputLines& lines, int rows, std::span<const char* const> needed,
                            LastColumns last = LastColumns::needed);

}  // namespace spoke::foreign
