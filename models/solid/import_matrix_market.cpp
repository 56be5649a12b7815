// Matrices of the exchange format of Matrix Market: a header, sizes, and the entries of a sparse
// matrix ("coordinate") or all numbers column by column ("array").

#include <algorithm>

#include "models/solid/import_formats.h"
#include "models/solid/import_text.h"
#include "models/solid/mesh_text.h"

namespace spoke::solid {
namespace {

struct MarketHeader {
  bool is_array = false;
  bool is_symmetric = false;
  std::int64_t entries = 0;  ///< as announced
  int line = 0;              ///< of the sizes
};

/// Reads "%%MatrixMarket matrix coordinate real symmetric".
MarketHeader read_banner(NumberText& text) {
  constexpr const char* kExpected =
      "expected \"%%MatrixMarket matrix\", coordinate or array, real, general or symmetric";
  if (!text.next()) text.fail(std::string("is empty, ") + kExpected);
  std::vector<std::string> words;
  for (const std::string_view word : text.fields()) words.push_back(in_small_letters(word));
  if (words.size() != 5 || words[0] != "%%matrixmarket" || words[1] != "matrix" ||
      (words[2] != "coordinate" && words[2] != "array"))
    text.fail(std::string("is no header, ") + kExpected);
  if (words[3] != "real" && words[3] != "double" && words[3] != "integer")
    text.fail("has numbers that are " + show_text(words[3]) + ", expected real ones");
  if (words[4] != "general" && words[4] != "symmetric")
    text.fail("is " + show_text(words[4]) + ", expected a general or symmetric matrix");
  return {.is_array = words[2] == "array", .is_symmetric = words[4] == "symmetric"};
}

/// Goes to the next line that is no comment; false at the end.
bool next_without_comments(NumberText& text) {
  while (text.next())
    if (text.line().front() != '%') return true;
  return false;
}

MarketHeader read_header(NumberText& text, const NodeTable& nodes) {
  MarketHeader header = read_banner(text);
  if (!next_without_comments(text)) text.fail("has no line of sizes, expected one");
  text.require_fields(header.is_array ? 2 : 3,
                      header.is_array ? "\"rows columns\"" : "\"rows columns entries\"");
  const std::int64_t rows = text.whole(0), columns = text.whole(1);
  if (rows != columns)
    text.fail("the matrix is not square: " + std::to_string(rows) + " rows, " +
              std::to_string(columns) + " columns, expected as many");
  if (rows != 3 * std::int64_t{nodes.size()})
    text.fail("the matrix has " + std::to_string(rows) + " rows, expected " +
              std::to_string(3 * nodes.size()) + ", three for each node of " + nodes.mesh().file);
  header.line = text.number();
  // At most some 6e9 nodes' squares: far from the range of the type.
  header.entries = !header.is_array      ? text.whole(2)
                   : header.is_symmetric ? rows * (rows + 1) / 2
                                         : rows * rows;
  if (header.entries < 0 || header.entries > rows * rows)
    text.fail("announces " + std::to_string(header.entries) + " entries, expected 0 to " +
              std::to_string(rows * rows));
  return header;
}

/// Walks through the places of the numbers of an array.
class ArrayPlace {
 public:
  ArrayPlace(std::int64_t rows, bool is_symmetric) : rows_(rows), is_symmetric_(is_symmetric) {}
  void advance() {
    if (++row_ < rows_) return;
    ++column_;
    row_ = is_symmetric_ ? column_ : 0;
  }
  int row() const { return static_cast<int>(row_); }
  int column() const { return static_cast<int>(column_); }

 private:
  std::int64_t rows_;
  bool is_symmetric_;
  std::int64_t row_ = 0, column_ = 0;
};

int read_index(const NumberText& text, std::size_t field, std::int64_t rows) {
  const std::int64_t index = text.whole(field);
  if (index < 1 || index > rows)
    text.fail("the row or column " + std::to_string(index) + " is outside, expected 1 to " +
              std::to_string(rows));
  return static_cast<int>(index - 1);
}

MatrixFile read_market_file(const MatrixName& name, const NodeTable& nodes) {
  NumberText text(name.file, name.key);
  const MarketHeader header = read_header(text, nodes);
  MatrixFile file{.file = name.file,
                  .key = name.key,
                  .triangles = header.is_symmetric ? StoredTriangles::one : StoredTriangles::both,
                  .entries = {}};
  const std::int64_t rows = 3 * std::int64_t{nodes.size()};
  ArrayPlace place(rows, header.is_symmetric);
  const auto announced = [&] {
    return ", expected " + std::to_string(header.entries) + ", as line " +
           std::to_string(header.line) + " announces";
  };
  std::int64_t found = 0;
  for (; next_without_comments(text); ++found) {
    if (found == header.entries) text.fail("is one entry too many" + announced());
    if (header.is_array) {
      text.require_fields(1, "one number");
      const double value = text.real(0);
      if (value != 0.0) file.entries.push_back({place.row(), place.column(), text.number(), value});
      place.advance();
    } else {
      text.require_fields(3, "\"row column value\"");
      const int row = read_index(text, 0, rows), column = read_index(text, 1, rows);
      file.entries.push_back({row, column, text.number(), text.real(2)});
    }
  }
  if (found != header.entries)
    text.fail_at(0, "ends after " + std::to_string(found) + " entries" + announced());
  return file;
}

}  // namespace

MatrixFiles read_matrix_market(const std::vector<MatrixName>& names, const NodeTable& nodes) {
  MatrixFiles result{.files = {}, .used = std::vector<char>(nodes.mesh().nodes.size(), 1)};
  for (const MatrixName& name : names) result.files.push_back(read_market_file(name, nodes));
  return result;
}

}  // namespace spoke::solid
