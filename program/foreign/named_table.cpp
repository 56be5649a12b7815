// Heads, units and rows.

#include "program/foreign/named_table.h"

#include <algorithm>

namespace spoke::foreign {

std::size_t NamedTable::find(std::string_view name) const {
  std::size_t k = 0;
  while (k < names.size() && !is_same_word(names[k], name)) ++k;
  return k;
}

std::vector<double> NamedTable::column(std::string_view name) const {
  const std::size_t k = find(name);
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(row[k]);
  return values;
}

NamedTable read_named_table(InputLines& lines, int rows, std::span<const char* const> needed,
                            LastColumns last) {
  NamedTable table;
  for (const std::string_view word :
       split_words(lines.take_filled("the heads of the table's columns")))
    table.names.push_back(printable(word));
  std::size_t columns = 0;
  for (const char* name : needed) {
    if (!table.has(name))
      lines.refuse("no column " + std::string(name) + ", expected " + std::string(needed[0]) +
                   " and the others of the table");
    columns = std::max(columns, table.find(name) + 1);
  }
  if (last == LastColumns::needed) columns = table.names.size();
  table.names.resize(columns);
  lines.take_filled("the units of the table's columns");
  for (int row = 1; row <= rows; ++row) {
    table.rows.push_back(
        lines.take_numbers(columns, "row " + std::to_string(row) + " of the table"));
    table.lines.push_back(lines.number());
  }
  return table;
}

}  // namespace spoke::foreign
