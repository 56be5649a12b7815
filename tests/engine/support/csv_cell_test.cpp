#include "engine/support/csv_cell.h"

#include <doctest/doctest.h>

using namespace spoke;

TEST_CASE("a text is a cell as it is, or in quotes where it has to be") {
  CHECK(csv_cell("blade 1") == "blade 1");
  CHECK(csv_cell("") == "");
  CHECK(csv_cell("a,b") == "\"a,b\"");
  CHECK(csv_cell("say \"so\"") == "\"say \"\"so\"\"\"");
  CHECK(csv_cell("two\nlines") == "\"two lines\"");
  CHECK(quoted_csv_cell("blade 1") == "\"blade 1\"");
}

TEST_CASE("a cell that a spreadsheet would compute becomes a text by an apostrophe") {
  for (const std::string text : {"=1+1", "+1", "-x", "@SUM(A1)", "\tx"})
    CHECK(csv_cell(text) == "'" + text);
  CHECK(csv_cell("=HYPERLINK(\"a\",b)") == "\"'=HYPERLINK(\"\"a\"\",b)\"");
  CHECK(quoted_csv_cell("=1+1") == "\"'=1+1\"");
  CHECK(csv_cell("1=1") == "1=1");
}
