// Quotes texts, and keeps spreadsheets from computing them.

#include "engine/support/csv_cell.h"

namespace spoke {
namespace {

/// Whether a spreadsheet takes a cell of this text for a formula.
bool is_like_formula(std::string_view text) {
  return !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
}

}  // namespace

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\n\r") != std::string_view::npos) return quoted_csv_cell(text);
  return (is_like_formula(text) ? "'" : "") + std::string(text);
}

std::string quoted_csv_cell(std::string_view text) {
  std::string quoted = is_like_formula(text) ? "\"'" : "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c == '\n' || c == '\r' ? ' ' : c;
  }
  return quoted + '"';
}

}  // namespace spoke
