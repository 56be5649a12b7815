#pragma once

// Texts as cells of CSV files.

#include <string>
#include <string_view>

namespace spoke {

/// Returns a text as a cell: in quotes if it holds a comma, quote or line end, line ends as spaces.
/// A text that a spreadsheet would take for a formula, as it begins with =, +, -, @ or a tab, gets
/// an apostrophe before it, which keeps it a text.
std::string csv_cell(std::string_view text);

/// Returns a text as a cell that is always in quotes.
std::string quoted_csv_cell(std::string_view text);

}  // namespace spoke
